/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/series.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 16 -eva-split-return full -eva-slevel 50 -eva-slevel-merge-after-loop @all
// trusted: 1
// The plan was checked, and position (group - 1) N + k is one of its 3 N.

void main(void)
{
    invcal_plan plan;
    invcal_series series;
    invcal_real j;
    invcal_real coefficient[INVCAL_PLAN_GROUPS][INVCAL_SERIES_TERMS];
    invcal_real x[INVCAL_PARAMETERS];
    invcal_real information[INVCAL_PACKED_SIZE(INVCAL_SERIES_TERMS)];
    unsigned group;

    ANY(plan);
    ANY(j);
    ANY(group);
    ANY(information);
    (void)invcal_series_efficiency(information);
    (void)invcal_series_init(&series, &plan);
    ANY(series);
    (void)invcal_series_coefficients(&series, coefficient);
    (void)invcal_series_solve(&series, x);
    ANY(series);
    (void)invcal_series_add(&series, j);
    ANY(plan);
    (void)invcal_series_information(&plan, group, information);
}
