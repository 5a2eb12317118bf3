/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50
// eva: -eva-split-return-function invcal_observe:0,invcal_residuals_add:0,invcal_sums_add:0,invcal_positions_sum:0,invcal_positions_compare:0,determine_all:0,invcal_factor:0,invcal_ellipsoid:0,invcal_behind:0,judge_result:0,invcal_residuals_end:0
// config: -D__OPTIMIZE__=1

enum { COUNT = 100 };

static invcal_real raw[3 * COUNT];
static invcal_calibration nominal;
static invcal_real a[3][3];

static void any_positions(invcal_positions *positions)
{
    ANY(*positions);
    positions->raw = raw;
    positions->count = BETWEEN(0, COUNT);
    positions->nominal = &nominal;
}

static void any_passes(void)
{
    invcal_positions positions;
    invcal_sums sums;
    invcal_calibration out;
    invcal_quality q;
    invcal_real information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real squares;

    any_positions(&positions);
    positions.count = BETWEEN(0, 0xFFFFFFFF);
    (void)invcal_positions_check(&positions);
    any_positions(&positions);
    (void)invcal_positions_sum(&positions, &sums);
    ANY(out);
    (void)invcal_positions_compare(&positions, &out, (const invcal_real(*)[3])a, information,
                                   &squares, &q);
    (void)invcal_positions_solve(&positions, &sums, &out, &q);
}

static void any_steps(void)
{
    invcal_calibration c;
    invcal_row row;
    invcal_quality q;
    invcal_real inverse[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real k[INVCAL_PARAMETERS];
    invcal_real g[3];
    invcal_real x;
    invcal_real y;

    ANY(c);
    ANY(q);
    ANY(inverse);
    ANY(k);
    ANY(x);
    ANY(y);
    invcal_residuals_begin(&q);
    (void)invcal_residuals_add(&c, raw, BETWEEN(0, 0xFFFF), &row, &q);
    (void)invcal_residuals_end(BETWEEN(1, 0xFFFF), &q);
    (void)invcal_gradient((const invcal_real(*)[3])a, raw, g);
    invcal_judge_noise(x, y, (invcal_real)Frama_C_double_interval(-1e30, 0xFFFE), &q);
    (void)invcal_condition(inverse, INVCAL_PARAMETERS, x);
    (void)invcal_is_resolved(x);
    invcal_judge_parameters(k, (int)BETWEEN(0, 1), (const invcal_real(*)[3])a, &q);
}

void main(void)
{
    ANY(raw);
    ANY(nominal);
    ANY(a);
    any_passes();
    any_steps();
}
