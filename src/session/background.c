/* SPDX-License-Identifier: MIT
 *
 * Calibration of a device in use (mathematics_programs.md, "Guidance"): the detector and table of a
 * session, but a position stays only if it adds information. Its worth is its leverage h K h' among
 * all positions kept: each new one changes K, so all are weighed again when a rest is taken, never
 * in between.
 */
#include <string.h>

#include "../plan/guidance.h"
#include "invcal/background.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* Min h K h' of a position to keep: l = 9 of 20 without it in the sums, l / (1 + l) with it. */
#define INFORMATIVE (INVCAL_REAL(9.0) / 29)
enum { DAYS = 88 }; /* after which a position is dropped */

invcal_status invcal_background_init(invcal_background *background, size_t size,
                                     const invcal_calibration *nominal, invcal_real rate)
{
    INVCAL_ASSERT(background && nominal);
    const size_t of_session =
        size == sizeof *background ? sizeof background->session : 0; /* 0: it refuses */
    const invcal_status status =
        invcal_session_init_nominal(&background->session, of_session, nominal, rate);
    if (status == INVCAL_OK) {
        invcali_zero(background->age, sizeof background->age);
    }
    return status;
}

/* Later positions move up. */
static void drop_position(invcal_background *b, unsigned i)
{
    //@ split i;
    b->session.count--;
    b->session.good = 0; /* to be judged again */
    for (; i < b->session.count; i++) {
        b->session.mean[i] = b->session.mean[i + 1];
        b->age[i] = b->age[i + 1];
    }
}

/* Refuses the last position if it adds little. If the table is full, drops the least informative
 * one, by its share of det H'H, an old one before a new one. Returns the event for the new one. */
INVCAL_NOINLINE static invcal_event sift(invcal_background *b)
{
    invcal_session *session = &b->session;
    invcal_real least = INVCAL_REAL_MAX;
    invcal_real leverage = 0;
    unsigned which = 0;
    invcal_sums sums;
    invcali_row row;

    const invcal_positions kept = {session->mean, session->count, &session->nominal, 0, NULL};
    invcali_sum_readings(&kept, &sums, row.h);
    (void)invcali_ridged_inverse(&sums);
    for (unsigned i = 0; i < b->session.count; i++) {
        (void)invcali_observe(&session->nominal, session->mean[i].v, &row); /* it was accepted */
        leverage = invcali_leverage(sums.sum, row.h); /* finally that of the newest */
        const invcal_real worth = (invcal_real)(DAYS - b->age[i]) * leverage;
        if (worth < least) {
            least = worth;
            which = i;
        }
    }
    if (!(leverage > INFORMATIVE)) {
        drop_position(b, session->count - 1u);
        session->last = INVCAL_REFUSED;
        session->reason = INVCAL_REST_SAME;
        return INVCAL_REFUSED;
    }
    if (session->count == INVCAL_MAX_POSITIONS) { /* before the session would drop the oldest */
        drop_position(b, which);
    }
    return INVCAL_TAKEN;
}

invcal_event invcal_background_feed(invcal_background *background, int32_t x, int32_t y, int32_t z)
{
    INVCAL_ASSERT(background);
    invcal_session *const session = &background->session;
    const invcal_event event = invcal_session_feed(session, x, y, z);
    if (event != INVCAL_TAKEN) {
        return event;
    }
    background->age[session->count - 1u] = 0;
    return sift(background);
}

void invcal_background_age(invcal_background *background)
{
    INVCAL_ASSERT(background);
    /* from the end, since later positions move up */
    for (unsigned i = background->session.count; i > 0; i--) {
        if (++background->age[i - 1] >= DAYS) {
            drop_position(background, i - 1);
        }
    }
}
