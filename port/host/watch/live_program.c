/* SPDX-License-Identifier: MIT */
#include "watch/live_program.h"

#include <math.h>

#include "text/paint.h"
#include "text/wrapped.h"

#define FOLLOWED 3u  /* positions of a program that tell zero and scale, if they are these */
#define FAR_ZERO 0.3 /* over the field */
#define ASTRAY 2u    /* positions in a row that were not asked for: worth a word */

void live_program_begin(live_program *l, const design *set, const invcal_session *session,
                        const positions *taken, double unit, int is_zero_stated)
{
    program_begin(&l->now, set);
    l->session = session;
    l->taken = taken;
    l->unit = unit;
    l->is_zero_stated = is_zero_stated;
    l->wanted = set->count;
    l->astray = 0;
}

/* ---- where a rest was -------------------------------------------------------------------------- */

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

/* Nothing states the zero, nor do so few positions tell it: their directions may be anything. */
static int is_zero_unknown(const live_program *l)
{
    return !l->is_zero_stated && l->taken->count < FOLLOWED;
}

/* The position that a rest was at, a mean in counts. What is no position, as long as nobody knows the
 * zero, counts as the one asked for. */
static void visit(const live_program *l, program *p, const invcal_calibration *known,
                  const double counts[3])
{
    double up[3];

    invcal_apply(known, counts, up);
    const unsigned found = program_find(p, up);
    program_visit(p, found == PROGRAM_NOWHERE && is_zero_unknown(l) ? p->asked : found, up);
}

/* The last rest was not where it was asked to be. */
static int is_astray(const program *now, unsigned asked)
{
    return asked < now->set->count && now->here != asked && !now->is_again;
}

int live_program_take(live_program *l)
{
    const invcal_calibration known = best_known(l);
    const design *set = l->now.set;

    l->wanted = l->now.asked;
    program_begin(&l->now, set);
    for (unsigned n = 0; n < l->taken->count; n++) {
        double counts[3];
        for (unsigned i = 0; i < 3; i++) {
            counts[i] = l->taken->mean[3 * (size_t)n + i] / l->unit;
        }
        visit(l, &l->now, &known, counts);
    }
    l->astray = is_astray(&l->now, l->wanted) ? l->astray + 1 : 0;
    return l->wanted < set->count && l->now.asked == set->count;
}

int live_program_scale(const live_program *l, double zero[3], double *length)
{
    const unsigned count = l->taken->count;

    return count >= FOLLOWED && count <= l->now.set->count &&
           program_scale(&l->now, l->taken->mean, count, zero, length) &&
           hypot(hypot(zero[0], zero[1]), zero[2]) > FAR_ZERO * *length;
}

/* ---- what is said of it ------------------------------------------------------------------------ */

/* The program as it will be once the rest that is READY and still held has been taken: until the next
 * call. */
static const program *foreseen(const live_program *l)
{
    static program soon; /* large */
    double counts[3];

    soon = l->now;
    if (invcal_session_progress(l->session) == 100 &&
        invcal_rests_mean(&l->session->rests, counts)) {
        const invcal_calibration known = best_known(l);
        visit(l, &soon, &known, counts);
    }
    return &soon;
}

void live_program_say_good(const live_program *l, FILE *talk)
{
    char text[PROGRAM_TEXT_MAX];
    char words[PROGRAM_TEXT_MAX + 80];
    char but[40] = "";
    const program *soon = foreseen(l);

    if (is_astray(soon, l->now.asked)) {
        snprintf(but, sizeof but, ", but not position %u", l->now.asked + 1);
    }
    (void)program_angles_text(soon, text);
    snprintf(words, sizeof words, "good%s: move on%s%s", but, *text ? " to " : "", text);
    (void)wrapped_words(talk, 0, 2, words);
}

void live_program_say_wrong(const live_program *l, FILE *talk)
{
    char text[PROGRAM_TEXT_MAX];

    if (l->astray > 0) {
        wrapped_printf(talk, 2, "%swrong position:%s %s. It is used all the same",
                       paint_on(talk, PAINT_YELLOW), paint_off(talk),
                       program_wrong_text(&l->now, l->wanted, text));
    }
    if (l->astray == ASTRAY) {
        wrapped_printf(talk, 2,
                       "%u wrong in a row: are alpha and beta exchanged, is the sense of one "
                       "reversed, or its zero elsewhere?",
                       ASTRAY);
    }
}

void live_program_say_missing(const live_program *l, FILE *talk)
{
    char text[PROGRAM_TEXT_MAX];

    if (l->now.asked < l->now.set->count) {
        wrapped_printf(talk, 2, "of the program not visited: %s",
                       program_missing_text(&l->now, text));
    }
}
