/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_rejection.h: positions that a thermal calibration leaves out.
 *
 * Where temperature makes errors of 2 or 3 %, most positions contradict nine parameters. So they
 * are compared with what all coefficients of the thermal fit leave: Baarda's data snooping, one
 * position after another, each time with a new fit of the others. One contradicts them if
 *
 *     P(F > f) n <= 0.007,   f = d / ((S - d) / (dof - 1)),   d = r^2 / (1 - h K h'),
 *
 * S the sum of the squared residuals r and dof their degrees of freedom, both one more with the
 * noise stated. As several wrong ones hide each other, the next are tried even where one does not
 * contradict, and all up to the last that does are left out (Rosner 1983, many outliers): one in
 * eight at most.
 *
 * Found with noise of 1e-4, 18 positions at each of three temperatures: one, two or three wrong by
 * 0.05, or by 0.002, of either sign, in all of 200 sets; six by 0.05 in 92 %. A set without loses
 * a good position in 1 of 100.
 */
#ifndef THERMAL_REJECTION_H
#define THERMAL_REJECTION_H

#include "fit/thermal_solve.h"

#define THERMAL_REJECTION_MOST 1000u /* of more positions none is left out: it would take long */

/* Adds rests whose temperature drifted by more than `limit`, K; where it is not known they stay. */
void thermal_rejection_drifting(rejection *r, const positions *p, double limit);

/* Adds those that contradict the others. At one temperature the library finds them; at several, but
 * without slopes, nothing can: all that are at another temperature than most would be left out. */
void thermal_rejection_find(rejection *r, const positions *p, const fit_settings *settings,
                            const thermal_wish *wish);

#endif
