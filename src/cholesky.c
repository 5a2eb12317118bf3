/* SPDX-License-Identifier: MIT */
#include "invcal/cholesky.h"

#include "vector.h"

invcal_real invcal_largest_diagonal(const invcal_real *a, unsigned n)
{
    invcal_real largest = 0;

    INVCAL_ASSERT(a);
    for (unsigned r = 0; r < n; r++) {
        const invcal_real d = a[INVCAL_PACKED(r, r)];
        largest = d > largest ? d : largest;
    }
    return largest;
}

/* x <- L^-1 x */
static inline void forward(const invcal_real *l, unsigned n, invcal_real *x)
{
    for (unsigned r = 0; r < n; r++) {
        x[r] = (x[r] - invcal_dot(l, x, r)) / l[r];
        l += r + 1;
    }
}

/* Row by row: L(r,c) = (A(r,c) - sum L(r,k) L(c,k)) / L(c,c), which is a forward solution with the
 * rows above, and L(r,r) = sqrt(A(r,r) - sum L^2). */
invcal_status invcal_cholesky_factor(invcal_real *a, unsigned n, invcal_real floor)
{
    INVCAL_ASSERT(a && n >= 1 && n <= INVCAL_CHOLESKY_MAX);
    const invcal_real least = floor * invcal_largest_diagonal(a, n);
    invcal_real *row = a;

    for (unsigned r = 0; r < n; r++) {
        forward(a, r, row);
        const invcal_real pivot = row[r] - invcal_dot(row, row, r);
        if (!(pivot > least && invcal_is_positive(pivot))) {
            return INVCAL_UNDETERMINED;
        }
        row[r] = INVCAL_SQRT(pivot);
        row += r + 1;
    }
    return INVCAL_OK;
}

void invcal_cholesky_forward(const invcal_real *l, unsigned n, invcal_real *x)
{
    INVCAL_ASSERT(l && x && n >= 1 && n <= INVCAL_CHOLESKY_MAX);
    forward(l, n, x);
}

/* L' y = x, by columns of L' (rows of L): once y(r) is known its share is taken from the rest. */
static void backward(const invcal_real *l, unsigned n, invcal_real *x)
{
    for (unsigned r = n; r-- > 0;) {
        const invcal_real *row = &l[INVCAL_PACKED(r, 0)];
        x[r] /= row[r];
        for (unsigned c = 0; c < r; c++) {
            x[c] -= row[c] * x[r];
        }
    }
}

void invcal_cholesky_solve(const invcal_real *l, unsigned n, invcal_real *x)
{
    forward(l, n, x);
    backward(l, n, x);
}

/* Row r of the inverse needs row r of L and the rows of the inverse above it. */
void invcal_cholesky_invert(invcal_real *l, unsigned n)
{
    INVCAL_ASSERT(l && n >= 1 && n <= INVCAL_CHOLESKY_MAX);
    for (unsigned r = 0; r < n; r++) {
        invcal_real *row = &l[INVCAL_PACKED(r, 0)];
        for (unsigned c = 0; c < r; c++) {
            invcal_real sum = 0;
            for (unsigned k = c; k < r; k++) {
                sum += row[k] * l[INVCAL_PACKED(k, c)];
            }
            row[c] = -sum / row[r]; /* row[k >= c] are still those of L */
        }
        row[r] = 1 / row[r];
    }
}

void invcal_cholesky_inverse(invcal_real *l, unsigned n)
{
    invcal_cholesky_invert(l, n);
    /* A^-1 = (L^-1)' L^-1. Element (r,c) needs the rows from r downwards: those not yet done. */
    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            invcal_real sum = 0;
            for (unsigned k = r; k < n; k++) {
                sum += l[INVCAL_PACKED(k, r)] * l[INVCAL_PACKED(k, c)];
            }
            l[INVCAL_PACKED(r, c)] = sum;
        }
    }
}

/* A^-1(r,r) = |L^-1 e_r|^2; the first r elements of L^-1 e_r are zero. */
void invcal_cholesky_inverse_diagonal(const invcal_real *l, unsigned n, invcal_real *diagonal)
{
    invcal_real y[INVCAL_MAX_PARAMETERS];

    INVCAL_ASSERT(l && diagonal && n >= 1 && n <= INVCAL_MAX_PARAMETERS);
    for (unsigned r = 0; r < n; r++) {
        for (unsigned i = r; i < n; i++) {
            const invcal_real *row = &l[INVCAL_PACKED(i, 0)];
            y[i] = ((i == r ? 1 : 0) - invcal_dot(row + r, y + r, i - r)) / row[i];
        }
        diagonal[r] = invcal_dot(y + r, y + r, n - r);
    }
}
