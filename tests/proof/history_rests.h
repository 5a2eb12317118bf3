/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_RESTS_H
#define HISTORY_RESTS_H

#include "history.h"
#include "invcal/rests.h"

#define LEVEL_MAX 16383
#define WIDEST ((int32_t)1 << 20) /* counts: of a mean from origin */
#define MEAN_MOST (WIDEST << 8)   /* the same in 1/256 counts */
#define TOTAL_MOST(bits) (UINT16_MAX * ((int64_t)WIDEST << (bits)))

/* The rates at which a block has 1 << bits samples. */
#define RATE_FROM(bits) ((bits) == 2 ? INVCAL_RATE_MIN : (11u << ((bits) - 1)) + 1)
#define RATE_TO(bits) ((bits) == 10 ? INVCAL_RATE_MAX : 11u << (bits))

/* Any state of the detector of rests at these rates: of what is bounded, what the code relies on. */
static void any_rests(invcal_rests *s, unsigned bits)
{
    ANY(*s);
    s->bits = (uint8_t)bits;
    s->rate = (uint16_t)BETWEEN(RATE_FROM(bits), RATE_TO(bits));
    s->least = (uint8_t)BETWEEN(4, 255);
    s->dwell = (uint16_t)BETWEEN(4, UINT16_MAX);
    s->pended = (uint8_t)BETWEEN(0, 2);
    s->pace = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->noise = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->wander = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->reach = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->other = (int16_t)BETWEEN(0, LEVEL_MAX);
    for (unsigned a = 0; a < 3; a++) {
        s->once[a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->twice[a] = INT32_BETWEEN(-MEAN_MOST, MEAN_MOST);
        s->pending[0][a] = INT32_BETWEEN(-(WIDEST << bits), WIDEST << bits);
        s->pending[1][a] = INT32_BETWEEN(-(WIDEST << bits), WIDEST << bits);
        s->total[a] = INT64_BETWEEN(-TOTAL_MOST(bits), TOTAL_MOST(bits));
    }
}

static void check_rests(const invcal_rests *s, unsigned bits)
{
    HOLDS(s->bits == bits);
    WITHIN(s->rate, RATE_FROM(bits), RATE_TO(bits));
    HOLDS(s->least >= 4);
    HOLDS(s->dwell >= 4);
    HOLDS(s->pended <= 2);
    WITHIN(s->pace, 0, LEVEL_MAX);
    WITHIN(s->noise, 0, LEVEL_MAX);
    WITHIN(s->wander, 0, LEVEL_MAX);
    WITHIN(s->reach, 0, LEVEL_MAX);
    WITHIN(s->other, 0, LEVEL_MAX);
    for (unsigned a = 0; a < 3; a++) {
        WITHIN(s->once[a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->twice[a], -MEAN_MOST, MEAN_MOST);
        WITHIN(s->pending[0][a], -(WIDEST << bits), WIDEST << bits);
        WITHIN(s->pending[1][a], -(WIDEST << bits), WIDEST << bits);
        WITHIN(s->total[a], -TOTAL_MOST(bits), TOTAL_MOST(bits));
    }
}

#endif
