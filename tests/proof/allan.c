/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/allan.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 40 -eva-slevel-function stage:200
// wide: -DINVCAL_ALLAN_TAUS=31 -DINVCAL_ALLAN_OVERLAP=16384
// config: -DINVCAL_ALLAN_TAUS=1 -DINVCAL_ALLAN_OVERLAP=1
// trusted: 3
// trusted: -DINVCAL_ALLAN_TAUS=1 1

/* Any state of one axis. */
static void any_allan(invcal_allan *a)
{
    ANY(*a);
    a->taus = (uint8_t)BETWEEN(0, INVCAL_ALLAN_TAUS);
    for (unsigned k = 0; k < INVCAL_ALLAN_TAUS; k++) {
        a->tau[k].m = BETWEEN(1, INVCAL_ALLAN_LONGEST);
    }
}

static void begin(void)
{
    uint32_t m[INVCAL_ALLAN_TAUS];
    invcal_allan allan;

    ANY(m);
    invcal_allan_init(&allan);
    (void)invcal_allan_begin(&allan, m, BETWEEN(0, UINT32_MAX));
}

static void push(invcal_allan *allan)
{
    int32_t raw;

    ANY(raw);
    any_allan(allan);
    invcal_allan_push(allan, raw);
    any_allan(allan);
    invcal_allan_apart(allan);
    invcal_allan_gap(allan);
}

static void look(invcal_allan *allan)
{
    invcal_allan_point point;
    invcal_noise noise;
    invcal_dwell dwell;
    invcal_real x;
    unsigned index;

    ANY(index);
    ANY(x);
    any_allan(allan);
    (void)invcal_allan_get(allan, index, &point);
    (void)invcal_allan_noise(allan, x, &noise);
    ANY(noise);
    (void)invcal_noise_sigma(&noise, x);
    (void)invcal_noise_dwell(&noise, x, &dwell);
}

void main(void)
{
    static invcal_allan allan;

    begin();
    push(&allan);
    look(&allan);
}
