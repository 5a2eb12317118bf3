/* SPDX-License-Identifier: MIT
 *
 * read/timeline.h: the outline of a log of any length, for a picture: the smallest and the largest
 * reading in each of one to two thousand bins of equal duration. One pass, fixed memory: when the
 * last bin is full, pairs are merged.
 */
#ifndef TIMELINE_H
#define TIMELINE_H

#define TIMELINE_BINS 2048u
#define TIMELINE_TRACES 4u /* x y z, temperature */
#define TIMELINE_EVENTS 64u

typedef struct {
    float low[TIMELINE_TRACES]; /* above high where there is no sample */
    float high[TIMELINE_TRACES];
} timeline_bin;

typedef struct {
    timeline_bin bin[TIMELINE_BINS];
    unsigned bins;                   /* in use */
    double width;                    /* of a bin, seconds */
    double duration;                 /* up to the last sample, seconds */
    unsigned refusals;               /* number of refused rests, at most TIMELINE_EVENTS, */
    double refused[TIMELINE_EVENTS]; /* and when, seconds */
} timeline;

/* Begins the outline of a log with `rate` samples per second. */
void timeline_begin(timeline *t, double rate);

/* Adds a sample at `time` seconds from the first; time must not decrease. */
void timeline_add(timeline *t, double time, const double value[TIMELINE_TRACES]);

/* Notes a refused rest at the latest sample. */
void timeline_refuse(timeline *t);

/* The smallest and the largest value of a trace in bins from ... to - 1. Returns 0 if they hold no
 * sample. */
int timeline_range(const timeline *t, unsigned trace, unsigned from, unsigned to, double *low,
                   double *high);

#endif
