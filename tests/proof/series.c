/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/series.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 16 -eva-split-limit 1000 -eva-split-return full -eva-slevel 20 -eva-slevel-merge-after-loop @all -eva-slevel-function wrap:0,circle:0

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
    const unsigned n = plan.per_group;
    if (n < INVCAL_PLAN_PER_GROUP_MIN) {
        (void)invcal_series_information(&plan, group, information);
    } else if (n > INVCAL_PLAN_PER_GROUP_MAX) {
        (void)invcal_series_information(&plan, group, information);
    } else {
        //@ split n;
        plan.per_group = n;
        (void)invcal_series_information(&plan, group, information);
    }
    //@ merge n;
    const unsigned m = series.plan.per_group;
    if (m < INVCAL_PLAN_PER_GROUP_MIN) {
        (void)invcal_series_add(&series, j);
    } else if (m > INVCAL_PLAN_PER_GROUP_MAX) {
        (void)invcal_series_add(&series, j);
    } else {
        //@ split m;
        series.plan.per_group = m;
        (void)invcal_series_add(&series, j);
    }
}
