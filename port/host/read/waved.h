/* SPDX-License-Identifier: MIT
 *
 * read/waved.h: the log of a magnetometer that is waved, not held still.
 */
#ifndef WAVED_H
#define WAVED_H

#include "invcal/magnetometer.h"
#include "read/positions.h"

/* What the accelerometer beside it and the magnetometer itself read at an instant, input units. */
typedef struct {
    double up[3];
    double field[3];
} waved_pair;

typedef struct {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    invcal_status status;           /* of what is below: it is there if this is INVCAL_OK */
    invcal_calibration calibration; /* of input units, over the field */
    invcal_quality quality;
    invcal_magnetometer_found found; /* the field in the unit of nominal */
    double next[3];                  /* way of the case that is to point along the field next */
    waved_pair *pair;                /* where there is an accelerometer, else null; */
    unsigned long pairs;             /* so many, */
    unsigned long room;              /* in memory for so many */
} waved;

/* Reads a log ("-": standard input), of which x, y and z are a magnetometer's where there is one.
 *
 * nominal  of input units, to any unit.
 * p        out: the cells as positions, if there is a solution; else none. To be released with positions_free in
 *          either case. Their lines are that of the first sample.
 *
 * out      to be released with waved_free in either case.
 *
 * Returns EXIT_GOOD, also without a solution; EXIT_FILE, with a message. */
int waved_read(positions *p, const char *path, double rate, const invcal_calibration *nominal,
               waved *out);

void waved_free(waved *log);

#endif
