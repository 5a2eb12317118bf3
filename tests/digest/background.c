/* SPDX-License-Identifier: MIT
 *
 * A device that is never calibrated on purpose: it is put down somewhere again and again.
 */
#include "digest.h"
#include "invcal/background.h"
#include "invcal/positions.h"

enum { RATE = 16, REST = 4 * RATE, MOTION = RATE, PLACES = 60 };

static const input_sensor accelerometer = {
    {35, -20, 12}, {{4150, 20, -11}, {-16, 4020, 9}, {14, -7, 4100}}, 2};

static invcal_background background;

static void feed(const float force[3])
{
    int32_t raw[3];

    input_sample(&accelerometer, force, raw);
    const invcal_event event = invcal_background_feed(&background, raw[0], raw[1], raw[2]);
    if (event == INVCAL_TAKEN || event == INVCAL_REFUSED) {
        digest_bits("event", event);
        digest_bits("reason", background.session.reason);
        digest_bits("positions", background.session.count);
    }
}

static void put_down(void)
{
    float up[3], force[3];

    input_direction(up);
    for (unsigned step = 0; step < MOTION; step++) {
        for (int i = 0; i < 3; i++) {
            force[i] = up[i] + 0.2f * input_noise();
        }
        feed(force);
    }
    for (unsigned step = 0; step < REST; step++) {
        feed(up);
    }
}

void part_background(void)
{
    static const float zero[3] = {0, 0, 0};
    static const float counts[3] = {4096, 4096, 4096};
    invcal_calibration nominal, calibration;
    invcal_quality quality;

    (void)invcal_nominal(zero, counts, &nominal);
    digest_set("begin");
    digest_bits("status", invcal_background_init(&background, sizeof background, &nominal, RATE));
    for (unsigned place = 0; place < PLACES; place++) {
        digest_numbered("place", place);
        put_down();
        invcal_background_age(&background);
    }
    digest_set("result");
    digest_bytes("age", background.age, background.session.count);
    digest_bits("status", invcal_session_solve(&background.session, &calibration, &quality));
    digest_calibration(&calibration, &nominal);
    digest_quality(&quality, &nominal);
}
