/* SPDX-License-Identifier: MIT
 *
 * calibrate/gyro.h: the gyroscope with the accelerometer.
 */
#ifndef CALIBRATE_GYRO_H
#define CALIBRATE_GYRO_H

#include "calibrate/request.h"
#include "result/result.h"

/* Fills in result->gyro, from the accelerometer's solution or, if that was refused, from nominal; and where rests alone
 * leave the accelerometer open or weak, but moves do not, its solution, too. Returns EXIT_GOOD; `refused` if that stays;
 * EXIT_FILE after a message. */
int calibrate_gyro(const request *r, const gyro_log *gyro, int refused, calibrate_result *result);

/* The accelerometer is in its final frame, which differs from that of the moves: turns the gyroscope to it. */
void calibrate_gyro_turn(calibrate_result *result);

#endif
