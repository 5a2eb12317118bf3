/* SPDX-License-Identifier: MIT
 *
 * A program with other build options than its library, and structures in zeros: every _init refuses them, writes
 * nothing behind their first bytes, and nothing is written afterwards, whatever is fed. Prints nothing then.
 *
 * WHAT     the structure, of 1 << OF_... those that the option changes
 */
#include <stdio.h>
#include <string.h>

#include "invcal/allan.h"
#include "invcal/expert.h"
#include "invcal/gyro.h"
#include "invcal/store.h"

enum { HEAD = 64, BEHIND = 65536 }; /* bytes: what may be written; what must not be */

static unsigned char memory[BEHIND];
static unsigned char before[BEHIND];
static int failures;

static void expect(int holds, const char *what)
{
    if (!holds) {
        printf("%s\n", what);
        failures++;
    }
}

/* Nothing but the reason has changed, at the beginning. */
static void expect_untouched(const char *what)
{
    expect(memcmp(memory + HEAD, before + HEAD, BEHIND - HEAD) == 0, what);
}

static void try_session(unsigned char fill)
{
    invcal_session *session = (invcal_session *)(void *)memory;
    const invcal_calibration nominal = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    memset(memory, fill, sizeof memory);
    memset(before, fill, sizeof before);
    expect(invcal_session_init(session, sizeof *session, 16384, 100) == INVCAL_OTHER_BUILD,
           "session_init");
    expect(invcal_session_feed(session, 1, 2, 3) == INVCAL_REFUSED, "session_feed");
    expect(invcal_session_reason(session) == INVCAL_OTHER_BUILD, "session_reason");
    expect(strcmp(invcal_session_reason_text(session), "other build") == 0, "session_why");
    expect_untouched("session_init");
    expect(invcal_session_init_nominal(session, sizeof *session, &nominal, 100) ==
               INVCAL_OTHER_BUILD,
           "session_begin");
    expect(!invcal_session_is_good(session), "session_is_good");
    expect_untouched("session_begin");
}

static void try_background(unsigned char fill)
{
    invcal_background *background = (invcal_background *)(void *)memory;
    const invcal_calibration nominal = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    memset(memory, fill, sizeof memory);
    memset(before, fill, sizeof before);
    expect(invcal_background_init(background, sizeof *background, &nominal, 100) ==
               INVCAL_OTHER_BUILD,
           "background_init");
    expect(invcal_background_feed(background, 1, 2, 3) == INVCAL_REFUSED, "background_feed");
    expect_untouched("background_init");
}

static void try_moves(unsigned char fill)
{
    invcal_moves *moves = (invcal_moves *)(void *)memory;
    const invcal_calibration nominal = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    memset(memory, fill, sizeof memory);
    memset(before, fill, sizeof before);
    expect(invcal_moves_init(moves, sizeof *moves, &nominal, 100) == INVCAL_OTHER_BUILD,
           "moves_init");
    for (int i = 0; i < 1000; i++) {
        invcal_moves_feed(moves, 1000, 2000, -3000);
    }
    invcal_moves_gap(moves);
    memset(before + offsetof(invcal_moves, layout), 0, sizeof moves->layout);
    expect(memcmp(memory, before, BEHIND) == 0, "moves_init");
}

static void try_allan(unsigned char fill)
{
    invcal_allan *allan = (invcal_allan *)(void *)memory;
    const uint32_t one = 1;

    memset(memory, fill, sizeof memory);
    memset(before, fill, sizeof before);
    expect(invcal_allan_init(allan, sizeof *allan) == INVCAL_OTHER_BUILD, "allan_init");
    expect(invcal_allan_init_taus(allan, sizeof *allan, &one, 1) == INVCAL_OTHER_BUILD,
           "allan_begin");
    for (int i = 0; i < 1000; i++) {
        invcal_allan_feed(allan, i);
    }
    expect_untouched("allan_init");
}

int main(void)
{
    static const unsigned char fill[] = {0, 0x5A, 0xFF};

    for (unsigned i = 0; i < sizeof fill; i++) {
        SESSION ? try_session(fill[i]) : (void)0;
        SESSION ? try_background(fill[i]) : (void)0;
        MOVES ? try_moves(fill[i]) : (void)0;
        ALLAN ? try_allan(fill[i]) : (void)0;
    }
    return failures > 0;
}
