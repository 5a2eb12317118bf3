/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/thermal.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30 -eva-slevel 40 -eva-slevel-merge-after-loop @all -eva-slevel-function gather:500
// What is written only if a function returns 0, or does not, is told apart by it.
// eva: -eva-split-return-function gather:0,solve_at_noise:0,solve_to:0,try_degree:0,solve_highest:0,compose:0,interpolate:0,improve:0,weigh:0,judge_at:0,judge_range:0,find_range:0,hold:0,set_up:0,run:0
// eva: -eva-split-return-function invcal_observe:0,invcal_residuals_add:0,invcal_residuals_end:0,invcal_positions_check:0,invcal_factor:0,invcal_ellipsoid:0,invcal_behind:0,invcal_thermal_find:0,invcal_thermal_triad:0
// config: -DINVCAL_THERMAL_DEGREE=2
// config: -DINVCAL_THERMAL_DEGREE=0
// trusted: 1
// As for prior.c.

enum { COUNT = 100 };

static invcal_real raw[3 * COUNT];
static invcal_real temperature[COUNT];

static void any_look(void)
{
    invcal_calibration nominal;
    invcal_thermal_fallback fallback;
    invcal_real noise;
    invcal_real slope;
    invcal_thermal out;

    ANY(nominal);
    ANY(fallback);
    ANY(noise);
    ANY(slope);
    (void)invcal_thermal_fallback_text(fallback);
    (void)invcal_thermal_drift_limit(noise, slope);
    (void)invcal_thermal_start(&nominal, NULL, 0, &out);
    (void)invcal_thermal_start(&nominal, temperature, BETWEEN(1, COUNT), &out);
}

static void any_calibrate(void)
{
    invcal_calibration nominal;
    invcal_real noise;
    invcal_thermal out;
    invcal_quality quality;

    ANY(nominal);
    ANY(noise);
    (void)invcal_thermal_calibrate(NULL, NULL, 0, &nominal, noise, &out, &quality);
    (void)invcal_thermal_calibrate(raw, temperature, BETWEEN(1, COUNT), &nominal, noise, &out,
                                   &quality);
}

static void any_fit(const invcal_thermal_prior *prior)
{
    invcal_thermal_positions positions = {raw, temperature, BETWEEN(1, COUNT), 0};
    invcal_thermal base;
    invcal_thermal out;
    invcal_quality quality;
    invcal_real at;

    ANY(positions.noise);
    ANY(base);
    ANY(at);
    (void)invcal_thermal_fit(&positions, prior, &base, BETWEEN(0, 0xFFFFFFFF), &out, &quality);
    (void)invcal_thermal_judge(&positions, prior, &base, at, &quality);
}

void main(void)
{
    invcal_thermal_prior prior;

    ANY(raw);
    ANY(temperature);
    ANY(prior);
    any_look();
    any_calibrate();
    any_fit(NULL);
    any_fit(&prior);
}
