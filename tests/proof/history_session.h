/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_SESSION_H
#define HISTORY_SESSION_H

#include "history_still.h"
#include "invcal/session.h"

/* Any session, begun with any setup that its init accepts. */
static void any_session(invcal_session *s)
{
    ANY(*s);
    any_still(&s->still);
    s->stored = (uint16_t)BETWEEN(0, INVCAL_MAX_POSITIONS);
}

static void check_session(const invcal_session *s)
{
    check_still(&s->still);
    HOLDS(s->stored <= INVCAL_MAX_POSITIONS);
}

#endif
