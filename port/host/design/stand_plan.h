/* SPDX-License-Identifier: MIT
 *
 * design/stand_plan.h: the library's programs for a stand, of arguments that are known to be valid.
 */
#ifndef STAND_PLAN_H
#define STAND_PLAN_H

#include "plan/plan_axes.h"

/* The program of invcal_plan_init; per_group is 0 if it is refused. */
invcal_plan stand_plan_make(unsigned per_group);

/* Position i of a program; both are valid. */
invcal_plan_position stand_plan_at(const invcal_plan *plan, unsigned i);

#endif
