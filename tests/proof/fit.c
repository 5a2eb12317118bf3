/* SPDX-License-Identifier: MIT */
#include "diagnose/fit.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-slevel-merge-after-loop @all
// eva: -eva-split-return-function invcali_observe:0,invcali_positions_sum:0,invcali_factor:0,invcali_determine:0,invcali_fit_solve:0
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64

static invcal_vector mean[INVCAL_MAX_POSITIONS];
static invcal_calibration nominal;

/* Any positions, as the diagnosis passes them: at most as many as the mask has bits. */
static void any_fit(invcali_fit *fit)
{
    ANY(*fit);
    fit->selection.given.mean = mean;
    fit->selection.given.count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    fit->selection.given.nominal = &nominal;
}

static void any_solve(void)
{
    invcali_fit any;
    invcali_fit fit; /* with only its positions set */
    invcal_real row[INVCAL_PARAMETERS + 1];

    any_fit(&any);
    fit.selection = any.selection;
    if (invcali_fit_solve(&fit) == INVCAL_OK) {
        invcali_fit_row(&fit, BETWEEN(0, INVCAL_MAX_POSITIONS - 1), row);
        (void)invcali_chance(&fit, fit.squares, fit.squares, 1, 0, 0);
        (void)invcali_fit_spare(&fit, BETWEEN(0, 0xFFFFFFFF));
    }
}

static void any_chance(void)
{
    invcali_fit fit;
    invcal_real x;
    invcal_real y;

    any_fit(&fit);
    ANY(x);
    ANY(y);
    (void)invcali_chance(&fit, x, y, BETWEEN(0, 0xFFFFFFFF), BETWEEN(0, 0xFFFFFFFF),
                         BETWEEN(0, 0xFFFFFFFF));
}

void main(void)
{
    ANY(mean);
    ANY(nominal);
    any_solve();
    any_chance();
}
