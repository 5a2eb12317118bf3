/* SPDX-License-Identifier: MIT */
#include "invcal/plan.h"

#include "vector.h"

#define TURN INVCAL_REAL(360.0)
#define ALONG INVCAL_REAL(0.99999847691) /* cos 0.1 degrees */

static invcal_status check_per_group(unsigned per_group)
{
    if (per_group < INVCAL_PLAN_PER_GROUP_MIN) {
        return INVCAL_TOO_FEW;
    }
    return per_group <= INVCAL_PLAN_PER_GROUP_MAX ? INVCAL_OK : INVCAL_BAD_SETTING;
}

invcal_status invcal_plan_check(const invcal_plan *plan)
{
    INVCAL_ASSERT(plan);
    const invcal_status status = check_per_group(plan->per_group);

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS && status == INVCAL_OK; g++) {
        if (!(INVCAL_FABS(plan->start[g]) <= TURN)) {
            return INVCAL_BAD_SETTING;
        }
    }
    return status;
}

/* The same angle above -180, at most 180. */
static invcal_real wrap(invcal_real degrees)
{
    while (degrees > TURN / 2) { /* at most one step: |degrees| is a turn or less */
        degrees -= TURN;
    }
    while (degrees <= -TURN / 2) { /* at most one step, likewise */
        degrees += TURN;
    }
    return degrees;
}

/* start + 360 k / N, wrapped before it is rounded: half a turn is taken off each part, exactly. */
static invcal_real angle(invcal_real start, unsigned k, unsigned per_group)
{
    const invcal_real turned = 2 * k > per_group ? -(invcal_real)(per_group - k) : (invcal_real)k;
    const invcal_real from = wrap(start);
    const invcal_real step = TURN * turned / (invcal_real)per_group;
    const invcal_real half = from + step > TURN / 2    ? TURN / 2
                             : from + step < -TURN / 2 ? -TURN / 2
                                                       : 0;

    return wrap((from - half) + (step - half));
}

/* Cosine and sine of a wrapped angle. Taking off quarter turns is exact, and so are 0 and 1. */
static void circle(invcal_real degrees, invcal_real *cosine, invcal_real *sine)
{
    unsigned quarters = 0;

    while (degrees > TURN / 8) { /* at most two steps: half a turn or less */
        degrees -= TURN / 4;
        quarters += 1;
    }
    while (degrees < -TURN / 8) { /* at most two steps */
        degrees += TURN / 4;
        quarters += 3;
    }
    const invcal_real c = INVCAL_COS(degrees * INVCAL_DEGREE);
    const invcal_real s = INVCAL_SIN(degrees * INVCAL_DEGREE);
    *cosine = quarters % 4 == 0 ? c : quarters % 4 == 1 ? -s : quarters % 4 == 2 ? -c : s;
    *sine = quarters % 4 == 0 ? s : quarters % 4 == 1 ? c : quarters % 4 == 2 ? -s : -c;
}

/* eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta). */
static void set_vertical(invcal_plan_position *p)
{
    invcal_real cos_alpha;
    invcal_real sin_alpha;
    invcal_real cos_beta;
    invcal_real sin_beta;

    circle(p->alpha, &cos_alpha, &sin_alpha);
    circle(p->beta, &cos_beta, &sin_beta);
    p->vertical[0] = sin_alpha * sin_beta;
    p->vertical[1] = cos_alpha;
    p->vertical[2] = sin_alpha * cos_beta;
}

invcal_status invcal_plan_position_at(const invcal_plan *plan, unsigned i,
                                      invcal_plan_position *out)
{
    INVCAL_ASSERT(plan && out);
    const invcal_status status = invcal_plan_check(plan);

    if (status != INVCAL_OK) {
        return status;
    }
    if (i >= INVCAL_PLAN_GROUPS * plan->per_group) {
        return INVCAL_BAD_SETTING;
    }
    const unsigned group = i < plan->per_group ? 0 : i < 2 * plan->per_group ? 1 : 2;
    const unsigned k = i - group * plan->per_group;
    const invcal_real turned = angle(plan->start[group], k, plan->per_group);
    out->group = group + 1;
    out->index = k + 1;
    out->alpha = group == 1 ? -TURN / 4 : turned; /* Table 1 */
    out->beta = group == 0 ? 0 : group == 1 ? turned : TURN / 4;
    set_vertical(out);
    return INVCAL_OK;
}

invcal_status invcal_plan_starts(unsigned per_group, invcal_real start[INVCAL_PLAN_GROUPS])
{
    INVCAL_ASSERT(start);
    const invcal_status status = check_per_group(per_group);

    if (status == INVCAL_OK) {
        const invcal_real step = TURN / (invcal_real)per_group;
        const unsigned quarter = per_group / 4; /* floor(N/4) */
        start[0] = TURN / 4 - step * (invcal_real)quarter;
        start[1] = start[0];
        start[2] = TURN / 2 - step;
    }
    return status;
}

uint8_t invcal_axis_up(const invcal_real vertical[3])
{
    INVCAL_ASSERT(vertical);
    for (unsigned i = 0; i < 3; i++) {
        if (vertical[i] > ALONG) {
            return (uint8_t)(1u << (INVCAL_AXIS_PLUS_X + 2 * i));
        }
        if (vertical[i] < -ALONG) {
            return (uint8_t)(1u << (INVCAL_AXIS_MINUS_X + 2 * i));
        }
    }
    return 0;
}
