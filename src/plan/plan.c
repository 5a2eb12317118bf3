/* SPDX-License-Identifier: MIT
 *
 * Positions of the paper's programs, Table 1, and start angles as in Table 2
 * (mathematics_programs.md, "Programs"). Angles stay in degrees up to the last step: they are
 * wrapped before they are rounded, and multiples of 90 give exact components.
 */
#include "invcal/plan.h"

#include <string.h>

#include "../core/circle.h"
#include "../core/vector.h"

#define TURN INVCAL_REAL(360.0)
#define ALONG INVCAL_REAL(0.99999847691) /* cos 0.1 degrees */

static invcal_status check_per_group(unsigned per_group)
{
    if (per_group < INVCAL_PLAN_PER_GROUP_MIN) {
        return INVCAL_TOO_FEW;
    }
    return per_group <= INVCAL_PLAN_PER_GROUP_MAX ? INVCAL_OK : INVCAL_BAD_ANGLE;
}

invcal_status invcal_plan_check(const invcal_plan *plan)
{
    INVCAL_ASSERT(plan);
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        if (!(INVCAL_FABS(plan->start[g]) <= TURN)) {
            return INVCAL_BAD_ANGLE;
        }
    }
    return check_per_group(plan->per_group);
}

/* The same angle above -180, at most 180; |degrees| is a turn or less. */
static invcal_real wrap(invcal_real degrees)
{
    return degrees > TURN / 2 ? degrees - TURN : degrees <= -TURN / 2 ? degrees + TURN : degrees;
}

/* start + 360 k / N, wrapped before rounding: half a turn is subtracted from each part, exactly. */
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

/* The rows of eta are eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta) with
 * the constant angle of each group put in. */
invcal_status invcal_plan_position_at(const invcal_plan *plan, unsigned i,
                                      invcal_plan_position *out)
{
    invcal_real c;
    invcal_real s;

    INVCAL_ASSERT(plan && out);
    const invcal_status status = invcal_plan_check(plan);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned n = plan->per_group;
    if (i >= INVCAL_PLAN_GROUPS * n) {
        return INVCAL_BAD_ANGLE;
    }
    const unsigned g = i < n ? 0 : i < 2 * n ? 1 : 2;
    const unsigned k = i - g * n;
    const invcal_real turned = angle(plan->start[g], k, n);
    out->group = g + 1;
    out->index = k + 1;
    out->alpha = g == 1 ? -TURN / 4 : turned; /* Table 1 */
    out->beta = g == 0 ? 0 : g == 1 ? turned : TURN / 4;
    invcal_circle(turned, &c, &s);
    const invcal_real eta[INVCAL_PLAN_GROUPS][3] = {{0, c, s}, {-s, 0, -c}, {s, c, 0}};
    memcpy(out->vertical, eta[g], sizeof out->vertical);
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
