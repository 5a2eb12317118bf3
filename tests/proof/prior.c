/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "arbitrary.h"
#include "invcal/expert.h"
#include "invcal/result.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-slevel-merge-after-loop @all
// eva: -eva-split-return-function check_prior:0,calibrate:0,calibrate_twice:0,solve_with:0,factor_with:0,judge_with:0,invcali_observe:0,invcali_positions_pass:0,invcali_factor:0,invcali_ellipsoid:0,invcali_compose:0,invcali_residuals_end:0
// trusted: 1

enum { COUNT = 100 };

void main(void)
{
    static invcal_vector mean[COUNT];
    invcal_calibration nominal;
    invcal_real prior[INVCAL_PARAMETERS];
    invcal_calibration out;
    invcal_quality quality;
    invcal_real noise;
    invcal_real gamma;

    ANY(mean);
    ANY(nominal);
    ANY(prior);
    ANY(noise);
    ANY(gamma);
    (void)invcal_calibrate_prior(POSITIONS_OF(NULL, 0, &nominal, noise), prior, &out, &quality);
    (void)invcal_calibrate_prior(POSITIONS_OF(mean, BETWEEN(1, COUNT), &nominal, noise), prior,
                                 &out, &quality);
    (void)invcal_calibrate_faces(POSITIONS_OF(mean, BETWEEN(1, COUNT), &nominal, noise), gamma,
                                 &out, &quality);
}
