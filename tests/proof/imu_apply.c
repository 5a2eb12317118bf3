/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/gyro.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 20

void main(void)
{
    invcal_imu_result result;
    invcal_real raw[3];
    invcal_real acceleration[3];
    invcal_real rate[3];

    ANY(result);
    ANY(raw);
    ANY(acceleration);
    invcal_imu_apply(&result, raw[0], raw[1], raw[2], acceleration, rate);
}
