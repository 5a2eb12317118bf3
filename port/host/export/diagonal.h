/* SPDX-License-Identifier: MIT
 *
 * export/diagonal.h: a calibration for systems that cannot store cross terms.
 */
#ifndef EXPORT_DIAGONAL_H
#define EXPORT_DIAGONAL_H

#include "export/format.h"

/* Errors in a field of length 1, over all directions with equal weight. */
typedef struct {
    double rms;        /* |calibrated - true|: root mean square */
    double max;        /* largest */
    double length_rms; /* |calibrated| - |true| */
    double length_max;
} export_error;

typedef struct {
    double scale[3];      /* calibrated = scale (driver - offset), axis by axis */
    export_error best;    /* remaining errors with these scales */
    export_error cut_off; /* the same with the diagonal of the full matrix instead */
} export_diagonal;

/* The scales with the smallest mean square error; the offset is not changed. */
export_diagonal export_diagonal_fit(const invcal_calibration *full);

/* Prints the remaining error on stderr. */
void export_diagonal_message(const export_job *job, const export_diagonal *d);

/* The same as a comment in the file. */
void export_diagonal_comment(FILE *file, const char *prefix, const export_diagonal *d);

#endif
