/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_RESTS_H
#define HISTORY_RESTS_H

#include "history.h"
#include "invcal/expert.h"
#include "session/rests.h"

#define LEVEL_MAX 16383

/* The rates at which a block has 1 << bits samples. */
#define RATE_FROM(bits) ((bits) == 2 ? INVCAL_RATE_MIN : (11u << ((bits) - 1)) + 1)
#define RATE_TO(bits) ((bits) == 10 ? INVCAL_RATE_MAX : 11u << (bits))

/* Blocks in 1/125 s, 1/65536, at these rates. */
#define PACE(bits, rate) ((uint16_t)((rate) * UINT32_C(33555) >> (6 + (bits))) + 1u)
#define PACE_FROM(bits) PACE(bits, RATE_FROM(bits))
#define PACE_TO(bits) PACE(bits, RATE_TO(bits))

/* Any state of the detector of rests at these rates, within the bounds that the code relies on. */
static void any_rests(invcal_private_rests *s, unsigned bits)
{
    ANY(*s);
    s->bits = (uint8_t)bits;
    s->pace = (uint16_t)BETWEEN(PACE_FROM(bits), PACE_TO(bits));
    s->least = (uint8_t)BETWEEN(4, 255);
    s->dwell = (uint16_t)BETWEEN(4, UINT16_MAX);
    s->pended = (uint8_t)BETWEEN(0, 2);
    s->taken = (uint8_t)BETWEEN(0, 1);
    s->noise = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->wander = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->reach = (int16_t)BETWEEN(0, LEVEL_MAX);
    s->other = (int16_t)BETWEEN(0, LEVEL_MAX);
}

static void check_rests(const invcal_private_rests *s, unsigned bits)
{
    HOLDS(s->bits == bits);
    WITHIN(s->pace, PACE_FROM(bits), PACE_TO(bits));
    HOLDS(s->least >= 4);
    HOLDS(s->dwell >= 4);
    HOLDS(s->pended <= 2);
    HOLDS(s->taken <= 1);
    WITHIN(s->noise, 0, LEVEL_MAX);
    WITHIN(s->wander, 0, LEVEL_MAX);
    WITHIN(s->reach, 0, LEVEL_MAX);
    WITHIN(s->other, 0, LEVEL_MAX);
}

#endif
