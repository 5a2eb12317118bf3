/* SPDX-License-Identifier: MIT
 *
 * watch/live_program.h: following a program while the samples come in: at which of its positions each rest was,
 * what is to be next, and what is said of it.
 */
#ifndef LIVE_PROGRAM_H
#define LIVE_PROGRAM_H

#include <stdio.h>

#include "read/positions.h"
#include "design/program.h"

typedef struct {
    program now;
    const invcal_session *session; /* in counts, */
    const positions *taken;        /* what it has taken, input units, */
    double unit;                   /* and what a count is of these */
    int is_zero_stated;            /* zero and scale of the readings, or one of them */
    unsigned wanted;               /* the position that was asked for before the last rest */
    unsigned astray;               /* rests in a row at the last that were not those asked for */
} live_program;                    /* large: not for the stack */

/* Begins with the first position. What is handed over is kept and read. */
void live_program_begin(live_program *l, const design *set, const invcal_session *session,
                        const positions *taken, double unit, int is_zero_stated);

/* The session has taken a rest. All of them are looked at again, with what is known by now: the calibration
 * so far may think otherwise of where the first ones were. Returns 1 if the program is complete by it. */
int live_program_take(live_program *l);

/* Zero and scale of the readings, input units, as the positions taken tell them if they are the first of the
 * program: three or more. Returns 1 if that zero is far from 0. */
int live_program_scale(const live_program *l, double zero[3], double *length);

/* A rest is good and still held: "good: move on to alpha 90, beta 0 deg", with a word if it is not the one
 * asked for. No end of line. */
void live_program_say_good(const live_program *l, FILE *talk);

/* If the last rest was not where it was asked to be: where it was, and what may be wrong. */
void live_program_say_wrong(const live_program *l, FILE *talk);

/* Which positions have not been visited, if any. */
void live_program_say_missing(const live_program *l, FILE *talk);

#endif
