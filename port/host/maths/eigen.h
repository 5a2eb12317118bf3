/* SPDX-License-Identifier: MIT
 *
 * maths/eigen.h: eigenvalues of small symmetric matrices, packed (INVCAL_PACKED of
 * invcal/expert.h).
 */
#ifndef EIGEN_H
#define EIGEN_H

#define EIGEN_MAX 18u /* rows at most */

/* All eigenvalues of a matrix of n rows, by Jacobi rotations, in no particular order.
 *
 * Error of each: (n + 8) DBL_EPSILON times the largest of them. A NaN in the matrix gives NaNs. */
void eigenvalues(const double *a, unsigned n, double *value);

/* The condition number: the largest eigenvalue over the smallest, with a relative error of (n + 8)
 * DBL_EPSILON times itself. HUGE_VAL if the matrix is not positive definite to rounding. */
double eigen_condition(const double *a, unsigned n);

#endif
