/* SPDX-License-Identifier: MIT
 *
 * invcal/block.h: the integer sums of one block of raw samples: mean, variance, resolution.
 *
 * Nothing is rounded while samples come in: what is summed is the difference to the first sample
 * of the block, an integer, and so are its squares. The variance costs one subtraction of two
 * exact integers and one division,
 *
 *     variance = (n sum d^2 - (sum d)^2) / (n (n - 1)),      d = sample - first,
 *
 * so that an offset of any size, however large against the noise, takes nothing away from it.
 * The rest detector (still.h) is built on these blocks; firmware has no need to call them.
 */
#ifndef INVCAL_BLOCK_H
#define INVCAL_BLOCK_H

#include <stdint.h>

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_BLOCK_SIZE_MAX 1000u          /* samples: sums of squares stay below 2^64 */
#define INVCAL_BLOCK_FAR (UINT32_C(1) << 26) /* counts, 1/64 of int32: no noise is so large */

/* The sums of a block. Nothing in it is meant to be changed. */
typedef struct {
    int64_t sum[3];    /* of d, for each axis; complete when the block is full */
    uint64_t square;   /* of d^2, the three axes together */
    int32_t quick[3];  /* sums of the differences below near, until then */
    int32_t first[3];  /* the first sample */
    int32_t low, high; /* rails: a sensor that reads them may be beyond */
    uint32_t quantum;  /* smallest change ever seen inside a block, counts; 0: none as yet */
    uint16_t size;     /* samples in a full block */
    uint16_t missing;  /* samples until it is full; 0: the next begins another */
    uint16_t near;     /* differences below this, a power of two or 0, are added quickly */
    uint16_t span;     /* twice near; 0: nothing quickly in this block, it is near a rail */
    uint8_t clipped;   /* not 0: some sample was at a rail or beyond */
    uint8_t wild;      /* not 0: some sample was further from `first` than INVCAL_BLOCK_FAR; it
                          is in no sum, and mean and variance are not those of the block */
} invcal_block;

/* Begins the first block of a stream.
 *
 * size       samples in a block, 2 ... INVCAL_BLOCK_SIZE_MAX.
 * low, high  the smallest and the largest count that the sensor can deliver, low < high; where
 *            they are not known INT32_MIN and INT32_MAX.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if either is out of range. */
invcal_status invcal_block_init(invcal_block *block, unsigned size, int32_t low, int32_t high);

/* Adds one sample, of any value; the one after a full block begins the next.
 *
 * Returns 1 if the block is full now, else 0.
 * Cost: some 55 instructions on a Cortex-M4, no division; more near a rail, in motion, and with
 * noise above 2000 counts. */
int invcal_block_add(invcal_block *block, const int32_t raw[3]);

/* Forgets the samples of a block that is not full. What was learned, quantum, stays. */
void invcal_block_drop(invcal_block *block);

/* The mean of a full block in whole counts, to the nearest, halves away from the first sample. */
void invcal_block_mean(const invcal_block *block, int32_t mean[3]);

/* The variance of one sample of a full block, counts^2, the sum over the three axes.
 * Exact but for the rounding of the result as long as square < 2^54 (a noise of 2 million counts
 * in the largest block); beyond, to about 1e-5 in float. */
invcal_real invcal_block_variance(const invcal_block *block);

#ifdef __cplusplus
}
#endif

#endif
