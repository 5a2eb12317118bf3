/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "arbitrary.h"
#include "invcal/expert.h"
#include "invcal/result.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-slevel-merge-after-loop @all
// eva: -eva-split-return-function invcali_observe:0,invcali_positions_pass:0,invcali_positions_solve:0,invcali_factor:0,invcali_ellipsoid:0,invcali_compose:0,invcali_residuals_end:0,invcali_determine:0
// No more degrees of freedom than positions: a difference of two counts that no interval sees.

enum { COUNT = 100 };

void main(void)
{
    static invcal_vector mean[COUNT];
    invcal_calibration nominal;
    invcal_calibration out;
    invcal_quality quality;
    invcal_real noise;

    ANY(mean);
    ANY(nominal);
    ANY(noise);
    (void)invcal_coverage(BETWEEN(0, 0xFFFFFFFF));
    ANY(quality);
    (void)invcal_accuracy(&quality, noise);
    (void)invcal_reaches(&quality, noise, noise, noise);
    (void)invcal_calibrate_plain(POSITIONS_OF(mean, BETWEEN(1, COUNT), &nominal, noise), &out,
                                 &quality);
}
