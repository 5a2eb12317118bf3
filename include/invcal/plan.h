/* SPDX-License-Identifier: MIT
 *
 * invcal/plan.h: which positions to visit: the paper's programs for a two-axis stand.
 *
 * The stand turns the instrument by alpha about its outer and by beta about its inner axis; in the
 * frame of the instrument the vertical is then
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta).
 *
 * A program is three groups of N positions, each a full turn in N equal steps about one axis (the
 * paper's Table 1):
 *
 *     group   alpha_deg                        beta_deg
 *     1       start_deg[0] + 360 (l - 1)/N     0
 *     2       -90                              start_deg[1] + 360 (l - 1)/N
 *     3       start_deg[2] + 360 (l - 1)/N     90                           l = 1 ... N
 *
 * Positions are computed one at a time: a device stores no table. invcal_session_is_at checks
 * whether one was taken; by hand, follow them roughly. invcal.h states the rules and units.
 */
#ifndef INVCAL_PLAN_H
#define INVCAL_PLAN_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A program: three groups, each a full turn. */
typedef struct {
    unsigned per_group;       /* N, 5 ... 1000 */
    invcal_real start_deg[3]; /* -360 ... 360 */
} invcal_plan;

/* A position of a program. */
typedef struct {
    unsigned group;        /* 1 ... 3 */
    unsigned index;        /* l, 1 ... N */
    invcal_real alpha_deg; /* outer angle, above -180, at most 180 */
    invcal_real beta_deg;  /* inner angle, in the same range */
    invcal_real up[3];     /* eta, a unit vector */
} invcal_plan_position;

/* A plan that points as many of the axes x, y, z up and down as possible: for an even N all six,
 * for an odd one +z, -x, -y. N = 6 starts at 30, 30, 120, the paper's Table 2.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW below 5 positions in a group: its five coefficients are open;
 * INVCAL_BAD_COUNT above 1000. */
INVCAL_NODISCARD invcal_status invcal_plan_init(invcal_plan *plan, unsigned per_group);

/* Position i of a program, 0 ... 3 N - 1. Multiples of 90 degrees give components that are exactly
 * 0 and 1.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW or INVCAL_BAD_COUNT as invcal_plan_init, or if there is no
 * position i; INVCAL_BAD_ANGLE for a start that is NaN or outside its range.
 * Error of a component: 3e-7 (float), 1e-15 (double). Stack: about 120 bytes. */
INVCAL_NODISCARD invcal_status invcal_plan_get(const invcal_plan *plan, unsigned i,
                                               invcal_plan_position *out);

/* A direction in words: "+z up"; "+z up, tilt 45 deg, +x rises"; "-z up, tilt 55 deg, +x and -y
 * rise": from an axis pointing up, tilt the case by that angle (rounded to 5 degrees) so that the
 * sides named come up. Plain ASCII, terminated by zero.
 *
 * up  unit vector; anything else, a NaN too, gives words like any other. Returns text. */
const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE]);

/* For a device that follows a program: is the position that is READY, or else the last one, within
 * 20 degrees of a direction? Returns 1 or 0; 0 if there is neither.
 *
 * up  unit vector. */
int invcal_session_is_at(const invcal_session *session, const invcal_real up[3]);

#ifdef __cplusplus
}
#endif

#endif
