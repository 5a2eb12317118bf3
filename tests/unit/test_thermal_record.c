/* SPDX-License-Identifier: MIT
 *
 * For every INVCAL_THERMAL_DEGREE.
 */
#include <float.h>
#include <string.h>

#include "invcal/thermal_record.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum {
    DEGREE = INVCAL_THERMAL_DEGREE,
    SIZE = INVCAL_THERMAL_RECORD_SIZE,
    FLAT = INVCAL_THERMAL_RECORD_BYTES(0), /* of degree 0 */
    MARGIN = 16,
    RECORD_AT = 4,
    DEGREE_AT = 188,
    REALS_AT = 192,
    SPAN_AT = 196,
    MATRIX_AT = 220,
    X_AT = 256
};

/* A record of degree 0 whose coefficients are none, so that at the reference the nominal holds. By
 * Python, numbers as in golden_record:
 *
 *     import struct, zlib
 *     b = struct.pack('<BBH8sIHHHBB39f', 0xCA, 1, 184, b'SN-00042', 0x6543210F, 54, 0x101, 0x82,
 *         2, 1, *reals)       # record.h
 *     b += struct.pack('<I', zlib.crc32(b))
 *     b = struct.pack('<BBH184sBBBB25f', 0xCB, 1, 296, b, 0, 0, 1, 0, 25, 45, -20.5, 70.25,
 *         *offset, *matrix, *[0] * 9)
 *     b += struct.pack('<I', zlib.crc32(b))
 */
static const uint8_t golden[FLAT] = {
    0xCB, 0x01, 0x28, 0x01, 0xCA, 0x01, 0xB8, 0x00, 0x53, 0x4E, 0x2D, 0x30, 0x30, 0x30, 0x34, 0x32,
    0x0F, 0x21, 0x43, 0x65, 0x36, 0x00, 0x01, 0x01, 0x82, 0x00, 0x02, 0x01, 0x00, 0x00, 0x1D, 0x41,
    0x00, 0x00, 0x00, 0x3B, 0x00, 0x00, 0xC8, 0x41, 0x00, 0x00, 0x80, 0x3A, 0x00, 0x00, 0x80, 0x39,
    0x00, 0x00, 0x04, 0x41, 0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46,
    0x0A, 0xD7, 0x23, 0x3B, 0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7,
    0x8F, 0xC2, 0x75, 0x3B, 0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6,
    0x0A, 0xD7, 0xA3, 0xBB, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3E, 0x00, 0x00, 0x00, 0x3F,
    0x00, 0x00, 0x40, 0x3F, 0x17, 0xB7, 0xD1, 0x38, 0x17, 0xB7, 0x51, 0x39, 0x52, 0x49, 0x9D, 0x39,
    0x17, 0xB7, 0xD1, 0x39, 0x6F, 0x12, 0x03, 0x3A, 0x52, 0x49, 0x1D, 0x3A, 0x34, 0x80, 0x37, 0x3A,
    0x17, 0xB7, 0x51, 0x3A, 0xFA, 0xED, 0x6B, 0x3A, 0x5B, 0xF3, 0x8F, 0x6F, 0x00, 0x00, 0x01, 0x00,
    0x00, 0x00, 0xC8, 0x41, 0x00, 0x00, 0x34, 0x42, 0x00, 0x00, 0xA4, 0xC1, 0x00, 0x80, 0x8C, 0x42,
    0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46, 0x0A, 0xD7, 0x23, 0x3B,
    0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7, 0x8F, 0xC2, 0x75, 0x3B,
    0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6, 0x0A, 0xD7, 0xA3, 0xBB,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0xC7, 0xB0, 0x7B, 0xA8,
};

static void take_three(invcal_real to[3], double a, double b, double c)
{
    to[0] = (invcal_real)a;
    to[1] = (invcal_real)b;
    to[2] = (invcal_real)c;
}

static invcal_calibration golden_calibration(void)
{
    invcal_calibration c;

    take_three(c.offset, 33123.5, -33276.25, 32360.75);
    take_three(c.matrix[0], 0.0025, 1.5e-5, -2.5e-6);
    take_three(c.matrix[1], -1e-5, 0.00375, 3e-6);
    take_three(c.matrix[2], 4e-6, -5e-6, -0.005);
    return c;
}

static invcal_thermal_record golden_record(void)
{
    invcal_thermal_record r;

    memset(&r, 0, sizeof r);
    r.thermal.nominal = golden_calibration();
    r.thermal.field = INVCAL_REAL(9.8125);
    r.thermal.reference = 25;
    r.thermal.span = 45;
    r.thermal.least = INVCAL_REAL(-20.5);
    r.thermal.greatest = INVCAL_REAL(70.25);
    r.thermal.fallback = INVCAL_THERMAL_FEW;
    r.record.field_sigma = INVCAL_REAL(0.001953125);
    r.record.temperature = 25;
    r.record.temperature_known = 1;
    r.record.noise = INVCAL_REAL(0.0009765625);
    r.record.residual_rms = INVCAL_REAL(0.000244140625);
    r.record.condition = INVCAL_REAL(8.25);
    take_three(r.record.sigma_offset, 0.25, 0.5, 0.75);
    take_three(r.record.sigma_delta, 1e-4, 2e-4, 3e-4);
    take_three(r.record.sigma_dk, 4e-4, 5e-4, 6e-4);
    take_three(r.record.sigma_gamma, 7e-4, 8e-4, 9e-4);
    memcpy(r.record.sensor, "SN-00042", 8);
    r.record.date = 0x6543210Fu;
    r.record.positions = 54;
    r.record.undetermined = 0x101;
    r.record.from_prior = 0x82;
    r.record.verdict = INVCAL_WEAK;
    return r;
}

/* A calibration of the highest degree, with errors of some per cent. */
static invcal_thermal_record random_record(random_source *random)
{
    invcal_thermal_record r = golden_record();

    for (unsigned k = 0; k <= DEGREE; k++) {
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            r.thermal.x[k][i] = (invcal_real)random_uniform(random, -0.03, 0.03);
        }
    }
    r.thermal.reference = (invcal_real)random_uniform(random, -20, 60);
    r.thermal.span = (invcal_real)random_uniform(random, 1, 60);
    r.thermal.least = r.thermal.reference - r.thermal.span;
    r.thermal.greatest = r.thermal.reference + r.thermal.span / 2;
    r.thermal.degree = DEGREE;
    r.thermal.fitted = (uint8_t)random_uniform(random, 0, DEGREE + 1);
    r.thermal.fallback = (invcal_thermal_fallback)(unsigned)random_uniform(random, 0, 4);
    r.thermal.frame = (invcal_frame)(unsigned)random_uniform(random, 0, 2);
    return r;
}

static uint32_t assert_encodes(const invcal_thermal_record *r, uint8_t bytes[SIZE])
{
    uint8_t room[SIZE + MARGIN];
    uint32_t length = 0;

    memset(room, 0x5A, sizeof room);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_record_encode(r, room + 1, &length)); /* odd address */
    TEST_ASSERT_EQUAL_UINT32(INVCAL_THERMAL_RECORD_BYTES(r->thermal.degree), length);
    TEST_ASSERT_EQUAL_HEX8(0x5A, room[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room + 1 + length, SIZE + MARGIN - 1 - length);
    memcpy(bytes, room + 1, length);
    return length;
}

static void assert_not_encoded(invcal_status expected, const invcal_thermal_record *r)
{
    uint8_t bytes[SIZE];
    uint32_t length = 77;

    memset(bytes, 0x5A, sizeof bytes);
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_record_encode(r, bytes, &length));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, bytes, SIZE);
    TEST_ASSERT_EQUAL_UINT32(77, length);
}

static void assert_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    static invcal_thermal_record out;
    const uint8_t *written = (const uint8_t *)&out;

    memset(&out, 0x5A, sizeof out);
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_record_decode(bytes, size, &out));
    for (unsigned i = 0; i < sizeof out; i++) {
        TEST_ASSERT_EQUAL_HEX8(0x5A, written[i]);
    }
}

/* Numbers are equal to the bit, after rounding to float. */
static void assert_rounded(const invcal_real *expected, const invcal_real *actual, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const invcal_real e = (invcal_real)(float)expected[i];
        TEST_ASSERT_EQUAL_MEMORY(&e, &actual[i], sizeof e);
    }
}

static void assert_equal_thermals(const invcal_thermal_calibration *e,
                                  const invcal_thermal_calibration *a)
{
    assert_rounded(&e->x[0][0], &a->x[0][0], (DEGREE + 1) * INVCAL_PARAMETERS);
    assert_rounded(e->nominal.offset, a->nominal.offset, 3);
    assert_rounded(&e->nominal.matrix[0][0], &a->nominal.matrix[0][0], 9);
    assert_rounded(&e->field, &a->field, 1);
    assert_rounded(&e->reference, &a->reference, 1);
    assert_rounded(&e->span, &a->span, 1);
    assert_rounded(&e->least, &a->least, 1);
    assert_rounded(&e->greatest, &a->greatest, 1);
    TEST_ASSERT_EQUAL_INT(e->frame, a->frame);
    TEST_ASSERT_EQUAL_INT(e->fallback, a->fallback);
    TEST_ASSERT_EQUAL_INT(e->degree, a->degree);
    TEST_ASSERT_EQUAL_INT(e->fitted, a->fitted);
}

static void assert_equal_judgements(const invcal_record *e, const invcal_record *a)
{
    assert_rounded(&e->field_sigma, &a->field_sigma, 1);
    assert_rounded(&e->temperature, &a->temperature, 1);
    assert_rounded(&e->noise, &a->noise, 1);
    assert_rounded(&e->residual_rms, &a->residual_rms, 1);
    assert_rounded(&e->condition, &a->condition, 1);
    assert_rounded(e->sigma_offset, a->sigma_offset, 3);
    assert_rounded(e->sigma_delta, a->sigma_delta, 3);
    assert_rounded(e->sigma_dk, a->sigma_dk, 3);
    assert_rounded(e->sigma_gamma, a->sigma_gamma, 3);
    TEST_ASSERT_EQUAL_MEMORY(e->sensor, a->sensor, 8);
    TEST_ASSERT_EQUAL_HEX32(e->date, a->date);
    TEST_ASSERT_EQUAL_HEX16(e->positions, a->positions);
    TEST_ASSERT_EQUAL_HEX16(e->undetermined, a->undetermined);
    TEST_ASSERT_EQUAL_HEX16(e->from_prior, a->from_prior);
    TEST_ASSERT_EQUAL_INT(e->verdict, a->verdict);
}

/* ---- what is kept ------------------------------------------------------------------------------ */

static void a_record_has_the_bytes_of_the_table(void)
{
    const invcal_thermal_record r = golden_record();
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_UINT32(FLAT, assert_encodes(&r, bytes));
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, FLAT);
}

static void the_bytes_of_the_table_give_the_record(void)
{
    const invcal_thermal_record expected = golden_record();
    const invcal_calibration nominal = golden_calibration();
    invcal_thermal_record r;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_record_decode(golden, FLAT, &r));
    assert_equal_thermals(&expected.thermal, &r.thermal);
    assert_equal_judgements(&expected.record, &r.record);
    assert_rounded(nominal.offset, r.record.calibration.offset, 3);
    assert_rounded(&nominal.matrix[0][0], &r.record.calibration.matrix[0][0], 9);
}

/* Coefficient i of t^k stands at 256 + 36 k + 4 i, as a binary32. */
static void the_coefficients_of_every_power_stand_where_the_table_says(void)
{
    random_source random = random_start(1);
    const invcal_thermal_record r = random_record(&random);
    uint8_t bytes[SIZE];

    assert_encodes(&r, bytes);
    for (unsigned k = 0; k <= DEGREE; k++) {
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            const uint8_t *at = bytes + X_AT + 36 * k + 4 * i;
            const float x = (float)r.thermal.x[k][i];
            uint32_t bits;
            memcpy(&bits, &x, sizeof bits);
            TEST_ASSERT_EQUAL_HEX32(bits, at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
                                              (uint32_t)at[3] << 24);
        }
    }
}

static void a_record_comes_back_as_it_was(void)
{
    random_source random = random_start(2);

    for (int i = 0; i < SOME(500); i++) {
        const invcal_thermal_record r = random_record(&random);
        static invcal_thermal_record back;
        uint8_t bytes[SIZE];
        uint8_t again[SIZE];
        const uint32_t length = assert_encodes(&r, bytes);
        memset(&back, 0x5A, sizeof back);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_record_decode(bytes, length, &back));
        assert_equal_thermals(&r.thermal, &back.thermal);
        assert_equal_judgements(&r.record, &back.record);
        assert_encodes(&back, again);
        TEST_ASSERT_EQUAL_MEMORY(bytes, again, length);
    }
}

/* A device that does not know its temperature reads the rest at byte 4. Its readings have the
 * field's length where the errors are those of t = 0. */
static void what_holds_at_the_reference_is_a_record_of_its_own(void)
{
    random_source random = random_start(3);
    invcal_thermal_record r = random_record(&random);
    invcal_solution solution;
    invcal_record part;
    triad_truth truth;
    uint8_t bytes[SIZE];

    take_three(r.thermal.nominal.offset, 0, 0, 0);
    for (unsigned i = 0; i < 3; i++) {
        take_three(r.thermal.nominal.matrix[i], i == 0, i == 1, i == 2);
    }
    r.thermal.field = 1;
    assert_encodes(&r, bytes);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_record_decode(bytes + RECORD_AT, INVCAL_RECORD_SIZE, &part));
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        truth.x[i] = (double)r.thermal.x[0][i];
    }
    solution.calibration = part.calibration;
    for (int i = 0; i < 20; i++) {
        double direction[3];
        random_direction(&random, direction);
        TEST_ASSERT_DOUBLE_WITHIN(3e-7, 1, calibrated_length(&solution, &truth, direction, 1));
    }
}

static void bytes_behind_a_record_are_not_looked_at(void)
{
    uint8_t bytes[FLAT + MARGIN];
    invcal_thermal_record r;

    memset(bytes, 0xA5, sizeof bytes);
    memcpy(bytes, golden, FLAT);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_record_decode(bytes, sizeof bytes, &r));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_record_decode(bytes, 0xFFFFFFFFu, &r));
}

/* ---- what is refused --------------------------------------------------------------------------- */

/* Every real of the thermal part. */
enum { REALS = 17 + (DEGREE + 1) * INVCAL_PARAMETERS };
static invcal_real *real_of(invcal_thermal_calibration *c, unsigned i)
{
    invcal_real *const single[] = {&c->field, &c->reference, &c->span, &c->least, &c->greatest};

    if (i < 5) {
        return single[i];
    }
    if (i < 8) {
        return &c->nominal.offset[i - 5];
    }
    return i < 17 ? &c->nominal.matrix[(i - 8) / 3][(i - 8) % 3]
                  : &c->x[(i - 17) / 9][(i - 17) % 9];
}

static void a_number_that_is_not_finite_is_not_encoded(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 3.5e38};
    random_source random = random_start(4);
    const invcal_thermal_record good = random_record(&random);

    for (unsigned i = 0; i < REALS; i++) {
        for (unsigned k = 0; k < (INVCAL_DOUBLE ? 4 : 3); k++) {
            invcal_thermal_record r = good;
            *real_of(&r.thermal, i) = (invcal_real)bad[k];
            assert_not_encoded(INVCAL_NOT_FINITE, &r);
        }
    }
}

static void a_number_that_is_not_finite_is_not_decoded(void)
{
    for (unsigned at = REALS_AT; at < FLAT - 4; at += 4) {
        uint8_t bytes[FLAT];
        memcpy(bytes, golden, FLAT);
        bytes[at + 2] = 0xC0;
        bytes[at + 3] = 0x7F;
        seal_bytes(bytes, FLAT - 4);
        assert_refused(INVCAL_DAMAGED, bytes, FLAT);
    }
}

static void what_is_never_calibrated_is_not_encoded(void)
{
    const invcal_thermal_record good = golden_record();
    invcal_thermal_record r = good;

    r.thermal.span = 0;
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.least = INVCAL_REAL(70.5);
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.degree = DEGREE + 1;
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.fitted = 1;
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.fallback = (invcal_thermal_fallback)(INVCAL_THERMAL_OPEN + 1);
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.frame = (invcal_frame)(INVCAL_FRAME_TRIANGULAR + 1);
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.field = 0;
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.record.verdict = (invcal_verdict)(INVCAL_WEAK + 1);
    assert_not_encoded(INVCAL_BAD_SETTING, &r);
    r = good;
    r.thermal.x[0][INVCAL_DK_X] = -2;
    assert_not_encoded(INVCAL_NOT_ELLIPSOID, &r);
}

static void what_is_never_encoded_is_not_decoded(void)
{
    static const struct {
        unsigned at;
        uint8_t byte;
    } wrong[] = {{2, 255},           {DEGREE_AT, 1},     {DEGREE_AT + 1, 1},
                 {DEGREE_AT + 2, 4}, {DEGREE_AT + 3, 2}, {SPAN_AT + 3, 0xC2}};

    for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        uint8_t bytes[FLAT];
        memcpy(bytes, golden, FLAT);
        bytes[wrong[i].at] = wrong[i].byte;
        seal_bytes(bytes, FLAT - 4);
        assert_refused(INVCAL_DAMAGED, bytes, FLAT);
    }
}

/* A nominal matrix of 1e-38 to 1e38 has an inverse, what comes of it at the reference has none: a
 * fuzzer found that such a record came in and could not go out again. */
static void a_calibration_without_inverse_is_damage(void)
{
    static const uint8_t matrix[36] = {0x12, 0x13, 0x14, 0x15, 0x16, 0x17, 0x18, 0x19, 0x1A,
                                       0x1B, 0x1C, 0x1D, 0x1E, 0x1F, 0x20, 0x01, 0x05, 0x00,
                                       0x02, 0x11, 0x22, 0xFF, 0x00, 0xFF, 0x00, 0xFF, 0x00,
                                       0xFF, 0x00, 0x10, 0x00, 0x40, 0x2D, 0xFD, 0x7F, 0xBF};
    static const uint8_t x[36] = {0x6F, 0x12, 0x83, 0x3A, 0xE8, 0x90, 0xB4, 0x2D, 0xB7,
                                  0x87, 0xA0, 0xAD, 0xE8, 0x90, 0xB4, 0x2D, 0x36, 0x06,
                                  0x81, 0x3A, 0xC5, 0x6A, 0x11, 0xAD, 0xB7, 0x87, 0xA0,
                                  0xAD, 0xC5, 0x6A, 0x11, 0xAD, 0x81, 0x80, 0x80, 0x3A};
    uint8_t bytes[FLAT];

    memcpy(bytes, golden, FLAT);
    memcpy(bytes + MATRIX_AT, matrix, sizeof matrix);
    memcpy(bytes + X_AT, x, sizeof x);
    bytes[DEGREE_AT + 3] = INVCAL_FRAME_TRIANGULAR;
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_DAMAGED, bytes, FLAT);
}

/* Sound as a whole, but what stands at byte 4 is not. */
static void a_damaged_part_is_damage(void)
{
    uint8_t bytes[FLAT];

    memcpy(bytes, golden, FLAT);
    bytes[RECORD_AT + 20] ^= 1u;
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_DAMAGED, bytes, FLAT);
}

static void a_sound_record_that_is_too_short_is_damaged(void)
{
    uint8_t bytes[FLAT];

    memcpy(bytes, golden, FLAT);
    for (unsigned length = 8; length < FLAT; length++) {
        bytes[2] = (uint8_t)(length & 0xFFu);
        bytes[3] = (uint8_t)(length >> 8);
        seal_bytes(bytes, length - 4);
        assert_refused(INVCAL_DAMAGED, bytes, length);
        memcpy(bytes, golden, FLAT);
    }
}

static void another_kind_version_or_a_higher_degree_is_named(void)
{
    enum { HIGHER = INVCAL_THERMAL_RECORD_BYTES(DEGREE + 1) };
    uint8_t bytes[HIGHER] = {0};

    memcpy(bytes, golden, FLAT);
    bytes[0] = 0xCA;
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_OTHER_VERSION, bytes, FLAT);
    bytes[0] = 0xCB;
    bytes[1] = 2;
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_OTHER_VERSION, bytes, FLAT);
    bytes[1] = 1;
    bytes[2] = (uint8_t)(HIGHER & 0xFFu);
    bytes[3] = (uint8_t)(HIGHER >> 8);
    bytes[DEGREE_AT] = DEGREE + 1;
    seal_bytes(bytes, HIGHER - 4);
    assert_refused(INVCAL_OTHER_VERSION, bytes, HIGHER);
}

static void any_wrong_bit_is_damage(void)
{
    for (unsigned bit = 0; bit < 8 * FLAT; bit += TEST_SHORT) {
        uint8_t bytes[FLAT];
        memcpy(bytes, golden, FLAT);
        bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        assert_refused(INVCAL_DAMAGED, bytes, FLAT);
    }
}

static void a_cut_record_is_damaged(void)
{
    for (unsigned size = 0; size < FLAT; size++) {
        assert_refused(INVCAL_DAMAGED, golden, size);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_record_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_record);
    RUN_TEST(the_coefficients_of_every_power_stand_where_the_table_says);
    RUN_TEST(a_record_comes_back_as_it_was);
    RUN_TEST(what_holds_at_the_reference_is_a_record_of_its_own);
    RUN_TEST(bytes_behind_a_record_are_not_looked_at);
    RUN_TEST(a_number_that_is_not_finite_is_not_encoded);
    RUN_TEST(a_number_that_is_not_finite_is_not_decoded);
    RUN_TEST(what_is_never_calibrated_is_not_encoded);
    RUN_TEST(what_is_never_encoded_is_not_decoded);
    RUN_TEST(a_calibration_without_inverse_is_damage);
    RUN_TEST(a_damaged_part_is_damage);
    RUN_TEST(a_sound_record_that_is_too_short_is_damaged);
    RUN_TEST(another_kind_version_or_a_higher_degree_is_named);
    RUN_TEST(any_wrong_bit_is_damage);
    RUN_TEST(a_cut_record_is_damaged);
    return UNITY_END();
}
