/* SPDX-License-Identifier: MIT
 *
 * calibrate/calibrate.h: positions in, a calibration out, wherever the positions come from.
 */
#ifndef CALIBRATE_H
#define CALIBRATE_H

#include "calibrate/request.h"
#include "read/rests.h"

/* Reads positions; `log` tells what they were found in, `gyro` what a gyroscope
 * read meanwhile. Returns an exit code. */
typedef int positions_reader(const request *r, positions *data, rests_summary *log, turns *gyro);

/* A whole command: its line, the positions, the result. Returns its exit code. */
int calibrate_run(int argc, char **argv, int is_live, positions_reader *read);

#endif
