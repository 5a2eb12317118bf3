/* SPDX-License-Identifier: MIT
 *
 * calibrate/refuse.h: why there is no calibration, and what to do about it. Nothing is printed here: the reason is
 * left in result->refused, which deliver.h prints.
 */
#ifndef CALIBRATE_REFUSE_H
#define CALIBRATE_REFUSE_H

#include "result/result.h"

/* What fit_make answered, not INVCAL_OK.
 *
 * angles  those of a stand, as stated: they show which group of a program is missing.
 * reason  details of the answer.
 *
 * This and those below return EXIT_DATA. */
int calibrate_refuse(calibrate_result *result, const stand_options *angles, invcal_status status,
                     const fit_reason *reason);

/* The temperature drifted in so many rests that too few are left. */
int calibrate_all_drift(calibrate_result *result);

/* A log holds no rest, and what it holds. */
int calibrate_no_rest(calibrate_result *result);

/* The angles of the stand are not those that were stated. */
int calibrate_no_frame(calibrate_result *result);

/* The ways up of the case that were stated are not those measured. */
int calibrate_no_case(calibrate_result *result, invcal_status status);

/* The rotation to the axes of the accelerometer is not determined. */
int calibrate_no_axes(calibrate_result *result);

/* The samples of a magnetometer do not determine a calibration. */
int calibrate_refuse_waved(calibrate_result *result);

#endif
