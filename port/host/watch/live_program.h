/* SPDX-License-Identifier: MIT
 *
 * watch/live_program.h: follows a program of positions while the samples come in: the position of
 * each rest, the next one, and texts about both.
 */
#ifndef LIVE_PROGRAM_H
#define LIVE_PROGRAM_H

#include <stddef.h>

#include "read/positions.h"
#include "design/program.h"

/* Positions that determine zero and scale, if they are the first of the program. */
#define LIVE_PROGRAM_FOLLOWED 3u

typedef struct {
    program program;
    const invcal_session *session; /* in counts */
    const positions *taken;        /* its positions, in input units */
    double unit;                   /* input units per count */
    int is_zero_stated;            /* zero or scale of the readings is stated */
    unsigned requested;            /* the position requested before the last rest */
    unsigned wrong_count; /* number of consecutive rests, up to the last, at other positions */
} live_program;           /* large: not for the stack */

/* Begins with the first position. Keeps the pointers. */
void live_program_begin(live_program *l, const design *set, const invcal_session *session,
                        const positions *taken, double unit, int is_zero_stated);

/* The session has taken a rest. Finds the positions of all rests again, since with a better
 * calibration those of the first ones may differ. Returns 1 if this rest completes the program. */
int live_program_take(live_program *l);

/* Zero and scale of the readings, input units, from three or more positions, if they are the first
 * of the program. Returns 1 if that zero is far from 0. */
int live_program_scale(const live_program *l, double zero[3], double *length);

/* The program after the current rest, which is READY, will have been taken. Valid until the next
 * call. */
const program *live_program_predicted(const live_program *l);

/* The current rest is READY: "good: move on to alpha 90, beta 0 deg", with a note if it is not at
 * the requested position. Returns text. */
const char *live_program_good_text(const live_program *l, const program *soon, char *text,
                                   size_t size);

/* Where the last rest was, if it was not at the requested position; else "". Returns text. */
const char *live_program_wrong_text(const live_program *l, char text[PROGRAM_TEXT_MAX]);

/* The positions that have not been visited; "" if all have. Returns text. */
const char *live_program_missing_text(const live_program *l, char text[PROGRAM_TEXT_MAX]);

#endif
