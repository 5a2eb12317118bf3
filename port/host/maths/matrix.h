/* SPDX-License-Identifier: MIT
 *
 * maths/matrix.h: small matrices turned round.
 */
#ifndef MATRIX_H
#define MATRIX_H

#include "invcal/expert.h"

/* The inverse of a calibration's matrix. Returns 1; 0 if that is singular to rounding, or not finite:
 * inverse is lost then. */
int matrix_inverse(const invcal_calibration *calibration, double inverse[3][3]);

/* A symmetric positive definite matrix of n rows, packed (INVCAL_PACKED), becomes its inverse. Returns
 * 1; 0 if it is singular to rounding: a is lost then. */
int matrix_invert_packed(double *a, unsigned n);

#endif
