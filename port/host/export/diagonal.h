/* SPDX-License-Identifier: MIT
 *
 * export/diagonal.h: a calibration for systems that store no cross terms.
 */
#ifndef EXPORT_DIAGONAL_H
#define EXPORT_DIAGONAL_H

#include "export/format.h"

/* What is wrong in a field of length 1, over all directions alike. */
typedef struct {
    double rms;        /* length of the vector calibrated - true: root mean square, */
    double max;        /* largest */
    double length_rms; /* |calibrated| - |true| */
    double length_max;
} export_error;

typedef struct {
    double scale[3];      /* calibrated = scale (driver - offset), axis by axis; */
    export_error best;    /* what it leaves, */
    export_error cut_off; /* and what the diagonal of the full matrix would leave */
} export_diagonal;

/* The scales that leave the smallest mean square error, with the offset as it is. */
export_diagonal export_diagonal_fit(const invcal_calibration *full);

/* Says on stderr what it leaves. */
void export_diagonal_tell(const export_job *job, const export_diagonal *d);

/* The same as a comment. */
void export_diagonal_comment(FILE *file, const char *prefix, const export_diagonal *d);

#endif
