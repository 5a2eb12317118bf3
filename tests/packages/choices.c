/* SPDX-License-Identifier: MIT
 *
 * A program that was compiled with other build options than its library: each _init must refuse its structure, and
 * nothing behind the first bytes of it may be written, then or later, whatever is fed. Says what does not hold.
 *
 * SESSION, MOVES, ALLAN  1: the option changes these structures; 0: they are not tried
 */
#include <stdio.h>
#include <string.h>

#include "invcal/allan.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "invcal/gyro.h"
#include "invcal/store.h"

enum {
    FIRST = 64,
    ALL = 65536
}; /* bytes: those that may be written, and those of the largest structure */

static const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
static union {
    unsigned char bytes[ALL];
    invcal_session session;
    invcal_background background;
    invcal_imu imu;
    invcal_allan allan;
} memory;
static unsigned char before[ALL];
static int failures;

static void expect(int holds, const char *what)
{
    if (!holds) {
        printf("%s\n", what);
        failures++;
    }
}

static void fill(int byte)
{
    memset(&memory, byte, sizeof memory);
    memset(before, byte, sizeof before);
}

static void expect_untouched(size_t from, const char *what)
{
    expect(memcmp(memory.bytes + from, before + from, ALL - from) == 0, what);
}

static void try_session(void)
{
    invcal_session *session = &memory.session;

    expect(invcal_session_init(session, sizeof *session, 16384, 100) == INVCAL_OTHER_BUILD,
           "session_init");
    expect(invcal_session_feed(session, 1, 2, 3) == INVCAL_REFUSED, "session_feed");
    expect(strcmp(invcal_session_reason_text(session), "other build") == 0, "session_reason_text");
    expect(invcal_session_init_nominal(session, sizeof *session, &unit, 100) == INVCAL_OTHER_BUILD,
           "session_init_nominal");
    expect(!invcal_session_is_good(session), "session_is_good");
    expect_untouched(FIRST, "session");
}

static void try_background(void)
{
    invcal_background *background = &memory.background;

    expect(invcal_background_init(background, sizeof *background, &unit, 100) == INVCAL_OTHER_BUILD,
           "background_init");
    expect(invcal_background_feed(background, 1, 2, 3) == INVCAL_REFUSED, "background_feed");
    expect_untouched(FIRST, "background");
}

/* If the session is of the same size in both, it was begun; it says why it refuses, too. */
static void try_moves(void)
{
    invcal_imu *imu = &memory.imu;

    expect(invcal_session_init(&imu->session, sizeof imu->session, 16384, 100) ==
               (SESSION && MOVES && ALLAN ? INVCAL_OTHER_BUILD : INVCAL_OK),
           "session of both");
    memcpy(before, memory.bytes, sizeof before);
    expect(invcal_imu_init(imu, sizeof *imu, 3753, 100) == INVCAL_OTHER_BUILD, "imu_init");
    expect(invcal_imu_init_nominal(imu, sizeof *imu, &unit, 100) == INVCAL_OTHER_BUILD,
           "imu_init_nominal");
    for (int i = 0; i < 1000; i++) {
        invcal_imu_feed_gyro(imu, 1000, 2000, -3000);
        expect(invcal_imu_feed(imu, 1, 2, 3) == INVCAL_REFUSED, "imu_feed");
    }
    invcal_imu_gap(imu);
    expect(strcmp(invcal_session_reason_text(&imu->session), "other build") == 0,
           "reason_text of both");
    expect(imu->own.layout == 0, "moves: begun");
    memset(before + offsetof(invcal_imu, own.layout), 0, sizeof imu->own.layout);
    before[offsetof(invcal_imu, own.fault)] = INVCAL_OTHER_BUILD;
    before[offsetof(invcal_imu, session.reason)] = INVCAL_OTHER_BUILD;
    memset(before + offsetof(invcal_imu, session.layout), 0, sizeof imu->session.layout);
    expect_untouched(0, "moves");
}

static void try_allan(void)
{
    invcal_allan *allan = &memory.allan;
    const uint32_t one = 1;

    expect(invcal_allan_init(allan, sizeof *allan) == INVCAL_OTHER_BUILD, "allan_init");
    expect(invcal_allan_init_taus(allan, sizeof *allan, &one, 1, 0) == INVCAL_OTHER_BUILD,
           "allan_init_taus");
    for (int i = 0; i < 1000; i++) {
        invcal_allan_feed(allan, i);
    }
    expect_untouched(FIRST, "allan");
}

int main(void)
{
    static void (*const tries[])(void) = {try_session, try_background, try_moves, try_allan};
    static const int is_changed[] = {SESSION, SESSION, MOVES, ALLAN};
    static const int bytes[] = {0, 0x5A, 0xFF};

    for (unsigned i = 0; i < 4; i++) {
        for (unsigned k = 0; k < 3 && is_changed[i]; k++) {
            fill(bytes[k]);
            tries[i]();
        }
    }
    return failures > 0;
}
