/* SPDX-License-Identifier: MIT */
#include "core/circle.h"
#include "arbitrary.h"

// eva: -eva-auto-loop-unroll 20 -eva-slevel 20

void main(void)
{
    const invcal_real degrees = (invcal_real)Frama_C_double_interval(-720, 720);
    invcal_real cosine;
    invcal_real sine;

    invcali_circle(degrees, &cosine, &sine);
}
