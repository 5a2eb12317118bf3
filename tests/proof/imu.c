/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "imu/imu.h"
#include "imu/rotation.h"
#include "core/solve.h"
#include "core/sums.h"

// trusted: 2
// eva: -eva-precision 0 -eva-auto-loop-unroll 24 -eva-slevel 0 -eva-split-return full
// stubs: system sums solve nominal apply moves

/* ---- what other modules do ---------------------------------------------------------------------- */

#define UNKNOWN(array, count) Frama_C_make_unknown((char *)(array), (count) * sizeof *(array))

static invcal_status or_fail(invcal_status failure)
{
    return BETWEEN(0, 1) ? INVCAL_OK : failure;
}

static invcal_real any_real(void)
{
    invcal_real x;

    ANY(x);
    return x;
}

invcal_status invcali_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor)
{
    (void)n;
    (void)floor;
    UNKNOWN(a, INVCAL_PACKED_SIZE(rows));
    return or_fail(INVCAL_UNDETERMINED);
}

void invcali_back_substitute(invcal_real *l, unsigned n)
{
    UNKNOWN(l, INVCAL_PACKED_SIZE(n) + n);
}

void invcali_invert(invcal_real *l, unsigned n)
{
    UNKNOWN(l, INVCAL_PACKED_SIZE(n));
}

invcal_real invcali_variance(const invcal_real *inverse, unsigned n, unsigned r)
{
    (void)inverse[INVCAL_PACKED(n - 1, r)];
    return any_real();
}

invcal_real invcali_trace(const invcal_real *a, unsigned n)
{
    (void)a[INVCAL_PACKED_SIZE(n) - 1];
    return any_real();
}

void invcali_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight)
{
    (void)v[0];
    (void)v[n - 1];
    (void)weight;
    UNKNOWN(a, INVCAL_PACKED_SIZE(n));
}

void invcali_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS])
{
    (void)eta[2];
    UNKNOWN(g, INVCAL_PARAMETERS);
}

invcal_real invcali_cofactors(const invcal_real m[3][3], invcal_real c[3][3])
{
    (void)m[2][2];
    UNKNOWN(c, 3);
    return any_real();
}

invcal_status invcali_compose(const invcal_calibration *nominal, invcal_calibration *c)
{
    (void)nominal->matrix[2][2];
    ANY(*c);
    return or_fail(INVCAL_BAD_NOMINAL);
}

invcal_status invcali_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return or_fail(INVCAL_BAD_NOMINAL);
}

void invcali_correct(const invcal_calibration *calibration, const invcal_real raw[3],
                     invcal_real calibrated[3])
{
    (void)calibration->matrix[2][2];
    (void)raw[2];
    UNKNOWN(calibrated, 3);
}

invcal_real invcali_dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    (void)(a[0] + a[n - 1]);
    (void)(b[0] + b[n - 1]);
    return any_real();
}

void invcali_cross(const invcal_real *a, const invcal_real *b, invcal_real *restrict out)
{
    (void)(a[0] + a[1] + a[2]);
    (void)(b[0] + b[1] + b[2]);
    UNKNOWN(out, 3);
}

void invcali_unpack(const int16_t packed[3], invcal_real unit, invcal_real out[3])
{
    (void)packed[2];
    (void)unit;
    UNKNOWN(out, 3);
}

/* ---- rests and means with arbitrary contents ------------------------------------------------------- */

static void solve(unsigned rests, unsigned means, int held)
{
    static invcal_imu imu;
    static invcal_vector mean[INVCAL_MAX_MOVES + 8];
    static invcal_real prior[INVCAL_IMU_PARAMETERS];
    static invcal_imu_result out;
    invcal_calibration accelerometer;
    invcal_positions positions;
    invcal_imu_settings settings;

    ANY(imu);
    ANY(mean);
    ANY(prior);
    ANY(accelerometer);
    ANY(settings);
    ANY(positions);
    imu.rests = (uint8_t)rests;
    positions.mean = &mean[INVCAL_MAX_MOVES + 8 - means];
    positions.count = means;
    positions.nominal = &accelerometer;
    settings.held = (uint8_t)held;
    settings.prior = BETWEEN(0, 1) ? prior : NULL;
    (void)invcali_imu_solve_of(&imu, &positions, &settings, &out);
}

void main(void)
{
    static invcal_imu imu;
    static invcal_imu_result out;

    ANY(imu);
    imu.rests = 0;
    imu.session.count = (uint8_t)BETWEEN(0, INVCAL_MAX_POSITIONS);
    (void)invcali_imu_is_begun(&imu);
    (void)invcal_imu_solve(&imu, NULL, &out);
    solve(INVCAL_MAX_MOVES, INVCAL_MAX_MOVES + 8, 0);
    solve(INVCAL_MAX_MOVES, INVCAL_MAX_MOVES - 8, 1);
    solve(13, 13, 0);
    solve(13, 0, 1);
    solve(1, 8, 0);
}
