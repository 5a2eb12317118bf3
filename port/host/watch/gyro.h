/* SPDX-License-Identifier: MIT
 *
 * watch/gyro.h: the calibration of a gyroscope in the stream so far, and the most informative next
 * turn.
 */
#ifndef WATCH_GYRO_H
#define WATCH_GYRO_H

#include "design/turn_words.h"
#include "fit/gyro.h"

#define WATCH_GYRO_MAX 200

/* All zero at first. */
typedef struct {
    /* "gyroscope: 7 of 8 moves; scale ± 0.1 %, cross ± 0.06 degrees"; or an error; or "" */
    char text[WATCH_GYRO_MAX];
    char refused[WATCH_GYRO_MAX]; /* newly refused moves, and why; else "" */
    int is_mistake;               /* there is an error that more moves do not correct */
    int is_good;                  /* both sensors are determined, and further moves confirm it */
    int has_turns;
    invcali_turns turns; /* rests and moves so far */
    /* positions after refused moves that have been reported; ends with 0 */
    unsigned reported[INVCAL_MAX_MOVES + 1];
} watch_gyro;

/* A rest was taken: evaluates all, once there are enough rests; takes some milliseconds.
 *
 * up  unit vector that points up in the last rest. */
void watch_gyro_take(watch_gyro *w, const gyro_log *t, const gyro_options *options, unsigned rate,
                     const double *clip, const positions *p, const invcal_calibration *start,
                     const double up[3]);

/* The most informative turn. held: unit vector that points up in the current rest, not taken yet;
 * or null. A direction near a face, an edge or a corner is replaced by that.
 *
 * Returns 1; 0: no turns are known, or there is an error that they do not correct. */
int watch_gyro_next(const watch_gyro *w, const double *held, double target[3],
                    char text[TURNS_WORDS_MAX]);

#endif
