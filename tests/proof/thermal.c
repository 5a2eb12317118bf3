/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "thermal/polynomials.h"

// eva: -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-split-return-function invcali_thermal_find:0,invcali_thermal_triad:0
// config: -DINVCAL_THERMAL_DEGREE=2
// config: -DINVCAL_THERMAL_DEGREE=0

void main(void)
{
    invcal_thermal thermal;
    invcal_calibration out;
    invcal_calibration triad;
    invcal_real temperature;
    invcal_real t;
    invcal_real c[3][INVCAL_PARAMETERS];
    invcal_real x[INVCAL_PARAMETERS];
    invcal_thermal_place place;

    ANY(thermal);
    ANY(temperature);
    ANY(c);
    (void)invcal_thermal_at(&thermal, temperature, &out, &place);
    (void)invcal_thermal_at(&thermal, temperature, &out, NULL);
    (void)invcali_thermal_find(&thermal, temperature, &t, &place);
    (void)invcali_thermal_triad(&thermal, temperature, &triad);
    (void)invcali_thermal_scaled(&thermal, temperature);
    for (unsigned degree = 0; degree <= 2; degree++) {
        invcali_polynomials(c[0], degree, temperature, x);
    }
}
