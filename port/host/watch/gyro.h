/* SPDX-License-Identifier: MIT
 *
 * watch/gyro.h: what the moves so far tell of a gyroscope in the stream.
 */
#ifndef WATCH_GYRO_H
#define WATCH_GYRO_H

#include "fit/gyro.h"

#define WATCH_GYRO_MAX 200

/* Judges it anew, once there are rests enough; takes some milliseconds.
 *
 * text  out: "gyroscope: 7 moves; scale ± 0.1 %, cross ± 0.06 degrees", or what is wrong with it; "": nothing yet.
 *
 * Returns 1 if both sensors are determined, and moves to spare confirm it. */
int watch_gyro(const turns *t, const gyro_wish *wish, unsigned rate, const double *clip,
               const positions *p, const invcal_calibration *start, char text[WATCH_GYRO_MAX]);

#endif
