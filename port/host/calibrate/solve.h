/* SPDX-License-Identifier: MIT
 *
 * calibrate/solve.h: from positions to the result.
 */
#ifndef CALIBRATE_SOLVE_H
#define CALIBRATE_SOLVE_H

#include "calibrate/request.h"
#include "result/result.h"

/* Returns EXIT_GOOD; EXIT_DATA with result->refused filled in; EXIT_USAGE or EXIT_FILE after a
 * message. */
int solve_positions(const request *r, const positions *data, const gyro_log *gyro,
                    calibrate_result *result);

/* The same of a magnetometer that was waved, whose cells `data` are: result->magnetometer. */
int solve_waved(const request *r, const positions *data, calibrate_result *result);

#endif
