/* SPDX-License-Identifier: MIT */
#include <limits.h>

#include "history_session.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 32 -eva-slevel 40

static void any_background(invcal_background *b, unsigned bits)
{
    ANY(b->age);
    any_session(&b->session, bits);
    b->session.count = (uint8_t)BETWEEN(0, INVCAL_MAX_POSITIONS - 1);
}

static void check_background(const invcal_background *b, unsigned bits)
{
    check_session(&b->session, bits);
    HOLDS(b->session.count < INVCAL_MAX_POSITIONS);
}

void main(void)
{
    static invcal_background b;
    invcal_calibration nominal;
    int32_t raw[3];

    ANY(nominal);
    ANY(raw);
    if (invcal_background_init(&b, &nominal, BETWEEN(0, UINT_MAX)) == INVCAL_OK) {
        HOLDS(b.session.count == 0);
    }
    //@ loop unroll 9;
    for (unsigned bits = 2; bits <= 10; bits++) {
        any_background(&b, bits);
        (void)invcal_background_feed(&b, raw);
        check_background(&b, bits);
    }
    any_background(&b, 2);
    invcal_background_age(&b);
    check_background(&b, 2);
}
