/* SPDX-License-Identifier: MIT
 *
 * fit/fit_drift.h: solves for twelve parameters: the nine, and the drift of each offset during the
 * session.
 */
#ifndef FIT_DRIFT_H
#define FIT_DRIFT_H

#include "fit/fit.h"

#define FIT_DRIFT_POSITIONS_MIN 14u /* two more than unknowns (fit_extended.h) */

/* Calibrates; the result holds for the middle of the session.
 *
 * tau    time of each position, from -1/2 at the first to 1/2 at the last.
 * drift  out: change of the three offsets from the first to the last, over the field.
 * sigma  out: their standard deviations.
 *
 * Returns as fit_make; INVCAL_UNDETERMINED, too, if the order of the positions hides a drift. */
invcal_status fit_drift_make(const double *raw, const double *tau, unsigned count,
                             const fit_settings *settings, fit_solution *solution,
                             fit_quality *quality, double drift[3], double sigma[3]);

#endif
