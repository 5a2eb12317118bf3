/* SPDX-License-Identifier: MIT
 *
 * thermal_rejection.h: positions that a thermal calibration leaves out.
 *
 * Where temperature makes errors of 2 or 3 %, most positions contradict nine parameters. So they
 * are compared with what all coefficients of the thermal fit leave: Baarda's data snooping, one
 * position after another, each time with a new fit of the others. A position is left out if
 *
 *     P(F > f) n <= 0.007,   f = d / ((S - d) / (dof - 1)),   d = r^2 / (1 - h K h'),
 *
 * S the sum of the squared residuals r and dof their degrees of freedom, both one more with the
 * noise stated. Two wrong positions near one another may hide each other (invcal_outliers_find,
 * which is for nine parameters, tries groups); no more than one in eight is left out.
 */
#ifndef THERMAL_REJECTION_H
#define THERMAL_REJECTION_H

#include "invcal/thermal.h"
#include "rejection.h"

#define THERMAL_REJECTION_MOST 1000u /* of more positions none is left out: it would take long */

/* Adds rests whose temperature drifted by more than `limit`, K; where it is not known they stay. */
void thermal_rejection_drifting(rejection *r, const positions *p, double limit);

/* Adds those that contradict the others. At one temperature the library tells which; at several, but
 * without slopes, nothing does: all that are at another temperature than most would be left out. */
void thermal_rejection_find(rejection *r, const positions *p, const invcal_settings *settings,
                            const invcal_thermal_settings *thermal);

#endif
