/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "plan/plan_axes.h"

void main(void)
{
    invcal_plan plan;
    invcal_plan_position position;
    invcal_real up[3];
    unsigned i;
    unsigned per_group;

    ANY(plan);
    ANY(up);
    ANY(i);
    ANY(per_group);
    (void)invcal_plan_init(&plan, per_group);
    (void)invcali_axis_up(up);
    ANY(plan);
    (void)invcali_plan_check(&plan);
    (void)invcal_plan_get(&plan, i, &position);
}
