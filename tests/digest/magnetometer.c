/* SPDX-License-Identifier: MIT
 *
 * A magnetometer that is waved, while a magnet passes by; and its axes against those of an
 * accelerometer.
 */
#include "digest.h"
#include "invcal/positions.h"

#include "magnetometer/cells.h"
#include "invcal/magnetometer.h"

enum { RATE = 50, SAMPLES = 60 * RATE, ALIKE = 8 };

static const input_sensor sensor = {
    {620, -310, 150}, {{480, 10, -7}, {10, 510, 5}, {-7, 5, 465}}, 3};

static invcal_magnetometer magnetometer;
static invcal_calibration nominal;

/* Back and forth, -1 ... 1, with a period in samples. */
static float back_and_forth(unsigned sample, unsigned period)
{
    const float phase = (float)(sample % period) / (float)period;

    return phase < 0.5f ? 4 * phase - 1 : 3 - 4 * phase;
}

/* The turn of the device from sample to sample. */
static void wave(unsigned sample, float v[3])
{
    const float by[3] = {0.06f * back_and_forth(sample, 700), 0.05f,
                         0.06f * back_and_forth(sample, 1100)};

    input_turn(v, by);
    input_to_unit(v);
}

static void feed(unsigned sample, const float field[3])
{
    int32_t counts[3];

    input_sample(&sensor, field, counts);
    const float raw[3] = {(float)counts[0], (float)counts[1], (float)counts[2]};
    const invcal_event event = invcal_magnetometer_feed(&magnetometer, raw[0], raw[1], raw[2]);
    if (event != INVCAL_NOTHING) {
        digest_numbered("sample", sample);
        digest_bits("event", event);
    }
}

/* The magnet passes by for half a second; later a reading fails. */
static void wave_about(void)
{
    float field[3] = {0, 0.6f, -0.8f};
    float along[3];

    digest_set("begin");
    digest_bits("status", invcal_magnetometer_init(&magnetometer, &nominal));
    for (unsigned sample = 0; sample < SAMPLES; sample++) {
        wave(sample, field);
        float disturbed[3] = {field[0], field[1], field[2]};
        if (sample / (RATE / 2) == 90) {
            disturbed[0] += 0.4f;
        }
        if (sample == 2500) {
            memset(disturbed, 0, sizeof disturbed);
        }
        feed(sample, disturbed);
        if (sample % 500 == 499) {
            invcal_magnetometer_next(&magnetometer, along);
            digest_reals("next", along, 3);
        }
    }
}

static void cells(const invcal_calibration *calibration)
{
    digest_set("cells");
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        float raw[3] = {0, 0, 0};
        digest_bits("samples", invcali_magnetometer_cell(&magnetometer, calibration, k, raw));
        digest_reals("raw", raw, 3);
    }
}

static void solve(invcal_calibration *calibration)
{
    static invcal_magnetometer_found found;
    invcal_quality quality;

    digest_set("solution");
    digest_bits("status", invcal_magnetometer_solve(&magnetometer, calibration, &quality, &found));
    digest_calibration(calibration, &nominal);
    digest_quality(&quality, &nominal);
    digest_reals("field", &found.field, 1);
    digest_reals("rms", &found.rms, 1);
    digest_reals("alike", &found.alike, 1);
    digest_bits("samples", found.samples);
    digest_bits("left_out", found.dropped);
    digest_bits("covered", found.covered);
    digest_bits("gap", found.gap_deg);
    digest_bits("disturbance", found.disturbance);
}

/* The magnetometer sits a little askew. */
static void dip(invcal_calibration *calibration)
{
    static const float askew[3] = {0.05f, -0.03f, 0.08f};
    float up[3] = {0, 0, 1}, field[3] = {0, 0.6f, -0.8f};
    invcal_rotation rotation;
    invcal_dip dip;
    invcal_dip_quality quality;

    digest_set("dip");
    invcal_dip_init(&dip);
    for (unsigned sample = 0; sample < 500; sample++) {
        float seen[3];
        wave(sample, up);
        wave(sample, field);
        for (int i = 0; i < 3; i++) {
            seen[i] = field[i] + 0.002f * input_noise();
        }
        input_turn(seen, askew);
        if (sample % 10 == 0) {
            digest_bits("added", invcal_dip_add(&dip, up, seen));
        }
    }
    digest_bits("status", invcal_dip_solve(&dip, ALIKE, &rotation, &quality));
    digest_reals("rotation", rotation.r[0], 9);
    digest_reals("sigma", quality.sigma, 3);
    digest_reals("sine", &quality.sine, 1);
    digest_reals("scatter", &quality.scatter, 1);
    digest_reals("heading", &quality.heading, 1);
    invcal_rotate(calibration, &rotation);
    digest_reals("matrix", calibration->matrix[0], 9);
}

void part_magnetometer(void)
{
    static const float zero[3] = {0, 0, 0};
    static const float counts[3] = {1, 1, 1};
    invcal_calibration calibration;

    (void)invcal_nominal(zero, counts, &nominal);
    wave_about();
    solve(&calibration);
    cells(&calibration);
    dip(&calibration);
}
