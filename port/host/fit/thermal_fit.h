/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_fit.h: a calibration for every temperature (invcal/thermal.h) of the positions of a file.
 */
#ifndef THERMAL_FIT_H
#define THERMAL_FIT_H

#include "read/positions.h"
#include "fit/rejection.h"
#include "fit/thermal_rows.h"
#include "fit/thermal_solve.h"

typedef struct {
    thermal_wish wish;
    fit_settings settings; /* the noise is what a prior is weighed with */
    invcal_thermal_prior prior;
    int has_prior;
    invcal_thermal calibration;
    fit_solution solution; /* at the reference, and what it is worth there; worst counts */
    fit_quality quality;   /* among the positions kept */
    double covariance[THERMAL_PACKED]; /* of the coefficients in calibrated units, over noise^2 */
    double slope[INVCAL_PARAMETERS];   /* of delta, dk, gamma, per K at the reference, */
    double slope_sigma[INVCAL_PARAMETERS];
    fit_solution nine;   /* nine parameters alone for the same positions, */
    double without;      /* and the rms of their residuals; NaN: they have no solution */
    double significance; /* chance that slopes that are none make the difference; 1: no slopes */
    double drift_limit;  /* K in a rest: those with more are left out */
} thermal_fit;

/* Fits the positions at which no temperature drifted and which do not contradict the others.
 *
 * settings  nominal, field, noise, prior at the reference, frame.
 * rejected  out: to be released with rejection_free in any case.
 * status    out: what the library answered; unless INVCAL_OK the fit is not to be used.
 * reason    out: details; its position counts in all positions.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. */
int thermal_fit_make(thermal_fit *fit, const positions *p, const fit_settings *settings,
                     const thermal_wish *wish, rejection *rejected, invcal_status *status,
                     fit_reason *reason);

/* The calibration at a temperature, at most at the edge of the range seen. */
invcal_calibration thermal_fit_at(const thermal_fit *fit, double temperature);

/* The reading that would have come at the reference temperature. */
void thermal_fit_to_reference(const thermal_fit *fit, const double raw[3], double temperature,
                              double out[3]);

/* Parameters and their sigma at a temperature in the range seen.
 *
 * kept  the positions that it was made of. */
void thermal_fit_judge(const thermal_fit *fit, const rejection *kept, double temperature,
                       fit_solution *solution, fit_quality *quality);

#endif
