/* SPDX-License-Identifier: MIT
 *
 * recording.h: what is remembered of a log beside its rests, in fixed memory: where in the file and
 * when each block of invcal_rests began (where samples were lost or lines skipped, counting does
 * not tell), and its outline.
 */
#ifndef RECORDING_H
#define RECORDING_H

#include "invcal/expert.h"
#include "samples.h"
#include "timeline.h"

#define RECORDING_BLOCKS 16384u /* the last ones, half an hour */

typedef struct {
    unsigned long line; /* of the first sample */
    double clock;
    double temperature; /* sum over its samples */
} recording_block;

typedef struct {
    recording_block block[RECORDING_BLOCKS];
    unsigned long blocks; /* full ones so far */
    recording_block open; /* the one that is being filled, */
    unsigned fill;        /* and its samples so far */
    unsigned size;        /* samples of a block; 0: not known yet */
    int has_temperature;
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
} recording_place;

void recording_begin(recording *r, const samples *log);

/* Before each sample is fed; after each that has filled a block. */
void recording_sample(recording *r, const samples *log, const sample *s);
void recording_filled(recording *r);

recording_place recording_find(const recording *r, const invcal_rest *rest);

#endif
