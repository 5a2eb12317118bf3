/* SPDX-License-Identifier: MIT */
#include <limits.h>

#include "history_session.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 32 -eva-slevel 40

static invcal_session session;

static void any_begin(void)
{
    invcal_calibration nominal;
    invcal_real counts;
    invcal_session begun;

    ANY(nominal);
    ANY(counts);
    if (invcal_session_init(&begun, counts, BETWEEN(0, UINT_MAX)) == INVCAL_OK) {
        HOLDS(begun.count == 0);
    }
    if (invcal_session_begin(&begun, &nominal, BETWEEN(0, UINT_MAX)) == INVCAL_OK) {
        HOLDS(begun.count == 0);
    }
}

static void any_feed(unsigned bits)
{
    int32_t raw[3];

    ANY(raw);
    any_session(&session, bits);
    (void)invcal_session_feed(&session, raw);
    check_session(&session, bits);
    any_session(&session, bits);
    (void)invcal_session_finish(&session);
    check_session(&session, bits);
}

static void any_change(unsigned bits)
{
    invcal_real noise;
    int32_t low, high;

    ANY(noise);
    ANY(low);
    ANY(high);
    any_session(&session, bits);
    invcal_session_hold(&session, BETWEEN(0, 0xFFFFFFFF));
    invcal_session_gap(&session);
    (void)invcal_session_noise(&session, noise);
    (void)invcal_session_rails(&session, low, high);
    check_session(&session, bits);
}

static void any_look(unsigned bits)
{
    char words[INVCAL_WORDS];
    invcal_real up[3];

    any_session(&session, bits);
    ANY(up);
    (void)invcal_session_progress(&session);
    (void)invcal_session_last(&session);
    (void)invcal_session_reason(&session);
    (void)invcal_session_why(&session);
    (void)invcal_session_is_at(&session, up);
    invcal_session_next(&session, up);
    (void)invcal_session_next_words(&session, words);
}

static void any_result(void)
{
    invcal_calibration out;
    invcal_quality quality;
    invcal_real target[3];

    any_session(&session, 2);
    ANY(target);
    (void)invcal_session_solve(&session, &out, &quality);
    (void)invcal_session_is_good(&session);
    (void)invcal_session_reaches(&session, target);
}

void main(void)
{
    any_begin();
    //@ loop unroll 9;
    for (unsigned bits = 2; bits <= 10; bits++) {
        any_feed(bits);
        any_change(bits);
    }
    any_look(2);
    any_result();
}
