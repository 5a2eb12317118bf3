/* SPDX-License-Identifier: MIT */
#include "invcal/block.h"

#include <string.h>

#define NEAR_MAX 0x4000u /* squares of three axes stay below 2^31 */
#define FAR ((int64_t)INVCAL_BLOCK_FAR)
#define SQUARE_EXACT 54 /* bits: times a size below 2^10 it fits 64 */

invcal_status invcal_block_init(invcal_block *block, unsigned size, int32_t low, int32_t high)
{
    INVCAL_ASSERT(block);
    if (size < 2 || size > INVCAL_BLOCK_SIZE_MAX || low >= high) {
        return INVCAL_BAD_SETTING;
    }
    const uint32_t eighth = ((uint32_t)high - (uint32_t)low) / 8;
    uint16_t near = NEAR_MAX;
    while (near > eighth) { /* at most 15 steps: near is halved */
        near /= 2;
    }
    memset(block, 0, sizeof *block);
    block->size = (uint16_t)size;
    block->low = low;
    block->high = high;
    block->near = near;
    return INVCAL_OK;
}

/* Where all that is near the first sample is off the rails too, one comparison will tell both. */
static void begin(invcal_block *block, const int32_t raw[3])
{
    block->span = (uint16_t)(2 * block->near);
    for (unsigned a = 0; a < 3; a++) {
        block->first[a] = raw[a];
        block->sum[a] = 0;
        block->quick[a] = 0;
        if ((int64_t)block->first[a] - block->low <= block->near ||
            (int64_t)block->high - block->first[a] <= block->near) {
            block->span = 0;
        }
    }
    block->square = 0;
    block->clipped = 0;
    block->wild = 0;
    block->missing = block->size;
}

/* Adds a sample whose differences d are all small: -near <= d < near, seen at one blow as d + near
 * has no bit from that of span upwards. Returns 0 if they are not. Modulo 2^32, which unsigned
 * arithmetic does everywhere alike. */
static int add_near(invcal_block *block, const int32_t raw[3])
{
    const uint32_t near = block->near;
    const uint32_t ux = (uint32_t)raw[0] - (uint32_t)block->first[0] + near;
    const uint32_t uy = (uint32_t)raw[1] - (uint32_t)block->first[1] + near;
    const uint32_t uz = (uint32_t)raw[2] - (uint32_t)block->first[2] + near;

    if ((ux | uy | uz) >= block->span) {
        return 0;
    }
    const int32_t x = (int32_t)ux - (int32_t)near;
    const int32_t y = (int32_t)uy - (int32_t)near;
    const int32_t z = (int32_t)uz - (int32_t)near;
    /* of at most 999 samples before it */
    //@ assert -999 * UINT16_MAX <= block->quick[0] <= 999 * UINT16_MAX;
    //@ assert -999 * UINT16_MAX <= block->quick[1] <= 999 * UINT16_MAX;
    //@ assert -999 * UINT16_MAX <= block->quick[2] <= 999 * UINT16_MAX;
    block->quick[0] += x;
    block->quick[1] += y;
    block->quick[2] += z;
    block->square +=
        (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z;
    return 1;
}

/* The same for any sample: at a rail, of a noise above 2^14 counts, or in motion. */
static void add_any(invcal_block *block, const int32_t raw[3])
{
    for (unsigned a = 0; a < 3; a++) {
        const int64_t d = (int64_t)raw[a] - block->first[a];
        if (raw[a] <= block->low || raw[a] >= block->high) {
            block->clipped = 1;
        }
        if (d > FAR || d < -FAR) {
            block->wild = 1;
        } else {
            //@ assert -999 * FAR <= block->sum[a] <= 999 * FAR; // as above
            block->sum[a] += d;
            block->square += (uint64_t)(d * d);
        }
    }
}

/* Only until a change by one count is seen, with most sensors the first second. */
static void learn_quantum(invcal_block *block, const int32_t raw[3])
{
    for (unsigned a = 0; a < 3; a++) {
        const int64_t d = (int64_t)raw[a] - block->first[a];
        const uint32_t change = (uint32_t)(d < 0 ? -d : d);
        if (change > 0 && (block->quantum == 0 || change < block->quantum)) {
            block->quantum = change;
        }
    }
}

int invcal_block_add(invcal_block *block, const int32_t raw[3])
{
    INVCAL_ASSERT(block && raw);
    if (block->missing == 0) {
        begin(block, raw);
    }
    if (!add_near(block, raw)) {
        add_any(block, raw);
    }
    if (block->quantum != 1) {
        learn_quantum(block, raw);
    }
    if (--block->missing > 0) {
        return 0;
    }
    for (unsigned a = 0; a < 3; a++) {
        //@ assert -1000 * FAR <= block->sum[a] <= 1000 * FAR;
        block->sum[a] += block->quick[a];
    }
    return 1;
}

void invcal_block_drop(invcal_block *block)
{
    INVCAL_ASSERT(block);
    block->missing = 0;
}

void invcal_block_mean(const invcal_block *block, int32_t mean[3])
{
    INVCAL_ASSERT(block && mean);
    const int64_t n = block->size;

    for (unsigned a = 0; a < 3; a++) {
        const int64_t half = block->sum[a] < 0 ? -(n / 2) : n / 2;
        mean[a] = (int32_t)(block->first[a] + (block->sum[a] + half) / n);
    }
}

/* sum d^2 - (sum d)^2 / n in floating point: d is measured from a sample of the block, no further
 * away than the noise, so little cancels. */
static invcal_real large_variance(const invcal_block *block)
{
    const invcal_real n = block->size;
    invcal_real squares = (invcal_real)block->square;

    for (unsigned a = 0; a < 3; a++) {
        const invcal_real sum = (invcal_real)block->sum[a];
        squares -= sum * sum / n;
    }
    return squares / (n - 1); /* 1/n of them is left: the first sample has d = 0 */
}

invcal_real invcal_block_variance(const invcal_block *block)
{
    INVCAL_ASSERT(block);
    const uint64_t n = block->size;
    uint64_t scatter = n * block->square;

    if (block->square >> SQUARE_EXACT != 0) {
        return large_variance(block);
    }
    for (unsigned a = 0; a < 3; a++) {
        const int64_t sum = block->sum[a];
        const uint64_t size = (uint64_t)(sum < 0 ? -sum : sum);
        scatter -= size * size; /* never below 0: Cauchy and Schwarz */
    }
    return (invcal_real)scatter / (invcal_real)(uint32_t)(n * (n - 1));
}
