/* SPDX-License-Identifier: MIT
 *
 * invcal/cholesky.h: A = L L', for symmetric positive definite A of any size up to
 * INVCAL_CHOLESKY_MAX, packed by rows (INVCAL_PACKED).
 *
 * All but one work in place, and what they cost depends on n alone: n is from 1 to
 * INVCAL_CHOLESKY_MAX, for the diagonal of the inverse to INVCAL_MAX_PARAMETERS; anything else is
 * a programming error.
 */
#ifndef INVCAL_CHOLESKY_H
#define INVCAL_CHOLESKY_H

#include "invcal/normal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The nine parameters, widened by a square polynomial of temperature. */
#define INVCAL_CHOLESKY_MAX 27u

/* The largest diagonal element of a packed matrix, at least 0; NaN elements are passed over. */
invcal_real invcal_largest_diagonal(const invcal_real *a, unsigned n);

/* Factors a matrix in place.
 *
 * a      in: the packed matrix; out: L, packed. On failure what is in it is lost: factor a copy.
 * floor  a pivot counts as zero unless it exceeds floor times the largest diagonal element of a.
 *        Relative to the largest element, not to the pivot's own: the latter lets matrices
 *        through that are singular to rounding. Use at least INVCAL_PIVOT_FLOOR. No floor finds
 *        them all: a combination that is open but hardly involves the last parameters shows in
 *        no pivot. It shows in the condition (eigen.h).
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if a pivot is too small, negative or NaN.
 * Cost: n^3/6 multiply-adds, n square roots. */
invcal_status invcal_cholesky_factor(invcal_real *a, unsigned n, invcal_real floor);

/* Below this a pivot is rounding error, or the parameter behind it might as well be. */
#define INVCAL_PIVOT_FLOOR (INVCAL_DOUBLE ? INVCAL_REAL(1e-8) : 16 * INVCAL_EPSILON)

/* Replaces x by the solution y of L y = x. Cost: n^2/2 multiply-adds.
 * |y|^2 = x' A^-1 x, the variance of the combination x of parameters. */
void invcal_cholesky_forward(const invcal_real *l, unsigned n, invcal_real *x);

/* Replaces x by the solution y of A y = x. Cost: n^2 multiply-adds. */
void invcal_cholesky_solve(const invcal_real *l, unsigned n, invcal_real *x);

/* Replaces L by L^-1, packed. Cost: n^3/6 multiply-adds.
 * |L^-1 x|^2 = x' A^-1 x for as many x as you like; A^-1(r,r) is the square of column r. */
void invcal_cholesky_invert(invcal_real *l, unsigned n);

/* Replaces L by A^-1, packed. Cost: n^3/3 multiply-adds. */
void invcal_cholesky_inverse(invcal_real *l, unsigned n);

/* The diagonal of A^-1, n numbers up to INVCAL_MAX_PARAMETERS, L kept. Cost: n^3/6
 * multiply-adds. */
void invcal_cholesky_inverse_diagonal(const invcal_real *l, unsigned n, invcal_real *diagonal);

#ifdef __cplusplus
}
#endif

#endif
