/* SPDX-License-Identifier: MIT
 *
 * The record of both sensors.
 */
#include <string.h>

#include "invcal/gyro_store.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { SIZE = INVCAL_IMU_RECORD_SIZE, MARGIN = 32, REALS = 48, ACCELEROMETER_REALS = 27 };
enum {
    RECORD_AT = 4,
    WEAK_AT = 140,
    VERDICT_AT = 144,
    G_AT = 146,
    NOTHING_AT = 147,
    REALS_AT = 148
};
enum { OFFSET = 3, MATRIX = 6, SIGMA = 15, SLOPE = 24, SLOPE_SIGMA = 36 };

/* The bytes of the record below, by Python:
 *
 *     import struct, zlib
 *     a = struct.pack('<BBH8sIHHHBB27f', 0xCA, 2, 136, b'SN-00042', 0x6543210F, 18, 0x101, 0x82, 5, 1,
 *         *accelerometer)     # store.h
 *     a += struct.pack('<I', zlib.crc32(a))
 *     b = struct.pack('<BBH136sHHBBBB48f', 0xCC, 1, 344, a, 0x111, 0x0223, 5, 12, 1, 0, *gyro)
 *     b += struct.pack('<I', zlib.crc32(b))
 */
static const uint8_t golden[SIZE] = {
    0xCC, 0x01, 0x58, 0x01, 0xCA, 0x02, 0x88, 0x00, 0x53, 0x4E, 0x2D, 0x30, 0x30, 0x30, 0x34, 0x32,
    0x0F, 0x21, 0x43, 0x65, 0x12, 0x00, 0x01, 0x01, 0x82, 0x00, 0x05, 0x01, 0x00, 0x00, 0x1D, 0x41,
    0x00, 0x00, 0x00, 0x3B, 0x00, 0x00, 0x48, 0xC1, 0x00, 0x00, 0x80, 0x3A, 0x00, 0x00, 0x80, 0x39,
    0x00, 0x00, 0x04, 0x41, 0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46,
    0x52, 0x49, 0x1D, 0x3B, 0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7,
    0x0A, 0xD7, 0x23, 0x3B, 0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6,
    0xC3, 0x64, 0x2A, 0xBB, 0x17, 0xB7, 0xD1, 0x38, 0x17, 0xB7, 0x51, 0x39, 0x52, 0x49, 0x9D, 0x39,
    0x17, 0xB7, 0xD1, 0x39, 0x6F, 0x12, 0x03, 0x3A, 0x52, 0x49, 0x1D, 0x3A, 0x34, 0x80, 0x37, 0x3A,
    0x17, 0xB7, 0x51, 0x3A, 0xFA, 0xED, 0x6B, 0x3A, 0x70, 0x3D, 0x06, 0x34, 0x11, 0x01, 0x23, 0x02,
    0x05, 0x0C, 0x01, 0x00, 0x45, 0xF5, 0xD6, 0x39, 0xBD, 0x3A, 0xC7, 0x3A, 0x04, 0xE7, 0x8C, 0x3B,
    0x00, 0x00, 0x48, 0x41, 0x00, 0x00, 0x21, 0xC2, 0x00, 0x00, 0xF8, 0x40, 0x6F, 0x12, 0x83, 0x3A,
    0xBD, 0x37, 0x06, 0x36, 0x9C, 0x53, 0x49, 0xB6, 0xBD, 0x37, 0x86, 0x36, 0xE0, 0x2D, 0x90, 0x3A,
    0xAC, 0xC5, 0xA7, 0x36, 0x9C, 0x53, 0xC9, 0xB6, 0x8B, 0xE1, 0xEA, 0x36, 0x52, 0x49, 0x9D, 0xBA,
    0x17, 0xB7, 0xD1, 0x38, 0x17, 0xB7, 0x51, 0x39, 0x52, 0x49, 0x9D, 0x39, 0x17, 0xB7, 0xD1, 0x39,
    0x6F, 0x12, 0x03, 0x3A, 0x52, 0x49, 0x1D, 0x3A, 0x34, 0x80, 0x37, 0x3A, 0x17, 0xB7, 0x51, 0x3A,
    0xFA, 0xED, 0x6B, 0x3A, 0x0A, 0xD7, 0xA3, 0xBB, 0x6F, 0x12, 0x83, 0xBB, 0xA6, 0x9B, 0x44, 0xBB,
    0x6F, 0x12, 0x03, 0xBB, 0x6F, 0x12, 0x83, 0xBA, 0x00, 0x00, 0x00, 0x00, 0x6F, 0x12, 0x83, 0x3A,
    0x6F, 0x12, 0x03, 0x3B, 0xA6, 0x9B, 0x44, 0x3B, 0x6F, 0x12, 0x83, 0x3B, 0x0A, 0xD7, 0xA3, 0x3B,
    0xA6, 0x9B, 0xC4, 0x3B, 0xAC, 0xC5, 0xA7, 0x37, 0xAC, 0xC5, 0x27, 0x38, 0x82, 0xA8, 0x7B, 0x38,
    0xAC, 0xC5, 0xA7, 0x38, 0x17, 0xB7, 0xD1, 0x38, 0x82, 0xA8, 0xFB, 0x38, 0xF7, 0xCC, 0x12, 0x39,
    0xAC, 0xC5, 0x27, 0x39, 0x62, 0xBE, 0x3C, 0x39, 0x17, 0xB7, 0x51, 0x39, 0xCD, 0xAF, 0x66, 0x39,
    0x82, 0xA8, 0x7B, 0x39, 0x7A, 0x40, 0x0D, 0xF8,
};

static const double accelerometer_reals[ACCELEROMETER_REALS] = {
    9.8125,    0.001953125, -12.5,  0.0009765625, 0.000244140625, 8.25,   33123.5,
    -33276.25, 32360.75,    0.0024, 1.5e-05,      -2.5e-06,       -1e-05, 0.0025,
    3e-06,     4e-06,       -5e-06, -0.0026,      0.0001,         0.0002, 0.0003,
    0.0004,    0.0005,      0.0006, 0.0007,       0.0008,         0.0009};
/* move_noise, move_rms, move_max; offset, matrix; sigma; slope; slope_sigma */
static const double reals[REALS] = {
    0.00041, 0.00152, 0.0043,  12.5,    -40.25,  7.75,   0.001,   2e-06,  -3e-06, 4e-06,
    0.0011,  5e-06,   -6e-06,  7e-06,   -0.0012, 0.0001, 0.0002,  0.0003, 0.0004, 0.0005,
    0.0006,  0.0007,  0.0008,  0.0009,  -0.005,  -0.004, -0.003,  -0.002, -0.001, 0.0,
    0.001,   0.002,   0.003,   0.004,   0.005,   0.006,  2e-05,   4e-05,  6e-05,  8e-05,
    0.0001,  0.00012, 0.00014, 0.00016, 0.00018, 0.0002, 0.00022, 0.00024};

/* What the bytes hold. */
typedef struct {
    invcal_imu_result r;
    invcal_record accelerometer;
} contents;

/* Real number i of the record, in the order of the table in frozen.md. */
static invcal_real *real_of(contents *c, unsigned i)
{
    invcal_imu_result *r = &c->r;
    invcal_real *const single[] = {&r->move_noise, &r->move_rms, &r->move_max};

    return i < OFFSET        ? single[i]
           : i < MATRIX      ? &r->gyro.offset[i - OFFSET]
           : i < SIGMA       ? &r->gyro.matrix[(i - MATRIX) / 3][(i - MATRIX) % 3]
           : i < SLOPE       ? &r->sigma[INVCAL_GYRO_XX + i - SIGMA]
           : i < SLOPE_SIGMA ? &r->slope[(i - SLOPE) / 4][(i - SLOPE) % 4]
                             : &r->slope_sigma[(i - SLOPE_SIGMA) / 4][(i - SLOPE_SIGMA) % 4];
}

static invcal_real *accelerometer_real(invcal_record *r, unsigned i)
{
    invcal_real *const single[] = {&r->field, &r->field_sigma, &r->temperature,
                                   &r->noise, &r->rms,         &r->condition};

    return i < 6    ? single[i]
           : i < 9  ? &r->calibration.offset[i - 6]
           : i < 18 ? &r->calibration.matrix[(i - 9) / 3][(i - 9) % 3]
                    : &r->sigma[i - 18];
}

static contents golden_record(void)
{
    contents r;

    memset(&r, 0, sizeof r);
    for (unsigned i = 0; i < REALS; i++) {
        *real_of(&r, i) = (invcal_real)reals[i];
    }
    for (unsigned i = 0; i < ACCELEROMETER_REALS; i++) {
        *accelerometer_real(&r.accelerometer, i) = (invcal_real)accelerometer_reals[i];
    }
    memcpy(r.accelerometer.sensor, "SN-00042", 8);
    r.accelerometer.date = 0x6543210Fu;
    r.accelerometer.positions = 18;
    r.accelerometer.weak = 0x101;
    r.accelerometer.held = 0x82;
    r.accelerometer.verdict = INVCAL_WEAK;
    r.accelerometer.temperature_known = 1;
    r.r.weak = (uint32_t)0x111 << 9 | 0x101;
    r.r.dof = 0x0223;
    r.r.verdict = INVCAL_WEAK;
    r.r.moves = 12;
    r.r.g_is_used = 1;
    r.r.accelerometer = r.accelerometer.calibration;
    r.r.noise = r.accelerometer.noise;
    memcpy(r.r.sigma, r.accelerometer.sigma, sizeof r.accelerometer.sigma);
    return r;
}

/* Equal to the bit, reals as they are after rounding to float. */
static void assert_equal_records(contents *expected, contents *actual)
{
    for (unsigned i = 0; i < REALS; i++) {
        const invcal_real e = (invcal_real)(float)*real_of(expected, i);
        TEST_ASSERT_EQUAL_MEMORY(&e, real_of(actual, i), sizeof e);
    }
    for (unsigned i = 0; i < ACCELEROMETER_REALS; i++) {
        const invcal_real e = (invcal_real)(float)*accelerometer_real(&expected->accelerometer, i);
        TEST_ASSERT_EQUAL_MEMORY(&e, accelerometer_real(&actual->accelerometer, i), sizeof e);
    }
    TEST_ASSERT_EQUAL_MEMORY(expected->accelerometer.sensor, actual->accelerometer.sensor, 8);
    TEST_ASSERT_EQUAL_HEX32(expected->accelerometer.date, actual->accelerometer.date);
    TEST_ASSERT_EQUAL_INT(expected->accelerometer.positions, actual->accelerometer.positions);
    TEST_ASSERT_EQUAL_HEX16(expected->accelerometer.weak, actual->accelerometer.weak);
    TEST_ASSERT_EQUAL_INT(expected->accelerometer.verdict, actual->accelerometer.verdict);
    TEST_ASSERT_EQUAL_HEX32(expected->r.weak >> 9 << 9 | expected->accelerometer.weak,
                            actual->r.weak);
    TEST_ASSERT_EQUAL_INT(expected->r.dof, actual->r.dof);
    TEST_ASSERT_EQUAL_INT(expected->r.verdict, actual->r.verdict);
    TEST_ASSERT_EQUAL_INT(expected->r.moves, actual->r.moves);
    TEST_ASSERT_EQUAL_INT(expected->r.g_is_used, actual->r.g_is_used);
}

/* The record of the accelerometer is its own: it has the same calibration. */
static invcal_status encode(const contents *c, uint8_t bytes[SIZE])
{
    contents own = *c;

    own.r.accelerometer = own.accelerometer.calibration;
    return invcal_imu_encode(&own.r, &own.accelerometer, bytes);
}

static invcal_status decode(const uint8_t *bytes, uint32_t size, contents *c)
{
    return invcal_imu_decode(bytes, size, &c->r, &c->accelerometer);
}

static void assert_encodes(const contents *r, uint8_t bytes[SIZE])
{
    uint8_t buffer[SIZE + MARGIN];
    const contents before = *r;

    memset(buffer, 0x5A, sizeof buffer);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, encode(r, buffer + 1)); /* odd address */
    TEST_ASSERT_EQUAL_MEMORY(&before, r, sizeof before);
    TEST_ASSERT_EQUAL_HEX8(0x5A, buffer[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, buffer + 1 + SIZE, MARGIN - 1);
    memcpy(bytes, buffer + 1, SIZE);
}

static void assert_decodes(const uint8_t *bytes, contents *out)
{
    uint8_t buffer[SIZE + 1];

    memcpy(buffer + 1, bytes, SIZE);
    memset(out, 0x5A, sizeof *out);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(buffer + 1, SIZE, out));
}

static void assert_not_encoded(invcal_status expected, const contents *r)
{
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_INT(expected, encode(r, bytes));
}

static int is_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    static contents out;
    static uint8_t before[sizeof out];

    memset(&out, 0x5A, sizeof out);
    memset(before, 0x5A, sizeof before);
    return decode(bytes, size, &out) == expected && memcmp(&out, before, sizeof out) == 0;
}

/* ---- what is kept ------------------------------------------------------------------------------ */

static void a_record_has_the_bytes_of_the_table(void)
{
    const contents r = golden_record();
    uint8_t bytes[SIZE];

    assert_encodes(&r, bytes);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, SIZE);
}

static void the_bytes_of_the_table_give_the_record(void)
{
    contents expected = golden_record();
    contents r;

    assert_decodes(golden, &r);
    assert_equal_records(&expected, &r);
}

static void a_record_comes_back_as_it_was(void)
{
    random_source random = random_start(1);

    for (int k = 0; k < SOME(2000); k++) {
        contents r = golden_record();
        contents back;
        uint8_t bytes[SIZE];
        uint8_t again[SIZE];
        for (unsigned i = 0; i < REALS; i++) {
            if (i < OFFSET || i >= SIGMA) {
                *real_of(&r, i) =
                    (invcal_real)(random_normal(&random) * pow(10, random_uniform(&random, -9, 9)));
            } else {
                *real_of(&r, i) *= (invcal_real)random_uniform(&random, 0.5, 1.5);
            }
        }
        r.r.weak = (uint32_t)random_uniform(&random, 0, 512) << 9;
        r.r.dof = (uint16_t)random_uniform(&random, 0, 65536);
        r.r.moves = (uint8_t)random_uniform(&random, 0, 256);
        r.r.g_is_used = (uint8_t)(k % 2);
        assert_encodes(&r, bytes);
        assert_decodes(bytes, &back);
        assert_equal_records(&r, &back);
        assert_encodes(&back, again);
        TEST_ASSERT_EQUAL_MEMORY(bytes, again, SIZE);
    }
}

/* A device without a gyroscope. */
static void the_accelerometer_is_a_record_of_its_own(void)
{
    contents expected = golden_record();
    contents r;

    assert_decodes(golden, &r);
    memset(&r.accelerometer, 0x5A, sizeof r.accelerometer);
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_record_decode(golden + RECORD_AT, INVCAL_RECORD_SIZE, &r.accelerometer));
    assert_equal_records(&expected, &r);
}

static void bytes_after_a_record_are_ignored(void)
{
    uint8_t bytes[SIZE + MARGIN];
    contents expected = golden_record();

    for (unsigned fill = 0; fill < 256; fill += 85) {
        contents r;
        memset(bytes, (int)fill, sizeof bytes);
        memcpy(bytes, golden, SIZE);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, decode(bytes, 0xFFFFFFFFu, &r));
        assert_equal_records(&expected, &r);
    }
}

/* Every number of a result, all different. */
static invcal_imu_result make_result(void)
{
    invcal_imu_result r = golden_record().r;

    r.verdict = INVCAL_GOOD;
    r.weak = 0;
    return r;
}

/* What the bytes of a result hold, with what else is known of the accelerometer, or nothing. */
static contents expect(const invcal_imu_result *result, invcal_verdict of_accelerometer)
{
    contents c;

    memset(&c, 0, sizeof c);
    c.r = *result;
    c.accelerometer.calibration = result->accelerometer;
    c.accelerometer.noise = result->noise;
    memcpy(c.accelerometer.sigma, result->sigma, sizeof c.accelerometer.sigma);
    c.accelerometer.weak = (uint16_t)(result->weak & 0x1FF);
    c.accelerometer.verdict = of_accelerometer;
    return c;
}

static void the_record_of_the_accelerometer_is_made_from_the_result(void)
{
    static const struct {
        uint32_t weak;
        uint8_t verdict, of_accelerometer;
    } judged[] = {{0, INVCAL_GOOD, INVCAL_GOOD},
                  {0, INVCAL_ROUGH, INVCAL_ROUGH},
                  {0x111u << 9, INVCAL_WEAK, INVCAL_NO_REDUNDANCY},
                  {0x101, INVCAL_WEAK, INVCAL_WEAK},
                  {0x3FFFF, INVCAL_WEAK, INVCAL_WEAK}};
    const contents golden_one = golden_record();

    for (unsigned k = 0; k < 2 * sizeof judged / sizeof *judged; k++) {
        invcal_imu_result result = make_result();
        invcal_record about =
            golden_one.accelerometer; /* an earlier one: only what lasts is taken */
        contents back;
        uint8_t bytes[SIZE];
        result.weak = judged[k / 2].weak;
        result.verdict = judged[k / 2].verdict;
        about.calibration.offset[1] += 1;
        contents expected = expect(&result, judged[k / 2].of_accelerometer);
        if (k % 2) {
            memcpy(expected.accelerometer.sensor, about.sensor, sizeof about.sensor);
            expected.accelerometer.date = about.date;
            expected.accelerometer.field = about.field;
            expected.accelerometer.field_sigma = about.field_sigma;
            expected.accelerometer.temperature = about.temperature;
            expected.accelerometer.temperature_known = about.temperature_known;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_encode(&result, k % 2 ? &about : NULL, bytes));
        assert_decodes(bytes, &back);
        assert_equal_records(&expected, &back);
    }
}

/* The accelerometer was held: its own record is kept whole, and comes back as it was. */
static void the_record_of_a_held_accelerometer_is_kept(void)
{
    contents c = golden_record();
    contents back;
    uint8_t bytes[SIZE];

    c.r.weak = 0;
    c.r.verdict = INVCAL_GOOD;
    memset(c.r.sigma, 0, 9 * sizeof c.r.sigma[0]);
    c.accelerometer.weak = 0;
    c.accelerometer.verdict = INVCAL_NO_REDUNDANCY;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_encode(&c.r, &c.accelerometer, bytes));
    assert_decodes(bytes, &back);
    assert_equal_records(&c, &back);
    for (unsigned i = 0; i < 9; i++) {
        TEST_ASSERT_TRUE(back.r.sigma[i] == back.accelerometer.sigma[i]);
    }
}

/* What the table does not name is 0; and nobody has to ask for the record. */
static void a_result_has_nothing_else(void)
{
    contents c = golden_record();
    invcal_imu_result r;

    memset(&r, 0x5A, sizeof r);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_decode(golden, SIZE, &r, NULL));
    TEST_ASSERT_TRUE(r.left_out == 0 && r.idle == 0 && r.worst == 0);
    TEST_ASSERT_TRUE(r.noise == c.accelerometer.noise);
    TEST_ASSERT_TRUE(r.accelerometer.offset[0] == c.accelerometer.calibration.offset[0]);
}

/* ---- what is refused --------------------------------------------------------------------------- */

static void a_number_that_is_not_finite_is_neither_encoded_nor_decoded(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    static const uint8_t bits[][4] = {
        {0, 0, 0xC0, 0x7F}, {1, 0, 0x80, 0xFF}, {0, 0, 0x80, 0x7F}, {0, 0, 0x80, 0xFF}};

    for (unsigned i = 0; i < REALS; i++) {
        for (unsigned k = 0; k < 3; k++) {
            contents r = golden_record();
            *real_of(&r, i) = (invcal_real)bad[k];
            assert_not_encoded(INVCAL_NOT_FINITE, &r);
        }
        for (unsigned k = 0; k < 4; k++) {
            uint8_t bytes[SIZE];
            memcpy(bytes, golden, SIZE);
            memcpy(bytes + REALS_AT + 4 * i, bits[k], 4);
            seal_bytes(bytes, SIZE - 4);
            TEST_ASSERT_TRUE(is_refused(INVCAL_NOT_FINITE, bytes, SIZE));
        }
    }
    for (unsigned i = 0; i < ACCELEROMETER_REALS; i++) {
        contents r = golden_record();
        *accelerometer_real(&r.accelerometer, i) = (invcal_real)NOT_A_NUMBER;
        assert_not_encoded(INVCAL_NOT_FINITE, &r);
    }
}

static void a_singular_matrix_is_neither_encoded_nor_decoded(void)
{
    contents r = golden_record();
    uint8_t bytes[SIZE];

    for (unsigned row = 0; row < 3; row++) {
        r = golden_record();
        memcpy(r.r.gyro.matrix[row], r.r.gyro.matrix[(row + 1) % 3], sizeof r.r.gyro.matrix[0]);
        assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
        memcpy(bytes, golden, SIZE);
        memset(bytes + REALS_AT + 4 * (MATRIX + 3 * row), 0, 12);
        seal_bytes(bytes, SIZE - 4);
        TEST_ASSERT_TRUE(is_refused(INVCAL_BAD_NOMINAL, bytes, SIZE));
    }
    r = golden_record();
    memset(r.accelerometer.calibration.matrix, 0, sizeof r.accelerometer.calibration.matrix);
    assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
}

/* Contradictions of weak parameters and verdict, for both sensors; a tenth parameter; undefined
 * flags. */
static void a_record_that_contradicts_itself_is_neither_encoded_nor_decoded(void)
{
    for (unsigned k = 0; k < 8 * 2 * 12 * 3 * 2; k += SLOW(1, 7)) {
        const uint8_t verdict = (uint8_t)(k % 8);
        const int other_is_weak = k / 8 % 2;
        const unsigned weak = k / 16 % 12 ? 1u << (k / 16 % 12 - 1) : 0;
        const uint8_t g = (uint8_t)(k / 192 % 3);
        const uint8_t nothing = (uint8_t)(k / 576);
        const int fits = verdict == 5 ? weak > 0 || other_is_weak : verdict < 5 && weak == 0;
        const int is_good = fits && weak < 512 && g < 2;
        contents r = golden_record();
        uint8_t bytes[SIZE];
        r.r.verdict = (uint8_t)(16 * verdict);
        r.r.weak = (uint32_t)weak << 9;
        r.r.g_is_used = g;
        if (!other_is_weak) {
            r.accelerometer.weak = 0;
            r.accelerometer.verdict = INVCAL_GOOD;
        }
        TEST_ASSERT_EQUAL_INT(is_good ? INVCAL_OK : INVCAL_DAMAGED, encode(&r, bytes));
        memcpy(bytes, golden, SIZE);
        if (!other_is_weak) {
            memset(bytes + RECORD_AT + 18, 0, 2);
            bytes[RECORD_AT + 22] = 0;
            seal_bytes(bytes + RECORD_AT, INVCAL_RECORD_SIZE - 4);
        }
        bytes[WEAK_AT] = (uint8_t)(weak & 0xFF);
        bytes[WEAK_AT + 1] = (uint8_t)(weak >> 8);
        bytes[VERDICT_AT] = verdict;
        bytes[G_AT] = g;
        bytes[NOTHING_AT] = nothing;
        seal_bytes(bytes, SIZE - 4);
        TEST_ASSERT_EQUAL_INT(is_good && nothing == 0, !is_refused(INVCAL_DAMAGED, bytes, SIZE));
    }
}

/* Verdicts are multiples of 16. */
static void a_verdict_between_two_is_damaged(void)
{
    for (unsigned between = 1; between < 16; between++) {
        contents r = golden_record();
        r.r.verdict = (uint8_t)(INVCAL_ROUGH + between);
        assert_not_encoded(INVCAL_DAMAGED, &r);
    }
}

static void any_wrong_bit_is_noticed(void)
{
    uint8_t bytes[SIZE];

    memcpy(bytes, golden, SIZE);
    for (unsigned bit = 0; bit < 8 * SIZE; bit += SLOW(1, 3)) {
        bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, SIZE));
        bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
}

/* Even if the CRC is right: the accelerometer's record has its own. */
static void a_wrong_bit_within_is_noticed(void)
{
    uint8_t bytes[SIZE];

    for (unsigned bit = 0; bit < 8 * INVCAL_RECORD_SIZE; bit += SLOW(1, 3)) {
        memcpy(bytes, golden, SIZE);
        bytes[RECORD_AT + bit / 8] ^= (uint8_t)(1u << bit % 8);
        seal_bytes(bytes, SIZE - 4);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, SIZE));
    }
}

static void too_few_bytes_are_refused(void)
{
    for (uint32_t size = 0; size < SIZE; size++) {
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, golden, size));
    }
}

/* Valid bytes of another kind or version, and of another length. */
static void another_kind_or_version_is_named(void)
{
    for (unsigned k = 0; k < 512; k++) {
        uint8_t bytes[SIZE];
        memcpy(bytes, golden, SIZE);
        bytes[k / 256] = (uint8_t)(k % 256);
        seal_bytes(bytes, SIZE - 4);
        const int is_golden = memcmp(bytes, golden, SIZE) == 0;
        TEST_ASSERT_EQUAL_INT(!is_golden, is_refused(INVCAL_OTHER_VERSION, bytes, SIZE));
    }
    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, golden + RECORD_AT, INVCAL_RECORD_SIZE));
    for (uint32_t length = 8; length < SIZE; length++) {
        uint8_t bytes[SIZE];
        memcpy(bytes, golden, SIZE);
        bytes[2] = (uint8_t)(length & 0xFF);
        bytes[3] = (uint8_t)(length >> 8);
        seal_bytes(bytes, length - 4);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, SIZE));
    }
}

/* ---- in a memory ------------------------------------------------------------------------------- */

enum { SLOT = INVCAL_STORE_BYTES(INVCAL_IMU_RECORD_SIZE, 4) };
static uint8_t cells[2][SLOT];
static long power; /* bytes until it fails */

static int read_cells(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &cells[slot][offset], size);
    return power <= 0;
}

static int erase_cells(void *context, unsigned slot)
{
    (void)context;
    for (unsigned i = 0; i < SLOT && power > 0; i++, power--) {
        cells[slot][i] = 0xFF;
    }
    return power <= 0;
}

static int program_cells(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context;
    for (uint32_t i = 0; i < size && power > 0; i++, power--) {
        cells[slot][offset + i] &= bytes[i];
    }
    return power <= 0;
}

static const invcal_store store = {read_cells, erase_cells, program_cells, NULL, SLOT, 4};

static void new_cells(void)
{
    memset(cells, 0xFF, sizeof cells);
    power = 100000;
}

static invcal_status load_contents(contents *c)
{
    return invcal_imu_load_result(&c->r, &store);
}

static void assert_loaded(const contents *expected, contents *loaded)
{
    contents e = *expected;

    loaded->accelerometer = e.accelerometer; /* of which the result has what matters */
    for (unsigned i = 0; i < ACCELEROMETER_REALS; i++) {
        invcal_real *real = accelerometer_real(&loaded->accelerometer, i);
        *real = (invcal_real)(float)*real;
    }
    assert_equal_records(&e, loaded);
}

/* The bytes in the memory are those of the record. */
static void a_result_is_saved_and_loaded(void)
{
    invcal_imu_result imu = make_result();
    contents expected;
    contents r;
    uint8_t bytes[SIZE];
    uint8_t stored[SIZE];
    uint32_t size = 0;

    new_cells();
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_RECORD, load_contents(&r));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save_result(&imu, &store));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, load_contents(&r));
    expected = expect(&imu, INVCAL_GOOD);
    assert_loaded(&expected, &r);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_encode(&imu, NULL, bytes));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_load(&store, stored, SIZE, &size));
    TEST_ASSERT_EQUAL_UINT32(SIZE, size);
    TEST_ASSERT_EQUAL_MEMORY(bytes, stored, SIZE);
    imu.gyro.offset[1] = (invcal_real)NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_imu_save_result(&imu, &store));
    imu.accelerometer.matrix[1][1] = (invcal_real)NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_imu_save_result(&imu, &store));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, load_contents(&r)); /* the previous one */
    assert_loaded(&expected, &r);
}

/* The other record, and what is not a record. */
static void what_is_not_a_result_is_not_loaded(void)
{
    static const uint8_t large[SLOT] = {0xCC, 1};
    contents r;

    new_cells();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_store_save(&store, golden + RECORD_AT, INVCAL_RECORD_SIZE));
    TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_VERSION, load_contents(&r));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, large, SIZE));
    TEST_ASSERT_EQUAL_INT(INVCAL_DAMAGED, load_contents(&r));
}

/* At each byte of a save: the old one or the new one is found, complete. */
static void a_power_cut_at_any_byte_of_a_save_loses_no_result(void)
{
    invcal_imu_result imu = make_result();
    int found[2] = {0, 0};
    int saved = 0;

    for (long cut = 1; !saved; cut++) {
        contents r;
        new_cells();
        imu.moves = 12;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save_result(&imu, &store));
        imu.moves = 13;
        power = cut;
        saved = invcal_imu_save_result(&imu, &store) == INVCAL_OK;
        power = 100000;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, load_contents(&r));
        TEST_ASSERT_TRUE(r.r.moves == 12 || r.r.moves == 13);
        TEST_ASSERT_TRUE(!saved || r.r.moves == 13);
        found[r.r.moves - 12]++;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_imu_save_result(&imu, &store)); /* and it works again */
    }
    TEST_ASSERT_TRUE(found[0] > SLOT && found[1] > 1);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_record_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_record);
    RUN_TEST(a_record_comes_back_as_it_was);
    RUN_TEST(the_accelerometer_is_a_record_of_its_own);
    RUN_TEST(bytes_after_a_record_are_ignored);
    RUN_TEST(the_record_of_the_accelerometer_is_made_from_the_result);
    RUN_TEST(the_record_of_a_held_accelerometer_is_kept);
    RUN_TEST(a_result_has_nothing_else);
    RUN_TEST(a_number_that_is_not_finite_is_neither_encoded_nor_decoded);
    RUN_TEST(a_singular_matrix_is_neither_encoded_nor_decoded);
    RUN_TEST(a_record_that_contradicts_itself_is_neither_encoded_nor_decoded);
    RUN_TEST(a_verdict_between_two_is_damaged);
    RUN_TEST(any_wrong_bit_is_noticed);
    RUN_TEST(a_wrong_bit_within_is_noticed);
    RUN_TEST(too_few_bytes_are_refused);
    RUN_TEST(another_kind_or_version_is_named);
    RUN_TEST(a_result_is_saved_and_loaded);
    RUN_TEST(what_is_not_a_result_is_not_loaded);
    RUN_LONG_TEST(a_power_cut_at_any_byte_of_a_save_loses_no_result);
    return UNITY_END() != 0;
}
