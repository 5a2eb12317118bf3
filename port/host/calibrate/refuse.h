/* SPDX-License-Identifier: MIT
 *
 * calibrate/refuse.h: why there is no calibration, and what to do about it. These functions fill in
 * result->refused, which deliver.h prints, and return EXIT_DATA.
 */
#ifndef CALIBRATE_REFUSE_H
#define CALIBRATE_REFUSE_H

#include "result/result.h"

/* The status of fit_make, not INVCAL_OK.
 *
 * angles  of a stand, as stated: they show which group of a program is missing.
 * reason  details of the status. */
int calibrate_refuse(calibrate_result *result, const stand_options *angles, invcal_status status,
                     const fit_reason *reason);

/* All readings are too large or too small for what was stated about them.
 *
 * reason, remedy  what is wrong, and what to do. */
int calibrate_refuse_readings(calibrate_result *result, const char *reason, const char *remedy);

/* Too few rests are left without those in which the temperature drifted. */
int calibrate_refuse_drift(calibrate_result *result);

/* The log has no rests. */
int calibrate_refuse_no_rest(calibrate_result *result);

/* The angles of the stand do not fit the readings as stated. */
int calibrate_refuse_frame(calibrate_result *result);

/* The stated up axes of the case do not fit the readings. */
int calibrate_refuse_case(calibrate_result *result, invcal_status status);

/* The rotation to the axes of the accelerometer is not determined. */
int calibrate_refuse_axes(calibrate_result *result);

/* The samples of a magnetometer do not determine a calibration. */
int calibrate_refuse_magnetometer(calibrate_result *result);

#endif
