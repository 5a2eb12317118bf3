/* SPDX-License-Identifier: MIT
 *
 * read/samples.h: reads the samples of a log as integers, as the library needs them.
 *
 * One count is a power of two of input units, at most 1. Counts can hold 512 times the largest of
 * the first readings; integers are exact, and decimals are rounded to a four millionth of that
 * reading.
 */
#ifndef SAMPLES_H
#define SAMPLES_H

#include <stdint.h>

#include "read/columns.h"

#define SAMPLES_RATE_MIN 8 /* samples per second at which rests are found */
#define SAMPLES_RATE_MAX 8000

#define SAMPLES_AHEAD 256u     /* lines read ahead to find unit and rate */
#define SAMPLES_AHEAD_LIVE 32u /* the same of a live stream */
#define SAMPLES_PAUSE 60.0     /* seconds: a longer time step is an error of the clock */

/* Of a row: x y z, time, temperature, alpha, beta, x y z of another accelerometer, of a
 * gyroscope. */
enum { SAMPLES_NUMBERS = 13 };

typedef struct {
    int32_t raw[3]; /* value / unit, rounded; saturated beyond an int32 */
    double time;    /* seconds, if there is a column */
    double clock;   /* seconds from the first sample; steps that are negative or above SAMPLES_PAUSE
                     * count as one sample */
    double temperature;
    double angle[2];         /* alpha and beta of a stand, degrees; NaN: not known */
    double accelerometer[3]; /* next to a magnetometer, input units; NaN: not known */
    double gyro[3];          /* if there is one, input units */
    unsigned long line;
    int is_gap; /* before it time went back or jumped, or lines were skipped */
} sample;

typedef struct {
    table table;
    columns where;
    double unit; /* input units of one count */
    double rate; /* samples per second */
    int has_time;
    int has_temperature; /* so far, see temperature.h */
    int has_gyro;
    int has_angles;    /* there are columns alpha and beta */
    int is_rate_known; /* given, or from the times; else rate is a guess */
    /* internal */
    double ahead[SAMPLES_AHEAD][SAMPLES_NUMBERS];
    unsigned long ahead_line[SAMPLES_AHEAD];
    unsigned ahead_count;
    unsigned next;
    double last_time;
    double clock;
    unsigned long count;
    unsigned long gaps;
    unsigned long skipped; /* malformed lines of a live stream; of a file a cut first or last one */
    double step_max;       /* the longest time step that is not a gap */
    columns_kind kind;
    int is_live;
    int is_broken; /* the line before was skipped */
} samples;

/* Opens a log ("-": standard input).
 *
 * kind  any but COLUMNS_POSITIONS.
 * rate  samples per second; 0: by the times (their mean or median step), or else 100.
 * live  0: a malformed line is an error, but a cut first or last one is reported and ignored. 1: a
 *       stream; malformed lines are reported, skipped and counted as gaps, up to a hundred in a
 *       row, and if the first line was cut, the second determines the columns.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if it is unreadable or malformed, holds no samples,
 * or the times give no rate within 8 ... 8000. The structure is large and must not be moved. Close
 * it with samples_close in either case. */
int samples_open(samples *s, const char *path, columns_kind kind, double rate, int live);

/* The rate rounded to whole samples per second, as the library needs it. */
unsigned samples_whole_rate(const samples *s);

/* A reading in counts, saturated beyond an int32. */
int32_t samples_count(const samples *s, double value);

/* The next sample. Returns 1; 0 at the end; -1, with a message, for a malformed line. */
int samples_next(samples *s, sample *out);

void samples_close(samples *s);

#endif
