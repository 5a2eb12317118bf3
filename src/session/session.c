/* SPDX-License-Identifier: MIT
 *
 * The whole procedure as one state: rests from samples (rests.c), their means in a table, the next
 * direction (guidance.c), and the calibration (judged.c). Positions are kept one by one, not as
 * sums, since the judgement needs each of them again. Feeding a sample never solves, so its cost is
 * bounded.
 */
#include <stddef.h>

#include "../plan/guidance.h"
#include "invcal/plan.h"
#include "invcal/store.h"
#include "../calibrate/judge.h"
#include "rests.h"
#include "session.h"
#include "../core/solve.h"
#include "../core/texts.h"
#include "../core/vector.h"

#define CLOSE INVCAL_REAL(0.9396926)     /* cosine of 20 degrees */
#define LONGEST_HOLD INVCAL_REAL(3600.0) /* seconds to hold */
enum { DOF = 3 };                        /* min degrees of freedom to trust sigma */
enum { NOT_ASKED, NOT_GOOD, GOOD };      /* session->good */

#define HEAD INVCAL_SESSION_HEAD

/* ---- settings -------------------------------------------------------------------------------- */

/* Of another build, no more than the first bytes are written: those are the same in all. */
invcal_status invcal_session_init_nominal(invcal_session *session, size_t size,
                                          const invcal_calibration *nominal, invcal_real rate)
{
    INVCAL_ASSERT(session && nominal);
    invcal_status status =
        size == sizeof *session ? invcali_nominal_check(nominal) : INVCAL_OTHER_BUILD;
    if (status == INVCAL_OK) {
        status = invcali_rests_init(&session->rests, rate);
    }
    invcali_zero(session, offsetof(invcal_session, rate));
    session->reason = (uint8_t)status;
    if (status == INVCAL_OK) {
        session->layout = INVCAL_SESSION_LAYOUT;
        session->rate = rate;
        invcali_copy(&session->nominal, nominal, sizeof *nominal);
        session->noise = 0;
    }
    return status;
}

invcal_status invcal_session_init(invcal_session *session, size_t size, invcal_real counts,
                                  invcal_real rate)
{
    const invcal_real k = 1 / counts;
    invcal_calibration nominal;

    invcali_zero(&nominal, sizeof nominal);
    nominal.matrix[0][0] = k;
    nominal.matrix[1][1] = k;
    nominal.matrix[2][2] = k;

    return invcal_session_init_nominal(session, size, &nominal, rate);
}

invcal_status invcal_session_set_limits(invcal_session *session, int32_t low, int32_t high)
{
    INVCAL_ASSERT(session);
    return invcali_session_is_begun(session) ? invcali_rests_rails(&session->rests, low, high)
                                             : INVCAL_NOT_BEGUN;
}

invcal_status invcal_session_set_noise(invcal_session *session, invcal_real noise)
{
    INVCAL_ASSERT(session);
    if (!invcali_session_is_begun(session)) {
        return INVCAL_NOT_BEGUN;
    }
    if (!(noise > 0 && noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    session->noise = noise;
    session->good = NOT_ASKED;
    return INVCAL_OK;
}

invcal_status invcal_session_set_hold(invcal_session *session, invcal_real seconds)
{
    INVCAL_ASSERT(session);
    if (!invcali_session_is_begun(session)) {
        return INVCAL_NOT_BEGUN;
    }
    if (!(seconds <= LONGEST_HOLD)) {
        return INVCAL_BAD_TIME;
    }
    const invcal_real positive = seconds > 0 ? seconds : 0;
    //@ assert \is_finite(positive); // no NaN is at most an hour
    invcali_rests_hold(&session->rests, (uint32_t)(1000 * positive + INVCAL_REAL(0.5)));
    return INVCAL_OK;
}

/* ---- after a reset --------------------------------------------------------------------------- */

uint32_t invcal_session_size(const invcal_session *session)
{
    INVCAL_ASSERT(session);
    return HEAD + (uint32_t)sizeof session->mean[0] * session->count;
}

/* What must be the same is in a row: layout, rate, nominal. */
invcal_status invcali_session_take(invcal_session *session, const uint8_t *begun,
                                   invcal_status status, uint32_t size)
{
    const unsigned same = (unsigned)offsetof(invcal_session, layout);
    const unsigned end = (unsigned)offsetof(invcal_session, noise);
    const uint8_t *loaded = (const uint8_t *)session;
    uint8_t count = 0;

    if (status == INVCAL_OK) {
        if (!invcali_is_same(&loaded[same], &begun[same], end - same)) {
            status = INVCAL_OTHER_SETTINGS;
        } else if (session->count > INVCAL_MAX_POSITIONS || size != invcal_session_size(session)) {
            status = INVCAL_DAMAGED;
        } else {
            count = session->count;
        }
    }
    invcali_copy(session, begun, HEAD);
    session->count = count;
    session->good = NOT_ASKED;
    return status;
}

invcal_status invcal_session_resume(invcal_session *session, const uint8_t *bytes, uint32_t size)
{
    invcal_status status = INVCAL_OK;
    uint8_t begun[HEAD];

    INVCAL_ASSERT(session && bytes);
    if (!invcali_session_is_begun(session)) {
        return INVCAL_NOT_BEGUN;
    }
    if (size > INVCAL_SESSION_SIZE) {
        status = INVCAL_NO_SPACE;
        size = 0;
    }
    invcali_copy(begun, session, HEAD);
    invcali_copy(session, bytes, (size_t)size);
    return invcali_session_take(session, begun, status, size);
}

/* ---- samples --------------------------------------------------------------------------------- */

/* The reading of the rest that is READY or was just TAKEN. */
INVCAL_NOINLINE static invcal_status read_rest(const invcal_session *session, invcali_row *row)
{
    return invcali_session_is_begun(session) && invcali_rests_mean(&session->rests, row->h)
               ? invcali_observe(&session->nominal, row->h, row)
               : INVCAL_TOO_FEW;
}

/* The table is in the order of taking; if it is full, the oldest is dropped. */
static INVCAL_ONCE void keep(invcal_session *session)
{
    unsigned count = session->count;

    if (count == INVCAL_MAX_POSITIONS) {
        count--;
        for (unsigned i = 0; i < count; i++) {
            invcali_copy(&session->mean[i], &session->mean[i + 1], sizeof session->mean[0]);
        }
    }
    (void)invcali_rests_mean(&session->rests, session->mean[count].v); /* TAKEN: there is one */
    session->count = (uint8_t)(count + 1u);
    session->good = NOT_ASKED;
}

/* A rest that is not a reading of this field is refused at once, and again when it ends. */
INVCAL_NOINLINE static invcal_event digest(invcal_session *session, invcal_event event)
{
    session->last = (uint8_t)event;
    if (event == INVCAL_REFUSED) {
        session->reason = (uint8_t)invcali_rests_reason(&session->rests);
    }
    if (event == INVCAL_READY || event == INVCAL_TAKEN) {
        invcali_row row;
        const invcal_status status = read_rest(session, &row);
        if (status != INVCAL_OK) {
            session->last = INVCAL_REFUSED;
            session->reason = (uint8_t)status;
        } else if (event == INVCAL_TAKEN) {
            keep(session);
        } /* cppcheck-suppress misra-c2012-15.7 ; READY: it may still become better */
    }
    return (invcal_event)session->last;
}

/* The reason is why it was not begun. */
static invcal_event refuse_all(invcal_session *session)
{
    if (session->reason == INVCAL_OK) {
        session->reason = INVCAL_NOT_BEGUN;
    }
    return INVCAL_REFUSED;
}

invcal_event invcal_session_feed(invcal_session *session, int32_t x, int32_t y, int32_t z)
{
    const int32_t raw[3] = {x, y, z};

    INVCAL_ASSERT(session);
    if (!invcali_session_is_begun(session)) {
        return refuse_all(session);
    }
    const invcal_event event = invcali_rests_feed(&session->rests, raw);
    return event == INVCAL_NOTHING ? event : digest(session, event);
}

void invcal_session_gap(invcal_session *session)
{
    INVCAL_ASSERT(session);
    if (invcali_session_is_begun(session)) {
        invcali_rests_gap(&session->rests);
    }
}

invcal_event invcal_session_end(invcal_session *session)
{
    INVCAL_ASSERT(session);
    return invcali_session_is_begun(session)
               ? digest(session, invcali_rests_finish(&session->rests))
               : refuse_all(session);
}

static INVCAL_ONCE invcal_positions positions_of(const invcal_session *session)
{
    const invcal_positions positions = {session->mean, session->count, &session->nominal,
                                        session->noise, NULL};

    return positions;
}

/* ---- instructions ---------------------------------------------------------------------------- */

unsigned invcal_session_progress(const invcal_session *session)
{
    INVCAL_ASSERT(session);
    return invcali_session_is_begun(session) ? invcali_rests_progress(&session->rests) : 0;
}

invcal_status invcal_session_reason(const invcal_session *session)
{
    INVCAL_ASSERT(session);
    return (invcal_status)session->reason;
}

const char *invcal_session_reason_text(const invcal_session *session)
{
    return invcali_refusal_text(invcal_session_reason(session));
}

/* Reads the last position. Returns 0 if there is none. */
INVCAL_NOINLINE static int read_last(const invcal_session *session, invcali_row *row)
{
    if (session->count == 0) {
        return 0;
    }
    (void)invcali_observe(&session->nominal, session->mean[session->count - 1].v,
                          row); /* accepted */
    return 1;
}

void invcal_session_next(const invcal_session *session, invcal_real up[3])
{
    invcal_sums sums;
    invcali_row row;

    INVCAL_ASSERT(session && up);
    const invcali_selection taken = {positions_of(session), 0};
    (void)invcali_positions_sum(&taken, &sums); /* accepted */
    if (session->last != INVCAL_TAKEN && read_rest(session, &row) == INVCAL_OK) {
        invcali_sums_add_row(&sums, &row, 1);
    } else if (!read_last(session, &row)) {
        invcali_zero(&row, sizeof row);
    } /* cppcheck-suppress misra-c2012-15.7 ; the row is that of the last position */
    invcali_next_of_sums(&sums, row.h, up);
}

const char *invcal_session_next_text(const invcal_session *session, char text[INVCAL_TEXT_SIZE])
{
    invcal_real up[3];

    invcal_session_next(session, up);
    return invcal_direction_text(up, text);
}

int invcal_session_is_at(const invcal_session *session, const invcal_real up[3])
{
    invcali_row row;

    INVCAL_ASSERT(session && up);
    int is_known = read_rest(session, &row) == INVCAL_OK;
    if (!is_known) {
        is_known = read_last(session, &row);
    }
    return is_known && invcali_dot3(row.h, up) >= CLOSE * INVCAL_SQRT(invcali_dot3(row.h, row.h));
}

/* ---- the result ------------------------------------------------------------------------------ */

invcal_status invcal_session_solve(const invcal_session *session, invcal_calibration *out,
                                   invcal_quality *quality)
{
    INVCAL_ASSERT(session && out && quality);
#ifndef __AVR__
    if (session->good == GOOD) {
        invcali_copy(out, &session->calibration, sizeof *out);
        invcali_copy(quality, &session->quality, sizeof *quality);
        return INVCAL_OK;
    }
#endif
    const invcal_positions positions = positions_of(session);
    return invcal_calibrate(&positions, out, quality);
}

/* NOT_GOOD, or GOOD with its solution. */
static uint8_t judge_session(const invcal_session *session, invcal_calibration *c,
                             invcal_quality *q)
{
    return invcal_session_solve(session, c, q) == INVCAL_OK && q->verdict == INVCAL_GOOD &&
                   (q->dof >= DOF || session->noise > 0)
               ? GOOD
               : NOT_GOOD;
}

int invcal_session_is_good(invcal_session *session)
{
    INVCAL_ASSERT(session);
    if (session->good == NOT_ASKED) {
#ifdef __AVR__
        invcal_calibration c;
        invcal_quality q;
        session->good = judge_session(session, &c, &q);
#else
        session->good = judge_session(session, &session->calibration, &session->quality);
#endif
    }
    return session->good - NOT_GOOD; /* 1 or 0 */
}
