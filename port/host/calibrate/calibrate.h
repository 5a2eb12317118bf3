/* SPDX-License-Identifier: MIT
 *
 * calibrate/calibrate.h: positions in, a calibration out, wherever the positions come from.
 */
#ifndef CALIBRATE_H
#define CALIBRATE_H

#include "calibrate/request.h"
#include "read/rests.h"
#include "read/magnetometer_log.h"

/* Reads positions; `log` is what they were found in, `gyro` what a gyroscope
 * read meanwhile. Returns an exit code. */
typedef int positions_reader(const request *r, positions *data, rests_summary *log, gyro_log *gyro);

/* The same of a magnetometer that is waved. */
typedef int waved_reader(const request *r, const invcal_calibration *nominal, positions *data,
                         magnetometer_log *log);

typedef struct {
    positions_reader *rests;
    waved_reader *waved;
} calibrate_readers;

/* A whole command: its line, the positions, the result. Returns its exit code. */
int calibrate_run(int argc, char **argv, int is_live, const calibrate_readers *read);

#endif
