/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "history_session.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-split-return full -eva-slevel 10
// trusted: 2

static invcal_session session;

static void any_begin(void)
{
    invcal_session_setup setup;
    invcal_session begun;

    ANY(setup);
    if (invcal_session_init(&begun, &setup) == INVCAL_OK) {
        HOLDS(begun.stored == 0);
    }
}

static void any_feed(void)
{
    int32_t raw[3];
    invcal_real temperature;
    invcal_event event;

    ANY(raw);
    ANY(temperature);
    any_session(&session);
    (void)invcal_session_feed(&session, raw, temperature, &event);
    check_session(&session);
}

static void any_finish(void)
{
    invcal_event event;

    any_session(&session);
    (void)invcal_session_finish(&session, &event);
    check_session(&session);
}

static void any_change(void)
{
    invcal_real seconds;
    invcal_calibration nominal;

    ANY(seconds);
    ANY(nominal);
    any_session(&session);
    invcal_session_hold(&session, seconds);
    invcal_session_gap(&session);
    (void)invcal_session_renew(&session, &nominal);
    invcal_session_age(&session);
    check_session(&session);
}

static void any_look(void)
{
    invcal_guidance next;
    invcal_solution solution;
    invcal_quality found;
    invcal_quality present;
    invcal_outliers outliers;

    any_session(&session);
    (void)invcal_session_next(&session, &next);
    (void)invcal_session_solve(&session, &solution, &found, NULL);
    (void)invcal_session_solve(&session, &solution, &found, &outliers);
    ANY(found);
    ANY(present);
    (void)invcal_session_improves(&found, &present);
}

void main(void)
{
    any_begin();
    any_feed();
    any_finish();
    any_change();
    any_look();
}
