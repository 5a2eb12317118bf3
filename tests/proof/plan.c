/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/plan.h"

void main(void)
{
    invcal_plan plan;
    invcal_plan_position position;
    invcal_real vertical[3];
    unsigned i;
    unsigned per_group;

    ANY(plan);
    ANY(vertical);
    ANY(i);
    ANY(per_group);
    (void)invcal_plan_starts(per_group, plan.start);
    (void)invcal_axis_up(vertical);
    ANY(plan);
    (void)invcal_plan_check(&plan);
    (void)invcal_plan_position_at(&plan, i, &position);
}
