/* SPDX-License-Identifier: MIT
 *
 * A magnetometer fed with anything: a device that turns about two axes at any rates, samples that are
 * anything in between, the field and its centre changed on the way. After each stretch its counts are
 * consistent; a calibration that it delivers is finite and regular, and what it says of it hangs together.
 * The same for the rotation to the axes of an accelerometer, of any sums.
 * fuzz: more than 50 inputs per second of CPU time
 */
#include <math.h>
#include <string.h>

#include "magnetometer/cells.h"
#include "fuzz.h"
#include "invcal/magnetometer.h"

enum { STRETCHES = 24, STRETCH = 400 };

static void require_counts(const invcal_magnetometer *m)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        REQUIRE(m->own.early.count[k] < 16384 && m->own.late.count[k] < 16384);
    }
    REQUIRE(m->own.samples < m->own.due && m->own.stage <= 2 && m->own.has_step <= 1);
    REQUIRE(m->own.squares >= 0 && m->own.products >= 0);
}

static void require_solved(const invcal_magnetometer *m)
{
    invcal_calibration calibration;
    invcal_quality quality;
    invcal_magnetometer_found found;
    invcal_real along[3];
    invcal_real raw[3];

    mark(&calibration, sizeof calibration);
    mark(&quality, sizeof quality);
    mark(&found, sizeof found);
    invcal_magnetometer_next(m, along);
    require_direction(along);
    if (invcal_magnetometer_solve(m, &calibration, &quality, &found) != INVCAL_OK) {
        require_mark(&calibration, sizeof calibration);
        require_mark(&quality, sizeof quality);
        require_mark(&found, sizeof found);
        return;
    }
    require_regular(&calibration);
    require_sigma(quality.sigma, INVCAL_PARAMETERS);
    REQUIRE(quality.positions >= INVCAL_PARAMETERS && quality.positions == found.covered);
    REQUIRE(found.covered <= INVCAL_CELLS && found.gap_deg <= 180);
    REQUIRE(found.disturbance <= INVCAL_STEP && quality.verdict <= INVCAL_WEAK);
    REQUIRE(found.field > 0 && found.rms >= 0 && found.alike >= 0);
    unsigned covered = 0;
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        if (invcali_magnetometer_cell(m, &calibration, k, raw) > 0) {
            require_finite(raw, 3);
            covered++;
        }
    }
    REQUIRE(covered == found.covered);
}

/* A stretch of motion, of which every so-many-th sample is anything. */
static void wave(invcal_magnetometer *m, source *s)
{
    const unsigned count = 1 + take_byte(s) * STRETCH / 255;
    const unsigned odd = take_byte(s);
    const double rate = take_byte(s) / 500.0;
    const double other = take_byte(s) / 500.0;
    const double begin = take_byte(s);
    const double field = (double)take_real(s, 480);
    const double centre = (double)take_real(s, 300);

    for (unsigned i = 0; i < count; i++) {
        const double a = begin + rate * i;
        const double b = other * i;
        invcal_real raw[3] = {(invcal_real)(centre + field * sin(a) * cos(b)),
                              (invcal_real)(field * sin(a) * sin(b)),
                              (invcal_real)(field * cos(a) - centre)};
        if (odd > 0 && i % odd == odd - 1) {
            raw[i % 3] = take_real(s, raw[i % 3]);
        }
        const invcal_event event = invcal_magnetometer_feed(m, raw[0], raw[1], raw[2]);
        REQUIRE(event == INVCAL_NOTHING || event == INVCAL_TAKEN || event == INVCAL_REFUSED);
    }
}

static void any_dip(source *s)
{
    invcal_dip dip;
    invcal_dip_quality quality;
    invcal_rotation rotation;

    invcal_dip_init(&dip);
    for (unsigned i = take_byte(s) % 32; i > 0; i--) {
        invcal_real up[3];
        invcal_real field[3];
        direction_of(i, up);
        for (unsigned a = 0; a < 3; a++) {
            field[a] = take_real(s, up[(a + 1) % 3]);
            up[a] = take_real(s, up[a]);
        }
        const invcal_dip before = dip;
        REQUIRE(invcal_dip_add(&dip, up, field) == INVCAL_OK ||
                memcmp(&before, &dip, sizeof dip) == 0);
    }
    mark(&rotation, sizeof rotation);
    mark(&quality, sizeof quality);
    if (invcal_dip_solve(&dip, take_real(s, 10), &rotation, &quality) == INVCAL_OK) {
        for (unsigned i = 0; i < 3; i++) {
            require_direction(rotation.r[i]);
        }
        REQUIRE(quality.sine > -1 && quality.sine < 1 && quality.scatter >= 0);
    } else {
        require_mark(&rotation, sizeof rotation);
        require_mark(&quality, sizeof quality);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    const conditions c = take_conditions(&s);
    invcal_magnetometer m;

    any_dip(&s);
    if (invcal_magnetometer_init(&m, &c.nominal) != INVCAL_OK) {
        REQUIRE(invcal_magnetometer_feed(&m, 1, 2, 3) == INVCAL_REFUSED);
        return 0;
    }
    for (unsigned i = 0; i < STRETCHES && s.left > 0; i++) {
        wave(&m, &s);
        require_counts(&m);
        require_solved(&m);
    }
    return 0;
}
