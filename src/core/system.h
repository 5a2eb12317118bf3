/* SPDX-License-Identifier: MIT
 *
 * Internal: a symmetric system of n unknowns, A p = -b, in one packed triangle. Row n, if present, is
 * b' and the constant: factoring it with A does the forward substitution.
 */
#ifndef INVCAL_SYSTEM_H
#define INVCAL_SYSTEM_H

#include "invcal/invcal.h"
#include "vector.h"

/* Index of (r, c), c <= r, in a symmetric matrix, stored as its lower triangle by rows. */
#define INVCAL_PACKED(r, c) ((r) * ((r) + 1u) / 2u + (c))
/* Number of elements. */
#define INVCAL_PACKED_SIZE(n) ((n) * ((n) + 1u) / 2u)

/* A pivot below this, over the largest element of the diagonal, may be a rounding error. */
#define INVCAL_FLOOR (INVCAL_DOUBLE ? INVCAL_REAL(1e-8) : 16 * INVCAL_EPSILON)

/* The sum of the diagonal. */
invcal_real invcali_trace(const invcal_real *a, unsigned n);

/* The largest element of the diagonal, at least 0. Skips NaN; 0 if the first element is one. */
invcal_real invcali_largest_diagonal(const invcal_real *a, unsigned n);

/* A = L L' in place. The diagonal becomes 1 / L(r,r), so that no later step divides. Rows from n to
 * rows - 1 are only divided by L': b' becomes y' of L y = b, and the constant its remainder.
 *
 * floor  a pivot counts as zero unless it exceeds floor times the largest element of the diagonal:
 *        INVCAL_FLOOR. Relative to the largest, since a test against the pivot's own element
 *        accepts matrices that are singular to rounding.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if a pivot is too small, negative or NaN: a is
 * overwritten.
 * Cost: n^3/6 multiply-adds, n square roots. */
invcal_status invcali_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor);

/* Replaces y in row n by p = -L'^-1 y. */
void invcali_back_substitute(invcal_real *l, unsigned n);

/* Replaces L by L^-1: A^-1(r,r) is then the squared length of column r, x'A^-1 x that of L^-1 x. */
void invcali_invert(invcal_real *l, unsigned n);

/* A^-1(r,r) from L^-1. */
invcal_real invcali_variance(const invcal_real *inverse, unsigned n, unsigned r);

/* The leverage h K h' of a row, from L^-1 of the nine parameters: what it adds to the rows in the
 * sums. h becomes y = L^-1 h; the result is its squared length. */
invcal_real invcali_leverage(const invcal_real *inverse, invcal_real h[INVCAL_PARAMETERS]);

/* v = L' v, for a packed triangle of n rows. */
void invcali_transposed(const invcal_real *l, unsigned n, invcal_real *v);

/* invcali_variance. */
static INVCAL_ONCE invcal_real invcali_variance_inline(const invcal_real *inverse, unsigned n,
                                                       unsigned r)
{
    invcal_real sum = 0;

    INVCAL_ROLL
    for (unsigned i = r; i < n; i++) {
        const invcal_real x = inverse[INVCAL_PACKED(i, r)];
        sum += x * x;
    }
    return sum;
}

#endif
