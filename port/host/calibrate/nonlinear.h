/* SPDX-License-Identifier: MIT
 *
 * calibrate/nonlinear.h: quadratic and cubic errors of the axes, fitted with the nine parameters.
 */
#ifndef CALIBRATE_NONLINEAR_H
#define CALIBRATE_NONLINEAR_H

#include "result/result.h"

/* Fits a nonlinearity, starting from the solution without. Returns EXIT_GOOD; EXIT_DATA, with
 * result->refused filled in, if the positions do not determine it. */
int calibrate_nonlinear(calibrate_result *result, unsigned degree);

#endif
