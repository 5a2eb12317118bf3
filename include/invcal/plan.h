/* SPDX-License-Identifier: MIT
 *
 * invcal/plan.h: which positions to visit: the paper's programs for a two-axis stand.
 *
 * The stand turns the instrument by alpha about its outer and by beta about its inner axis; in the
 * frame of the instrument the vertical is then
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta).
 *
 * A program is three groups of N positions, each group a full turn in N equal steps about one
 * axis (the paper's Table 1):
 *
 *     group   alpha                        beta
 *     1       start 1 + 360 (l - 1)/N      0
 *     2       -90                          start 2 + 360 (l - 1)/N
 *     3       start 3 + 360 (l - 1)/N      90                           l = 1 ... N
 *
 * The information of a program does not depend on the start angles (mathematics_programs.md; the
 * host tool computes it for any directions). They decide which axes are exactly along gravity.
 *
 * Positions are computed one at a time, so a device that follows a program stores no table:
 * invcal_session_is_at checks whether one was taken. A stand is optional: with the device in the
 * hand, follow the verticals roughly.
 */
#ifndef INVCAL_PLAN_H
#define INVCAL_PLAN_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_PLAN_GROUPS 3u        /* of a program */
#define INVCAL_PLAN_PER_GROUP_MIN 5u /* positions in a group: one per coefficient of its series */
#define INVCAL_PLAN_PER_GROUP_MAX 1000u /* max positions in a group */

/* A program: three groups, each a full turn. */
typedef struct {
    unsigned per_group;                    /* N, from INVCAL_PLAN_PER_GROUP_MIN to .._MAX */
    invcal_real start[INVCAL_PLAN_GROUPS]; /* degrees, -360 ... 360 */
} invcal_plan;

/* A position of a program. */
typedef struct {
    unsigned group;          /* 1 ... 3 */
    unsigned index;          /* l, 1 ... N */
    invcal_real alpha;       /* outer angle, degrees, above -180, at most 180 */
    invcal_real beta;        /* inner angle, in the same range */
    invcal_real vertical[3]; /* eta: unit vector of the up direction in the instrument frame */
} invcal_plan_position;

/* Is the plan usable?
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW    fewer than 5 positions in a group: its five coefficients are open;
 *   INVCAL_BAD_ANGLE  more than INVCAL_PLAN_PER_GROUP_MAX, or a start angle that is NaN or outside
 *                     -360 ... 360. */
invcal_status invcal_plan_check(const invcal_plan *plan);

/* Position i of a program, i from 0 to 3 N - 1: Table 1 and eta(alpha, beta).
 * Multiples of 90 degrees give components that are exactly 0 and 1.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW or INVCAL_BAD_ANGLE by invcal_plan_check;
 * INVCAL_BAD_ANGLE if there is no position i.
 * Error of a component: 3e-7 (float), 1e-15 (double). Stack: about 120 bytes. */
invcal_status invcal_plan_position_at(const invcal_plan *plan, unsigned i,
                                      invcal_plan_position *out);

/* Start angles with which a program points as many of the axes x, y, z up and down as possible.
 *
 * The paper asks for each axis along +g and along -g. An even N achieves it with
 * 90 - 360/N floor(N/4) for groups 1 and 2 and 180 - 360/N for group 3: +-z, +-x, +-y; N = 6 gives
 * 30, 30, 120, the paper's Table 2. For an odd N, which has no opposite directions, the same angles
 * give +z, -x, -y. (From N = 901 on a quarter of a step is below the 0.1 degrees of
 * invcal_axis_up: all six count.)
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW, INVCAL_BAD_ANGLE for an N outside its range. */
invcal_status invcal_plan_starts(unsigned per_group, invcal_real start[INVCAL_PLAN_GROUPS]);

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
 * positions gives the axes of a plan.
 *
 * vertical  a unit vector; any other, or a NaN, does no harm. */
uint8_t invcal_axis_up(const invcal_real vertical[3]);

/* A direction in words: "+z up"; "+z up, tilt 45 deg, +x rises"; "-z up, tilt 55 deg, +x and -y
 * rise": from an axis pointing up, tilt the case by that angle (rounded to 5 degrees) so that the
 * sides named come up. Plain ASCII, terminated by zero.
 *
 * up  unit vector; anything else, a NaN too, gives words like any other. Returns text. */
const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE]);

/* Is the position that is READY, or else the last one, within 20 degrees of a direction, such as
 * that of a program (plan.h)? Returns 1 or 0; 0 if there is neither.
 *
 * up  unit vector. */
int invcal_session_is_at(const invcal_session *session, const invcal_real up[3]);

#ifdef __cplusplus
}
#endif

#endif
