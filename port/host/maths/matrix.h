/* SPDX-License-Identifier: MIT
 *
 * maths/matrix.h: inverts small matrices.
 */
#ifndef MATRIX_H
#define MATRIX_H

#include "invcal/invcal.h"

/* The inverse of a calibration's matrix. Returns 1; 0, with `inverse` undefined, if the matrix is
 * singular to rounding or the inverse is not finite. */
int matrix_inverse(const invcal_calibration *calibration, double inverse[3][3]);

/* Inverts a symmetric positive definite matrix of n rows, packed (INVCAL_PACKED), in place. Returns
 * 1; 0, with `a` undefined, if it is singular to rounding. */
int matrix_invert_packed(double *a, unsigned n);

#endif
