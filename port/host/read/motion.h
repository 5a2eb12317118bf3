/* SPDX-License-Identifier: MIT
 *
 * read/motion.h: whether the sensor of a log has been at rest all the time, at any rate of samples and
 * with any unit: the noise follows from the log itself.
 *
 * The log is cut into blocks of equal length, at most MOTION_BLOCKS: each two become one when
 * there are more. It has moved where the means of three blocks in a row bend, or the variance
 * inside of one rises, far beyond what is usual in this log (the median). A drift, however long,
 * bends little; half of the log must be at rest.
 */
#ifndef MOTION_H
#define MOTION_H

#include "read/samples.h"

#define MOTION_BLOCKS 8192u /* even */

typedef struct {
    unsigned long line; /* of the first sample */
    double clock;
    uint32_t count;
    int64_t sum[3]; /* from the first sample of the log on, as the squares */
    double squares[3];
} motion_block;

typedef struct {
    motion_block block[MOTION_BLOCKS];
    unsigned blocks;
    uint32_t size;                 /* samples of a full block */
    int32_t origin[3];             /* the first sample, */
    int32_t last[3];               /* and the last one */
    int64_t quantum[3];            /* the smallest change of a reading, 0: none has changed yet */
    double scratch[MOTION_BLOCKS]; /* for sorting */
} motion;                          /* large: not for the stack */

typedef struct {
    unsigned axis;
    unsigned long line; /* where the block in question begins */
    double clock;
    int is_shaking; /* 1: the variance inside the block; 0: the means */
} motion_place;

void motion_begin(motion *m);
void motion_add(motion *m, const sample *s);

/* 1 if an axis has never changed. */
int motion_is_frozen(const motion *m, unsigned axis);

/* Returns 1 and the first place where it has moved; 0 if it has not, or the log is too short. */
int motion_find(motion *m, motion_place *out);

#endif
