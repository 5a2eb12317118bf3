/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "imu/imu.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 40 -eva-split-return full
// stubs: imu

/* ---- what other modules do ---------------------------------------------------------------------- */

invcal_status invcali_imu_begin(invcali_imu_work *w, const invcal_imu *imu,
                                const invcal_positions *positions,
                                const invcal_imu_settings *settings, invcal_imu_result *out)
{
    (void)positions->nominal->matrix[2][2];
    (void)(settings != NULL);
    ANY(*w);
    ANY(*out);
    w->imu = imu;
    w->out = out;
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcali_imu_sum(invcali_imu_work *w)
{
    (void)w->parameter[8];
    ANY(w->pass);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_OUT_OF_RANGE;
}

invcal_positions invcali_imu_positions(const invcal_imu *imu)
{
    const invcal_session *s = &imu->session;
    const invcal_positions positions = {s->mean, s->count, &s->nominal, s->noise, NULL};

    return positions;
}

void main(void)
{
    static invcal_imu imu;
    int8_t axes[3];
    invcal_real unit;

    ANY(imu);
    imu.own.first = (uint16_t)BETWEEN(0, INVCAL_MAX_SEGMENTS);
    (void)invcal_imu_mounting(&imu, axes, &unit);
}
