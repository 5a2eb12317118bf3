/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "imu/imu.h"

// trusted: 1
// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 60 -eva-slevel-function drop_oldest:2000,keep_move:2000,measure_bias:200 -eva-split-return full
// stubs: session

/* Its invariant holds, and everything else is arbitrary. */
static void any_moves(invcal_imu *imu)
{
    invcal_private_moves *m = &imu->own;

    ANY(*imu);
    m->used = (uint16_t)BETWEEN(0, INVCAL_MAX_SEGMENTS);
    m->fixed = (uint16_t)BETWEEN(0, m->used);
    m->first = (uint16_t)BETWEEN(0, m->fixed);
    m->cut = BETWEEN(0, 1) ? UINT16_MAX : (uint16_t)BETWEEN(0, m->fixed);
    imu->rests = (uint8_t)BETWEEN(0, INVCAL_MAX_MOVES);
    imu->session.rests.bits = (uint8_t)BETWEEN(2, 10);
}

/* What another module does. */
invcal_event invcal_session_feed(invcal_session *session, int32_t x, int32_t y, int32_t z)
{
    (void)(x + 0 * y + 0 * z);
    ANY(*session);
    session->rests.bits = (uint8_t)BETWEEN(2, 10);
    return (invcal_event)BETWEEN(INVCAL_NOTHING, INVCAL_REFUSED);
}

void invcal_session_gap(invcal_session *session)
{
    ANY(*session);
}

void main(void)
{
    static union {
        invcal_imu imu;
        uint8_t larger[sizeof(invcal_imu) + 800];
    } memory;
    invcal_imu *const m = &memory.imu;
    invcal_calibration nominal;
    invcal_real rate;
    invcal_real counts;
    int32_t raw[3];
    int32_t low;
    int32_t high;
    int16_t packed[3];
    invcal_real out[3];

    ANY(nominal);
    ANY(rate);
    ANY(counts);
    ANY(low);
    ANY(high);
    ANY(raw);
    ANY(packed);
    ANY(out);
    ANY(memory);
    (void)invcal_imu_init_nominal(m, 0, &nominal, rate); /* other builds */
    (void)invcal_imu_init_nominal(m, sizeof *m - 8, &nominal, rate);
    (void)invcal_imu_init_nominal(m, sizeof *m + 800, &nominal, rate);
    ANY(memory);
    (void)invcal_imu_init_nominal(m, sizeof *m, &nominal, rate);
    (void)invcal_imu_init(m, sizeof *m, counts, rate);
    any_moves(m);
    (void)invcal_imu_set_limits(m, low, high);
    invcal_imu_feed_gyro(m, raw[0], raw[1], raw[2]);
    any_moves(m);
    invcal_imu_gap(m);
    any_moves(m);
    invcali_moves_restart(m);
    any_moves(m);
    invcali_imu_follow(m, (invcal_event)BETWEEN(INVCAL_MOVING, INVCAL_REFUSED));
    any_moves(m);
    (void)invcal_imu_feed(m, raw[0], raw[1], raw[2]);
    any_moves(m);
    m->rests = (uint8_t)BETWEEN(1, INVCAL_MAX_MOVES);
    (void)invcal_imu_move_reason(m, BETWEEN(0, m->rests - 1));
    invcali_unpack(packed, INVCAL_V_UNIT, out);
}
