/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "stand/directions.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50
// eva: -eva-split-return full

void main(void)
{
    invcal_directions linear;
    invcal_calibration nominal;
    invcal_calibration out;
    invcal_real raw[3];
    invcal_real eta[3];
    invcal_real x[INVCAL_PARAMETERS];

    invcal_directions_init(&linear);
    ANY(linear);
    ANY(nominal);
    ANY(raw);
    ANY(eta);
    (void)invcal_directions_add(&linear, &nominal, raw, eta);
    (void)invcali_directions_add_scalar(&linear, &nominal, raw, eta);
    ANY(linear);
    (void)invcal_directions_solve(&linear, &nominal, &out, x);
    (void)invcal_directions_solve(&linear, &nominal, &nominal, x);
}
