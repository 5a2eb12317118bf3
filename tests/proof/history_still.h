/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_STILL_H
#define HISTORY_STILL_H

#include "history_block.h"
#include "invcal/still.h"

#define TOTAL_MAX ((int64_t)(UINT16_MAX + 1) << 31)
#define DWELL_MOST 20 /* blocks; 5 in fact, but at neighbouring rates at once more seem possible */

/* Any state of the rest detector. */
static void any_still(invcal_still *s)
{
    ANY(*s);
    any_block(&s->block, INVCAL_BLOCK_SIZE_MAX);
    s->pended = (uint8_t)BETWEEN(0, 2);
    s->dwell = (uint8_t)BETWEEN(4, DWELL_MOST);
    for (unsigned a = 0; a < 3; a++) {
        s->total[a] = INT64_BETWEEN(-TOTAL_MAX, TOTAL_MAX);
    }
}

static void check_still(const invcal_still *s)
{
    check_block(&s->block, INVCAL_BLOCK_SIZE_MAX);
    HOLDS(s->pended <= 2);
    WITHIN(s->dwell, 4, DWELL_MOST);
    for (unsigned a = 0; a < 3; a++) {
        WITHIN(s->total[a], -TOTAL_MAX, TOTAL_MAX);
    }
}

#endif
