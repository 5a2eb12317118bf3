/* SPDX-License-Identifier: MIT
 *
 * samples.h: the samples of a log as the library takes them: integers.
 *
 * A log of counts is taken as it is. One of decimals is scaled by the power of ten that makes all
 * its numbers whole (9.80665 is 980665 of 1e-5); one that has none, by a power of two that leaves
 * room for 64 times the first readings. The first lines decide.
 */
#ifndef SAMPLES_H
#define SAMPLES_H

#include <stdint.h>

#include "columns.h"

#define SAMPLES_AHEAD 256u /* lines that decide */

typedef struct {
    int32_t raw[3]; /* value / unit, rounded; beyond an int32 the nearest */
    double time;    /* seconds, if there is a column */
    double temperature;
    unsigned long line;
    int is_gap; /* time has gone back, or on by more than 4 periods and a tenth of a second */
} sample;

typedef struct {
    table table;
    columns where;
    double unit; /* input units of one count */
    double rate; /* samples a second */
    int has_time;
    int has_temperature;
    int is_rate_known; /* given, or told by the times; else rate is a guess */
    /* inside */
    double ahead[SAMPLES_AHEAD][5]; /* x y z, time, temperature */
    unsigned long ahead_line[SAMPLES_AHEAD];
    unsigned ahead_count;
    unsigned next;
    double last_time;
    int times_are_seconds;
    unsigned long count;
} samples;

/* Opens a log ("-": standard input).
 *
 * rate  samples a second, or 0: the times tell (the middle of their steps), or 100.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if it is unreadable or malformed, holds no
 * sample, or the times do not tell a rate within 1 ... 1e5. The structure is large and must not
 * be moved. To be closed with samples_close in either case. */
int samples_open(samples *s, const char *path, double rate);

/* The next sample. Returns 1; 0 at the end; -1, with a message, for a malformed line. */
int samples_next(samples *s, sample *out);

void samples_close(samples *s);

#endif
