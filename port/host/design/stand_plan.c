/* SPDX-License-Identifier: MIT */
#include "design/stand_plan.h"

invcal_plan stand_plan_make(unsigned per_group)
{
    invcal_plan plan;

    return invcal_plan_init(&plan, per_group) == INVCAL_OK ? plan : (invcal_plan){0};
}

invcal_plan_position stand_plan_at(const invcal_plan *plan, unsigned i)
{
    invcal_plan_position p;

    return invcal_plan_get(plan, i, &p) == INVCAL_OK ? p : (invcal_plan_position){0};
}
