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

/* Of the accelerometer, or the gyroscope: EXIT_GOOD; EXIT_DATA, with a message, if an axis has no part in its own reading or is lost in
 * those of the others: axes that are interchanged. */
int export_factors_check(const export_job *job, const invcal_calibration *c, double factor);

/* Of the matrix, times `factor`. */
export_factors export_factors_of(const invcal_calibration *c, double factor);

#endif
