/* SPDX-License-Identifier: MIT
 *
 * A calibration for every temperature, from positions at two.
 */
#include "../positions.h"
#include "digest.h"

#include "invcal/thermal_store.h"

enum { AT_ONE = 16, COUNT = 2 * AT_ONE };

static float means[COUNT][3];
static float temperature[COUNT];
static invcal_calibration nominal;

/* Some K apart; offsets and scales follow. */
static void make_positions(void)
{
    input_positions(means, COUNT, 0.02f, 1e-3f);
    for (unsigned i = 0; i < COUNT; i++) {
        const float celsius = (i < AT_ONE ? 10 : 45) + 2 * input_uniform();
        temperature[i] = celsius;
        means[i][0] += 2 * celsius;
        means[i][1] -= celsius;
        means[i][2] += (means[i][2] - 32768) * 2e-4f * celsius;
    }
}

static void thermal_results(const invcal_thermal *thermal)
{
    digest_reals("reference", &thermal->reference, 1);
    digest_reals("span", &thermal->span, 1);
    digest_reals("min", &thermal->min, 1);
    digest_reals("max", &thermal->max, 1);
    digest_reals("x", thermal->x[0], 3 * INVCAL_PARAMETERS);
    digest_bits("degree", thermal->degree);
    digest_bits("fitted", thermal->fitted);
    digest_bits("fallback", thermal->fallback);
}

static void at_temperatures(const invcal_thermal *thermal)
{
    const invcal_positions *positions = POSITIONS_AT(means, temperature, COUNT, &nominal, 0);

    for (uint32_t celsius = 0; celsius <= 60; celsius += 20) {
        invcal_calibration calibration;
        invcal_thermal_place place;
        invcal_quality quality;
        digest_numbered("degrees", celsius);
        digest_bits("status", invcal_thermal_at(thermal, (float)celsius, &calibration, &place));
        digest_bits("place", place);
        digest_calibration(&calibration, &nominal);
        digest_bits("judged",
                    invcal_thermal_judge(positions, NULL, thermal, (float)celsius, &quality));
        digest_reals("sigma", quality.sigma, INVCAL_PARAMETERS);
        digest_bits("verdict", quality.verdict);
    }
}

/* A year later, from four positions at one temperature. */
static void renew(const invcal_thermal *base)
{
    static invcal_thermal_prior prior;
    const invcal_positions *positions = POSITIONS_AT(means, temperature, 4, &nominal, 1e-3f);
    invcal_thermal renewed;
    invcal_quality quality;

    digest_set("renewed");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        prior.sigma[0][r] = 0.01f;
    }
    for (unsigned i = 0; i < 4; i++) {
        means[i][2] += 30;
    }
    digest_bits("status", invcal_thermal_fit(positions, &prior, base, 0, &renewed, &quality));
    thermal_results(&renewed);
    digest_quality(&quality, &nominal);
}

static void record_results(const invcal_thermal *thermal, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_calibration at_reference;
    invcal_thermal decoded;
    invcal_record about;

    digest_set("record");
    digest_bits("made", invcal_thermal_at(thermal, thermal->reference, &at_reference, NULL));
    invcal_record_init(&about, &at_reference, quality);
    digest_bits("encoded", invcal_thermal_encode(thermal, &about, bytes));
    digest_bytes("bytes", bytes, 212 + 36 * (thermal->degree + 1u));
    memset(&decoded, 0, sizeof decoded);
    digest_bits("decoded", invcal_thermal_decode(bytes, sizeof bytes, &decoded, NULL));
    thermal_results(&decoded);
}

void part_thermal(void)
{
    invcal_thermal thermal;
    invcal_quality quality;

    input_nominal(&nominal);
    make_positions();
    digest_set("fit");
    digest_bits("status",
                invcal_thermal_calibrate(POSITIONS_AT(means, temperature, COUNT, &nominal, 0),
                                         INVCAL_THERMAL_DEGREE, &thermal, &quality));
    thermal_results(&thermal);
    digest_quality(&quality, &nominal);
    at_temperatures(&thermal);
    record_results(&thermal, &quality);
    renew(&thermal);
}
