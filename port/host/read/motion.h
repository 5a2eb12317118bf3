/* SPDX-License-Identifier: MIT
 *
 * read/motion.h: detects motion in a log of a sensor at rest, at any sampling rate and in any unit:
 * the noise is estimated from the log itself.
 *
 * The log is divided into blocks of equal length, at most MOTION_BLOCKS; before there are more,
 * pairs are merged. The sensor has moved where the second difference of three block means, or the
 * variance within a block, is far above its median in this log. A drift has a small second
 * difference, however long it is. At least half of the log must be at rest.
 */
#ifndef MOTION_H
#define MOTION_H

#include "read/samples.h"

#define MOTION_BLOCKS 8192u /* even */

typedef struct {
    unsigned long line; /* of the first sample */
    double clock;
    uint32_t count;
    int64_t sum[3];    /* of differences from the first sample of the log */
    double squares[3]; /* of the same */
} motion_block;

typedef struct {
    motion_block block[MOTION_BLOCKS];
    unsigned blocks;
    uint32_t size;                 /* samples of a full block */
    int32_t origin[3];             /* the first sample, */
    int32_t last[3];               /* and the last one */
    int64_t quantum[3];            /* the smallest change of a reading; 0: it has not changed yet */
    double scratch[MOTION_BLOCKS]; /* for sorting */
} motion;                          /* large: not for the stack */

typedef struct {
    unsigned axis;
    unsigned long line; /* at which the block begins */
    double clock;
    int is_shaking; /* 1: by the variance within the block; 0: by the means */
} motion_place;

void motion_begin(motion *m);
void motion_add(motion *m, const sample *s);

/* 1 if an axis has never changed. */
int motion_is_frozen(const motion *m, unsigned axis);

/* Finds the first place where the sensor moved. Returns 1; 0 if it did not, or the log is too
 * short. */
int motion_find(motion *m, motion_place *out);

#endif
