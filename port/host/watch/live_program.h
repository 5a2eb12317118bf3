/* SPDX-License-Identifier: MIT
 *
 * watch/live_program.h: following a program while the samples come in: at which of its positions each rest was,
 * what is to be next, and what is said of it.
 */
#ifndef LIVE_PROGRAM_H
#define LIVE_PROGRAM_H

#include <stddef.h>

#include "read/positions.h"
#include "design/program.h"

#define LIVE_PROGRAM_FOLLOWED                                                                      \
    3u /* positions of a program that determine zero and scale, if they are these */

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

/* The session has taken a rest. All of them are looked at again, with what is known so far: the calibration
 * so far may think otherwise of where the first ones were. Returns 1 if the program is complete by it. */
int live_program_take(live_program *l);

/* Zero and scale of the readings, input units, from the positions taken if they are the first of the
 * program: three or more. Returns 1 if that zero is far from 0. */
int live_program_scale(const live_program *l, double zero[3], double *length);

/* The program as it will be once the rest that is READY and still held has been taken: until the next
 * call. */
const program *live_program_foreseen(const live_program *l);

/* A rest is good and still held: "good: move on to alpha 90, beta 0 deg", with a word if it is not the one
 * asked for. Returns text. */
const char *live_program_good_text(const live_program *l, const program *soon, char *text,
                                   size_t size);

/* Where the last rest was, if it was not where it was asked to be; else "". Returns text. */
const char *live_program_wrong_text(const live_program *l, char text[PROGRAM_TEXT_MAX]);

/* Which positions have not been visited; "" if all have. Returns text. */
const char *live_program_missing_text(const live_program *l, char text[PROGRAM_TEXT_MAX]);

#endif
