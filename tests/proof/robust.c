/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "any_positions.h"
#include "diagnose/outliers.h"

// eva: -eva-precision 0 -eva-slevel 10 -eva-split-return full
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64
// stubs: judge fit outliers

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcali_fit_solve(invcali_fit *fit)
{
    look_at(&fit->selection);
    ANY(fit->squares);
    ANY(fit->sums);
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);
}

void invcali_outliers_search(const invcali_fit *fit, invcali_group *found)
{
    look_at(&fit->selection);
    ANY(*found);
}

/* ---- positions: none, any, too many; the result may overwrite nominal ------------------------- */

void main(void)
{
    static invcal_vector mean[INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcal_real noise;
    invcal_calibration out;
    invcal_quality quality;

    ANY(mean);
    ANY(nominal);
    ANY(noise);
    (void)invcal_calibrate_robust(POSITIONS_OF(NULL, 0, &nominal, noise), &out, &quality);
    (void)invcal_calibrate_robust(
        POSITIONS_OF(mean, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise), &out, &quality);
    (void)invcal_calibrate_robust(
        POSITIONS_OF(mean, BETWEEN(INVCAL_MAX_POSITIONS + 1, 0xFFFFFFFF), &nominal, noise), &out,
        &quality);
    (void)invcal_calibrate_robust(
        POSITIONS_OF(mean, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise), &nominal, &quality);
}
