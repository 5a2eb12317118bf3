/* SPDX-License-Identifier: MIT
 *
 * read/recording.h: what is kept of a log besides its rests, in fixed memory: where in the file and
 * when each block of invcal_rests began (where samples were lost or lines skipped, counting is
 * not enough), and its outline.
 */
#ifndef RECORDING_H
#define RECORDING_H

#include "invcal/expert.h"
#include "read/samples.h"
#include "read/timeline.h"

#define RECORDING_BLOCKS 16384u /* the last ones, half an hour */

typedef struct {
    unsigned long line; /* of the first sample */
    double clock;
    double temperature; /* sums over its samples */
    double sum[3];      /* counts */
    double angle[2];    /* of the stand, at its first sample */
} recording_block;

typedef struct {
    recording_block block[RECORDING_BLOCKS];
    unsigned long blocks; /* full ones so far */
    recording_block open; /* the one that is being filled, */
    unsigned fill;        /* and its samples so far */
    unsigned size;        /* samples of a block; 0: not known yet */
    int has_temperature;
    int32_t before[3]; /* the last sample, */
    double quantum;    /* and the smallest step of any axis from one to the next; 0: none yet */
    timeline outline;
} recording; /* large: not for the stack */

/* Where and when a rest was. */
typedef struct {
    unsigned long line; /* of its first sample */
    double begin;       /* seconds from the first sample of the log */
    double end;
    double temperature; /* mean; NaN: not known */
    double drift;       /* of temperature from begin to end, K without sign, by the straight line
                           through its blocks: a thermometer's noise is no drift */
    double angle[2];    /* alpha and beta of the stand, degrees; NaN: not known, or they changed */
    double variance[3]; /* of its mean, counts^2, from its blocks: tremor is no white noise */
} recording_place;

void recording_begin(recording *r, const samples *log);

/* Before each sample is fed; after each that has filled a block. */
void recording_sample(recording *r, const samples *log, const sample *s);
void recording_filled(recording *r);

/* Blocks that are remembered, from the oldest on, and the mean of one: input units if a count is `unit`
 * of them. */
typedef struct {
    double time;        /* of its middle, seconds from the first sample of the log */
    double temperature; /* NaN: not known */
    double mean[3];
} recording_mean;
unsigned recording_count(const recording *r);
recording_mean recording_at(const recording *r, unsigned block, double unit);

recording_place recording_find(const recording *r, const invcal_rest *rest);

#endif
