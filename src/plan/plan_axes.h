/* SPDX-License-Identifier: MIT
 *
 * Internal: what the host tool needs of plan.h besides.
 */
#ifndef INVCAL_PLAN_AXES_H
#define INVCAL_PLAN_AXES_H

#include "invcal/plan.h"
#include "../core/names.h"

#define INVCAL_PLAN_GROUPS 3u        /* of a program */
#define INVCAL_PLAN_PER_GROUP_MIN 5u /* positions in a group: one per coefficient of its series */
#define INVCAL_PLAN_PER_GROUP_MAX 1000u /* max positions in a group */

/* Is the plan usable? Returns as invcal_plan_get. */
invcal_status invcali_plan_check(const invcal_plan *plan);

/* The six directions of the axes as bits: 1 << INVCAL_AXIS_PLUS_X and so on. */
enum {
    INVCAL_AXIS_PLUS_X = 0, /* x points up */
    INVCAL_AXIS_MINUS_X,    /* x points down */
    INVCAL_AXIS_PLUS_Y,     /* y points up */
    INVCAL_AXIS_MINUS_Y,    /* y points down */
    INVCAL_AXIS_PLUS_Z,     /* z points up */
    INVCAL_AXIS_MINUS_Z,    /* z points down */
    INVCAL_AXES             /* their number */
};

/* Which axis points up, within 0.1 degrees: one bit, or 0 if none does. The bitwise OR over all
 * positions gives the axes of a plan. From 901 positions in a group on a quarter of a step is less:
 * all six count, even if N is odd.
 *
 * up  a unit vector; any other, or a NaN, does no harm. */
uint8_t invcali_axis_up(const invcal_real up[3]);

#endif
