/* SPDX-License-Identifier: MIT
 *
 * calibrate/calibrate.h: what `invcal calibrate` and `invcal watch` share: from positions to a
 * calibration.
 */
#ifndef CALIBRATE_H
#define CALIBRATE_H

#include "calibrate/request.h"
#include "read/log_rests.h"
#include "read/magnetometer_log.h"

/* Reads positions; `log` describes the log that they were found in, `gyro` holds the readings of a
 * gyroscope in it. Returns an exit code. */
typedef int positions_reader(const request *r, positions *data, rests_summary *log, gyro_log *gyro);

/* The same for a magnetometer that is waved. */
typedef int magnetometer_reader(const request *r, const invcal_calibration *nominal,
                                positions *data, magnetometer_log *log);

typedef struct {
    positions_reader *rests;
    magnetometer_reader *magnetometer;
} calibrate_readers;

/* Runs the command: reads its command line and the positions, writes the result. Returns its exit
 * code. */
int calibrate_run(int argc, char **argv, int is_live, const calibrate_readers *read);

#endif
