/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_positions_compare:2000,invcal_positions_sum:500
// eva: -eva-split-return-function invcal_observe:0,invcal_residuals_add:0,invcal_sums_add:0,invcal_positions_check:0,invcal_positions_sum:0,invcal_positions_compare:0,invcal_positions_solve:0,determine_all:0,invcal_factor:0,invcal_ellipsoid:0,invcal_behind:0,judge_result:0,invcal_residuals_end:0
// config: -DINVCAL_MAX_POSITIONS=64

enum { COUNT = 100 };

void main(void)
{
    static invcal_real raw[3 * COUNT];
    invcal_calibration nominal;
    invcal_calibration out;
    invcal_quality quality;
    invcal_mask left_out;
    invcal_real noise;

    ANY(raw);
    ANY(nominal);
    ANY(left_out);
    ANY(noise);
    (void)invcal_coverage(BETWEEN(0, 0xFFFFFFFF));
    (void)invcal_calibrate(NULL, 0, &nominal, noise, &out, &quality);
    (void)invcal_calibrate(raw, BETWEEN(1, COUNT), &nominal, noise, &out, &quality);
    (void)invcal_calibrate_without(raw, BETWEEN(1, COUNT), left_out, &nominal, noise, &nominal,
                                   &quality);
}
