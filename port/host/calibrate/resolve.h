/* SPDX-License-Identifier: MIT
 *
 * calibrate/settle.h: what was not stated: unit, nominal calibration and noise, from the readings.
 */
#ifndef CALIBRATE_SETTLE_H
#define CALIBRATE_SETTLE_H

#include "calibrate/request.h"
#include "result/result.h"

/* A stated unit overrides a heading; the size of readings overrides words, and numbers only if it is sure. */
void settle_unit(const request *r, positions *data);

/* Zero and scale: given, or of an earlier calibration, or by the unit, or of a data sheet, or from the data's range. Returns
 * EXIT_GOOD; EXIT_DATA with result->refused filled in; else EXIT_USAGE or EXIT_FILE after a message. */
int settle_nominal(const request *r, calibrate_result *result);

/* What each parameter may be off by: --tolerance, or the data sheet. */
void settle_limits(const request *r, calibrate_result *result);

/* Whether a scale that was stated is one of these readings, or upside down: counts per g where the field per
 * count is meant. Returns EXIT_GOOD, also if it is wrong otherwise; EXIT_USAGE after a message. */
int settle_scale(const request *r, const positions *data, const nominal_choice *nominal);

/* That of a magnetometer, before it is read: without a scale 1, so that the result is in the unit of the
 * readings. Returns EXIT_GOOD; EXIT_FILE after a message. */
int settle_magnetometer(const request *r, nominal_choice *n);

/* The noise of a position mean, and whether it is known where it has to be. Returns as above. */
int settle_noise(const request *r, const positions *data, calibrate_result *result);

#endif
