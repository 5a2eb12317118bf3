/* SPDX-License-Identifier: MIT
 *
 * read/samples.h: the samples of a log as the library takes them: integers.
 *
 * One count is a power of two of input units, 1 or less, with room for 512 times the largest of
 * the first readings: whole numbers are exact, decimals are kept to a four millionth of it.
 */
#ifndef SAMPLES_H
#define SAMPLES_H

#include <stdint.h>

#include "read/columns.h"

#define SAMPLES_RATE_MIN 8 /* samples per second in which rests are found */
#define SAMPLES_RATE_MAX 8000

#define SAMPLES_AHEAD 256u     /* lines that decide, */
#define SAMPLES_PAUSE 60.0     /* seconds that a log may pause and go on */
#define SAMPLES_AHEAD_LIVE 32u /* of a live stream */

enum {
    SAMPLES_NUMBERS = 13
}; /* of a row: x y z, time, temperature, alpha, beta, x y z aside, gyroscope */

typedef struct {
    int32_t raw[3]; /* value / unit, rounded; beyond an int32 the nearest */
    double time;    /* seconds, if there is a column */
    double clock;   /* seconds from the first sample on; steps that are none, or of more than
                       SAMPLES_PAUSE, count as one sample */
    double temperature;
    double angle[2]; /* alpha and beta of a stand, degrees; NaN: not known */
    double aside[3]; /* the accelerometer next to a magnetometer, as it reads; NaN: not known */
    double gyro[3];  /* if there is one, input units */
    unsigned long line;
    int is_gap; /* time has gone back or jumped, or lines were skipped */
} sample;

typedef struct {
    table table;
    columns where;
    double unit; /* input units of one count */
    double rate; /* samples per second */
    int has_time;
    int has_temperature; /* so far: see temperature.h */
    int has_gyro;
    int has_angles;    /* there are columns alpha and beta */
    int is_rate_known; /* given, or from the times; else rate is a guess */
    /* inside */
    double ahead[SAMPLES_AHEAD][SAMPLES_NUMBERS];
    unsigned long ahead_line[SAMPLES_AHEAD];
    unsigned ahead_count;
    unsigned next;
    double last_time;
    double clock;
    unsigned long count;
    unsigned long gaps;
    unsigned long skipped; /* malformed lines of a live stream; else a first or last that is cut */
    double longest;        /* step of time that is none */
    columns_kind kind;     /* of its columns */
    int is_live;
    int is_broken; /* a line has been skipped just now */
} samples;

/* Opens a log ("-": standard input).
 *
 * kind  COLUMNS_LOG, COLUMNS_IMU with a gyroscope's columns, if there are some, or COLUMNS_GYRO.
 * live  0: a malformed line is an error, but a first or last one that is cut is reported and left out. 1: a stream that goes on whatever comes; malformed lines
 *       are reported, skipped and counted as gaps, up to a hundred in a row, and if the first line was
 *       cut, the second decides about the columns.
 * rate  samples per second, or 0: from the times (their mean or median step), or 100.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if it is unreadable or malformed, holds no
 * sample, or the times give no rate within 8 ... 8000. The structure is large and must not
 * be moved. To be closed with samples_close in either case. */
int samples_open(samples *s, const char *path, columns_kind kind, double rate, int live);

/* The rate in whole samples per second, as the library wants it. */
unsigned samples_whole_rate(const samples *s);

/* A reading in counts; beyond an int32 the nearest. */
int32_t samples_count(const samples *s, double value);

/* The next sample. Returns 1; 0 at the end; -1, with a message, for a malformed line. */
int samples_next(samples *s, sample *out);

void samples_close(samples *s);

#endif
