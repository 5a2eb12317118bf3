/* SPDX-License-Identifier: MIT
 *
 * calibrate/gyro.h: calibrates the gyroscope of a log, and the accelerometer with it.
 */
#ifndef CALIBRATE_GYRO_H
#define CALIBRATE_GYRO_H

#include "calibrate/request.h"
#include "result/result.h"

/* Fills in result->gyro, starting from the accelerometer's solution or, if that was refused, from
 * nominal. If the rests leave parameters of the accelerometer undetermined or weak and the moves
 * determine them, also replaces its solution.
 *
 * refused  exit code of the solution from the rests.
 *
 * Returns EXIT_GOOD; `refused` if that remains; EXIT_FILE after a message. */
int calibrate_gyro(const request *r, const gyro_log *gyro, int refused, calibrate_result *result);

/* Turns the gyroscope to the final frame of the accelerometer, which differs from that of the
 * moves. */
void calibrate_gyro_turn(calibrate_result *result);

#endif
