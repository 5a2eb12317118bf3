/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_fit.h: calibrates for a range of temperatures (invcal/thermal.h) from the positions
 * of a file.
 */
#ifndef THERMAL_FIT_H
#define THERMAL_FIT_H

#include "read/positions.h"
#include "fit/rejection.h"
#include "fit/thermal_rows.h"
#include "fit/thermal_solve.h"

typedef struct {
    thermal_options options;
    fit_settings settings; /* the noise is that with which the prior was weighted */
    invcal_thermal_prior prior;
    int has_prior;
    invcal_thermal calibration;
    fit_solution solution;             /* at the reference */
    fit_quality quality;               /* the same; `worst` is a number among the kept positions */
    double covariance[THERMAL_PACKED]; /* of the coefficients in calibrated units, over noise^2 */
    double slope[INVCAL_PARAMETERS];   /* of delta, dk, gamma, per K at the reference */
    double slope_sigma[INVCAL_PARAMETERS];
    fit_solution nine;   /* of nine parameters only, from the same positions */
    double without;      /* rms of the residuals of nine; NaN: no solution */
    double significance; /* probability of such an improvement if all slopes are 0; 1: no slopes */
    double drift_limit;  /* K in a rest: rests with more are left out */
} thermal_fit;

/* Fits the positions without a drift of temperature that do not contradict the others.
 *
 * settings  nominal, field, noise, prior at the reference, frame.
 * rejected  out: release it with rejection_free in any case.
 * status    out: the status of the library; the fit is valid only if it is INVCAL_OK.
 * reason    out: details; its position is a number among all positions.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if memory is short. */
int thermal_fit_make(thermal_fit *fit, const positions *p, const fit_settings *settings,
                     const thermal_options *options, rejection *rejected, invcal_status *status,
                     fit_reason *reason);

/* The calibration at a temperature; outside the measured range that at its edge. */
invcal_calibration thermal_fit_at(const thermal_fit *fit, double temperature);

/* Converts a reading to the reference temperature. */
void thermal_fit_to_reference(const thermal_fit *fit, const double raw[3], double temperature,
                              double out[3]);

/* Parameters and their sigma at a temperature in the measured range.
 *
 * kept  the positions of the fit. */
void thermal_fit_judge(const thermal_fit *fit, const rejection *kept, double temperature,
                       fit_solution *solution, fit_quality *quality);

#endif
