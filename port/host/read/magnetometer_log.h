/* SPDX-License-Identifier: MIT
 *
 * read/magnetometer_log.h: reads the log of a magnetometer that is waved, not held still.
 */
#ifndef MAGNETOMETER_LOG_H
#define MAGNETOMETER_LOG_H

#include "invcal/magnetometer.h"
#include "read/positions.h"
#include "read/samples.h"

/* The readings of an instant, input units. */
typedef struct {
    double up[3]; /* of the accelerometer; NaN: there is none */
    double field[3];
} magnetometer_instant;

typedef struct {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    invcal_status status;           /* the members below are valid if this is INVCAL_OK */
    invcal_calibration calibration; /* from input units to readings over the field */
    invcal_quality quality;
    invcal_magnetometer_found found; /* the field in the unit of nominal */
    double sample_rms;               /* of |calibrated| - 1 over all accepted samples */
    double next[3]; /* direction of the case that should point along the field next */
    magnetometer_instant *instant; /* of each accepted sample */
    unsigned long instants;
    unsigned long capacity;
} magnetometer_log;

/* What the listener gets for each sample. */
typedef struct {
    const invcal_magnetometer *magnetometer; /* after it was fed */
    const samples *log;
    const sample *latest;
    const double *raw;  /* input units */
    invcal_event event; /* as returned by invcal_magnetometer_feed */
} magnetometer_moment;
typedef void magnetometer_listener(const magnetometer_moment *at, void *context);

typedef struct {
    const char *path;                  /* "-": the standard input */
    double rate;                       /* as samples_open takes it */
    const invcal_calibration *nominal; /* from input units to any unit */
    int is_live;                       /* the log is a live stream */
    magnetometer_listener *listen;     /* null: none */
    void *context;
} magnetometer_log_options;

/* Reads and solves a log; x, y and z are those of the magnetometer if the header names two sensors.
 *
 * p    out: the cells as positions, if there is a solution; else none. Release it with
 *      positions_free in either case. Their line is that of the first sample.
 * out  Release it with magnetometer_log_free in either case.
 *
 * Returns EXIT_GOOD, also without a solution; EXIT_FILE, with a message. */
int magnetometer_log_read(positions *p, const magnetometer_log_options *options,
                          magnetometer_log *out);

void magnetometer_log_free(magnetometer_log *log);

#endif
