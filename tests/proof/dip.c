/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/magnetometer.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 60 -eva-slevel 100 -eva-split-return full

void main(void)
{
    invcal_dip dip;
    invcal_dip_quality quality;
    invcal_real up[3];
    invcal_real field[3];
    invcal_real alike;
    invcal_rotation rotation;

    invcal_dip_init(&dip);
    ANY(up);
    ANY(field);
    ANY(alike);
    (void)invcal_dip_add(&dip, up, field);
    ANY(dip);
    (void)invcal_dip_add(&dip, up, field);
    ANY(dip);
    (void)invcal_dip_solve(&dip, alike, &rotation, &quality);
    (void)invcal_dip_solve(&dip, alike, &rotation, 0);
}
