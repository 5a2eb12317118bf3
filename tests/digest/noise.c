/* SPDX-License-Identifier: MIT
 *
 * The noise of an axis at rest, which also wanders.
 */
#include "digest.h"

#include "invcal/allan.h"

enum { RATE = 100, SAMPLES = 4000 };

static invcal_allan allan;

static void feed(void)
{
    float walk = 0;

    digest_bits("begun", invcal_allan_init(&allan, sizeof allan));
    for (unsigned i = 0; i < SAMPLES; i++) {
        walk += 0.5f * input_noise();
        invcal_allan_feed(&allan, (int32_t)(12000 + walk + 20 * input_noise()));
        if (i == SAMPLES / 3) {
            invcal_allan_gap(&allan);
        }
    }
}

static void points(void)
{
    for (unsigned i = 0; i < INVCAL_ALLAN_TAUS; i++) {
        invcal_allan_point point = {0, 0, 0, 0, 0};
        digest_numbered("tau", i);
        digest_bits("status", invcal_allan_get(&allan, i, &point));
        digest_bits("m", point.m);
        digest_bits("count", point.count);
        digest_reals("adev", &point.adev, 1);
        digest_reals("edf", &point.edf, 1);
        digest_reals("relative", &point.relative, 1);
    }
}

static void dwell(const invcal_noise *noise, float sigma)
{
    static invcal_dwell dwell;
    const invcal_status status = invcal_noise_dwell(noise, sigma, &dwell);

    digest_set("dwell");
    digest_bits("status", status);
    digest_reals("seconds", &dwell.seconds, 1);
    digest_reals("sigma", &dwell.sigma, 1);
    digest_bits("end", dwell.end);
}

void part_noise(void)
{
    static invcal_noise noise;

    feed();
    points();
    digest_set("model");
    digest_bits("status", invcal_allan_solve(&allan, RATE, &noise));
    digest_reals("coefficient", noise.coefficient, INVCAL_NOISE_KINDS);
    digest_reals("relative", noise.relative, INVCAL_NOISE_KINDS);
    digest_bits("visible", (uint32_t)noise.visible);
    digest_reals("misfit", &noise.misfit, 1);
    digest_reals("minimum", &noise.minimum, 1);
    digest_reals("best", &noise.best, 1);
    digest_reals("shortest", &noise.shortest, 1);
    digest_reals("longest", &noise.longest, 1);
    dwell(&noise, 5);
    dwell(&noise, 0.1f);
}
