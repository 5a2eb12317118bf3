/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_RESTS_H
#define HISTORY_RESTS_H

#include "history.h"
#include "invcal/expert.h"

#define LEVEL_MAX 16383
#define WIDEST ((int32_t)1 << 20)       /* counts: of a mean from origin */
#define MEAN_MOST (INT32_C(0x3FFFFFFF)) /* the same in 1/1024 counts, and less */
#define TOTAL_MOST(bits) (UINT16_MAX * ((int64_t)WIDEST << (bits)))

/* The rates at which a block has 1 << bits samples. */
#define RATE_FROM(bits) ((bits) == 2 ? INVCAL_RATE_MIN : (11u << ((bits) - 1)) + 1)
#define RATE_TO(bits) ((bits) == 10 ? INVCAL_RATE_MAX : 11u << (bits))

/* Any state of the detector of rests at these rates: of what is bounded, what the code relies on. */
static void any_rests(invcal_rests *s, unsigned bits)
{
    ANY(*s);
    s->bits = (uint16_t)bits;
    s->rate = (uint16_t)BETWEEN(RATE_FROM(bits), RATE_TO(bits));
    s->least = (uint8_t)BETWEEN(4, 255);
    s->dwell = (uint16_t)BETWEEN(4, UINT16_MAX);
    s->blocks = INT32_BETWEEN(-2, UINT16_MAX);
    s->taken = (uint8_t)BETWEEN(0, 1);
    s->noise = (uint16_t)BETWEEN(0, LEVEL_MAX);
    s->wander = (uint16_t)BETWEEN(0, LEVEL_MAX);
    s->reach = (uint16_t)BETWEEN(0, LEVEL_MAX);
    s->other = (uint16_t)BETWEEN(0, LEVEL_MAX);
    for (unsigned a = 0; a < 3; a++) {
        s->rest.once[a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->rest.twice[a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->rest.pending[0][a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->rest.pending[1][a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->rest.total[a] = INT64_BETWEEN(-TOTAL_MOST(bits), TOTAL_MOST(bits));
    }
}

static void check_rests(const invcal_rests *s, unsigned bits)
{
    HOLDS(s->bits == bits);
    WITHIN(s->rate, RATE_FROM(bits), RATE_TO(bits));
    HOLDS(s->least >= 4);
    HOLDS(s->dwell >= 4);
    WITHIN(s->blocks, -2, UINT16_MAX);
    HOLDS(s->taken <= 1);
    WITHIN(s->noise, 0, LEVEL_MAX);
    WITHIN(s->wander, 0, LEVEL_MAX);
    WITHIN(s->reach, 0, LEVEL_MAX);
    WITHIN(s->other, 0, LEVEL_MAX);
    for (unsigned a = 0; a < 3; a++) {
        WITHIN(s->rest.once[a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->rest.twice[a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->rest.pending[0][a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->rest.pending[1][a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->rest.total[a], -TOTAL_MOST(bits), TOTAL_MOST(bits));
    }
}

#endif
