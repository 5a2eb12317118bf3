/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "history.h"
#include "invcal/thermal.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 31 -eva-slevel 40 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000
// What is written only if a function returns 0, or does not, is told apart by it.
// eva: -eva-split-return-function invcal_settings_check:0,check_settings:0,check_thermal:0,invcal_thermal_start:0,invcal_calibration_inverse:0,divide:0,centre:0
// eva: -eva-split-return-function invcal_observation_reading:0,invcal_observation_exact:0,exact:0,scale:0,check_reading:0,invcal_normal_add:0,invcal_residuals_add:0,observe:0,invcal_thermal_add:0,gather:0
// eva: -eva-split-return-function invcal_cholesky_factor:0,factor_system:0,obstacle:0,solve_degree:0,solve_highest:0,solve_degrees:0,improve:0
// eva: -eva-split-return-function invcal_triad_of_ellipsoid:0,invcal_triad_of_linear:0,invcal_triad_join:0,join_deviations:0,compose:0,interpolate:0
// eva: -eva-split-return-function coefficients_of_data:0,factor_at:0,step_towards:0,invcal_evidence_parameters:0,judge_thermal:0,invcal_thermal_assess:0,assess:0,weigh_thermal_prior:0,run:0,start_and_run:0,invcal_thermal_solve:0,invcal_thermal_calibrate:0
// config: -DINVCAL_THERMAL_DEGREE=2
// config: -DINVCAL_THERMAL_DEGREE=0
// trusted: 2
// Those of quality.c, which says why.
// dead: prior_of 1 constant_of 1 lacks_slopes 1 of a lower degree, or compared with a constant
// dead: -DINVCAL_THERMAL_DEGREE=2 prior_of 0 constant_of 0
// dead: -DINVCAL_THERMAL_DEGREE=0 evaluate 8 prior_of 6 constant_of 6 place_block 1 add_thermal_prior 4 are_slopes_known 10
// dead: -DINVCAL_THERMAL_DEGREE=0 solve_degree 3 solve_highest 19 solve_degrees 1 obstacle 9 lacks_slopes 5 doubt_slopes 2

enum { COUNT = 100 };

static invcal_settings settings;
static invcal_thermal_settings thermal;

/* Any that solve or start have written. */
static void any_calibration(invcal_thermal_calibration *c)
{
    ANY(*c);
    c->fitted = (uint8_t)BETWEEN(0, INVCAL_THERMAL_DEGREE);
}

static void check_calibration(const invcal_thermal_calibration *c)
{
    HOLDS(c->fitted <= INVCAL_THERMAL_DEGREE);
}

static void any_positions(void)
{
    invcal_thermal_sums sums;
    invcal_thermal_calibration base;
    invcal_real raw[3];
    invcal_real temperature;

    invcal_thermal_init(&sums);
    ANY(base);
    ANY(raw);
    ANY(temperature);
    (void)invcal_thermal_add(&sums, &base, raw, temperature);
    ANY(sums);
    (void)invcal_thermal_add(&sums, &base, raw, temperature);
    (void)invcal_thermal_remove(&sums, &base, raw, temperature);
}

static void any_solution(void)
{
    invcal_thermal_sums sums;
    invcal_thermal_calibration base;
    invcal_thermal_calibration out;

    ANY(sums);
    any_calibration(&base);
    if (invcal_thermal_solve(&sums, &base, &settings, &thermal, &out) == INVCAL_OK) {
        check_calibration(&out);
    }
}

static void any_judgement(void)
{
    invcal_thermal_sums sums;
    invcal_thermal_calibration calibration;
    invcal_real temperature;
    invcal_quality quality;

    ANY(sums);
    any_calibration(&calibration);
    ANY(temperature);
    (void)invcal_thermal_assess(&sums, &calibration, &settings, &thermal, temperature, &quality);
}

static void any_look(void)
{
    invcal_thermal_calibration calibration;
    invcal_thermal_fallback fallback;
    invcal_real temperature;
    invcal_solution solution;
    invcal_thermal_place place;

    ANY(calibration);
    ANY(fallback);
    ANY(temperature);
    (void)invcal_thermal_fallback_text(fallback);
    (void)invcal_thermal_drift_limit(&settings, &thermal);
    (void)invcal_thermal_at(&calibration, temperature, &solution, &place);
    if (invcal_thermal_start(&settings, &thermal, &calibration) == INVCAL_OK) {
        check_calibration(&calibration);
    }
}

/* Of any positions, and of none. */
static void any_calibrate(void)
{
    static invcal_real raw[3 * COUNT];
    static invcal_real temperature[COUNT];
    invcal_thermal_calibration out;
    invcal_quality quality;
    invcal_reason reason;

    ANY(raw);
    ANY(temperature);
    (void)invcal_thermal_calibrate(NULL, NULL, 0, &settings, &thermal, &out, &quality, &reason);
    if (invcal_thermal_calibrate(raw, temperature, BETWEEN(1, COUNT), &settings, &thermal, &out,
                                 &quality, BETWEEN(0, 1) ? &reason : NULL) == INVCAL_OK) {
        check_calibration(&out);
    }
}

void main(void)
{
    ANY(settings);
    ANY(thermal);
    any_look();
    any_positions();
    any_solution();
    any_judgement();
    any_calibrate();
}
