/* SPDX-License-Identifier: MIT
 *
 * Prints what this version of the library writes, as hexadecimal: calibrations, sessions and a
 * flash. For a release, see README.md; no test runs it. With INVCAL_THERMAL_DEGREE=2, for records
 * of all degrees.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "invcal/invcal.h"

static void print(const char *name, const uint8_t *bytes, uint32_t size)
{
    printf("\n%s", name);
    for (uint32_t i = 0; i < size; i++) {
        printf("%s%02x", i % 32 ? "" : "\n", bytes[i]);
    }
    printf("\n");
}

static void must(invcal_status status)
{
    if (status != INVCAL_OK) {
        printf("refused: %s\n", invcal_status_text(status));
    }
}

/* ---- calibrations ------------------------------------------------------------------------------ */

/* No number stands twice, so that none can be taken for another. */
static invcal_record some_record(void)
{
    const invcal_record record = {
        .calibration = {{33123.75f, 33275.125f, 32364.5f},
                        {{0.00241f, -4.125e-6f, -1.1e-5f},
                         {-4.19e-6f, 0.00242f, -2.58e-5f},
                         {-1.11e-5f, -2.57e-5f, 0.00243f}}},
        .delta = {0.0213f, -0.0071f, 0.0154f},
        .dk = {-0.0117f, 0.0042f, 0.0088f},
        .gamma = {0.0033f, -0.0091f, 0.0214f},
        .sigma_offset = {0.31f, 0.32f, 0.37f},
        .sigma_delta = {7.6e-5f, 7.9e-5f, 8.3e-5f},
        .sigma_dk = {1.02e-4f, 1.04e-4f, 1.07e-4f},
        .sigma_gamma = {1.9e-4f, 2.1e-4f, 2.3e-4f},
        .field = 9.81744f,
        .field_sigma = 0.0005f,
        .temperature = -12.5f,
        .temperature_known = 1,
        .sensor = {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88},
        .date = 0x65432101,
        .noise = 1.25e-4f,
        .residual_rms = 9.5e-5f,
        .condition = 13.75f,
        .verdict = INVCAL_WEAK,
        .positions = 0x1234,
        .undetermined = 0x0142,
        .from_prior = 0x0181,
    };
    return record;
}

static void write_thermal(uint8_t degree)
{
    static const char *const names[] = {"thermal_record_0", "thermal_record_1", "thermal_record_2"};
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal_record record = {.record = some_record()};
    invcal_thermal_calibration *c = &record.thermal;
    uint32_t size = 0;

    c->nominal.offset[0] = 32768.5f;
    c->nominal.offset[1] = 32767.25f;
    c->nominal.offset[2] = 32766.75f;
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned k = 0; k < 3; k++) {
            c->nominal.matrix[i][k] =
                (i == k ? 0.0024f : 1e-6f) * (1 + 0.01f * (invcal_real)(3 * i + k));
        }
    }
    for (unsigned k = 0; k <= degree; k++) {
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            c->x[k][r] = 0.001f * (invcal_real)(r + 1) + 0.0001f * (invcal_real)k;
        }
    }
    c->field = 9.81744f;
    c->reference = 22.5f;
    c->span = 47.25f;
    c->least = -20.75f;
    c->greatest = 69.5f;
    c->frame = INVCAL_FRAME_TRIANGULAR;
    c->fallback = degree == 1 ? INVCAL_THERMAL_NARROW : INVCAL_THERMAL_AS_ASKED;
    c->degree = degree;
    c->fitted = degree == 1 ? 0 : degree;
    must(invcal_thermal_record_encode(&record, bytes, &size));
    print(names[degree], bytes, size);
}

/* ---- sessions ---------------------------------------------------------------------------------- */

enum { RATE = 50, DWELL = 4, TURN = 1 };

typedef struct {
    uint32_t random;
    double up[3];
    invcal_session session;
    double temperature;
} device;

/* -1 ... 1 */
static double any(device *d)
{
    d->random = d->random * 1664525u + 1013904223u;
    return d->random / 2147483648.0 - 1;
}

/* A sensor with offsets, scale errors and an x axis that feels y. */
static void feed(device *d, const double up[3], double noise)
{
    const double u[3] = {0.02 + 1.01 * up[0] + 0.007 * up[1], 0.99 * up[1] - 0.03, 1.002 * up[2]};
    invcal_event event;
    int32_t raw[3];

    for (unsigned i = 0; i < 3; i++) {
        raw[i] = (int32_t)floor(130.0 * (i + 1) + 4096 * u[i] + noise * any(d) + 0.5);
    }
    (void)invcal_session_feed(&d->session, raw, (invcal_real)d->temperature, &event);
}

/* Turns there and lies still. */
static void visit(device *d, const double up[3])
{
    for (int i = 0; i < RATE * TURN; i++) {
        const double part = (double)i / (RATE * TURN);
        double way[3];
        for (unsigned k = 0; k < 3; k++) {
            way[k] = (1 - part) * d->up[k] + part * up[k];
        }
        feed(d, way, 250);
    }
    memcpy(d->up, up, sizeof d->up);
    for (int i = 0; i < RATE * DWELL; i++) {
        feed(d, up, 4);
    }
}

static void visit_any(device *d, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        double up[3] = {any(d), any(d), any(d)};
        const double length = sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]);
        for (unsigned k = 0; k < 3; k++) {
            up[k] /= length;
        }
        d->temperature += 0.25;
        visit(d, up);
    }
}

static invcal_session_setup some_setup(void)
{
    const invcal_session_setup setup = {
        .settings = {.nominal = {{120.5f, 250.25f, 380.75f},
                                 {{0.0024f, 1e-6f, 2e-6f},
                                  {3e-6f, 0.0023f, 4e-6f},
                                  {5e-6f, 6e-6f, 0.0025f}}},
                     .field = 9.80665f,
                     .noise = 0.0031f},
        .rate = RATE,
        .low = -32768,
        .high = 32767,
    };
    return setup;
}

static void begin(device *d, const invcal_session_setup *setup, uint32_t seed)
{
    const double level[3] = {0, 0, 1};

    memset(d, 0, sizeof *d);
    d->random = seed;
    d->temperature = 21.5;
    memcpy(d->up, level, sizeof level);
    must(invcal_session_init(&d->session, setup));
}

static void write_session(const char *name, const device *d)
{
    uint8_t bytes[INVCAL_RESUME_SIZE];
    uint32_t size = 0;

    must(invcal_resume_encode(&d->session, bytes, &size));
    print(name, bytes, size);
}

/* In the middle of a program, with a target. */
static void write_program(void)
{
    invcal_session_setup setup = some_setup();
    device d;

    setup.plan.per_group = 6;
    setup.plan.start[0] = 30;
    setup.plan.start[1] = 31.5f;
    setup.plan.start[2] = 120;
    setup.target[0] = 0.0011f;
    setup.target[1] = 0.0012f;
    setup.target[2] = 0.0013f;
    setup.mean_sigma = 0.0008f;
    begin(&d, &setup, 1);
    for (unsigned i = 0; i < 15; i++) {
        invcal_guidance next;
        must(invcal_session_next(&d.session, &next));
        d.temperature += 0.5;
        visit(&d, (const double[3]){(double)next.up[0], (double)next.up[1], (double)next.up[2]});
    }
    write_session("session_program", &d);
}

/* More positions than the table holds: the sums are stored. */
static void write_overfull(void)
{
    invcal_session_setup setup = some_setup();
    device d;

    setup.settings.frame = INVCAL_FRAME_TRIANGULAR;
    begin(&d, &setup, 2);
    visit_any(&d, INVCAL_MAX_POSITIONS + 4);
    write_session("session_sums", &d);
}

/* Nobody follows a procedure: positions age. */
static void write_background(void)
{
    invcal_session_setup setup = some_setup();
    device d;

    setup.background = 1;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        setup.settings.prior[r] = 0.02f + 0.001f * (invcal_real)r;
    }
    begin(&d, &setup, 3);
    for (unsigned day = 0; day < 5; day++) {
        visit_any(&d, 3);
        invcal_session_age(&d.session);
    }
    write_session("session_background", &d);
}

/* ---- a flash ----------------------------------------------------------------------------------- */

enum { GRANULARITY = 8, SLOT = INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, GRANULARITY) };
static uint8_t flash[2][SLOT];

static int read_flash(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, flash[slot] + offset, size);
    return 0;
}

static int erase_flash(void *context, unsigned slot)
{
    (void)context;
    memset(flash[slot], 0xFF, SLOT);
    return 0;
}

static int program_flash(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context;
    memcpy(flash[slot] + offset, bytes, size);
    return 0;
}

/* Two records, one a second older. */
static void write_store(void)
{
    const invcal_store store = {read_flash, erase_flash, program_flash, NULL, SLOT, GRANULARITY};
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record = some_record();

    must(invcal_store_erase(&store));
    record.date--;
    for (int i = 0; i < 2; i++) {
        must(invcal_record_encode(&record, bytes));
        must(invcal_store_save(&store, bytes, sizeof bytes));
        record.date++;
    }
    print("store", &flash[0][0], sizeof flash);
}

int main(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    const invcal_record record = some_record();

    printf("# SPDX-License-Identifier: MIT\n#\n# What invcal " INVCAL_VERSION
           " writes, by tests/reference/releases/write.c. Never made anew.\n");
    must(invcal_record_encode(&record, bytes));
    print("record", bytes, sizeof bytes);
    for (uint8_t degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        write_thermal(degree);
    }
    write_program();
    write_overfull();
    write_background();
    write_store();
    return 0;
}
