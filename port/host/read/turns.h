/* SPDX-License-Identifier: MIT
 *
 * read/turns.h: all readings of a gyroscope logged with the accelerometer: the moves can be made only when it is
 * known which rests count.
 *
 * The readings are columns of the log itself, or of a separate file with the same clock or as many rows.
 */
#ifndef TURNS_H
#define TURNS_H

#include <stdint.h>

#include "read/samples.h"

/* One sample of the accelerometer. */
typedef struct {
    double time;    /* seconds, if the log has times */
    int32_t raw[3]; /* counts, as in samples.h */
    uint32_t upto;  /* readings of the gyroscope up to its time */
    int is_gap;     /* samples were lost before it */
} turns_sample;

/* One of the gyroscope. */
typedef struct {
    double x[3]; /* input units */
    int is_gap;
} turns_reading;

typedef struct turns {
    turns_sample *sample;
    turns_reading *reading;
    size_t samples, readings;
    double unit;        /* input units of one count of raw */
    double rate;        /* readings per second, */
    int is_rate_known;  /* else it is a guess */
    const char *file;   /* separate file, to be set before; null: they are columns of the log */
    recognition seen;   /* how that was read */
    double turn;        /* rad/s in one unit, as the headings state it; 0: they do not */
    double steps, time; /* internal: of the readings' clock without gaps */
    double last;
    int has_time;
} turns;

void turns_begin(turns *t, const samples *log);

/* Adds a sample of the log, with its reading if the log has them. EXIT_GOOD; EXIT_FILE, with a message,
 * without memory. */
int turns_add(turns *t, const samples *log, const sample *s);

/* After the last reading: completes the rate. */
void turns_end(turns *t);

/* Reads the separate file into `file`, which is large and uninitialized. EXIT_GOOD; EXIT_FILE, with a message. */
int turns_read(turns *t, samples *file, double rate, const char *log);

void turns_free(turns *t);

#endif
