/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "core/solve.h"

// eva: -eva-auto-loop-unroll 12 -eva-slevel 50

void main(void)
{
    invcal_calibration calibration;
    invcal_calibration nominal;
    invcal_quality found;
    invcal_quality present;
    invcal_real x[INVCAL_PARAMETERS];
    invcal_real sigma[3];

    ANY(calibration);
    ANY(nominal);
    ANY(found);
    ANY(present);
    invcal_deviation(&calibration, &nominal, x);
    invcal_sigma_offset(&found, &nominal, sigma);
    (void)invcal_improves(&found, &present);
    invcali_make_triangular(&calibration, &nominal);
}
