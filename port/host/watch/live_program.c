/* SPDX-License-Identifier: MIT */
#include "watch/live_program.h"

#include <math.h>
#include <stdio.h>

#include "session/rests.h"

#define FAR_ZERO 0.3 /* over the field */

void live_program_begin(live_program *l, const design *set, const invcal_session *session,
                        const positions *taken, double unit, int is_zero_stated)
{
    program_begin(&l->program, set);
    l->session = session;
    l->taken = taken;
    l->unit = unit;
    l->is_zero_stated = is_zero_stated;
    l->requested = set->count;
    l->wrong_count = 0;
}

/* ---- the position of a rest -------------------------------------------------------------------- */

/* The calibration so far, or the nominal one. */
static invcal_calibration best_known(const live_program *l)
{
    invcal_calibration calibration;
    invcal_quality q;

    return invcal_session_solve(l->session, &calibration, &q) == INVCAL_OK &&
                   q.verdict != INVCAL_WEAK && q.dof > 0
               ? calibration
               : l->session->nominal;
}

/* The zero is not stated, and too few positions have been taken to determine it: any direction is
 * possible. */
static int is_zero_unknown(const live_program *l)
{
    return !l->is_zero_stated && l->taken->count < LIVE_PROGRAM_FOLLOWED;
}

/* Finds the position of a rest, a mean in counts. As long as the zero is unknown, a rest at no
 * position counts as the requested one. */
static void visit(const live_program *l, program *p, const invcal_calibration *known,
                  const double counts[3])
{
    double up[3];

    invcal_apply(known, counts[0], counts[1], counts[2], up);
    const unsigned found = program_find(p, up);
    program_visit(p, found == PROGRAM_NO_POSITION && is_zero_unknown(l) ? p->next : found, up);
}

/* The last rest was not at the requested position. */
static int is_wrong_position(const program *p, unsigned requested)
{
    return requested < p->set->count && p->current != requested && !p->is_repeat;
}

/* A better calibration may correct the positions of earlier rests. With many rests it hardly
 * improves, so they are all visited again only when their number has doubled: total time stays
 * proportional to the length of the stream. */
static unsigned first_to_visit(const live_program *l)
{
    const unsigned count = l->taken->count;

    return count <= INVCAL_MAX_POSITIONS || (count & (count - 1)) == 0 ? 0 : count - 1;
}

int live_program_take(live_program *l)
{
    const invcal_calibration known = best_known(l);
    const design *set = l->program.set;
    const unsigned first = first_to_visit(l);

    l->requested = l->program.next;
    if (first == 0) {
        program_begin(&l->program, set);
    }
    for (unsigned n = first; n < l->taken->count; n++) {
        double counts[3];
        for (unsigned i = 0; i < 3; i++) {
            counts[i] = l->taken->mean[3 * (size_t)n + i] / l->unit;
        }
        visit(l, &l->program, &known, counts);
    }
    l->wrong_count = is_wrong_position(&l->program, l->requested) ? l->wrong_count + 1 : 0;
    return l->requested < set->count && l->program.next == set->count;
}

int live_program_scale(const live_program *l, double zero[3], double *length)
{
    const unsigned count = l->taken->count;

    return count >= LIVE_PROGRAM_FOLLOWED && count <= l->program.set->count &&
           program_scale(&l->program, l->taken->mean, count, zero, length) &&
           hypot(hypot(zero[0], zero[1]), zero[2]) > FAR_ZERO * *length;
}

/* ---- texts ------------------------------------------------------------------------------------- */

const program *live_program_predicted(const live_program *l)
{
    static program soon; /* large */
    double counts[3];

    soon = l->program;
    if (invcal_session_progress(l->session) == 100 &&
        invcali_rests_mean(&l->session->rests, counts)) {
        const invcal_calibration known = best_known(l);
        visit(l, &soon, &known, counts);
    }
    return &soon;
}

const char *live_program_good_text(const live_program *l, const program *soon, char *text,
                                   size_t size)
{
    char angles[PROGRAM_TEXT_MAX];
    char but[64] = "";

    if (is_wrong_position(soon, l->program.next)) {
        snprintf(but, sizeof but, ", but not position %u", l->program.next + 1);
    }
    (void)program_angles_text(soon, angles);
    snprintf(text, size, "good%s: move on%s%s", but, *angles ? " to " : "", angles);
    return text;
}

const char *live_program_wrong_text(const live_program *l, char text[PROGRAM_TEXT_MAX])
{
    text[0] = '\0';
    return l->wrong_count > 0 ? program_wrong_text(&l->program, l->requested, text) : text;
}

const char *live_program_missing_text(const live_program *l, char text[PROGRAM_TEXT_MAX])
{
    text[0] = '\0';
    return l->program.next < l->program.set->count ? program_missing_text(&l->program, text) : text;
}
