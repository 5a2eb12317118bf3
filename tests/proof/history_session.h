/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_SESSION_H
#define HISTORY_SESSION_H

#include "history_rests.h"

/* Any session at these rates. */
static void any_session(invcal_session *s, unsigned bits)
{
    ANY(*s);
    any_rests(&s->rests, bits);
    s->count = (uint8_t)BETWEEN(0, INVCAL_MAX_POSITIONS);
}

static void check_session(const invcal_session *s, unsigned bits)
{
    check_rests(&s->rests, bits);
    HOLDS(s->count <= INVCAL_MAX_POSITIONS);
}

#endif
