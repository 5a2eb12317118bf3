/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "history.h"
#include "invcal/allan.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 40 -eva-slevel-function find_stage:100,invcal_allan_init:100,add_time:100,begin:40
// eva: -eva-split-return-function find_stage:0,check_times:0,invcal_allan_init:0,invcal_allan_get:0
// wide: -DINVCAL_ALLAN_TAUS=31 -DINVCAL_ALLAN_OVERLAP=16384
// config: -DINVCAL_ALLAN_TAUS=1 -DINVCAL_ALLAN_OVERLAP=1
// trusted: 3
// trusted: -DINVCAL_ALLAN_TAUS=1 2
// dead: -DINVCAL_ALLAN_TAUS=1 add_time 1 check_times 7 invcal_allan_get 1 collect 1
// One averaging time has one ring, and there is none before it.

enum { RINGS = INVCAL_ALLAN_RINGS };

/* Any state of one axis. */
static void any_allan(invcal_allan *a)
{
    ANY(*a);
    a->rings = (uint8_t)BETWEEN(0, RINGS);
    a->taus = (uint8_t)BETWEEN(0, INVCAL_ALLAN_TAUS);
    for (unsigned r = 0; r < RINGS; r++) {
        a->stage[r] = (uint8_t)BETWEEN(0, 30);
        a->end[r] = (uint8_t)BETWEEN(0, INVCAL_ALLAN_TAUS);
    }
}

static void check_allan(const invcal_allan *a)
{
    HOLDS(a->rings <= RINGS);
    HOLDS(a->taus <= INVCAL_ALLAN_TAUS);
    for (unsigned r = 0; r < RINGS; r++) {
        HOLDS(a->stage[r] <= 30);
        HOLDS(a->end[r] <= INVCAL_ALLAN_TAUS);
    }
}

static void begin(const uint32_t *m)
{
    invcal_allan allan;
    invcal_allan_windows windows;

    ANY(windows);
    if (invcal_allan_init(&allan, m, BETWEEN(0, UINT32_MAX), windows) == INVCAL_OK) {
        check_allan(&allan);
    }
}

static void push(invcal_allan *allan)
{
    int32_t raw;

    ANY(raw);
    any_allan(allan);
    invcal_allan_push(allan, raw);
    check_allan(allan);
}

static void gap(invcal_allan *allan)
{
    any_allan(allan);
    invcal_allan_gap(allan);
    check_allan(allan);
}

static void look(invcal_allan *allan)
{
    invcal_allan_point point;
    invcal_noise noise;
    invcal_dwell dwell;
    invcal_real x, y;
    unsigned index;

    ANY(index);
    ANY(x);
    ANY(y);
    any_allan(allan);
    invcal_allan_get(allan, index, &point);
    invcal_allan_noise(allan, x, y, &noise);
    ANY(noise);
    invcal_noise_sigma(&noise, x);
    invcal_noise_dwell(&noise, x, &dwell);
}

void main(void)
{
    static invcal_allan allan;
    uint32_t m[INVCAL_ALLAN_TAUS];

    ANY(m);
    begin(m);
    begin(NULL);
    push(&allan);
    gap(&allan);
    look(&allan);
}
