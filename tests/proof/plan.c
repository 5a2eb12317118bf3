/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/plan.h"

// eva: -eva-precision 0 -eva-split-limit 1000

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
    const unsigned n = plan.per_group;
    if (n < INVCAL_PLAN_PER_GROUP_MIN) {
        (void)invcal_plan_position_at(&plan, i, &position);
    } else if (n > INVCAL_PLAN_PER_GROUP_MAX) {
        (void)invcal_plan_position_at(&plan, i, &position);
    } else {
        //@ split n;
        plan.per_group = n;
        (void)invcal_plan_position_at(&plan, i, &position);
    }
}
