/* SPDX-License-Identifier: MIT
 *
 * read/gyro_log.h: all readings of a gyroscope that was logged with an accelerometer, kept in
 * memory: moves can be integrated only once it is known which rests are used.
 *
 * The readings are columns of the log itself, or of a separate file with the same clock or the same
 * number of rows.
 */
#ifndef GYRO_LOG_H
#define GYRO_LOG_H

#include <stdint.h>

#include "read/samples.h"

/* A sample of the accelerometer. */
typedef struct {
    double time;          /* seconds, if the log has times */
    int32_t raw[3];       /* counts, as in samples.h */
    uint32_t reading_end; /* index of the first reading of the gyroscope after it */
    int is_gap;           /* samples were lost before it */
} gyro_log_sample;

/* A reading of the gyroscope. */
typedef struct {
    double x[3]; /* input units */
    int is_gap;
} gyro_log_reading;

typedef struct gyro_log {
    gyro_log_sample *sample;
    gyro_log_reading *reading;
    size_t samples, readings;
    double unit;        /* input units of one count of raw */
    double rate;        /* readings per second */
    int is_rate_known;  /* else rate is a guess */
    const char *file;   /* separate file, set by the caller; null: columns of the log */
    recognition seen;   /* how the columns of that file were understood */
    double rate_unit;   /* rad/s in one input unit, by the headings; 0: not stated */
    double steps, time; /* internal: of the readings' clock, without gaps */
    double last;
    int has_time;
} gyro_log;

void gyro_log_begin(gyro_log *g, const samples *log);

/* Adds a sample of the log, with its reading unless there is a separate file. EXIT_GOOD; EXIT_FILE,
 * with a message, if memory is short. */
int gyro_log_add(gyro_log *g, const samples *log, const sample *s);

/* After the last reading: improves the rate. */
void gyro_log_end(gyro_log *g);

/* Reads the separate file, with `file` as working memory; it is large, and need not be initialised.
 * EXIT_GOOD; EXIT_FILE, with a message. */
int gyro_log_read(gyro_log *g, samples *file, double rate, const char *log);

void gyro_log_free(gyro_log *g);

#endif
