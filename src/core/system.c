/* SPDX-License-Identifier: MIT
 *
 * Least squares for any number of unknowns: A p = -b in one packed triangle, by Cholesky
 * (mathematics.md, "Normal equations"). invcali_factor makes L, with y of the right side as one more
 * row; invcali_back_substitute turns y into p; invcali_invert makes L^-1, from which variances and
 * leverages are sums of squares that cannot become negative.
 */
#include "system.h"

#include "vector.h"

invcal_real invcali_trace(const invcal_real *a, unsigned n)
{
    invcal_real sum = *a;

    for (unsigned r = 2; r <= n; r++) {
        a += r;
        sum += *a;
    }
    return sum;
}

static INVCAL_ONCE invcal_real largest(const invcal_real *a, unsigned n)
{
    invcal_real most = *a;

    INVCAL_UNROLL_ROWS
    for (unsigned r = 2; r <= n; r++) {
        a += r;
        most = *a > most ? *a : most;
    }
    return most;
}

invcal_real invcali_largest_diagonal(const invcal_real *a, unsigned n)
{
    const invcal_real most = largest(a, n);

    return most > 0 ? most : 0;
}

/* L(r,c) = (A(r,c) - sum L(r,k) L(c,k)) / L(c,c), L(r,r) = sqrt(A(r,r) - sum L(r,k)^2). */
static INVCAL_ONCE invcal_status factor(invcal_real *a, unsigned n, unsigned rows,
                                        invcal_real floor)
{
    const invcal_real least = floor * largest(a, n);
    invcal_real *row = a;

    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < rows; r++) {
        const invcal_real *l = a;
        invcal_real pivot = row[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c < r; c++) {
            invcal_real x = row[c];
            INVCAL_UNROLL_ROWS
            for (unsigned k = 0; k < c; k++) {
                x -= *l++ * row[k];
            }
            x *= *l++;
            row[c] = x;
            pivot -= x * x;
        }
        row[r] = pivot;
        if (r < n) {
            if (!(pivot > least)) {
                return INVCAL_UNDETERMINED;
            }
            row[r] = 1 / INVCAL_SQRT(pivot);
        }
        row += r + 1;
    }
    return INVCAL_OK;
}

/* If optimised for speed, known sizes are compiled separately. */
invcal_status invcali_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor)
{
    INVCAL_ASSERT(a && n >= 1);
#if INVCAL_FAST
    if (n == INVCAL_PARAMETERS) {
        return rows == n ? factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS, floor)
                         : factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, floor);
    }
#endif
    return factor(a, n, rows, floor);
}

/* By columns of L': once p(r) is known, its share is subtracted from those above. */
static INVCAL_ONCE void back_substitute(invcal_real *l, unsigned n)
{
    invcal_real *p = &l[INVCAL_PACKED(n, 0)];

    INVCAL_UNROLL_ROWS
    for (unsigned r = n; r-- > 0;) {
        const invcal_real *row = &l[INVCAL_PACKED(r, 0)];
        p[r] *= -row[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c < r; c++) {
            p[c] += row[c] * p[r];
        }
    }
}

void invcali_back_substitute(invcal_real *l, unsigned n)
{
#if INVCAL_FAST
    if (n == INVCAL_PARAMETERS) {
        back_substitute(l, INVCAL_PARAMETERS);
        return;
    }
#endif
    back_substitute(l, n);
}

INVCAL_OFTEN void invcali_transposed(const invcal_real *l, unsigned n, invcal_real *v)
{
    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < n; r++) {
        const invcal_real x = v[r];
        v[r] = 0;
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c <= r; c++) {
            v[c] += *l++ * x;
        }
    }
}

/* In place, row by row: L^-1(r,c) = -sum L(r,k) L^-1(k,c) / L(r,r) over k = c ... r - 1. The rows
 * above are inverted already. */
static INVCAL_ONCE void invert(invcal_real *l, unsigned n)
{
    invcal_real *row = l;

    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < n; r++) {
        invcali_transposed(l, r, row);
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c < r; c++) {
            row[c] *= -row[r];
        }
        row += r + 1;
    }
}

void invcali_invert(invcal_real *l, unsigned n)
{
#if INVCAL_FAST
    if (n == INVCAL_PARAMETERS) {
        invert(l, INVCAL_PARAMETERS);
        return;
    }
#endif
    invert(l, n);
}

invcal_real invcali_variance(const invcal_real *inverse, unsigned n, unsigned r)
{
    return invcali_variance_inline(inverse, n, r);
}

invcal_real invcali_leverage(const invcal_real *inverse, invcal_real h[INVCAL_PARAMETERS])
{
    const invcal_real *row = &inverse[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real sum = 0;

    INVCAL_UNROLL_ROWS
    for (unsigned r = INVCAL_PARAMETERS; r > 0; r--) { /* from the end: each h is read before */
        row -= r;
        h[r - 1] = invcali_dot(row, h, r);
        sum += h[r - 1] * h[r - 1];
    }
    return sum;
}
