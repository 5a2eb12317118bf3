/* SPDX-License-Identifier: MIT
 *
 * watch/gyro.h: judges a gyroscope in the stream by the moves so far, and finds the turn that would add most.
 */
#ifndef WATCH_GYRO_H
#define WATCH_GYRO_H

#include "design/turn_words.h"
#include "fit/gyro.h"

#define WATCH_GYRO_MAX 200

/* What is known so far; all zero at first. */
typedef struct {
    char text
        [WATCH_GYRO_MAX]; /* "gyroscope: 7 of 8 moves; scale ± 0.1 %, cross ± 0.06 degrees", or what is wrong
                                  with it; "": nothing yet */
    char refused[WATCH_GYRO_MAX]; /* moves that do not count, and why, if that is new; else "" */
    int is_mistake;               /* something is wrong that more moves do not mend */
    int is_good;                  /* both sensors are determined, and further moves confirm it */
    int has_turns;
    invcal_turns turns; /* rests and moves so far */
    unsigned known[INVCAL_MAX_MOVES +
                   1]; /* positions that moves which do not count led to; 0 ends them */
} watch_gyro;

/* A rest was taken: judges it again, once there are enough rests; takes some milliseconds.
 *
 * up  unit vector that points up in the last rest. */
void watch_gyro_take(watch_gyro *w, const gyro_log *t, const gyro_options *options, unsigned rate,
                     const double *clip, const positions *p, const invcal_calibration *start,
                     const double up[3]);

/* The turn that adds most. held: unit vector that points up in a rest that is not taken yet; or null. From near a face,
 * an edge or a corner it is that from there.
 *
 * Returns 1; 0: nothing is known of turns, or they are no use. */
int watch_gyro_next(const watch_gyro *w, const double *held, double target[3],
                    char text[TURNS_WORDS_MAX]);

#endif
