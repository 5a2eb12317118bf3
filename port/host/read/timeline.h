/* SPDX-License-Identifier: MIT
 *
 * read/timeline.h: a log of any length as its outline, for a picture: what the least and the greatest
 * readings were in each of some thousand equal stretches of time. One pass, fixed memory: when the
 * last stretch is full, each two become one.
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
    unsigned bins;     /* so many are in use */
    double width;      /* of a bin, seconds */
    double duration;   /* up to the last sample, seconds */
    unsigned refusals; /* rests that were refused: when (the first TIMELINE_EVENTS of them) */
    double refused[TIMELINE_EVENTS];
} timeline;

/* Begins one of a log that is sampled so many times a second. */
void timeline_begin(timeline *t, double rate);

/* A sample at `time` seconds from the first, not before the one before. */
void timeline_add(timeline *t, double time, const double value[TIMELINE_TRACES]);

/* A rest was refused, at the latest sample. */
void timeline_refuse(timeline *t);

/* The least and the greatest value of a trace in bins from ... to - 1. Returns 0 if no sample is
 * in them. */
int timeline_range(const timeline *t, unsigned trace, unsigned from, unsigned to, double *low,
                   double *high);

#endif
