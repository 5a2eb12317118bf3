/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/thermal.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-split-return full -eva-slevel 10 -eva-slevel-function extreme:2000

enum { COUNT = 100 };

static invcal_settings settings;
static invcal_thermal_settings thermal;

/* Any that solve or start have written. */
static void any_calibration(invcal_thermal_calibration *c)
{
    ANY(*c);
    c->fitted = (uint8_t)BETWEEN(0, INVCAL_THERMAL_DEGREE);
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
    (void)invcal_thermal_solve(&sums, &base, &settings, &thermal, &out);
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
    (void)invcal_thermal_start(&settings, &thermal, &calibration);
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
    (void)invcal_thermal_calibrate(raw, temperature, BETWEEN(1, COUNT), &settings, &thermal, &out,
                                   &quality, BETWEEN(0, 1) ? &reason : NULL);
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
