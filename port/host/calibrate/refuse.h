/* SPDX-License-Identifier: MIT
 *
 * calibrate/refuse.h: why there is no calibration, and what to do about it.
 */
#ifndef CALIBRATE_REFUSE_H
#define CALIBRATE_REFUSE_H

#include "result/result.h"

/* Says why there is no calibration: one line on stderr, and, if `json`, an object on stdout.
 *
 * status    what fit_make answered, not INVCAL_OK.
 * reason    its details.
 * settings  what it was asked.
 * nominal   where the zero and scale came from.
 * angles    what is said of those of a stand: which group of a program is missing they tell.
 *
 * Returns EXIT_DATA. */
int calibrate_refuse(const positions *data, const fit_settings *settings,
                     const nominal_choice *nominal, const stand_wish *angles, invcal_status status,
                     const fit_reason *reason, int json);

/* Says that the temperature drifted in so many rests that too few are left. Returns EXIT_DATA. */
int calibrate_all_drift(const calibrate_result *result, int json);

/* Says that a log holds no rest, and what it holds. Returns EXIT_DATA. */
int calibrate_no_rest(const positions *data, const rests_summary *log, int json);

/* The samples of a magnetometer do not tell a calibration. */
int calibrate_refuse_waved(const positions *data, const waved *log, int json);

#endif
