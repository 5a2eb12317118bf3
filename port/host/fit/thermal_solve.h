/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_solve.h: the library's thermal calibration of the positions kept, once.
 */
#ifndef THERMAL_SOLVE_H
#define THERMAL_SOLVE_H

#include "fit/rejection.h"
#include "invcal/thermal.h"

/* What is asked for. */
typedef struct {
    unsigned degree; /* 1 ... INVCAL_THERMAL_DEGREE */
    double slope[3]; /* prior: standard deviations per K of delta, dk, gamma; 0: not known */
    int keep_all;    /* leave no position out */
} thermal_wish;

/* What is known beforehand. Returns whether anything is. */
int thermal_prior(const fit_settings *settings, const thermal_wish *wish,
                  invcal_thermal_prior *prior);

/* The positions kept, as the library takes them. */
invcal_thermal_positions thermal_positions(const rejection *kept, const fit_settings *settings);

/* Around the mean temperature. Returns as invcal_thermal_start and invcal_thermal_fit. */
invcal_status thermal_solve(const rejection *kept, const fit_settings *settings,
                            const thermal_wish *wish, invcal_thermal *out, invcal_quality *quality);

#endif
