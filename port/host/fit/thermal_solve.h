/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_solve.h: a single thermal calibration of the kept positions by the library.
 */
#ifndef THERMAL_SOLVE_H
#define THERMAL_SOLVE_H

#include "fit/rejection.h"
#include "invcal/thermal.h"

/* What is asked for. */
typedef struct {
    unsigned degree; /* 1 ... INVCAL_THERMAL_DEGREE */
    double slope
        [3]; /* prior: standard deviations of the slopes of delta, dk, gamma per K; 0: not known */
    int keep_all; /* leave out no position */
} thermal_options;

/* The prior. Returns whether anything is known. */
int thermal_prior(const fit_settings *settings, const thermal_options *options,
                  invcal_thermal_prior *prior);

/* The kept positions, as the library needs them. */
invcal_positions thermal_positions(const rejection *kept, const fit_settings *settings);

/* The reference is the mean temperature. Returns as invcal_thermal_fit. */
invcal_status thermal_solve(const rejection *kept, const fit_settings *settings,
                            const thermal_options *options, invcal_thermal *out,
                            invcal_quality *quality);

#endif
