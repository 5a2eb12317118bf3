/* SPDX-License-Identifier: MIT
 *
 * apply/nonlinear_correction.h: removes quadratic and cubic errors of the axes (nonlinearity.h)
 * from a reading, before the linear calibration is applied.
 *
 * The error e(eta) of a reading depends on the field along the axes, eta, which depends on the
 * reading without it:
 *
 *     eta = A (raw - N^-1 e(eta) - offset)
 *
 * This is iterated until eta changes by less than 1e-12 of the field. The terms were found at rest,
 * up to the field along each axis. Beyond NONLINEAR_EDGE times the field, the error at that edge is
 * used, as a cubic would grow without bounds.
 */
#ifndef NONLINEAR_CORRECTION_H
#define NONLINEAR_CORRECTION_H

#include "result/calibration_file.h"

#define NONLINEAR_EDGE 1.1

typedef struct {
    int is_needed; /* the calibration has such terms */
    double term[2][3];
    double inverse[3][3];         /* N^-1: from an error over the field to input units */
    invcal_calibration symmetric; /* input units to eta, along the axes of the sensor */
    unsigned long readings;
    unsigned long beyond; /* readings beyond the edge */
    double farthest;      /* largest |eta| */
} nonlinear_correction;

/* If the file has no such terms, nothing is corrected.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the terms are so large that the iteration may
 * not converge: a slope of 0.5 or more. */
int nonlinear_correction_begin(nonlinear_correction *c, const calibration_file *file,
                               const char *name);

/* Removes the errors from a reading, input units. */
void nonlinear_correction_remove(nonlinear_correction *c, double raw[3]);

/* Prints a warning if readings were beyond the edge. */
void nonlinear_correction_end(const nonlinear_correction *c, const char *log);

#endif
