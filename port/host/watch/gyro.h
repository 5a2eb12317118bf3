/* SPDX-License-Identifier: MIT
 *
 * watch/gyro.h: judges a gyroscope in the stream by the moves so far.
 */
#ifndef WATCH_GYRO_H
#define WATCH_GYRO_H

#include "fit/gyro.h"

#define WATCH_GYRO_MAX 200

/* Judges it again, once there are enough rests; takes some milliseconds.
 *
 * text  out: "gyroscope: 7 moves; scale ± 0.1 %, cross ± 0.06 degrees", or what is wrong with it; "": nothing yet.
 *
 * Returns 1 if both sensors are determined, and further moves confirm it. */
int watch_gyro(const turns *t, const gyro_wish *wish, unsigned rate, const double *clip,
               const positions *p, const invcal_calibration *start, char text[WATCH_GYRO_MAX]);

#endif
