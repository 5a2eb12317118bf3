/* SPDX-License-Identifier: MIT */
#include <limits.h>

#include "arbitrary.h"
#include "plan/guidance.h"
#include "invcal/plan.h"
#include "invcal/store.h"
#include "calibrate/judge.h"
#include "session/rests.h"
#include "session/session.h"
#include "core/texts.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 32 -eva-slevel 100 -eva-split-return full
// trusted: 1
// stubs: rests judge judged guidance words status

static invcal_session session;

/* ---- what other modules do -------------------------------------------------------------------- */

static invcal_status any_status(void)
{
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);
}

static invcal_event any_event(invcal_private_rests *rests)
{
    ANY(*rests);
    return (invcal_event)BETWEEN(INVCAL_NOTHING, INVCAL_REFUSED);
}

invcal_status invcali_rests_init(invcal_private_rests *rests, invcal_real rate)
{
    const invcal_status status = any_status();

    (void)rate;
    if (status == INVCAL_OK) {
        ANY(*rests);
    }
    return status;
}

invcal_status invcali_rests_rails(invcal_private_rests *rests, int32_t low, int32_t high)
{
    (void)low;
    (void)high;
    ANY(*rests);
    return any_status();
}

void invcali_rests_hold(invcal_private_rests *rests, uint32_t milliseconds)
{
    (void)milliseconds;
    ANY(*rests);
}

invcal_event invcali_rests_feed(invcal_private_rests *rests, const int32_t raw[3])
{
    (void)raw[2];
    return any_event(rests);
}

void invcali_rests_gap(invcal_private_rests *rests)
{
    ANY(*rests);
}

invcal_event invcali_rests_finish(invcal_private_rests *rests)
{
    return any_event(rests);
}

unsigned invcali_rests_progress(const invcal_private_rests *rests)
{
    (void)rests->bits;
    return BETWEEN(0, 100);
}

invcal_status invcali_rests_reason(const invcal_private_rests *rests)
{
    (void)rests->reason;
    return any_status();
}

int invcali_rests_mean(const invcal_private_rests *rests, invcal_real mean[3])
{
    (void)rests->bits;
    if (BETWEEN(0, 1)) {
        Frama_C_make_unknown((char *)mean, 3 * sizeof *mean);
        return 1;
    }
    return 0;
}

/* May look at any reading of the array. */
static void look_at(const invcal_positions *positions)
{
    if (positions->count > 0) {
        (void)positions->mean[BETWEEN(0, positions->count - 1)].v[BETWEEN(0, 2)];
    }
    (void)positions->nominal->matrix[2][2];
    (void)positions->noise;
}

invcal_status invcal_calibrate(const invcal_positions *positions, invcal_calibration *out,
                               invcal_quality *quality)
{
    const invcal_status status = any_status();

    look_at(positions);
    if (status == INVCAL_OK) {
        ANY(*out);
        ANY(*quality);
    }
    return status;
}

invcal_status invcali_positions_pass(const invcali_selection *selection,
                                     const invcal_calibration *c, const invcal_real a[3][3],
                                     invcal_sums *sums, invcal_quality *q)
{
    look_at(&selection->given);
    (void)selection->left_out;
    (void)c->matrix[2][2];
    (void)a;
    (void)q;
    ANY(*sums);
    return any_status();
}

void invcali_next_of_sums(invcal_sums *sums, const invcal_real current[3], invcal_real up[3])
{
    ANY(*sums);
    (void)current[2];
    Frama_C_make_unknown((char *)up, 3 * sizeof *up);
}

const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE])
{
    (void)up[2];
    Frama_C_make_unknown(text, INVCAL_TEXT_SIZE);
    return text;
}

const char *invcali_refusal_text(invcal_status status)
{
    return status == INVCAL_OK ? "" : "any";
}

/* ---- the session ------------------------------------------------------------------------------ */

static void any_session(void)
{
    ANY(session);
    session.count = (uint8_t)BETWEEN(0, INVCAL_MAX_POSITIONS);
}

static void check_session(void)
{
    (void)(1 / (session.count <= INVCAL_MAX_POSITIONS)); /* an alarm if it does not hold */
}

static void any_begin(void)
{
    invcal_calibration nominal;
    invcal_real counts;
    invcal_real rate;

    ANY(nominal);
    ANY(counts);
    ANY(rate);
    any_session();
    (void)invcal_session_init(&session, sizeof session, counts, rate);
    check_session();
    any_session();
    (void)invcal_session_init_nominal(&session, BETWEEN(0, UINT_MAX), &nominal, rate);
    check_session();
}

static void any_change(void)
{
    int32_t raw[3];
    invcal_real noise;
    int32_t low, high;

    ANY(raw);
    ANY(noise);
    ANY(low);
    ANY(high);
    any_session();
    (void)invcal_session_feed(&session, raw[0], raw[1], raw[2]);
    check_session();
    any_session();
    (void)invcal_session_end(&session);
    check_session();
    (void)invcal_session_set_hold(&session, noise);
    invcal_session_gap(&session);
    (void)invcal_session_set_noise(&session, noise);
    (void)invcal_session_set_limits(&session, low, high);
    check_session();
}

/* What was saved is anything, of any length; what is resumed is a session, whose table is within it. */
static void any_resume(void)
{
    static uint8_t bytes[INVCAL_SESSION_SIZE];
    static uint8_t begun[INVCAL_SESSION_HEAD];

    any_session();
    (void)(1 / (invcal_session_size(&session) <= INVCAL_SESSION_SIZE));
    ANY(bytes);
    (void)invcal_session_resume(&session, bytes, BETWEEN(0, 0xFFFFFFFF));
    check_session();
    ANY(session);
    ANY(begun);
    (void)invcali_session_take(&session, begun, any_status(), BETWEEN(0, 0xFFFFFFFF));
    check_session();
}

static void any_look(void)
{
    char text[INVCAL_TEXT_SIZE];
    invcal_real up[3];

    any_session();
    ANY(up);
    (void)invcal_session_progress(&session);
    (void)invcal_session_reason(&session);
    (void)invcal_session_reason_text(&session);
    (void)invcal_session_is_at(&session, up);
    invcal_session_next(&session, up);
    (void)invcal_session_next_text(&session, text);
}

static void any_result(void)
{
    invcal_calibration out;
    invcal_quality quality;

    any_session();
    (void)invcal_session_solve(&session, &out, &quality);
    (void)invcal_session_is_good(&session);
}

void main(void)
{
    any_begin();
    any_change();
    any_resume();
    any_look();
    any_result();
}
