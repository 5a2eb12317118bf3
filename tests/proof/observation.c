/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/observation.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all

void main(void)
{
    invcal_calibration nominal;
    invcal_real field;
    invcal_real raw[3];
    invcal_real u[3]; /* not initialised: a function may not read it before it wrote it */
    invcal_real vertical[3];
    invcal_observation row;

    ANY(nominal);
    ANY(field);
    ANY(raw);
    ANY(vertical);
    if (invcal_observation_reading(&nominal, field, raw, u) == INVCAL_OK) {
        (void)invcal_observation_exact(u, &row);
    }
    (void)invcal_observation_reading(&nominal, field, raw, raw);
    (void)invcal_observe(&nominal, field, raw, &row);
    ANY(u);
    (void)invcal_observation_exact(u, &row);
    (void)invcal_observation_first_order(u, vertical, &row);
    (void)invcal_observation_vertical(u, vertical, &row);
    (void)invcal_observation_vertical(u, u, &row);
}
