/* SPDX-License-Identifier: MIT
 *
 * read/waved.h: the log of a magnetometer that is waved, not held still.
 */
#ifndef WAVED_H
#define WAVED_H

#include "invcal/magnetometer.h"
#include "read/positions.h"
#include "read/samples.h"

/* The readings at an instant, input units. */
typedef struct {
    double up[3]; /* of the accelerometer, NaN if there is none */
    double field[3];
} waved_instant;

typedef struct {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    invcal_status status;           /* what follows is valid if this is INVCAL_OK */
    invcal_calibration calibration; /* of input units, over the field */
    invcal_quality quality;
    invcal_magnetometer_found found; /* the field in the unit of nominal */
    double sample_rms;      /* of the lengths of all accepted samples, calibrated, less 1 */
    double next[3];         /* direction of the case that should point along the field next */
    waved_instant *instant; /* of each accepted sample; */
    unsigned long instants; /* their number, */
    unsigned long room;     /* and the number that memory holds */
} waved;

/* What a listener learns of each sample. */
typedef struct {
    const invcal_magnetometer *magnetometer; /* which has been fed it */
    const samples *log;
    const sample *latest;
    const double *raw;  /* input units */
    invcal_event event; /* what invcal_magnetometer_feed said */
} waved_moment;
typedef void waved_listener(const waved_moment *at, void *who);

typedef struct {
    const char *path;                  /* "-": the standard input */
    double rate;                       /* as samples_open takes it */
    const invcal_calibration *nominal; /* of input units, to any unit */
    int is_live;                       /* a stream */
    waved_listener *listen;            /* null: none */
    void *who;
} waved_wish;

/* Reads a log; x, y and z are those of a magnetometer if it has one.
 *
 * p    out: the cells as positions, if there is a solution; else none. Release them with positions_free in
 *      either case. Their line is that of the first sample.
 * out  release it with waved_free in either case.
 *
 * Returns EXIT_GOOD, also without a solution; EXIT_FILE, with a message. */
int waved_read(positions *p, const waved_wish *wish, waved *out);

void waved_free(waved *log);

#endif
