/* SPDX-License-Identifier: MIT
 *
 * invcal_calibrate: calibrates, diagnoses, leaves out what contradicts the others, and
 * repeats this until nothing more is found (mathematics_judgement.md, "Choosing between
 * hypotheses"). In the end repeated directions are taken off the degrees of freedom ("What cannot
 * be tested").
 */
#include "diagnosis.h"
#include "invcal/positions.h"
#include "outliers.h"

#include <stddef.h>

#include "../core/vector.h"

#define VISITED INVCAL_REAL(0.0228) /* three times the square of the chord of 5 degrees */

/* Has the direction of position i been visited before? near: a squared distance, counts. */
static INVCAL_ONCE int is_visited(const invcal_vector *mean, invcali_set left_out, unsigned i,
                                  invcal_real near)
{
    for (unsigned k = 0; k < i; k++) {
        invcal_real square = 0;
        INVCAL_UNROLL
        for (unsigned a = 0; a < 3; a++) {
            const invcal_real d = mean[i].v[a] - mean[k].v[a];
            square += d * d;
        }
        if (!(left_out >> k & 1u) && square <= near) {
            return 1;
        }
    }
    return 0;
}

/* A repeated direction is not a check. One count is worth the gain of the matrix, root mean square
 * over all directions: its square is a third of the sum of the squared elements, hence the three in
 * VISITED. */
static INVCAL_ONCE void judge_directions(const invcal_positions *p, const invcal_calibration *c,
                                         invcal_quality *q)
{
    const invcal_real near = VISITED / invcali_dot(c->matrix[0], c->matrix[0], 9);
    const invcali_set left_out = (invcali_set)q->left_out;

    for (unsigned i = 0; i < p->count; i++) {
        if (!(left_out >> i & 1u) && is_visited(p->mean, left_out, i, near) && q->dof > 0) {
            q->dof--;
        }
    }
    if (q->dof == 0) {
        invcali_raise(q, INVCAL_NO_REDUNDANCY);
    }
}

/* Group by group, since one may mask the next. If one is so wrong that all together give no
 * ellipsoid, search in nominal units. Rough: too many are left out, or the others are not
 * determined without them. */
static INVCAL_ONCE invcal_status leave_out_groups(invcali_selection *s, invcal_calibration *c,
                                                  invcal_quality *q)
{
    int has_solution = 0;

    for (;;) { /* at most INVCAL_MAX_POSITIONS times: each but the last leaves one out */
        const invcal_status status = invcali_positions_calibrate(s, c, q);
        const int is_solved = status == INVCAL_OK;
        invcali_set more = 0;
        has_solution |= is_solved;
        if (is_solved ? !invcali_are_many(q->positions, s->given.count)
                      : !has_solution && status == INVCAL_NOT_ELLIPSOID) {
            more = invcali_diagnose(s, is_solved ? c : s->given.nominal, is_solved ? q : NULL);
        } else if (has_solution) {
            invcali_raise(q, INVCAL_ROUGH);
        } /* cppcheck-suppress misra-c2012-15.7 ; there is no calibration */
        if (more == 0) {
            return has_solution ? INVCAL_OK : status;
        }
        s->left_out |= more;
    }
}

invcal_status invcal_calibrate(const invcal_positions *positions, invcal_calibration *out,
                               invcal_quality *quality)
{
    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && out && out != positions->nominal && quality);
    if (positions->count > INVCAL_MAX_POSITIONS) {
        return INVCAL_BAD_COUNT;
    }
    invcali_selection selection = {*positions, 0};
    const invcal_status status = leave_out_groups(&selection, out, quality);
    if (status == INVCAL_OK) {
        judge_directions(&selection.given, out, quality);
    }
    return status;
}
