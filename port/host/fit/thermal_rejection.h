/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_rejection.h: finds the outliers of a thermal calibration.
 *
 * If temperature causes errors of 2 or 3 %, most positions contradict nine parameters. So the
 * residuals of the thermal fit are tested: Baarda's data snooping, one position after another, each
 * time with a new fit of the others. A position contradicts them if
 *
 *     P(F > f) n <= 0.007,   f = d / ((S - d) / (dof - 1)),   d = r^2 / (1 - h K h'),
 *
 * S the sum of the squared residuals r and dof their degrees of freedom; a stated noise counts as
 * one more residual. As several outliers mask each other, further positions are tested even if one
 * does not contradict, and all up to the last one that does are left out (Rosner 1983, many
 * outliers), at most one in eight.
 *
 * With noise of 1e-4 and 18 positions at each of three temperatures, it finds one, two or three
 * errors of 0.05, or of 0.002, of either sign, in all of 200 sets; six of 0.05 in 92 %. A set
 * without errors loses a good position in 1 of 100 cases.
 */
#ifndef THERMAL_REJECTION_H
#define THERMAL_REJECTION_H

#include "fit/thermal_solve.h"

#define THERMAL_REJECTION_MAX                                                                      \
    1000u /* with more positions none is left out, as it would take too long */

/* Rejects rests whose temperature drifted by more than `limit`, K; rests with unknown drift
 * stay. */
void thermal_rejection_drifting(rejection *r, const positions *p, double limit);

/* Rejects positions that contradict the others. At a single temperature nine parameters suffice; at
 * several, but without slopes, none can be found: all at another temperature than most would seem
 * wrong. */
void thermal_rejection_find(rejection *r, const positions *p, const fit_settings *settings,
                            const thermal_options *options);

#endif
