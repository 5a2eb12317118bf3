/* SPDX-License-Identifier: MIT
 *
 * Records are of degree 0, 1 or 2 in every build, whichever it can fit.
 */
#include <float.h>
#include <string.h>

#include "invcal/thermal_store.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum {
    DEGREE = 2, /* the highest one */
    SIZE = INVCAL_THERMAL_RECORD_SIZE,
    FLAT = 248, /* of degree 0 */
    MARGIN = 16,
    RECORD_AT = 4,
    DEGREE_AT = 140,
    FRAME_AT = 143,
    REALS_AT = 144,
    SPAN_AT = 148,
    OFFSET_AT = 160,
    MATRIX_AT = 172,
    X_AT = 208
};

/* What the bytes hold. */
typedef struct {
    invcal_thermal thermal;
    invcal_record about;
} content;

/* Of the table. */
static uint32_t length_of(unsigned degree)
{
    return 212 + 36 * (degree + 1);
}

static invcal_status encode(const content *c, uint8_t *bytes)
{
    return invcal_thermal_encode(&c->thermal, &c->about, bytes);
}

static invcal_status decode(const uint8_t *bytes, uint32_t size, content *out)
{
    return invcal_thermal_decode(bytes, size, &out->thermal, &out->about);
}

/* A record of degree 0 whose coefficients are none, so that at the reference the nominal holds. By
 * Python, numbers as in golden_content:
 *
 *     import struct, zlib
 *     b = struct.pack('<BBH8sIHHHBB27f', 0xCA, 2, 136, b'SN-00042', 0x6543210F, 54, 0x101, 0x82,
 *         2, 1, *reals)       # store.h
 *     b += struct.pack('<I', zlib.crc32(b))
 *     b = struct.pack('<BBH136sBBBB25f', 0xCB, 2, 248, b, 0, 0, 1, 0, 25, 45, -20.5, 70.25,
 *         *offset, *matrix, *[0] * 9)
 *     b += struct.pack('<I', zlib.crc32(b))
 */
static const uint8_t golden[FLAT] = {
    0xCB, 0x02, 0xF8, 0x00, 0xCA, 0x02, 0x88, 0x00, 0x53, 0x4E, 0x2D, 0x30, 0x30, 0x30, 0x34, 0x32,
    0x0F, 0x21, 0x43, 0x65, 0x36, 0x00, 0x01, 0x01, 0x82, 0x00, 0x05, 0x01, 0x00, 0x00, 0x1D, 0x41,
    0x00, 0x00, 0x00, 0x3B, 0x00, 0x00, 0xC8, 0x41, 0x00, 0x00, 0x80, 0x3A, 0x00, 0x00, 0x80, 0x39,
    0x00, 0x00, 0x04, 0x41, 0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46,
    0x0A, 0xD7, 0x23, 0x3B, 0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7,
    0x8F, 0xC2, 0x75, 0x3B, 0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6,
    0x0A, 0xD7, 0xA3, 0xBB, 0x17, 0xB7, 0xD1, 0x38, 0x17, 0xB7, 0x51, 0x39, 0x52, 0x49, 0x9D, 0x39,
    0x17, 0xB7, 0xD1, 0x39, 0x6F, 0x12, 0x03, 0x3A, 0x52, 0x49, 0x1D, 0x3A, 0x34, 0x80, 0x37, 0x3A,
    0x17, 0xB7, 0x51, 0x3A, 0xFA, 0xED, 0x6B, 0x3A, 0x42, 0xCE, 0xA9, 0xCA, 0x00, 0x00, 0x01, 0x00,
    0x00, 0x00, 0xC8, 0x41, 0x00, 0x00, 0x34, 0x42, 0x00, 0x00, 0xA4, 0xC1, 0x00, 0x80, 0x8C, 0x42,
    0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46, 0x0A, 0xD7, 0x23, 0x3B,
    0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7, 0x8F, 0xC2, 0x75, 0x3B,
    0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6, 0x0A, 0xD7, 0xA3, 0xBB,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0xAC, 0xDD, 0x4F, 0xAF,
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

static content golden_content(void)
{
    content r;

    memset(&r, 0, sizeof r);
    r.thermal.nominal = golden_calibration();
    r.thermal.reference = 25;
    r.thermal.span = 45;
    r.thermal.min = INVCAL_REAL(-20.5);
    r.thermal.max = INVCAL_REAL(70.25);
    r.thermal.fallback = INVCAL_THERMAL_FEW;
    r.about.calibration = golden_calibration();
    r.about.field = INVCAL_REAL(9.8125);
    r.about.field_sigma = INVCAL_REAL(0.001953125);
    r.about.temperature = 25;
    r.about.temperature_known = 1;
    r.about.noise = INVCAL_REAL(0.0009765625);
    r.about.rms = INVCAL_REAL(0.000244140625);
    r.about.condition = INVCAL_REAL(8.25);
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        r.about.sigma[i] = (invcal_real)(i + 1) / 10000;
    }
    memcpy(r.about.sensor, "SN-00042", 8);
    r.about.date = 0x6543210Fu;
    r.about.positions = 54;
    r.about.weak = 0x101;
    r.about.held = 0x82;
    r.about.verdict = INVCAL_WEAK;
    return r;
}

/* The calibration at the reference, as the record must have it. */
static void settle(content *r)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_at(&r->thermal, r->thermal.reference,
                                                       &r->about.calibration, NULL));
}

/* A calibration of the highest degree, with errors of some per cent. */
static content random_content(random_source *random)
{
    content r = golden_content();

    for (unsigned k = 0; k <= DEGREE; k++) {
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            r.thermal.x[k][i] = (invcal_real)random_uniform(random, -0.03, 0.03);
        }
    }
    r.thermal.reference = (invcal_real)random_uniform(random, -20, 60);
    r.thermal.span = (invcal_real)random_uniform(random, 1, 60);
    r.thermal.min = r.thermal.reference - r.thermal.span;
    r.thermal.max = r.thermal.reference + r.thermal.span / 2;
    r.thermal.degree = DEGREE;
    r.thermal.fitted = (uint8_t)random_uniform(random, 0, DEGREE + 1);
    r.thermal.fallback = (uint8_t)random_uniform(random, 0, 4);
    settle(&r);
    return r;
}

static uint32_t assert_encodes(const content *r, uint8_t bytes[SIZE])
{
    const uint32_t length = length_of(r->thermal.degree);
    uint8_t space[SIZE + MARGIN];

    memset(space, 0x5A, sizeof space);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, encode(r, space + 1)); /* odd address */
    TEST_ASSERT_EQUAL_HEX8(0x5A, space[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, space + 1 + length, SIZE + MARGIN - 1 - length);
    memcpy(bytes, space + 1, length);
    return length;
}

static void assert_not_encoded(invcal_status expected, const content *r)
{
    uint8_t bytes[SIZE + MARGIN];

    memset(bytes, 0x5A, sizeof bytes);
    TEST_ASSERT_EQUAL_INT(expected, encode(r, bytes));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, bytes + SIZE, MARGIN);
}

static void assert_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    static content out;

    memset(&out, 0x5A, sizeof out);
    TEST_ASSERT_EQUAL_INT(expected, decode(bytes, size, &out));
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_decode(bytes, size, &out.thermal, NULL));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &out, sizeof out);
}

/* Numbers are equal to the bit, after rounding to float. */
static void assert_rounded(const invcal_real *expected, const invcal_real *actual, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const invcal_real e = (invcal_real)(float)expected[i];
        TEST_ASSERT_EQUAL_MEMORY(&e, &actual[i], sizeof e);
    }
}

static void assert_equal_thermals(const invcal_thermal *e, const invcal_thermal *a)
{
    assert_rounded(&e->x[0][0], &a->x[0][0], (DEGREE + 1) * INVCAL_PARAMETERS);
    assert_rounded(e->nominal.offset, a->nominal.offset, 3);
    assert_rounded(&e->nominal.matrix[0][0], &a->nominal.matrix[0][0], 9);
    assert_rounded(&e->reference, &a->reference, 1);
    assert_rounded(&e->span, &a->span, 1);
    assert_rounded(&e->min, &a->min, 1);
    assert_rounded(&e->max, &a->max, 1);
    TEST_ASSERT_EQUAL_INT(e->fallback, a->fallback);
    TEST_ASSERT_EQUAL_INT(e->degree, a->degree);
    TEST_ASSERT_EQUAL_INT(e->fitted, a->fitted);
}

static void assert_equal_judgements(const invcal_record *e, const invcal_record *a)
{
    assert_rounded(&e->field, &a->field, 1);
    assert_rounded(&e->field_sigma, &a->field_sigma, 1);
    assert_rounded(&e->temperature, &a->temperature, 1);
    assert_rounded(&e->noise, &a->noise, 1);
    assert_rounded(&e->rms, &a->rms, 1);
    assert_rounded(&e->condition, &a->condition, 1);
    assert_rounded(e->sigma, a->sigma, INVCAL_PARAMETERS);
    TEST_ASSERT_EQUAL_MEMORY(e->sensor, a->sensor, 8);
    TEST_ASSERT_EQUAL_HEX32(e->date, a->date);
    TEST_ASSERT_EQUAL_HEX16(e->positions, a->positions);
    TEST_ASSERT_EQUAL_HEX16(e->weak, a->weak);
    TEST_ASSERT_EQUAL_HEX16(e->held, a->held);
    TEST_ASSERT_EQUAL_INT(e->verdict, a->verdict);
}

/* ---- what is kept ------------------------------------------------------------------------------ */

static void a_record_has_the_bytes_of_the_table(void)
{
    const content r = golden_content();
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_UINT32(FLAT, assert_encodes(&r, bytes));
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, FLAT);
}

static void the_bytes_of_the_table_give_the_record(void)
{
    const content expected = golden_content();
    const invcal_calibration nominal = golden_calibration();
    content r;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(golden, FLAT, &r));
    assert_equal_thermals(&expected.thermal, &r.thermal);
    assert_equal_judgements(&expected.about, &r.about);
    assert_rounded(nominal.offset, r.about.calibration.offset, 3);
    assert_rounded(&nominal.matrix[0][0], &r.about.calibration.matrix[0][0], 9);
}

/* 0.2.0 could turn the record to the triangular frame, and said so in a byte: then it differs from
 * what invcal_thermal_at gives, but no length does. Now the byte is 0, whatever it was. */
static void a_record_in_another_frame_is_read_and_kept(void)
{
    random_source random = random_start(6);
    content r = random_content(&random);
    const invcal_real(*m)[3] = (const invcal_real(*)[3])r.about.calibration.matrix;
    content back;
    invcal_real turned[3][3];
    double turn[3][3];
    uint8_t bytes[SIZE];
    uint8_t of_old[SIZE];

    random_rotation(&random, turn);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            turned[i][j] = 0;
            for (int k = 0; k < 3; k++) {
                turned[i][j] += (invcal_real)turn[i][k] * m[k][j];
            }
        }
    }
    memcpy(r.about.calibration.matrix, turned, sizeof turned);
    const uint32_t length = assert_encodes(&r, bytes);
    TEST_ASSERT_EQUAL_HEX8(0, bytes[FRAME_AT]);
    for (unsigned frame = 0; frame < 256; frame++) {
        memcpy(of_old, bytes, length);
        of_old[FRAME_AT] = (uint8_t)frame;
        seal_bytes(of_old, length - 4);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(of_old, length, &back));
        assert_rounded(&turned[0][0], &back.about.calibration.matrix[0][0], 9);
        assert_encodes(&back, of_old);
        TEST_ASSERT_EQUAL_MEMORY(bytes, of_old, length);
    }
}

/* Coefficient i of t^k is at 208 + 36 k + 4 i, as a binary32. */
static void the_coefficients_of_every_power_are_where_the_table_says(void)
{
    random_source random = random_start(1);
    const content r = random_content(&random);
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
        const content r = random_content(&random);
        static content back;
        uint8_t bytes[SIZE];
        uint8_t again[SIZE];
        const uint32_t length = assert_encodes(&r, bytes);
        memset(&back, 0x5A, sizeof back);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, length, &back));
        assert_equal_thermals(&r.thermal, &back.thermal);
        assert_equal_judgements(&r.about, &back.about);
        assert_encodes(&back, again);
        TEST_ASSERT_EQUAL_MEMORY(bytes, again, length);
    }
}

/* Whichever degree this build can fit; of a lower degree the other coefficients are 0. */
static void a_record_of_every_degree_comes_back(void)
{
    static const uint32_t lengths[] = {248, 284, 320}; /* of the table */
    random_source random = random_start(7);

    TEST_ASSERT_EQUAL_UINT32(320, SIZE);
    for (unsigned degree = 0; degree <= 2; degree++) {
        content r = random_content(&random);
        static content back;
        uint8_t bytes[SIZE];
        r.thermal.degree = (uint8_t)degree;
        r.thermal.fitted = (uint8_t)degree;
        for (unsigned k = degree + 1; k <= 2; k++) {
            memset(r.thermal.x[k], 0, sizeof r.thermal.x[k]);
        }
        TEST_ASSERT_EQUAL_UINT32(lengths[degree], assert_encodes(&r, bytes));
        memset(&back, 0x5A, sizeof back);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, lengths[degree], &back));
        assert_equal_thermals(&r.thermal, &back.thermal);
        assert_equal_judgements(&r.about, &back.about);
    }
}

/* A device that does not know its temperature reads the rest at byte 4. Its readings have the
 * field's length where the errors are those of t = 0. */
static void what_holds_at_the_reference_is_a_record_of_its_own(void)
{
    random_source random = random_start(3);
    content r = random_content(&random);
    invcal_record part;
    triad_truth truth;
    uint8_t bytes[SIZE];

    r.thermal.nominal = unit_nominal();
    settle(&r);
    assert_encodes(&r, bytes);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_record_decode(bytes + RECORD_AT, INVCAL_RECORD_SIZE, &part));
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        truth.x[i] = (double)r.thermal.x[0][i];
    }
    for (int i = 0; i < 20; i++) {
        double direction[3];
        random_direction(&random, direction);
        TEST_ASSERT_DOUBLE_WITHIN(3e-7, 1, calibrated_length(&part.calibration, &truth, direction));
    }
}

static void bytes_after_a_record_are_ignored(void)
{
    uint8_t bytes[FLAT + MARGIN];
    content r;

    memset(bytes, 0xA5, sizeof bytes);
    memcpy(bytes, golden, FLAT);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, sizeof bytes, &r));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, 0xFFFFFFFFu, &r));
}

static void the_record_within_is_given_only_if_it_is_asked_for(void)
{
    const content expected = golden_content();
    invcal_thermal thermal;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_decode(golden, FLAT, &thermal, NULL));
    assert_equal_thermals(&expected.thermal, &thermal);
}

/* ---- what is refused --------------------------------------------------------------------------- */

/* Every real of the thermal part. */
enum { REALS = 16 + (DEGREE + 1) * INVCAL_PARAMETERS };
static invcal_real *real_of(invcal_thermal *t, unsigned i)
{
    invcal_real *const single[] = {&t->reference, &t->span, &t->min, &t->max};

    if (i < 4) {
        return single[i];
    }
    if (i < 7) {
        return &t->nominal.offset[i - 4];
    }
    return i < 16 ? &t->nominal.matrix[(i - 7) / 3][(i - 7) % 3]
                  : &t->x[(i - 16) / 9][(i - 16) % 9];
}

static void a_number_that_is_not_finite_is_not_encoded(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 3.5e38};
    random_source random = random_start(4);
    const content good = random_content(&random);

    for (unsigned i = 0; i < REALS; i++) {
        for (unsigned k = 0; k < (INVCAL_DOUBLE ? 4 : 3); k++) {
            content r = good;
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
        assert_refused(INVCAL_NOT_FINITE, bytes, FLAT);
    }
}

static void what_is_never_calibrated_is_not_encoded(void)
{
    const content good = golden_content();
    content r = good;

    r.thermal.span = 0;
    assert_not_encoded(INVCAL_DAMAGED, &r);
    r = good;
    r.thermal.min = INVCAL_REAL(70.5);
    assert_not_encoded(INVCAL_DAMAGED, &r);
    r = good;
    r.thermal.degree = DEGREE + 1;
    assert_not_encoded(INVCAL_BAD_COUNT, &r);
    r = good;
    r.thermal.fitted = 1;
    assert_not_encoded(INVCAL_DAMAGED, &r);
    r = good;
    r.thermal.fallback = INVCAL_THERMAL_OPEN + 1;
    assert_not_encoded(INVCAL_DAMAGED, &r);
    r = good;
    r.about.verdict = INVCAL_WEAK + 1;
    assert_not_encoded(INVCAL_DAMAGED, &r);
    r = good;
    r.thermal.x[0][INVCAL_DK_X] = -2;
    assert_not_encoded(INVCAL_NOT_ELLIPSOID, &r);
    r = good;
    memset(r.thermal.nominal.matrix[1], 0, sizeof r.thermal.nominal.matrix[1]);
    assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
}

static void what_is_never_encoded_is_not_decoded(void)
{
    static const struct {
        unsigned at;
        uint8_t byte;
    } wrong[] = {
        {2, 247}, {DEGREE_AT, 1}, {DEGREE_AT + 1, 1}, {DEGREE_AT + 2, 4}, {SPAN_AT + 3, 0xC2}};

    for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        uint8_t bytes[FLAT];
        memcpy(bytes, golden, FLAT);
        bytes[wrong[i].at] = wrong[i].byte;
        seal_bytes(bytes, bytes[2] - 4u);
        assert_refused(INVCAL_DAMAGED, bytes, FLAT);
    }
}

/* Whose record is it? A device that knows its temperature would read one calibration, and one that
 * does not another. */
static void a_record_of_another_calibration_is_refused(void)
{
    random_source random = random_start(7);

    for (unsigned i = 0; i < 12; i++) {
        content r = random_content(&random);
        invcal_calibration *c = &r.about.calibration;
        uint8_t bytes[SIZE];
        /* a thousandth of the field, or of a scale */
        if (i < 3) {
            c->offset[i] += (invcal_real)1e-3 / c->matrix[i][i];
        } else {
            const unsigned k = i - 3;
            c->matrix[k / 3][k % 3] += (invcal_real)1e-3 * c->matrix[k % 3][k % 3];
        }
        assert_not_encoded(INVCAL_DAMAGED, &r);
        settle(&r);
        assert_encodes(&r, bytes);
    }
    /* in bytes: the offset of x is 1 of 33123.5 counts more, 0.0025 of the field, in either place */
    const unsigned at[] = {RECORD_AT + 48, OFFSET_AT};
    for (unsigned i = 0; i < 2; i++) {
        uint8_t bytes[FLAT];
        memcpy(bytes, golden, FLAT);
        bytes[at[i] + 1] += 1;
        seal_bytes(bytes + RECORD_AT, INVCAL_RECORD_SIZE - 4);
        seal_bytes(bytes, FLAT - 4);
        assert_refused(INVCAL_DAMAGED, bytes, FLAT);
    }
}

/* A nominal matrix of 1e-38 to 1e38 has an inverse, but the calibration at the reference has none:
 * a fuzzer found that such a record was decoded and could not be encoded again. */
static void a_calibration_without_inverse_is_refused(void)
{
    static const uint8_t matrix[36] = {0x12, 0x13, 0x14, 0x15, 0x16, 0x17, 0x18, 0x19, 0x1A,
                                       0x1B, 0x1C, 0x1D, 0x1E, 0x1F, 0x20, 0x01, 0x05, 0x00,
                                       0x02, 0x11, 0x22, 0xFF, 0x00, 0xFF, 0x00, 0xFF, 0x00,
                                       0xFF, 0x00, 0x10, 0x00, 0x40, 0x2D, 0xFD, 0x7F, 0xBF};
    uint8_t bytes[FLAT];

    memcpy(bytes, golden, FLAT);
    memcpy(bytes + MATRIX_AT, matrix, sizeof matrix);
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_BAD_NOMINAL, bytes, FLAT);
}

/* Sound as a whole, but the record at byte 4 is not. */
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

    for (unsigned length = 8; length < FLAT; length++) {
        memcpy(bytes, golden, FLAT);
        bytes[2] = (uint8_t)length;
        seal_bytes(bytes, length - 4);
        assert_refused(INVCAL_DAMAGED, bytes, length);
    }
}

static void another_kind_version_or_a_higher_degree_is_named(void)
{
    enum { HIGHER = 356 };
    uint8_t bytes[HIGHER] = {0};

    memcpy(bytes, golden, FLAT);
    bytes[0] = 0xCA;
    seal_bytes(bytes, FLAT - 4);
    assert_refused(INVCAL_OTHER_VERSION, bytes, FLAT);
    bytes[0] = 0xCB;
    for (unsigned version = 0; version < 256; version++) {
        bytes[1] = (uint8_t)version;
        seal_bytes(bytes, FLAT - 4);
        if (version != golden[1]) {
            assert_refused(INVCAL_OTHER_VERSION, bytes, FLAT);
        }
    }
    bytes[1] = 2;
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

/* ---- in a memory ------------------------------------------------------------------------------- */

enum { SLOT = 384 };
static uint8_t memory[2][SLOT];
static int is_stuck; /* nothing is programmed */

static int memory_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &memory[slot][offset], size);
    return 0;
}

static int memory_erase(void *context, unsigned slot)
{
    (void)context;
    memset(memory[slot], 0xFF, SLOT);
    return 0;
}

static int memory_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                          uint32_t size)
{
    (void)context;
    memcpy(&memory[slot][offset], bytes, size);
    return is_stuck;
}

static const invcal_store store = {memory_read, memory_erase, memory_program, NULL, SLOT, 8};

static void assert_not_loaded(invcal_status expected)
{
    invcal_thermal out;

    memset(&out, 0x5A, sizeof out);
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_load(&out, &store));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &out, sizeof out);
}

static invcal_quality possible_quality(void)
{
    invcal_quality q;

    memset(&q, 0, sizeof q);
    q.noise = INVCAL_REAL(0.25);
    q.sigma[8] = INVCAL_REAL(0.125);
    q.positions = 54;
    q.held = 3;
    q.verdict = INVCAL_ROUGH;
    return q;
}

/* Of every degree, also where the reference is out of the range: then the record is of its edge. */
static void what_was_saved_is_loaded_with_all_that_is_known(void)
{
    random_source random = random_start(8);
    const invcal_quality quality = possible_quality();

    for (unsigned i = 0; i < 6; i++) {
        content r = random_content(&random);
        content back;
        invcal_thermal loaded;
        uint8_t bytes[SIZE];
        uint8_t expected[SIZE];
        uint32_t size = 0;
        r.thermal.degree = (uint8_t)(i % 3);
        r.thermal.fitted = 0;
        for (unsigned k = i % 3 + 1; k <= 2; k++) {
            memset(r.thermal.x[k], 0, sizeof r.thermal.x[k]);
        }
        if (i >= 3) {
            r.thermal.min = r.thermal.reference + r.thermal.span / 4;
        }
        settle(&r);
        invcal_calibration at_reference = r.about.calibration;
        invcal_record_init(&r.about, &at_reference, &quality);
        memset(memory, 0xFF, sizeof memory);
        assert_not_loaded(INVCAL_NO_RECORD);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_save(&r.thermal, &quality, &store));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_load(&loaded, &store));
        assert_equal_thermals(&r.thermal, &loaded);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_load(&store, bytes, sizeof bytes, &size));
        TEST_ASSERT_EQUAL_UINT32(assert_encodes(&r, expected), size);
        TEST_ASSERT_EQUAL_MEMORY(expected, bytes, size);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, size, &back));
        assert_equal_judgements(&r.about, &back.about);
        TEST_ASSERT_EQUAL_UINT(54, back.about.positions);
    }
}

static void assert_not_saved(invcal_status expected, const invcal_thermal *thermal,
                             const invcal_quality *quality)
{
    uint8_t before[sizeof memory];

    memcpy(before, memory, sizeof memory);
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_save(thermal, quality, &store));
    TEST_ASSERT_EQUAL_MEMORY(before, memory, sizeof memory);
}

static void what_is_no_solution_is_not_saved_and_changes_nothing(void)
{
    random_source random = random_start(9);
    const invcal_thermal good = random_content(&random).thermal;
    const invcal_quality quality = possible_quality();
    invcal_store wrong = store;
    invcal_thermal bad = good;
    invcal_quality q = quality;
    invcal_thermal loaded;

    memset(memory, 0xFF, sizeof memory);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_save(&good, &quality, &store));
    bad.reference = (invcal_real)NOT_A_NUMBER;
    assert_not_saved(INVCAL_BAD_TEMPERATURE, &bad, &quality);
    bad = good;
    bad.nominal.offset[1] = (invcal_real)NOT_A_NUMBER;
    assert_not_saved(INVCAL_BAD_NOMINAL, &bad, &quality);
    bad = good;
    bad.x[0][INVCAL_DK_X] = -2;
    assert_not_saved(INVCAL_NOT_ELLIPSOID, &bad, &quality);
    bad = good;
    bad.degree = DEGREE + 1;
    assert_not_saved(INVCAL_BAD_COUNT, &bad, &quality);
    bad = good;
    bad.fallback = INVCAL_THERMAL_OPEN + 1;
    assert_not_saved(INVCAL_DAMAGED, &bad, &quality);
    q.noise = (invcal_real)NOT_A_NUMBER;
    assert_not_saved(INVCAL_NOT_FINITE, &good, &q);
    q = quality;
    q.verdict = INVCAL_WEAK; /* and no parameter is */
    assert_not_saved(INVCAL_DAMAGED, &good, &q);
    wrong.slot_size = 128;
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_thermal_save(&good, &quality, &wrong));
    wrong.granularity = 3;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_STORE, invcal_thermal_save(&good, &quality, &wrong));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_STORE, invcal_thermal_load(&loaded, &wrong));
    is_stuck = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_IO, invcal_thermal_save(&good, &quality, &store));
    is_stuck = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_load(&loaded, &store)); /* the first one */
    assert_equal_thermals(&good, &loaded);
}

/* A plain record, a session, something large. */
static void something_else_is_not_loaded(void)
{
    static invcal_session session;
    static const uint8_t large[SIZE + 1] = {0xCB, 2};

    memset(memory, 0xFF, sizeof memory);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_store_save(&store, golden + RECORD_AT, INVCAL_RECORD_SIZE));
    assert_not_loaded(INVCAL_OTHER_VERSION);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, golden, FLAT - 1));
    assert_not_loaded(INVCAL_DAMAGED);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, large, sizeof large));
    assert_not_loaded(INVCAL_NO_SPACE);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&session, sizeof session, 16384, 100));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_save(&session, &store));
    assert_not_loaded(INVCAL_DAMAGED);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_record_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_record);
    RUN_TEST(a_record_in_another_frame_is_read_and_kept);
    RUN_TEST(the_coefficients_of_every_power_are_where_the_table_says);
    RUN_TEST(a_record_comes_back_as_it_was);
    RUN_TEST(a_record_of_every_degree_comes_back);
    RUN_TEST(what_holds_at_the_reference_is_a_record_of_its_own);
    RUN_TEST(bytes_after_a_record_are_ignored);
    RUN_TEST(the_record_within_is_given_only_if_it_is_asked_for);
    RUN_TEST(a_number_that_is_not_finite_is_not_encoded);
    RUN_TEST(a_number_that_is_not_finite_is_not_decoded);
    RUN_TEST(what_is_never_calibrated_is_not_encoded);
    RUN_TEST(what_is_never_encoded_is_not_decoded);
    RUN_TEST(a_record_of_another_calibration_is_refused);
    RUN_TEST(a_calibration_without_inverse_is_refused);
    RUN_TEST(a_damaged_part_is_damage);
    RUN_TEST(a_sound_record_that_is_too_short_is_damaged);
    RUN_TEST(another_kind_version_or_a_higher_degree_is_named);
    RUN_TEST(any_wrong_bit_is_damage);
    RUN_TEST(a_cut_record_is_damaged);
    RUN_TEST(what_was_saved_is_loaded_with_all_that_is_known);
    RUN_TEST(what_is_no_solution_is_not_saved_and_changes_nothing);
    RUN_TEST(something_else_is_not_loaded);
    return UNITY_END() != 0;
}
