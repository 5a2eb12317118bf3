/* SPDX-License-Identifier: MIT */
#ifndef HISTORY_ALLAN_H
#define HISTORY_ALLAN_H

#include "history.h"
#include "allan/noise.h"

/* Any state of one axis. */
static void any_allan(invcal_allan *a)
{
    ANY(*a);
    a->taus = (uint8_t)BETWEEN(0, INVCAL_ALLAN_TAUS);
    for (unsigned k = 0; k < INVCAL_ALLAN_TAUS; k++) {
        a->own[k].m = UINT32_BETWEEN(0, INVCAL_ALLAN_LONGEST);
    }
}

static void check_allan(const invcal_allan *a)
{
    HOLDS(a->taus <= INVCAL_ALLAN_TAUS);
    for (unsigned k = 0; k < INVCAL_ALLAN_TAUS; k++) {
        HOLDS(a->own[k].m <= INVCAL_ALLAN_LONGEST);
    }
}

#endif
