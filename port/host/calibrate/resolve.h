/* SPDX-License-Identifier: MIT
 *
 * calibrate/resolve.h: unit, nominal calibration, limits and noise, as stated or from file and
 * readings.
 */
#ifndef CALIBRATE_RESOLVE_H
#define CALIBRATE_RESOLVE_H

#include "calibrate/request.h"
#include "result/result.h"

/* The unit of the readings. A stated unit overrides that of the header; without either, the size of
 * the readings decides, or, if it is not conclusive, --sensor. */
void resolve_unit(const request *r, positions *data);

/* Zero and scale: as stated, or from an earlier calibration, the unit, a data sheet or the range of
 * the data. Returns EXIT_GOOD; EXIT_DATA with result->refused filled in; else EXIT_USAGE or
 * EXIT_FILE after a message. */
int resolve_nominal(const request *r, calibrate_result *result);

/* The limits of the parameters: --tolerance, or the data sheet. */
void resolve_limits(const request *r, calibrate_result *result);

/* Checks --lsb and the unit by the size of the readings. A scale by which they are not 1/1.5 to 1.5
 * times the field is refused; a unit only if another one fits, or if they are not 0.1 to 10 times.
 * Returns EXIT_GOOD, also if the positions are too few to show it; EXIT_USAGE after a message about
 * --lsb; EXIT_DATA with result->refused filled in. */
int resolve_check_size(const request *r, calibrate_result *result);

/* Zero and scale of a magnetometer, before its log is read. Without a stated scale, it is 1 and the
 * result is in the unit of the readings. Returns EXIT_GOOD; EXIT_FILE after a message. */
int resolve_magnetometer(const request *r, nominal_choice *n);

/* The noise of a position mean. Returns EXIT_GOOD; EXIT_USAGE or EXIT_FILE after a message, if it
 * is out of range or missing where an option needs it. */
int resolve_noise(const request *r, const positions *data, calibrate_result *result);

#endif
