/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "imu/rotation.h"

// trusted: 1
// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 60 -eva-slevel-function drop_oldest:2000,keep_move:2000,measure_bias:200 -eva-split-return full

/* Its invariant holds, and everything else is arbitrary. */
static void any_moves(invcal_moves *m)
{
    ANY(*m);
    m->used = (uint16_t)BETWEEN(0, INVCAL_MAX_SEGMENTS);
    m->fixed = (uint16_t)BETWEEN(0, m->used);
    m->first = (uint16_t)BETWEEN(0, m->fixed);
    m->cut = BETWEEN(0, 1) ? UINT16_MAX : (uint16_t)BETWEEN(0, m->fixed);
    m->count = (uint8_t)BETWEEN(0, INVCAL_MAX_MOVES);
}

void main(void)
{
    static invcal_moves m;
    invcal_calibration nominal;
    invcal_private_rests rests;
    invcal_real rate;
    int32_t raw[3];
    int32_t low;
    int32_t high;
    int16_t packed[3];
    invcal_real out[3];

    ANY(nominal);
    ANY(rate);
    ANY(low);
    ANY(high);
    ANY(raw);
    ANY(rests);
    ANY(packed);
    ANY(out);
    rests.bits = (uint8_t)BETWEEN(2, 10);
    (void)invcal_moves_init(&m, 0, &nominal, rate); /* another build */
    (void)invcal_moves_init(&m, sizeof m, &nominal, rate);
    any_moves(&m);
    (void)invcal_moves_set_limits(&m, low, high);
    invcal_moves_feed(&m, raw[0], raw[1], raw[2]);
    any_moves(&m);
    invcal_moves_gap(&m);
    any_moves(&m);
    invcal_moves_restart(&m);
    any_moves(&m);
    invcal_moves_follow(&m, &rests, (invcal_event)BETWEEN(INVCAL_NOTHING, INVCAL_REFUSED));
    any_moves(&m);
    m.count = (uint8_t)BETWEEN(1, INVCAL_MAX_MOVES);
    (void)invcal_moves_reason(&m, BETWEEN(0, m.count - 1));
    invcal_unpack(packed, INVCAL_V_UNIT, out);
}
