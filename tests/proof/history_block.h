/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_BLOCK_H
#define HISTORY_BLOCK_H

#include "history.h"
#include "invcal/block.h"

#define SUM_OF(n) ((int64_t)(n) * (INVCAL_BLOCK_FAR + UINT16_MAX))
#define QUICK_OF(n) ((int32_t)(n) * UINT16_MAX)

/* Any block of any size that holds up to n samples. */
static void any_block(invcal_block *b, unsigned n)
{
    ANY(*b);
    b->size = (uint16_t)BETWEEN(2, INVCAL_BLOCK_SIZE_MAX);
    b->missing = (uint16_t)BETWEEN(0, INVCAL_BLOCK_SIZE_MAX);
    for (unsigned a = 0; a < 3; a++) {
        b->sum[a] = INT64_BETWEEN(-SUM_OF(n), SUM_OF(n));
        b->quick[a] = INT32_BETWEEN(-QUICK_OF(n), QUICK_OF(n));
    }
}

static void check_block(const invcal_block *b, unsigned n)
{
    WITHIN(b->size, 2, INVCAL_BLOCK_SIZE_MAX);
    HOLDS(b->missing <= INVCAL_BLOCK_SIZE_MAX);
    for (unsigned a = 0; a < 3; a++) {
        WITHIN(b->sum[a], -SUM_OF(n), SUM_OF(n));
        WITHIN(b->quick[a], -QUICK_OF(n), QUICK_OF(n));
    }
}

#endif
