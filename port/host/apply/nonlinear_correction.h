/* SPDX-License-Identifier: MIT
 *
 * apply/nonlinear_correction.h: removes quadratic and cubic errors of the axes from a reading, before what is linear
 * corrects it (nonlinearity.h).
 *
 * The error e(eta) of a reading depends on what the axes feel, eta, and that on the reading without it:
 *
 *     eta = A (raw - N^-1 e(eta) - offset)
 *
 * Steps of this equation go on until eta moves by less than 1e-12 of the field, which leaves nothing to speak
 * of. The terms were found at rest, up to the field along each axis: beyond NONLINEAR_EDGE times that the
 * error at the edge is used, where a cubic would grow without bounds.
 */
#ifndef NONLINEAR_CORRECTION_H
#define NONLINEAR_CORRECTION_H

#include "result/calibration_file.h"

#define NONLINEAR_EDGE 1.1

typedef struct {
    int is_needed; /* the calibration has such terms */
    double term[2][3];
    double inverse[3][3];         /* N^-1: of an error over the field, input units */
    invcal_calibration symmetric; /* input units to over the field, along the axes of the sensor */
    unsigned long readings;
    unsigned long beyond; /* of them beyond the edge, */
    double farthest;      /* up to here, over the field */
} nonlinear_correction;

/* Without such terms in the file nothing is corrected.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the terms are so large that the steps need not converge:
 * half of the field or more per field. */
int nonlinear_correction_begin(nonlinear_correction *c, const calibration_file *file,
                               const char *name);

/* The reading without the errors, input units. */
void nonlinear_correction_take(nonlinear_correction *c, double raw[3]);

/* Says in one line on stderr if readings were beyond the edge. */
void nonlinear_correction_end(const nonlinear_correction *c, const char *log);

#endif
