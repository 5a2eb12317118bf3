/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "imu/imu.h"
#include "invcal/result.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 40 -eva-split-return full
// stubs: imu status

/* ---- what other modules do ---------------------------------------------------------------------- */

invcal_status invcal_imu_begin(invcal_imu_work *w, const invcal_vector *mean, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings, invcal_imu *out)
{
    (void)(mean != NULL);
    (void)count;
    (void)accelerometer->matrix[2][2];
    (void)(settings != NULL);
    ANY(*w);
    ANY(*out);
    w->moves = moves;
    w->out = out;
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_imu_sum(invcal_imu_work *w)
{
    (void)w->out->parameter[8];
    ANY(w->pass);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_OUT_OF_RANGE;
}

const char *invcal_parameter_text(unsigned parameter)
{
    (void)parameter;
    return "?";
}

void main(void)
{
    static invcal_moves moves;
    static invcal_vector mean[1];
    invcal_calibration accelerometer;
    int8_t axes[3];
    invcal_real unit;

    ANY(moves);
    ANY(mean);
    ANY(accelerometer);
    moves.first = (uint16_t)BETWEEN(0, INVCAL_MAX_SEGMENTS);
    (void)invcal_imu_mounting(mean, 1, &accelerometer, &moves, axes, &unit);
    (void)*invcal_imu_parameter_text(BETWEEN(0, 0xFFFFFFFF));
}
