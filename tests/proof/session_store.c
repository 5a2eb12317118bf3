/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "driver.h"

// eva: -eva-precision 0 -eva-slevel 60 -eva-split-return auto

static invcal_session session;

/* What was put back is anything, of any length. */
static void resume(void)
{
    ANY(session);
    (void)invcal_session_resume(&session, any_u32());
}

static void keep(void)
{
    const invcal_store store = {any_read, any_erase, any_program, NULL, 1024, 8};

    ANY(session);
    session.count = (uint8_t)BETWEEN(0, INVCAL_MAX_POSITIONS);
    (void)invcal_save_session(&store, &session);
    (void)invcal_load_session(&store, &session);
}

void main(void)
{
    resume();
    keep();
}
