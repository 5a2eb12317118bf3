/* SPDX-License-Identifier: MIT
 *
 * calibrate/solve.h: from positions to the result.
 */
#ifndef CALIBRATE_SOLVE_H
#define CALIBRATE_SOLVE_H

#include "calibrate/request.h"
#include "result/result.h"

/* Calibrates from positions. Returns EXIT_GOOD; EXIT_DATA with result->refused filled in;
 * EXIT_USAGE or EXIT_FILE after a message. */
int solve_positions(const request *r, const positions *data, const gyro_log *gyro,
                    calibrate_result *result);

/* The same for a magnetometer that was waved, result->magnetometer; `data` are its cells. */
int solve_magnetometer(const request *r, const positions *data, calibrate_result *result);

#endif
