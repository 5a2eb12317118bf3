/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "imu/turns.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 45 -eva-slevel 60 -eva-split-return full

// stubs: imu

invcal_status invcali_imu_begin(invcali_imu_work *work, const invcal_imu *imu,
                                const invcal_positions *positions,
                                const invcal_imu_settings *settings, invcal_imu_result *out)
{
    static invcal_vector means[INVCAL_MAX_MOVES];

    (void)positions->count;
    (void)(settings != NULL);
    ANY(means);
    ANY(*work);
    ANY(*out);
    work->imu = imu;
    work->mean = means;
    work->out = out;
    work->n = BETWEEN(0, 1) ? INVCAL_IMU_PARAMETERS : INVCAL_GYRO_PARAMETERS;
    work->begin = BETWEEN(0, INVCAL_MAX_MOVES);
    return positions->nominal->offset[0] > 0 ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcali_imu_settings_check(const invcal_imu_settings *settings, invcal_real noise)
{
    return settings->rate_noise >= 0 && noise >= 0 ? INVCAL_OK : INVCAL_BAD_NOISE;
}

invcal_status invcali_imu_sum(invcali_imu_work *work)
{
    ANY(work->pass);
    return Frama_C_int_interval(0, 1) ? INVCAL_OK : INVCAL_OUT_OF_RANGE;
}

enum { COUNT = 40 };

void main(void)
{
    static invcal_vector raw[COUNT];
    static invcal_imu imu;
    invcal_positions positions;
    invcal_real noise;
    invcal_calibration nominal;
    static invcali_turns turns;
    invcal_imu_settings settings;
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    invcal_real sigma[INVCAL_IMU_PARAMETERS];
    invcal_real up[2][3];
    invcal_turn turn;
    uint32_t open;
    unsigned i;

    ANY(i);
    (void)invcali_tour(i, &turn);
    ANY(up);
    (void)invcali_turn_to(up[0], up[1], &turn);
    ANY(settings);
    ANY(noise);
    ANY(prior);
    settings.prior = Frama_C_int_interval(0, 1) ? prior : 0;
    (void)invcali_turns_begin(&turns, up[0], 0, 0);
    (void)invcali_turns_begin(&turns, up[0], &settings, noise);
    ANY(raw);
    ANY(nominal);
    ANY(imu);
    ANY(positions);
    imu.rests = (uint8_t)BETWEEN(0, INVCAL_MAX_MOVES);
    positions.mean = raw;
    positions.count = BETWEEN(0, COUNT);
    positions.nominal = &nominal;
    (void)invcali_turns_after(&turns, &imu, &positions, 0);
    (void)invcali_turns_after(&turns, &imu, &positions, &settings);
    ANY(turns);
    turns.n = Frama_C_int_interval(0, 1) ? INVCAL_IMU_PARAMETERS : INVCAL_GYRO_PARAMETERS;
    ANY(turn);
    invcali_turns copy = turns;
    (void)invcali_turns_add(&copy, &turn);
    (void)invcali_turns_sigma(&turns, &turn, sigma, &open);
    (void)invcali_turns_sigma(&turns, 0, sigma, &open);
    invcali_turns_next(&turns, &turn);
}
