/* SPDX-License-Identifier: MIT
 *
 * calibrate/settle.h: what was not stated: unit, nominal calibration and noise, from the readings.
 */
#ifndef CALIBRATE_SETTLE_H
#define CALIBRATE_SETTLE_H

#include "calibrate/request.h"
#include "result/result.h"

/* Whoever states the unit knows better than a heading; a size tells words, but no numbers. */
void settle_unit(const request *r, positions *data);

/* Zero and scale: given, or of an earlier calibration, or by the unit, or from the data's range. Returns
 * EXIT_GOOD; else EXIT_USAGE, EXIT_DATA or EXIT_FILE after a message. */
int settle_nominal(const request *r, const positions *data, nominal_choice *n);

/* That of a magnetometer, before it is read: without a scale 1, so that the result is in the unit of the
 * readings. Returns EXIT_GOOD; EXIT_FILE after a message. */
int settle_magnetometer(const request *r, nominal_choice *n);

/* The noise of a position mean, and whether it is known where it has to be. Returns as above. */
int settle_noise(const request *r, const positions *data, calibrate_result *result);

#endif
