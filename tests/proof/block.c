/* SPDX-License-Identifier: MIT */
#include "history_block.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 16 -eva-split-return full -eva-slevel 10

#define FAR ((int64_t)INVCAL_BLOCK_FAR)

/* A sample more in a block of exactly n: FAR or less to a sum, or quickly, to both at its end. */
static void add(unsigned n, const int32_t raw[3])
{
    invcal_block b;

    any_block(&b, n);
    for (unsigned a = 0; a < 3; a++) {
        b.sum[a] = INT64_BETWEEN(-(int64_t)n * FAR, (int64_t)n * FAR);
    }
    if (invcal_block_add(&b, raw) == 0) {
        check_block(&b, n + 1);
        for (unsigned a = 0; a < 3; a++) {
            WITHIN(b.sum[a], -(int64_t)(n + 1) * FAR, (int64_t)(n + 1) * FAR);
        }
    } else {
        check_block(&b, n + 1);
    }
}

static void begin(void)
{
    int32_t low, high;
    invcal_block b;

    ANY(low);
    ANY(high);
    if (invcal_block_init(&b, BETWEEN(0, UINT32_MAX), low, high) == INVCAL_OK) {
        check_block(&b, 0);
        HOLDS(b.missing == 0);
    }
}

void main(void)
{
    int32_t raw[3], mean[3];
    invcal_block b;

    begin();
    ANY(raw);
    //@ loop unroll 1000;
    for (unsigned n = 0; n < INVCAL_BLOCK_SIZE_MAX; n++) {
        add(n, raw);
    }
    any_block(&b, INVCAL_BLOCK_SIZE_MAX);
    invcal_block_mean(&b, mean);
    invcal_block_variance(&b);
    invcal_block_drop(&b);
    check_block(&b, INVCAL_BLOCK_SIZE_MAX);
}
