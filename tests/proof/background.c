/* SPDX-License-Identifier: MIT */
#include <limits.h>

#include "arbitrary.h"
#include "plan/guidance.h"
#include "invcal/background.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 32 -eva-slevel 40 -eva-split-return full
// stubs: session guidance

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_session_init_nominal(invcal_session *session, size_t size,
                                          const invcal_calibration *nominal, invcal_real rate)
{
    (void)size;
    (void)nominal->matrix[2][2];
    (void)rate;
    if (BETWEEN(0, 1)) {
        ANY(*session);
        session->count = 0;
        return INVCAL_OK;
    }
    return INVCAL_BAD_NOMINAL;
}

/* Takes a place in the table only if the event says so. */
invcal_event invcal_session_feed(invcal_session *session, int32_t x, int32_t y, int32_t z)
{
    const unsigned count = session->count;
    const invcal_event event = (invcal_event)BETWEEN(INVCAL_NOTHING, INVCAL_REFUSED);

    (void)x;
    (void)y;
    (void)z;
    ANY(*session);
    session->count = (uint8_t)(event == INVCAL_TAKEN ? count + 1 : count);
    return event;
}

void invcali_sum_readings(const invcal_positions *positions, invcal_sums *sums, invcal_real last[3])
{
    if (positions->count > 0) {
        (void)positions->mean[BETWEEN(0, positions->count - 1)].v[BETWEEN(0, 2)];
    }
    (void)positions->nominal->matrix[2][2];
    ANY(*sums);
    Frama_C_make_unknown((char *)last, 3 * sizeof *last);
}

invcal_real invcali_ridged_inverse(invcal_sums *sums)
{
    invcal_real ridge;

    ANY(*sums);
    ANY(ridge);
    return ridge;
}

/* ---- in the background ------------------------------------------------------------------------ */

static invcal_background b;

static void any_background(unsigned count)
{
    ANY(b);
    b.session.count = (uint8_t)count;
}

static void check_background(void)
{
    (void)(1 / (b.session.count < INVCAL_MAX_POSITIONS)); /* an alarm if it does not hold */
}

void main(void)
{
    invcal_calibration nominal;
    int32_t raw[3];

    ANY(nominal);
    ANY(raw);
    (void)invcal_background_init(&b, 0, &nominal, 100); /* another build */
    if (invcal_background_init(&b, sizeof b, &nominal, 100) == INVCAL_OK) {
        check_background();
    }
    for (unsigned count = 0; count < INVCAL_MAX_POSITIONS; count++) {
        any_background(count);
        (void)invcal_background_feed(&b, raw[0], raw[1], raw[2]);
        check_background();
        any_background(count);
        invcal_background_age(&b);
        check_background();
    }
}
