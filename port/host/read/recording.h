/* SPDX-License-Identifier: MIT
 *
 * read/recording.h: what is kept of a log besides its rests, in fixed memory: line and time at
 * which each block of the detector began (they cannot be computed if samples were lost or lines
 * skipped), and the outline.
 */
#ifndef RECORDING_H
#define RECORDING_H

#include "read/samples.h"
#include "read/timeline.h"
#include "session/rests.h"

#define RECORDING_BLOCKS 16384u /* the last ones, half an hour */

typedef struct {
    unsigned long line; /* of the first sample */
    double clock;
    double temperature; /* sums over its samples */
    double sum[3];      /* counts */
    double angle[2];    /* of the stand, at the first sample */
} recording_block;

typedef struct {
    recording_block block[RECORDING_BLOCKS];
    unsigned long blocks; /* full ones so far */
    recording_block open; /* the one that is being filled */
    unsigned fill;        /* samples in it so far */
    unsigned size;        /* samples of a block; 0: not known yet */
    int has_temperature;
    int32_t before[3]; /* the last sample */
    double quantum;    /* smallest step of any axis between consecutive samples; 0: none yet */
    timeline outline;
} recording; /* large: not for the stack */

/* Place and time of a rest. */
typedef struct {
    unsigned long line; /* of its first sample */
    double begin;       /* seconds from the first sample of the log */
    double end;
    double temperature; /* mean; NaN: not known */
    double drift;       /* of temperature from begin to end, K, absolute, by a straight line through
                         * the blocks, which a thermometer's noise hardly affects */
    double angle[2];    /* alpha and beta of the stand, degrees; NaN: not known, or they changed */
    double variance[3]; /* of the mean, counts^2, from block means, as tremor is not white noise */
} recording_place;

void recording_begin(recording *r, const samples *log);

/* To be called before each sample is fed; and after each that has filled a block. */
void recording_sample(recording *r, const samples *log, const sample *s);
void recording_filled(recording *r);

/* The number of blocks in memory, from the oldest on, and the mean of one in input units; a count
 * is `unit` of them. */
typedef struct {
    double time;        /* of the middle, seconds from the first sample of the log */
    double temperature; /* NaN: not known */
    double mean[3];
} recording_mean;
unsigned recording_count(const recording *r);
recording_mean recording_at(const recording *r, unsigned block, double unit);

recording_place recording_find(const recording *r, const invcali_rest *rest);

#endif
