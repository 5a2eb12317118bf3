/* SPDX-License-Identifier: MIT
 *
 * export/factors.h: matrix = misalignment . diag(scale), with ones on the misalignment's diagonal.
 *
 * Column by column: scale_j = matrix_jj, misalignment_ij = matrix_ij / matrix_jj. It is unique.
 */
#ifndef EXPORT_FACTORS_H
#define EXPORT_FACTORS_H

#include "export/format.h"

typedef struct {
    double misalignment[3][3];
    double scale[3];
} export_factors;

/* Checks the calibration of accelerometer or gyroscope. Returns EXIT_GOOD; EXIT_DATA, with a
 * message, if a diagonal element is too small: the axes are interchanged. */
int export_factors_check(const export_job *job, const invcal_calibration *c, double factor);

/* The factors of the matrix, times `factor`. */
export_factors export_factors_of(const invcal_calibration *c, double factor);

#endif
