/* SPDX-License-Identifier: MIT
 *
 * fit/fit_drift.h: twelve parameters: the nine, and how far the offset of each axis drifts meanwhile.
 */
#ifndef FIT_DRIFT_H
#define FIT_DRIFT_H

#include "fit/fit.h"

#define FIT_DRIFT_FEWEST 14u /* positions: two more than the unknowns (fit_extended.h) */

/* Calibrates; the result holds in the middle.
 *
 * tau    when each position was visited, from -1/2 at the first of all to 1/2 at the last.
 * drift  by how much the offsets of the three axes grow from the first to the last, over the field.
 * sigma  their standard deviations.
 *
 * Returns as fit_make; INVCAL_UNDETERMINED, too, if the order hides a drift. */
invcal_status fit_drift_make(const double *raw, const double *tau, unsigned count,
                             const fit_settings *settings, fit_solution *solution,
                             fit_quality *quality, double drift[3], double sigma[3]);

#endif
