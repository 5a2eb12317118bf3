/* SPDX-License-Identifier: MIT
 *
 * Positions of the paper's programs, Table 1, and start angles as in Table 2
 * (mathematics_programs.md, "Programs"). Angles stay in degrees up to the last step: they are
 * wrapped before they are rounded, and multiples of 90 give exact components.
 */
#include "plan_axes.h"

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
    return per_group <= INVCAL_PLAN_PER_GROUP_MAX ? INVCAL_OK : INVCAL_BAD_COUNT;
}

invcal_status invcali_plan_check(const invcal_plan *plan)
{
    INVCAL_ASSERT(plan);
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        if (!(INVCAL_FABS(plan->start_deg[g]) <= TURN)) {
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
invcal_status invcal_plan_get(const invcal_plan *plan, unsigned i, invcal_plan_position *out)
{
    invcal_real c;
    invcal_real s;

    INVCAL_ASSERT(plan && out);
    const invcal_status status = invcali_plan_check(plan);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned n = plan->per_group;
    if (i >= INVCAL_PLAN_GROUPS * n) {
        return INVCAL_BAD_COUNT;
    }
    const unsigned g = i < n ? 0 : i < 2 * n ? 1 : 2;
    const unsigned k = i - g * n;
    const invcal_real turned = angle(plan->start_deg[g], k, n);
    out->group = g + 1;
    out->index = k + 1;
    out->alpha_deg = g == 1 ? -TURN / 4 : turned; /* Table 1 */
    out->beta_deg = g == 0 ? 0 : g == 1 ? turned : TURN / 4;
    invcali_circle(turned, &c, &s);
    const invcal_real eta[INVCAL_PLAN_GROUPS][3] = {{0, c, s}, {-s, 0, -c}, {s, c, 0}};
    memcpy(out->up, eta[g], sizeof out->up);
    return INVCAL_OK;
}

/* An even N points each axis along +g and along -g with 90 - 360/N floor(N/4) for groups 1 and 2 and
 * 180 - 360/N for group 3: +-z, +-x, +-y. An odd one has no opposite directions. */
invcal_status invcal_plan_init(invcal_plan *plan, unsigned per_group)
{
    INVCAL_ASSERT(plan);
    const invcal_status status = check_per_group(per_group);

    if (status == INVCAL_OK) {
        const invcal_real step = TURN / (invcal_real)per_group;
        const unsigned quarter = per_group / 4; /* floor(N/4) */
        plan->per_group = per_group;
        plan->start_deg[0] = TURN / 4 - step * (invcal_real)quarter;
        plan->start_deg[1] = plan->start_deg[0];
        plan->start_deg[2] = TURN / 2 - step;
    }
    return status;
}

uint8_t invcali_axis_up(const invcal_real up[3])
{
    INVCAL_ASSERT(up);
    for (unsigned i = 0; i < 3; i++) {
        if (up[i] > ALONG) {
            return (uint8_t)(1u << (INVCAL_AXIS_PLUS_X + 2 * i));
        }
        if (up[i] < -ALONG) {
            return (uint8_t)(1u << (INVCAL_AXIS_MINUS_X + 2 * i));
        }
    }
    return 0;
}
