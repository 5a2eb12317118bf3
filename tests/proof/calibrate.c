/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/calibrate.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000
// trusted: 2
// config: -DINVCAL_MAX_POSITIONS=64

void main(void)
{
    static invcal_real raw[3 * INVCAL_MAX_POSITIONS];
    static uint8_t age[INVCAL_MAX_POSITIONS];
    invcal_positions positions;
    invcal_normal normal;
    invcal_settings settings;
    invcal_solution solution;
    invcal_quality quality;
    invcal_reason reason;
    unsigned days;

    ANY(raw);
    ANY(age);
    ANY(normal);
    ANY(settings);
    ANY(days);
    (void)invcal_faded(days);

    const unsigned count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    (void)invcal_calibrate(raw, count, &settings, &solution, &quality, NULL);
    (void)invcal_calibrate(raw, count, &settings, &solution, &quality, &reason);
    (void)invcal_calibrate(NULL, 0, &settings, &solution, &quality, &reason);

    ANY(positions.left_out);
    positions.raw = raw;
    positions.age = NULL;
    positions.count = BETWEEN(1, INVCAL_MAX_POSITIONS);
    (void)invcal_calibrate_sums(&normal, &positions, &settings, &solution, &quality);
    positions.age = age;
    (void)invcal_calibrate_sums(&normal, &positions, &settings, &solution, &quality);
}
