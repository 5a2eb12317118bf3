/* SPDX-License-Identifier: MIT
 *
 * A session with any setup, fed with anything: rests and moves as of a person, any int32, any
 * temperature, gaps, holds, other nominal calibrations, days that go by, power that goes. After every
 * event its counts are consistent; a calibration that it delivers is finite and positive definite.
 * fuzz: at least 10 inputs a second
 */
#include <string.h>

#include "drive.h"

static invcal_session_setup take_setup(source *s)
{
    enum { PLAN = 1, TARGET = 2, MEAN_SIGMA = 4, RATE = 8, RAILS = 16, BACKGROUND = 32 };
    static const invcal_real rate[] = {8, 10, 25, 50};
    const unsigned unusual = take_byte(s);
    invcal_session_setup setup;

    memset(&setup, 0, sizeof setup);
    setup.settings = take_settings(s);
    setup.rate = rate[unusual >> 6];
    if (unusual & PLAN) {
        setup.plan.per_group = take_byte(s);
        for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
            setup.plan.start[g] = take_real(s, 30);
        }
    }
    for (unsigned i = 0; i < 3 && unusual & TARGET; i++) {
        setup.target[i] = take_real(s, INVCAL_REAL(0.01));
    }
    if (unusual & MEAN_SIGMA) {
        setup.mean_sigma = take_real(s, INVCAL_REAL(0.001));
    }
    if (unusual & RATE) {
        setup.rate = take_real(s, 100);
    }
    if (unusual & RAILS) {
        setup.low = take_i32(s);
        setup.high = take_i32(s);
    }
    setup.background = unusual & BACKGROUND ? 1 : 0;
    return setup;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    const invcal_session_setup setup = take_setup(&s);
    invcal_session session;

    mark(&session, sizeof session);
    if (invcal_session_init(&session, &setup) != INVCAL_OK) {
        require_mark(&session, sizeof session);
        return 0;
    }
    drive(&session, &s);
    return 0;
}
