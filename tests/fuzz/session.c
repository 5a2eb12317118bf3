/* SPDX-License-Identifier: MIT
 *
 * A session with any setup, or one in the background, fed with anything: rests and moves as of a
 * person, any int32, gaps, holds, other rails, days that go by, power that goes. After every event its
 * counts are consistent; a calibration that it delivers is finite and positive definite.
 * fuzz: more than 10 inputs per second of CPU time
 */
#include <string.h>

#include "drive.h"
#include "session/rests.h"

enum { NOISE = 1, HOLD = 2, RAILS = 4, RATE = 8, COUNTS = 16, BACKGROUND = 32 };

static unsigned take_rate(source *s, unsigned unusual)
{
    static const unsigned rate[] = {8, 10, 25, 50};

    return unusual & RATE ? take_u32(s) % 10000 : rate[unusual >> 6];
}

/* Returns 1 if it has begun; what is refused is untouched. */
static int begin(invcal_background *b, source *s, unsigned unusual)
{
    const conditions c = take_conditions(s);
    const unsigned rate = take_rate(s, unusual);
    invcal_status status;

    mark(b, sizeof *b);
    if (unusual & BACKGROUND) {
        status = invcal_background_init(b, sizeof *b, &c.nominal, (invcal_real)rate);
    } else if (unusual & COUNTS) {
        status = invcal_session_init(&b->session, sizeof b->session, take_real(s, 1000),
                                     (invcal_real)rate);
    } else {
        status = invcal_session_init_nominal(&b->session, sizeof b->session, &c.nominal,
                                             (invcal_real)rate);
    }
    if (status != INVCAL_OK) {
        require_mark((const uint8_t *)b + 8, sizeof *b - 8); /* the first say why */
        REQUIRE(status == INVCAL_BAD_NOMINAL || status == INVCAL_BAD_RATE);
        return 0;
    }
    REQUIRE(rate >= INVCAL_RATE_MIN && rate <= INVCAL_RATE_MAX);
    require_regular(&b->session.nominal);
    REQUIRE(b->session.count == 0 && invcal_session_reason(&b->session) == INVCAL_OK);
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    const unsigned unusual = take_byte(&s);
    invcal_background b;

    if (!begin(&b, &s, unusual)) {
        return 0;
    }
    if (unusual & NOISE) {
        (void)invcal_session_set_noise(&b.session, take_real(&s, INVCAL_REAL(0.001)));
    }
    if (unusual & HOLD) {
        invcal_session_set_hold(&b.session, (invcal_real)(take_u32(&s)) / 1000);
    }
    if (unusual & RAILS) {
        const int32_t low = take_i32(&s);
        (void)invcal_session_set_limits(&b.session, low, take_i32(&s));
    }
    drive(&b.session, unusual & BACKGROUND ? &b : NULL, &s);
    return 0;
}
