/* SPDX-License-Identifier: MIT
 *
 * invcal/eigen.h: eigenvalues of symmetric matrices, small and without iteration limits to tune.
 */
#ifndef INVCAL_EIGEN_H
#define INVCAL_EIGEN_H

#include "invcal/cholesky.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A symmetric 3x3 matrix as M = V diag(value) V'. */
typedef struct {
    invcal_real value[3];     /* in no particular order */
    invcal_real vector[3][3]; /* V: column i belongs to value[i]; orthonormal */
} invcal_eigen3;

/* Decomposes a packed symmetric 3x3 matrix (INVCAL_PACKED) by Jacobi's rotations.
 * A matrix with a NaN gives values with a NaN. Cost: at most 10 sweeps of three rotations; a
 * matrix near the diagonal takes two or three. */
void invcal_eigen3_decompose(const invcal_real m[6], invcal_eigen3 *out);

/* The condition number of a symmetric positive definite matrix: its largest eigenvalue over its
 * smallest, from a tridiagonal form (Householder) by Laguerre's iteration.
 *
 * a  the packed matrix (INVCAL_PACKED), n rows, 1 <= n <= INVCAL_MAX_PARAMETERS. Used as
 *    workspace: its content is lost.
 *
 * Relative error: (n + 8) INVCAL_EPSILON times the condition number. A matrix that is not positive
 * definite to rounding gives INVCAL_REAL_MAX. */
invcal_real invcal_condition(invcal_real *a, unsigned n);

/* The largest eigenvalue of a symmetric positive definite matrix; a and n as above. Relative
 * error: (n + 8) INVCAL_EPSILON, so that the largest of A times the largest of A^-1 gives a
 * condition without the loss above. What is no positive definite matrix gives INVCAL_REAL_MAX or
 * a number without meaning. */
invcal_real invcal_largest_eigenvalue(invcal_real *a, unsigned n);

#ifdef __cplusplus
}
#endif

#endif
