/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/calibrate.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 31 -eva-slevel 500 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000,compare:2000,invcal_faded:0
// eva: -eva-split-return full -eva-split-return-function add_positions:0,compare:0,solve_and_assess:0,weigh_prior_again:0,invcal_calibrate_sums:0,invcal_solve:0,invcal_assess:0,invcal_observation_reading:0,invcal_observe:0,invcal_normal_add:0,invcal_residuals_add:0,judge:0,invert:0,invcal_evidence_parameters:0,judge_noise:0,invcal_information_factor:0,invcal_cholesky_factor:0,invcal_settings_check:0
// trusted: 3
// The worst residual is one of a position that is not left out. The other two are of quality.c.
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

    (void)invcal_calibrate(NULL, 0, &settings, &solution, &quality, &reason);
    (void)invcal_calibrate(raw, BETWEEN(1, INVCAL_MAX_POSITIONS), &settings, &solution, &quality,
                           BETWEEN(0, 1) ? &reason : NULL);

    ANY(positions);
    positions.raw = raw;
    positions.age = BETWEEN(0, 1) ? age : NULL;
    positions.count = BETWEEN(1, INVCAL_MAX_POSITIONS);
    (void)invcal_calibrate_sums(&normal, &positions, &settings, &solution, &quality);
}
