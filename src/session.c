/* SPDX-License-Identifier: MIT */
#include "invcal/session.h"

#include <string.h>

#include "invcal/calibrate.h"
#include "triad.h"
#include "vector.h"

#define ASKED INVCAL_REAL(0.9396926) /* cos 20 degrees */
#define TELLING INVCAL_REAL(0.35)    /* h K h' of a position that is worth its place */
#define NORMAL INVCAL_REAL(1.96)     /* sigma that hold 95 % where the noise is known */
#define SHORTEST INVCAL_REAL(0.625)  /* seconds: what still.h demands of a rest */
#define DOF 3                        /* residuals to spare before sigma is believed */
#define FADED 88u                    /* days: a sixteenth of the weight is left */

static int is_number_or_none(invcal_real x)
{
    return x >= 0 && x <= INVCAL_REAL_MAX;
}

static int has_plan(const invcal_session_setup *setup)
{
    return setup->plan.per_group > 0;
}

static invcal_status check_setup(const invcal_session_setup *setup)
{
    invcal_status status = invcal_settings_check(&setup->settings);

    for (unsigned b = 0; b < 3; b++) {
        if (!is_number_or_none(setup->target[b])) {
            return INVCAL_BAD_SETTING;
        }
    }
    if (!is_number_or_none(setup->mean_sigma)) {
        return INVCAL_BAD_SETTING;
    }
    if (status == INVCAL_OK && has_plan(setup)) {
        status = invcal_plan_check(&setup->plan);
    }
    return status;
}

invcal_status invcal_session_init(invcal_session *session, const invcal_session_setup *setup)
{
    invcal_still still;

    INVCAL_ASSERT(session && setup);
    invcal_status status = check_setup(setup);
    if (status == INVCAL_OK) {
        status = invcal_still_init(&still, setup->rate, setup->low, setup->high);
    }
    if (status == INVCAL_OK) {
        memset(session, 0, sizeof *session);
        session->setup = *setup;
        session->still = still;
    }
    return status;
}

/* ---- the table of positions ------------------------------------------------------------------ */

static invcal_status read_mean(const invcal_session *session, const invcal_real mean[3],
                               invcal_observation *row)
{
    const invcal_settings *settings = &session->setup.settings;

    return invcal_observe(&settings->nominal, settings->field, mean, row);
}

/* The row of a stored position; it was accepted when it was stored. Else it is empty. */
static void stored_row(const invcal_session *session, unsigned i, invcal_observation *row)
{
    memset(row, 0, sizeof *row);
    (void)read_mean(session, session->mean[i], row);
}

static invcal_real weight_of(const invcal_session *session, unsigned i)
{
    return invcal_faded(session->age[i]);
}

/* The sums anew, as weights and members, or the nominal calibration, have changed. */
static void sum_positions(invcal_session *session)
{
    invcal_observation row;

    invcal_normal_init(&session->normal);
    for (unsigned i = 0; i < session->stored; i++) {
        stored_row(session, i, &row);
        (void)invcal_normal_add(&session->normal, &row, weight_of(session, i));
    }
}

/* The last one takes its place: their order means nothing. */
static void drop(invcal_session *session, unsigned i)
{
    //@ assert 0 < session->stored; // i is one of them
    const unsigned last = --session->stored;

    if (i < last) {
        for (unsigned a = 0; a < 3; a++) {
            session->mean[i][a] = session->mean[last][a];
        }
        session->age[i] = session->age[last];
    }
}

/* h K h' of a row beside those in the table. Where they leave parameters open a small ridge, that
 * of guidance.c, tells what is new from what is not. */
static invcal_real telling(const invcal_session *session, const invcal_observation *row)
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real x[INVCAL_PARAMETERS];

    invcal_normal_matrix(&session->normal, l);
    const invcal_real largest = invcal_largest_diagonal(l, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        l[INVCAL_PACKED(r, r)] += INVCAL_RIDGE * (largest > 1 ? largest : 1);
    }
    /* what is a sum of squares and a ridge is positive definite */
    (void)invcal_cholesky_factor(l, INVCAL_PARAMETERS, INVCAL_EPSILON);
    memcpy(x, row->h, sizeof x);
    invcal_cholesky_forward(l, INVCAL_PARAMETERS, x);
    return invcal_dot(x, x, INVCAL_PARAMETERS);
}

/* The stored position that tells least, by its weight and h K h', and less than `least`; `stored`
 * if none does. */
static unsigned least_telling(const invcal_session *session, invcal_real least)
{
    invcal_observation row;
    unsigned which = session->stored;

    for (unsigned i = 0; i < session->stored; i++) {
        stored_row(session, i, &row);
        const invcal_real t = weight_of(session, i) * telling(session, &row);
        if (t < least) {
            least = t;
            which = i;
        }
    }
    return which;
}

/* ---- a position is taken ---------------------------------------------------------------------- */

/* The mean over the positions, and the extremes. */
static void note_temperature(invcal_session *session, invcal_real t)
{
    const invcal_real change = t - session->temperature;

    if (!invcal_is_finite(change)) {
        return;
    }
    if (session->measured < session->normal.count) {
        session->measured++;
    } else {
        session->measured = session->normal.count;
    }
    const int is_first = session->measured <= 1;
    session->coldest = is_first || t < session->coldest ? t : session->coldest;
    session->warmest = is_first || t > session->warmest ? t : session->warmest;
    session->temperature += change / (invcal_real)session->measured;
}

static void store(invcal_session *session, const invcal_real mean[3])
{
    memcpy(session->mean[session->stored], mean, sizeof session->mean[0]);
    session->age[session->stored++] = 0;
}

/* Background: in place of the one that tells least, if there is no room. It is looked for with the
 * new one among the others, so that det H'H never falls. */
static invcal_session_what keep_if_telling(invcal_session *session, const invcal_real mean[3],
                                           const invcal_observation *row)
{
    if (!(telling(session, row) > TELLING)) {
        return INVCAL_SESSION_COVERED;
    }
    (void)invcal_normal_add(&session->normal, row, 1);
    if (session->stored == INVCAL_MAX_POSITIONS) {
        const unsigned least = least_telling(session, telling(session, row));
        if (least == session->stored) {
            sum_positions(session);
            return INVCAL_SESSION_COVERED;
        }
        drop(session, least);
    }
    store(session, mean);
    sum_positions(session);
    return INVCAL_SESSION_TAKEN;
}

/* Is the reading the one that was asked for? */
static int is_asked(const invcal_session *session, const invcal_real u[3])
{
    invcal_plan_position position;

    if (!has_plan(&session->setup) ||
        invcal_plan_position_at(&session->setup.plan, session->step, &position) != INVCAL_OK) {
        return 1; /* no program: any will do */
    }
    return invcal_dot3(u, position.vertical) >= ASKED * INVCAL_SQRT(invcal_dot3(u, u));
}

/* sigma from few residuals may be small by luck: it counts as much as its interval is wide. */
static int is_within(const invcal_quality *q, const invcal_real sigma[3], invcal_real target)
{
    for (unsigned i = 0; i < 3; i++) {
        if (target > 0 && !(sigma[i] * q->coverage <= target * NORMAL)) {
            return 0;
        }
    }
    return 1;
}

/* On failure solution and quality are lost. */
static invcal_status solve_positions(const invcal_session *session, const invcal_normal *normal,
                                     invcal_mask left_out, invcal_solution *solution,
                                     invcal_quality *quality)
{
    const invcal_positions positions = {&session->mean[0][0], session->age, session->stored,
                                        left_out};

    if (session->stored == 0) {
        return INVCAL_TOO_FEW;
    }
    return invcal_calibrate_sums(normal, &positions, &session->setup.settings, solution, quality);
}

INVCAL_APART static int reaches_target(const invcal_session *session)
{
    const invcal_real *target = session->setup.target;
    invcal_solution solution;
    invcal_quality q;

    const int is_wanted = target[0] > 0 || target[1] > 0 || target[2] > 0;
    if (!is_wanted || solve_positions(session, &session->normal, 0, &solution, &q) != INVCAL_OK) {
        return 0;
    }
    return q.verdict == INVCAL_GOOD && (q.dof >= DOF || session->setup.settings.noise > 0) &&
           is_within(&q, q.sigma_delta, target[0]) && is_within(&q, q.sigma_dk, target[1]) &&
           is_within(&q, q.sigma_gamma, target[2]);
}

/* Procedure: the table takes what it can hold, the sums everything. */
static invcal_session_what add_position(invcal_session *session, const invcal_real mean[3],
                                        const invcal_observation *row, int asked)
{
    const unsigned last = INVCAL_PLAN_GROUPS * session->setup.plan.per_group;

    if (session->stored < INVCAL_MAX_POSITIONS) {
        store(session, mean);
    }
    (void)invcal_normal_add(&session->normal, row, 1);
    if (has_plan(&session->setup) && asked && session->step < last) {
        session->step++;
        if (session->step == last) {
            return INVCAL_SESSION_FINISHED;
        }
    }
    return INVCAL_SESSION_TAKEN;
}

INVCAL_APART static void take(invcal_session *session, const invcal_rest *rest, invcal_event *event)
{
    invcal_real mean[3];
    invcal_observation row;

    invcal_rest_mean(rest, mean);
    event->status = read_mean(session, mean, &row);
    if (event->status != INVCAL_OK) {
        event->what = INVCAL_SESSION_REFUSED;
        return;
    }
    event->is_asked = is_asked(session, row.h);
    event->what = session->setup.background ? keep_if_telling(session, mean, &row)
                                            : add_position(session, mean, &row, event->is_asked);
    if (event->what != INVCAL_SESSION_COVERED) {
        note_temperature(session, session->latest);
    }
}

/* ---- how long to stay -------------------------------------------------------------------------- */

static int is_procedure(const invcal_session *session)
{
    return !session->setup.background;
}

static invcal_real seconds_of(const invcal_session *session, const invcal_rest *rest)
{
    return (invcal_real)rest->count / session->setup.rate;
}

/* The first rest tells the noise: T = s^2 / (sigma^2 rate), s^2 that of a sample in field units, the
 * mean over the axes. */
static void learn_hold(invcal_session *session, const invcal_rest *rest)
{
    const invcal_real sigma = session->setup.mean_sigma;
    const invcal_calibration *c = &session->setup.settings.nominal;
    invcal_real gain = 0;

    if (!(sigma > 0) || session->normal.count > 0) {
        return;
    }
    for (unsigned i = 0; i < 3; i++) {
        gain += invcal_dot3(c->matrix[i], c->matrix[i]) / 3;
    }
    const invcal_real wanted = gain * rest->variance / sigma / sigma / session->setup.rate;
    session->hold = wanted <= INVCAL_SESSION_HOLD_MAX ? wanted : INVCAL_SESSION_HOLD_MAX;
}

void invcal_session_hold(invcal_session *session, invcal_real seconds)
{
    INVCAL_ASSERT(session);
    session->setup.mean_sigma = 0;
    session->hold = !(seconds > 0)                          ? 0
                    : seconds < INVCAL_SESSION_HOLD_LONGEST ? seconds
                                                            : INVCAL_SESSION_HOLD_LONGEST;
}

static int is_short(const invcal_session *session, const invcal_rest *rest)
{
    return is_procedure(session) && !(seconds_of(session, rest) >= session->hold);
}

/* A rest that is long enough, but no reading of this field: better said at once. */
static void announce_rest(const invcal_session *session, const invcal_rest *rest,
                          invcal_event *event)
{
    invcal_real mean[3];
    invcal_observation row;

    invcal_rest_mean(rest, mean);
    event->status = read_mean(session, mean, &row);
    event->what = event->status == INVCAL_OK ? INVCAL_SESSION_READY : INVCAL_SESSION_REFUSED;
}

/* Percent of a time: 100 seconds of it are given. Never 100 before READY. */
static unsigned share(const invcal_session *session, invcal_real hundred)
{
    const invcal_real least = SHORTEST;
    const int is_longer = is_procedure(session) && session->hold > least;
    const invcal_real percent = hundred / (is_longer ? session->hold : least);
    //@ assert \is_finite(percent) && percent >= 0; // as all three are, and least > 0

    return percent < 99 ? (unsigned)percent : 99;
}

/* At rest: READY is said once, when the rest has been measured long enough. */
INVCAL_APART static void settle(invcal_session *session, invcal_event *event)
{
    invcal_rest rest;

    event->what = INVCAL_SESSION_SETTLING;
    if (session->is_ready) {
        return;
    }
    if (!invcal_still_current(&session->still, &rest)) {
        event->progress = share(session, (invcal_real)event->progress * SHORTEST);
        return;
    }
    learn_hold(session, &rest);
    if (is_short(session, &rest)) {
        event->progress = share(session, 100 * seconds_of(session, &rest));
        return;
    }
    session->is_ready = 1;
    announce_rest(session, &rest, event);
}

/* It has been left. */
static void leave(invcal_session *session, const invcal_rest *rest, invcal_event *event)
{
    if (is_short(session, rest)) {
        event->what = INVCAL_SESSION_REFUSED;
        event->reason = INVCAL_REST_SHORT;
        return;
    }
    take(session, rest, event);
    if (event->what == INVCAL_SESSION_TAKEN && is_procedure(session) && !session->is_enough &&
        reaches_target(session)) {
        session->is_enough = 1;
        event->what = INVCAL_SESSION_ENOUGH;
    }
}

static invcal_session_what digest(invcal_session *session, invcal_still_event seen,
                                  const invcal_rest *rest, invcal_event *event)
{
    event->progress = invcal_still_progress(&session->still);
    event->reason = INVCAL_REST_GOOD;
    event->status = INVCAL_OK;
    event->is_asked = 0;
    if (seen == INVCAL_STILL_TAKEN) {
        event->rest = *rest;
    } else {
        memset(&event->rest, 0, sizeof event->rest);
    }
    switch (seen) {
    case INVCAL_STILL_SETTLING:
    case INVCAL_STILL_READY:
        settle(session, event);
        break;
    case INVCAL_STILL_TAKEN:
        leave(session, rest, event);
        session->is_ready = 0;
        break;
    case INVCAL_STILL_REFUSED:
        event->what = INVCAL_SESSION_REFUSED;
        event->reason = invcal_still_reason(&session->still);
        session->is_ready = 0;
        break;
    default:
        event->what = INVCAL_SESSION_MOVING;
        break;
    }
    event->positions = session->normal.count;
    return event->what;
}

invcal_session_what invcal_session_feed(invcal_session *session, const int32_t raw[3],
                                        invcal_real temperature, invcal_event *event)
{
    invcal_rest rest;

    INVCAL_ASSERT(session && raw && event);
    session->latest = temperature;
    const invcal_still_event seen = invcal_still_push(&session->still, raw, &rest);
    return seen == INVCAL_STILL_NONE ? INVCAL_SESSION_NOTHING : digest(session, seen, &rest, event);
}

void invcal_session_gap(invcal_session *session)
{
    INVCAL_ASSERT(session);
    invcal_still_gap(&session->still);
}

invcal_session_what invcal_session_finish(invcal_session *session, invcal_event *event)
{
    invcal_rest rest;

    INVCAL_ASSERT(session && event);
    const invcal_still_event seen = invcal_still_finish(&session->still, &rest);
    return digest(session, seen, &rest, event);
}

/* ---- what to do next, and the result ---------------------------------------------------------- */

/* The position that is READY and still held counts as taken. Returns 1 if there is one. */
static int held_row(const invcal_session *session, invcal_observation *row)
{
    invcal_rest rest;
    invcal_real mean[3];

    if (!invcal_still_current(&session->still, &rest) || !session->is_ready) {
        return 0;
    }
    invcal_rest_mean(&rest, mean);
    return read_mean(session, mean, row) == INVCAL_OK;
}

static invcal_status next_of_plan(const invcal_session *session, unsigned step,
                                  const invcal_normal *normal, invcal_guidance *next)
{
    invcal_plan_position position;

    if (invcal_plan_position_at(&session->setup.plan, step, &position) != INVCAL_OK) {
        return INVCAL_TOO_FEW; /* the program is complete */
    }
    return invcal_guidance_of(normal, position.vertical, next);
}

invcal_status invcal_session_next(const invcal_session *session, invcal_guidance *next)
{
    invcal_normal normal;
    invcal_observation row;

    INVCAL_ASSERT(session && next);
    normal = session->normal;
    const int is_held = held_row(session, &row);
    if (is_held) {
        (void)invcal_normal_add(&normal, &row, 1);
    }
    if (has_plan(&session->setup)) {
        const unsigned step = session->step + (is_held && is_asked(session, row.h) ? 1u : 0u);
        return next_of_plan(session, step, &normal, next);
    }
    if (!is_held && session->stored > 0) {
        stored_row(session, session->stored - 1u, &row);
    }
    const int has_last = is_held || session->stored > 0;
    return invcal_guidance_next(&normal, has_last ? row.h : NULL, next);
}

invcal_status invcal_session_renew(invcal_session *session, const invcal_calibration *nominal)
{
    invcal_settings *settings = &session->setup.settings;
    const invcal_calibration old = settings->nominal;
    invcal_observation row;

    INVCAL_ASSERT(nominal);
    if (session->normal.count > session->stored) {
        return INVCAL_NO_SPACE;
    }
    settings->nominal = *nominal;
    invcal_status status = invcal_settings_check(settings);
    for (unsigned i = 0; i < session->stored && status == INVCAL_OK; i++) {
        status = read_mean(session, session->mean[i], &row) == INVCAL_OK ? INVCAL_OK
                                                                         : INVCAL_OUT_OF_RANGE;
    }
    if (status != INVCAL_OK) {
        settings->nominal = old;
        return status;
    }
    sum_positions(session);
    return INVCAL_OK;
}

/* The sums without the outliers. Where none can be looked for, none are left out: what positions
 * (and a prior) are worth, invcal_calibrate_sums will say. */
INVCAL_APART static void leave_out(const invcal_session *session, invcal_normal *normal,
                                   invcal_outliers *outliers)
{
    invcal_observation row;

    memset(outliers, 0, sizeof *outliers);
    (void)invcal_outliers_find(&session->mean[0][0], session->stored, &session->setup.settings,
                               outliers);
    for (unsigned i = 0; i < session->stored; i++) {
        if (outliers->removed >> i & 1u) {
            stored_row(session, i, &row);
            (void)invcal_normal_remove(normal, &row, weight_of(session, i));
        }
    }
}

INVCAL_APART static invcal_status solve_without_outliers(const invcal_session *session,
                                                         invcal_solution *solution,
                                                         invcal_quality *quality,
                                                         invcal_outliers *outliers)
{
    invcal_normal normal = session->normal;

    leave_out(session, &normal, outliers);
    return solve_positions(session, &normal, outliers->removed, solution, quality);
}

invcal_status invcal_session_solve(const invcal_session *session, invcal_solution *solution,
                                   invcal_quality *quality, invcal_outliers *outliers)
{
    invcal_solution s;
    invcal_quality q;

    INVCAL_ASSERT(session && solution && quality);
    const invcal_status status = outliers ? solve_without_outliers(session, &s, &q, outliers)
                                          : solve_positions(session, &session->normal, 0, &s, &q);
    if (status == INVCAL_OK) {
        *solution = s;
        *quality = q;
    }
    return status;
}

void invcal_session_age(invcal_session *session)
{
    INVCAL_ASSERT(session);
    if (!session->setup.background) {
        return;
    }
    for (unsigned i = session->stored; i > 0; i--) {
        if (++session->age[i - 1] > FADED) {
            drop(session, i - 1);
        }
    }
    sum_positions(session);
}

/* Squared half widths of the intervals: a sigma that is small by luck does not win. */
static invcal_real squares(const invcal_quality *q)
{
    return q->coverage * q->coverage *
           (invcal_dot(q->sigma_delta, q->sigma_delta, 3) +
            invcal_dot(q->sigma_dk, q->sigma_dk, 3) +
            invcal_dot(q->sigma_gamma, q->sigma_gamma, 3));
}

int invcal_session_improves(const invcal_quality *found, const invcal_quality *present)
{
    INVCAL_ASSERT(found && present);
    return found->verdict <= present->verdict && squares(found) < squares(present);
}
