/* SPDX-License-Identifier: MIT */
#include "../positions.h"
#include "calibrate/judge.h"

#include <stddef.h>

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-slevel-merge-after-loop @all
// eva: -eva-split-return-function invcali_observe:0,invcali_positions_pass:0,invcali_positions_solve:0,invcali_factor:0,invcali_ellipsoid:0,invcali_compose:0,invcali_residuals_end:0,invcali_determine:0,invcali_positions_calibrate:0
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64

enum { COUNT = 100 };

static invcal_vector mean[COUNT];
static invcal_calibration nominal;
static invcal_real a[3][3];

/* Reads all of it, so that none may be uninitialised. */
static void read(const invcal_quality *q)
{
    (void)q->sigma[BETWEEN(0, INVCAL_PARAMETERS - 1)];
    (void)(q->noise + q->rms + q->max + q->condition + q->size);
    (void)(q->left_out + q->suspected);
    (void)(q->weak + q->positions + q->dof + q->sigma_dof + q->worst);
    (void)(q->systematic + q->axis + q->unchecked + q->verdict);
}

static void any_passes(void)
{
    invcali_selection selection;
    invcal_sums sums;
    invcal_calibration out;
    invcal_quality quality;

    ANY(selection);
    selection.given.mean = mean;
    selection.given.nominal = &nominal;
    (void)invcali_positions_check(&selection.given);
    selection.given.count = BETWEEN(0, COUNT);
    if (invcali_positions_calibrate(&selection, &out, &quality) == INVCAL_OK) {
        read(&quality);
    }
    (void)invcali_positions_sum(&selection, &sums);
    if (invcali_positions_solve(&selection, &sums, &quality) == INVCAL_OK) {
        (void)quality.sigma[BETWEEN(0, INVCAL_PARAMETERS - 1)];
        (void)quality.condition;
    }
    ANY(out);
    if (invcali_positions_pass(&selection, &out, (const invcal_real(*)[3])a, &sums, &quality) ==
        INVCAL_OK) {
        read(&quality);
    }
}

static void any_steps(void)
{
    invcal_real system[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)];
    invcal_real g[3];
    invcal_real x;
    invcal_real y;
    invcal_real silent;
    invcali_row row;
    invcal_quality q;

    ANY(row);
    ANY(q);
    ANY(x);
    ANY(y);
    ANY(silent);
    invcali_residuals_add(&q, BETWEEN(0, 0xFFFFFFFF), &row);
    (void)invcali_residuals_end(&q);
    (void)invcali_gradient((const invcal_real(*)[3])a, mean[0].v, g);
    const invcal_real dof = (invcal_real)Frama_C_double_interval(-1e30, 1e30);
    invcali_judge_noise(x, y, dof, silent, &q);
    invcali_weigh_noise(x, y, &q);
    (void)invcali_whole(dof);
    ANY(system);
    (void)invcali_condition(system, INVCAL_PARAMETERS, x);
    (void)invcali_is_resolved(x);
    (void)invcali_determine(system, INVCAL_PARAMETERS, &q);
    ANY(system);
    (void)invcali_determine(system, INVCAL_PARAMETERS + 1, &q);
    ANY(q);
    invcali_judge_parameters((const invcal_real(*)[3])a, &q);
}

/* Any positions, and none; the result may overwrite nominal. */
static void any_calibrate(void)
{
    invcal_mask left_out;
    invcal_real noise;
    invcal_calibration out;
    invcal_quality quality;

    ANY(left_out);
    ANY(noise);
    (void)invcali_positions_calibrate(SELECTION(NULL, 0, left_out, &nominal, noise), &out,
                                      &quality);
    (void)invcali_positions_calibrate(SELECTION(mean, BETWEEN(1, COUNT), left_out, &nominal, noise),
                                      &out, &quality);
    (void)invcali_positions_calibrate(SELECTION(mean, BETWEEN(1, COUNT), left_out, &nominal, noise),
                                      &nominal, &quality);
}

void main(void)
{
    ANY(mean);
    ANY(nominal);
    ANY(a);
    any_passes();
    any_steps();
    any_calibrate();
}
