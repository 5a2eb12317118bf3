/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/store.h"
#include "core/vector.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { SIZE = INVCAL_RECORD_SIZE, REALS = 27, MARGIN = 64 };

/* The bytes of the record below, by Python:
 *
 *     import struct, zlib
 *     b = struct.pack('<BBH8sIHHHBB27f', 0xCA, 2, 136, b'SN-00042', 0x6543210F, 18, 0x101, 0x82,
 *         2, 1, *reals)       # the numbers of golden_reals
 *     b += struct.pack('<I', zlib.crc32(b))
 */
static const uint8_t golden[SIZE] = {
    0xCA, 0x02, 0x88, 0x00, 0x53, 0x4E, 0x2D, 0x30, 0x30, 0x30, 0x34, 0x32, 0x0F, 0x21, 0x43, 0x65,
    0x12, 0x00, 0x01, 0x01, 0x82, 0x00, 0x05, 0x01, 0x00, 0x00, 0x1D, 0x41, 0x00, 0x00, 0x00, 0x3B,
    0x00, 0x00, 0x48, 0xC1, 0x00, 0x00, 0x80, 0x3A, 0x00, 0x00, 0x80, 0x39, 0x00, 0x00, 0x04, 0x41,
    0x80, 0x63, 0x01, 0x47, 0x40, 0xFC, 0x01, 0xC7, 0x80, 0xD1, 0xFC, 0x46, 0x52, 0x49, 0x1D, 0x3B,
    0x82, 0xA8, 0x7B, 0x37, 0xAC, 0xC5, 0x27, 0xB6, 0xAC, 0xC5, 0x27, 0xB7, 0x0A, 0xD7, 0x23, 0x3B,
    0x9C, 0x53, 0x49, 0x36, 0xBD, 0x37, 0x86, 0x36, 0xAC, 0xC5, 0xA7, 0xB6, 0xC3, 0x64, 0x2A, 0xBB,
    0x17, 0xB7, 0xD1, 0x38, 0x17, 0xB7, 0x51, 0x39, 0x52, 0x49, 0x9D, 0x39, 0x17, 0xB7, 0xD1, 0x39,
    0x6F, 0x12, 0x03, 0x3A, 0x52, 0x49, 0x1D, 0x3A, 0x34, 0x80, 0x37, 0x3A, 0x17, 0xB7, 0x51, 0x3A,
    0xFA, 0xED, 0x6B, 0x3A, 0x70, 0x3D, 0x06, 0x34,
};

/* field, field_sigma, temperature, noise, rms, condition; offset, matrix; sigma. */
static const double golden_reals[REALS] = {
    9.8125, 0.001953125, -12.5,   0.0009765625, 0.000244140625, 8.25, 33123.5, -33276.25, 32360.75,
    0.0024, 1.5e-5,      -2.5e-6, -1e-5,        0.0025,         3e-6, 4e-6,    -5e-6,     -0.0026,
    1e-4,   2e-4,        3e-4,    4e-4,         5e-4,           6e-4, 7e-4,    8e-4,      9e-4,
};
enum { FIELD = 0, TEMPERATURE = 2, OFFSET = 6, MATRIX = 9, SIGMA = 18, REALS_AT = 24 };

/* Real number i of a record, in the order of the table in store.h. */
static invcal_real *real_of(invcal_record *r, unsigned i)
{
    invcal_real *const single[] = {&r->field, &r->field_sigma, &r->temperature,
                                   &r->noise, &r->rms,         &r->condition};

    return i < OFFSET   ? single[i]
           : i < MATRIX ? &r->calibration.offset[i - OFFSET]
           : i < SIGMA  ? &r->calibration.matrix[(i - MATRIX) / 3][(i - MATRIX) % 3]
                        : &r->sigma[i - SIGMA];
}

static invcal_record golden_record(void)
{
    invcal_record r;

    memset(&r, 0, sizeof r);
    for (unsigned i = 0; i < REALS; i++) {
        *real_of(&r, i) = (invcal_real)golden_reals[i];
    }
    memcpy(r.sensor, "SN-00042", 8);
    r.date = 0x6543210Fu;
    r.positions = 18;
    r.weak = 0x101;
    r.held = 0x82;
    r.verdict = INVCAL_WEAK;
    r.temperature_known = 1;
    return r;
}

/* Equal to the bit, reals as they are after rounding to float. */
static void assert_equal_records(invcal_record *expected, invcal_record *actual)
{
    for (unsigned i = 0; i < REALS; i++) {
        const invcal_real e = (invcal_real)(float)*real_of(expected, i);
        TEST_ASSERT_EQUAL_MEMORY(&e, real_of(actual, i), sizeof e);
    }
    TEST_ASSERT_EQUAL_MEMORY(expected->sensor, actual->sensor, 8);
    TEST_ASSERT_EQUAL_HEX32(expected->date, actual->date);
    TEST_ASSERT_EQUAL_HEX16(expected->positions, actual->positions);
    TEST_ASSERT_EQUAL_HEX16(expected->weak, actual->weak);
    TEST_ASSERT_EQUAL_HEX16(expected->held, actual->held);
    TEST_ASSERT_EQUAL_INT(expected->verdict, actual->verdict);
    TEST_ASSERT_EQUAL_INT(expected->temperature_known, actual->temperature_known);
}

static void assert_encodes(const invcal_record *r, uint8_t bytes[SIZE])
{
    uint8_t buffer[SIZE + MARGIN];
    const invcal_record before = *r;

    memset(buffer, 0x5A, sizeof buffer);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_record_encode(r, buffer + 1)); /* odd address */
    TEST_ASSERT_EQUAL_MEMORY(&before, r, sizeof before);
    TEST_ASSERT_EQUAL_HEX8(0x5A, buffer[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, buffer + 1 + SIZE, MARGIN - 1);
    memcpy(bytes, buffer + 1, SIZE);
}

static void assert_not_encoded(invcal_status expected, const invcal_record *r)
{
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_INT(expected, invcal_record_encode(r, bytes));
}

static void assert_decodes(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    uint8_t buffer[SIZE + MARGIN + 1];

    memcpy(buffer + 1, bytes, size);
    memset(out, 0x5A, sizeof *out);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_record_decode(buffer + 1, size, out));
}

static int is_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    invcal_record out;
    uint8_t before[sizeof out];

    memset(&out, 0x5A, sizeof out);
    memset(before, 0x5A, sizeof before);
    return invcal_record_decode(bytes, size, &out) == expected &&
           memcmp(&out, before, sizeof out) == 0;
}

static invcal_record random_record(random_source *random)
{
    invcal_record r;

    memset(&r, 0, sizeof r);
    for (unsigned i = 0; i < REALS; i++) {
        *real_of(&r, i) =
            (invcal_real)(random_normal(random) * pow(10, random_uniform(random, -9, 9)));
    }
    for (unsigned i = 0; i < 9; i++) { /* regular */
        const double base = i % 4 == 0 ? 1 : 0;
        *real_of(&r, MATRIX + i) = (invcal_real)(base + random_uniform(random, -0.2, 0.2));
    }
    for (unsigned i = 0; i < 8; i++) {
        r.sensor[i] = (uint8_t)random_uniform(random, 0, 256);
    }
    r.date = (uint32_t)random_uniform(random, 0, 4294967296.0);
    r.positions = (uint16_t)random_uniform(random, 0, 65536);
    r.weak = (uint16_t)random_uniform(random, 0, 512);
    if (random_uniform(random, -1, 1) < 0) {
        r.weak = 0;
    }
    r.verdict = INVCAL_WEAK;
    while ((r.verdict == INVCAL_WEAK) != (r.weak > 0)) {
        r.verdict = (uint8_t)(16 * (int)random_uniform(random, 0, 6));
    }
    r.held = (uint16_t)random_uniform(random, 0, 512);
    r.temperature_known = 1;
    return r;
}

/* ---- what is kept ------------------------------------------------------------------------------ */

static void a_record_has_the_bytes_of_the_table(void)
{
    const invcal_record r = golden_record();
    uint8_t bytes[SIZE];

    assert_encodes(&r, bytes);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, SIZE);
}

static void the_bytes_of_the_table_give_the_record(void)
{
    invcal_record expected = golden_record();
    invcal_record r;

    assert_decodes(golden, SIZE, &r);
    assert_equal_records(&expected, &r);
}

static void a_record_comes_back_as_it_was(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < SOME(2000); i++) {
        invcal_record r = random_record(&random);
        invcal_record back;
        uint8_t bytes[SIZE];
        uint8_t again[SIZE];
        assert_encodes(&r, bytes);
        assert_decodes(bytes, SIZE, &back);
        assert_equal_records(&r, &back);
        assert_encodes(&back, again);
        TEST_ASSERT_EQUAL_MEMORY(bytes, again, SIZE);
    }
}

/* Largest, smallest, subnormal, and both zeros: wherever a calibration allows them. */
static void reals_at_the_limits_of_float_come_back(void)
{
    static const float limit[] = {FLT_MAX, -FLT_MAX, FLT_MIN, 1.4e-45f, -1.4e-45f, 0, -0.0f};

    for (unsigned k = 0; k < sizeof limit / sizeof limit[0]; k++) {
        invcal_record r = golden_record();
        invcal_record back;
        uint8_t bytes[SIZE];
        for (unsigned i = 0; i < REALS; i++) {
            if (i < OFFSET || i >= SIGMA) {
                *real_of(&r, i) = (invcal_real)limit[k];
            }
        }
        assert_encodes(&r, bytes);
        assert_decodes(bytes, SIZE, &back);
        assert_equal_records(&r, &back);
    }
}

static void a_new_record_holds_what_is_known_and_marks_the_rest_as_unknown(void)
{
    invcal_record expected = golden_record();
    invcal_record r;
    invcal_quality q;
    uint8_t bytes[SIZE];

    memset(&r, 0x5A, sizeof r);
    memset(&q, 0x5A, sizeof q);
    memcpy(q.sigma, expected.sigma, sizeof q.sigma);
    q.noise = expected.noise;
    q.rms = expected.rms;
    q.condition = expected.condition;
    q.weak = expected.weak;
    q.held = expected.held;
    q.positions = 18;
    q.verdict = INVCAL_WEAK;
    invcal_record_init(&r, &expected.calibration, &q);
    expected.field = 0;
    expected.field_sigma = 0;
    expected.temperature = 0;
    expected.temperature_known = 0;
    expected.date = 0;
    memset(expected.sensor, 0, sizeof expected.sensor);
    assert_encodes(&r, bytes);
    assert_decodes(bytes, SIZE, &r);
    assert_equal_records(&expected, &r);
}

static void bytes_after_a_record_are_ignored(void)
{
    uint8_t bytes[SIZE + MARGIN];

    for (unsigned fill = 0; fill < 256; fill += 85) {
        invcal_record expected = golden_record();
        invcal_record r;
        memset(bytes, (int)fill, sizeof bytes);
        memcpy(bytes, golden, SIZE);
        assert_decodes(bytes, sizeof bytes, &r);
        assert_equal_records(&expected, &r);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_record_decode(bytes, 0xFFFFFFFFu, &r));
    }
}

/* ---- what is refused --------------------------------------------------------------------------- */

static void a_number_that_is_not_finite_is_neither_encoded_nor_decoded(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    static const uint8_t bits[][4] = {
        {0, 0, 0xC0, 0x7F}, {1, 0, 0x80, 0xFF}, {0, 0, 0x80, 0x7F}, {0, 0, 0x80, 0xFF}};

    for (unsigned i = 0; i < REALS; i++) {
        for (unsigned k = 0; k < 3; k++) {
            invcal_record r = golden_record();
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
}

static void a_number_beyond_float_is_not_encoded(void)
{
#if INVCAL_DOUBLE
    for (unsigned i = 0; i < REALS; i++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            invcal_record r = golden_record();
            *real_of(&r, i) = sign * 3.4028235e38; /* just above the largest */
            assert_not_encoded(INVCAL_NOT_FINITE, &r);
        }
    }
    invcal_record r = golden_record();
    for (unsigned i = 0; i < 9; i++) {
        *real_of(&r, MATRIX + i) *= 1e-50; /* 0 as a float */
    }
    assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
    r = golden_record();
    r.calibration.matrix[0][0] = 1; /* singular as a float */
    r.calibration.matrix[0][1] = 1;
    r.calibration.matrix[0][2] = 0;
    r.calibration.matrix[1][0] = 1;
    r.calibration.matrix[1][1] = 1 + 1e-9;
    r.calibration.matrix[1][2] = 0;
    assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
#else
    TEST_ASSERT_TRUE(INVCAL_REAL_MAX <= FLT_MAX); /* there is no such parameter */
#endif
}

static void a_singular_matrix_is_neither_encoded_nor_decoded(void)
{
    for (unsigned row = 0; row < 3; row++) {
        invcal_record r = golden_record();
        uint8_t bytes[SIZE];
        memcpy(r.calibration.matrix[row], r.calibration.matrix[(row + 1) % 3], 3 * sizeof r.field);
        assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
        memset(r.calibration.matrix[row], 0, 3 * sizeof r.field);
        assert_not_encoded(INVCAL_BAD_NOMINAL, &r);
        memcpy(bytes, golden, SIZE);
        memset(bytes + REALS_AT + 4 * (MATRIX + 3 * row), 0, 12);
        seal_bytes(bytes, SIZE - 4);
        TEST_ASSERT_TRUE(is_refused(INVCAL_BAD_NOMINAL, bytes, SIZE));
    }
}

/* Verdicts have steps of 16, and are stored in steps of 1: 0 ... 5. */
static void every_verdict_keeps_its_byte(void)
{
    for (unsigned k = 0; k < 256; k++) {
        invcal_record r = golden_record();
        uint8_t bytes[SIZE];
        r.verdict = (uint8_t)k;
        if (k < INVCAL_WEAK) {
            r.weak = 0;
        }
        if (k % 16 == 0 && k <= INVCAL_WEAK) {
            assert_encodes(&r, bytes);
            TEST_ASSERT_EQUAL_UINT(k / 16, bytes[22]);
            invcal_record back;
            assert_decodes(bytes, SIZE, &back);
            TEST_ASSERT_EQUAL_UINT(k, back.verdict);
        } else {
            assert_not_encoded(INVCAL_DAMAGED, &r);
        }
    }
}

/* A verdict that there is not (the fifth is weak), or that the weak parameters do not bear out; a
 * parameter that there is not, a temperature that is not known and yet stated. */
static void a_record_that_contradicts_itself_is_neither_encoded_nor_decoded(void)
{
    for (unsigned k = 0; k < 3 * 16 * 16 * 8; k += SLOW(1, 7)) {
        const uint8_t verdict = (uint8_t)(k % 8);
        const unsigned weak = k / 8 % 16 ? 1u << (k / 8 % 16 - 1) : 0;
        const unsigned held = k / 128 % 16 ? 1u << (k / 128 % 16 - 1) : 0;
        const uint8_t known = (uint8_t)(k / 2048);
        const int others_are = weak < 512 && held < 512 && known == 1;
        const int is_good = verdict <= 5 && (verdict == 5) == (weak > 0) && others_are;
        invcal_record r = golden_record();
        uint8_t bytes[SIZE];
        r.verdict = (uint8_t)(16 * verdict);
        r.weak = (uint16_t)weak;
        r.held = (uint16_t)held;
        r.temperature_known = known;
        TEST_ASSERT_EQUAL_INT(is_good ? INVCAL_OK : INVCAL_DAMAGED,
                              invcal_record_encode(&r, bytes));
        memcpy(bytes, golden, SIZE);
        bytes[18] = (uint8_t)(weak & 0xFF);
        bytes[19] = (uint8_t)(weak >> 8);
        bytes[20] = (uint8_t)(held & 0xFF);
        bytes[21] = (uint8_t)(held >> 8);
        bytes[22] = verdict;
        bytes[23] = known;
        seal_bytes(bytes, SIZE - 4);
        TEST_ASSERT_EQUAL_INT(is_good, !is_refused(INVCAL_DAMAGED, bytes, SIZE));
    }
}

static void an_unknown_temperature_is_zero(void)
{
    static const double any[] = {25, -1, 1e-40, 0};

    for (unsigned i = 0; i < 4; i++) {
        invcal_record r = golden_record();
        invcal_record back;
        uint8_t bytes[SIZE];
        r.temperature_known = 0;
        r.temperature = (invcal_real)any[i];
        if (i < 3) {
            assert_not_encoded(INVCAL_DAMAGED, &r);
        } else {
            assert_encodes(&r, bytes);
            assert_decodes(bytes, SIZE, &back);
            assert_equal_records(&r, &back);
        }
    }
}

static void any_wrong_bit_is_noticed(void)
{
    uint8_t bytes[SIZE + MARGIN];

    for (unsigned tail = 0; tail <= MARGIN; tail += MARGIN) { /* also in a larger buffer */
        memset(bytes, 0, sizeof bytes);
        memcpy(bytes, golden, SIZE);
        for (unsigned bit = 0; bit < 8 * SIZE; bit++) {
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, SIZE + tail));
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
    }
}

static int compare_u32(const void *a, const void *b)
{
    uint32_t x;
    uint32_t y;

    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return x < y ? -1 : x > y;
}

/* The check of two errors is the exclusive or of theirs. If no two pairs of bits have the same,
 * nor one that is zero, no one to four wrong bits pass: in any record, as it is linear. */
static void any_four_wrong_bits_are_noticed(void)
{
    enum { BITS = 8 * SIZE };
    static const uint32_t all = BITS * (BITS + 1L) / 2 + 1;
    static uint32_t check[BITS];
    static uint32_t pair[ROOM(BITS * (BITS + 1L) / 2 + 1, 1)];
    uint32_t pairs = 0;

    if (sizeof pair / sizeof pair[0] < all) {
        skip_large();
    }
    for (unsigned bit = 0; bit < BITS; bit++) {
        uint8_t bytes[SIZE];
        memcpy(bytes, golden, SIZE);
        bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        check[bit] = crc_by_table(bytes, SIZE); /* the same for any sound record */
        check[bit] ^= crc_by_table(golden, SIZE);
        for (unsigned other = 0; other < bit; other++) {
            pair[pairs++] = check[bit] ^ check[other];
        }
        pair[pairs++] = check[bit]; /* single ones as well */
    }
    pair[pairs++] = 0;
    TEST_ASSERT_EQUAL_UINT32(all, pairs);
    qsort(pair, pairs, sizeof pair[0], compare_u32);
    for (uint32_t i = 1; i < pairs; i++) {
        TEST_ASSERT_TRUE(pair[i] != pair[i - 1]);
    }
}

static void any_two_bytes_exchanged_are_noticed(void)
{
    uint8_t bytes[SIZE];
    unsigned exchanged = 0;

    memcpy(bytes, golden, SIZE);
    for (unsigned a = 0; a < SIZE; a++) {
        for (unsigned b = 0; b < a; b++) {
            if (golden[a] != golden[b]) {
                bytes[a] = golden[b];
                bytes[b] = golden[a];
                TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, SIZE));
                bytes[a] = golden[a];
                bytes[b] = golden[b];
                exchanged++;
            }
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(SIZE / 2 * SIZE / 10 * 9, exchanged);
}

static void a_record_without_its_end_is_noticed(void)
{
    for (uint32_t size = 0; size < SIZE; size++) {
        uint8_t *exact = malloc(size + 1); /* so that a sanitizer sees a read beyond it */
        memcpy(exact + 1, golden, size);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, exact + 1, size));
        free(exact);
    }
}

static void blank_and_random_bytes_are_not_a_record(void)
{
    random_source random = random_start(2);
    uint8_t bytes[SIZE + MARGIN];

    for (unsigned k = 0; k < SOME(1000); k++) {
        for (unsigned i = 0; i < sizeof bytes; i++) {
            bytes[i] = k == 0 ? 0 : k == 1 ? 0xFF : (uint8_t)random_uniform(&random, 0, 256);
        }
        if (k % 2 && k > 1) {
            memcpy(bytes, golden, 4);
        }
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, sizeof bytes));
    }
}

static void a_sound_record_of_another_kind_or_version_is_named_so(void)
{
    static const uint16_t lengths[] = {8, 9, 40, 135, 136, 137, 183, 184, 185, 190};

    for (unsigned k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
        for (unsigned at = 0; at < 2; at++) {
            for (unsigned value = 0; value < 256; value++) {
                uint8_t bytes[SIZE + MARGIN] = {0};
                const uint16_t length = lengths[k];
                memcpy(bytes, golden, SIZE);
                bytes[at] = (uint8_t)value;
                bytes[2] = (uint8_t)(length & 0xFF);
                bytes[3] = (uint8_t)(length >> 8);
                seal_bytes(bytes, length - 4u);
                if (value != golden[at]) {
                    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, bytes, length));
                    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, bytes, sizeof bytes));
                } else if (length != SIZE) { /* it has but one */
                    TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, sizeof bytes));
                }
                TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, length - 1u));
            }
        }
    }
}

static void a_length_shorter_than_any_record_is_refused(void)
{
    for (uint8_t length = 0; length < 8; length++) {
        uint8_t bytes[8] = {0xCA, 2, 0, 0, 0, 0, 0, 0};
        bytes[2] = length;
        if (length >= 4) {
            seal_bytes(bytes, length - 4u);
        }
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, sizeof bytes));
    }
}

/* ---- in a memory ------------------------------------------------------------------------------- */

enum { SLOT = 224 };
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

static int is_loaded(invcal_status expected, invcal_calibration *calibration)
{
    uint8_t before[sizeof *calibration];

    memset(calibration, 0x5A, sizeof *calibration);
    memset(before, 0x5A, sizeof before);
    return invcal_load(calibration, &store) == expected &&
           (expected == INVCAL_OK || memcmp(before, calibration, sizeof before) == 0);
}

/* The golden calibration, and a possible quality. */
static invcal_status save_golden(uint8_t verdict)
{
    const invcal_record r = golden_record();
    invcal_quality q;

    memset(&q, 0, sizeof q);
    memcpy(q.sigma, r.sigma, sizeof q.sigma);
    q.verdict = verdict;
    return invcal_save(&r.calibration, &q, &store);
}

static void a_calibration_that_was_saved_is_loaded_and_so_is_its_record(void)
{
    invcal_record expected = golden_record();
    invcal_calibration c;
    invcal_record r;
    uint8_t bytes[SIZE];
    uint32_t size = 0;

    memset(memory, 0xFF, sizeof memory);
    TEST_ASSERT_TRUE(is_loaded(INVCAL_NO_RECORD, &c));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, save_golden(INVCAL_NO_REDUNDANCY));
    TEST_ASSERT_TRUE(is_loaded(INVCAL_OK, &c));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_load(&store, bytes, sizeof bytes, &size));
    assert_decodes(bytes, size, &r);
    TEST_ASSERT_EQUAL_UINT32(SIZE, size);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, r.verdict);
    for (unsigned i = OFFSET; i < SIGMA; i++) {
        const invcal_real e = (invcal_real)(float)*real_of(&expected, i);
        TEST_ASSERT_EQUAL_MEMORY(&e, real_of(&r, i), sizeof e);
    }
    TEST_ASSERT_EQUAL_MEMORY(&r.calibration, &c, sizeof c);
}

static void what_is_saved_is_the_record_that_init_makes(void)
{
    const invcal_record golden_one = golden_record();
    invcal_record r;
    invcal_quality q;
    uint8_t expected[SIZE];
    uint8_t bytes[SIZE];
    uint32_t size = 0;

    memset(&q, 0x5A, sizeof q);
    memcpy(q.sigma, golden_one.sigma, sizeof q.sigma);
    q.noise = golden_one.noise;
    q.rms = golden_one.rms;
    q.condition = golden_one.condition;
    q.weak = golden_one.weak;
    q.held = golden_one.held;
    q.positions = golden_one.positions;
    q.verdict = INVCAL_WEAK;
    invcal_record_init(&r, &golden_one.calibration, &q);
    assert_encodes(&r, expected);
    memset(memory, 0xFF, sizeof memory);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_save(&golden_one.calibration, &q, &store));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_load(&store, bytes, sizeof bytes, &size));
    TEST_ASSERT_EQUAL_UINT32(SIZE, size);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(expected, bytes, SIZE);
}

static void a_failure_of_either_side_is_reported_and_changes_nothing(void)
{
    uint8_t other[SIZE + 1] = {0};
    invcal_calibration c;
    uint8_t before[sizeof memory];

    memset(memory, 0xFF, sizeof memory);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, save_golden(INVCAL_GOOD));
    memcpy(before, memory, sizeof memory);
    TEST_ASSERT_EQUAL_INT(INVCAL_DAMAGED, save_golden(INVCAL_WEAK)); /* and no parameter is */
    TEST_ASSERT_EQUAL_MEMORY(before, memory, sizeof memory);
    is_stuck = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_IO, save_golden(INVCAL_GOOD));
    is_stuck = 0;
    TEST_ASSERT_TRUE(is_loaded(INVCAL_OK, &c));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, golden, 20)); /* part of one */
    TEST_ASSERT_TRUE(is_loaded(INVCAL_DAMAGED, &c));
    memcpy(other, golden, SIZE);
    other[1] = 1;
    seal_bytes(other, SIZE - 4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, other, SIZE));
    TEST_ASSERT_TRUE(is_loaded(INVCAL_OTHER_VERSION, &c));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, other, sizeof other));
    TEST_ASSERT_TRUE(is_loaded(INVCAL_NO_SPACE, &c));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_record_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_record);
    RUN_TEST(a_record_comes_back_as_it_was);
    RUN_TEST(reals_at_the_limits_of_float_come_back);
    RUN_TEST(a_new_record_holds_what_is_known_and_marks_the_rest_as_unknown);
    RUN_TEST(bytes_after_a_record_are_ignored);
    RUN_TEST(a_number_that_is_not_finite_is_neither_encoded_nor_decoded);
    RUN_TEST(a_number_beyond_float_is_not_encoded);
    RUN_TEST(a_singular_matrix_is_neither_encoded_nor_decoded);
    RUN_TEST(every_verdict_keeps_its_byte);
    RUN_TEST(a_record_that_contradicts_itself_is_neither_encoded_nor_decoded);
    RUN_TEST(an_unknown_temperature_is_zero);
    RUN_TEST(any_wrong_bit_is_noticed);
    RUN_LONG_TEST(any_four_wrong_bits_are_noticed);
    RUN_SLOW_TEST(any_two_bytes_exchanged_are_noticed);
    RUN_TEST(a_record_without_its_end_is_noticed);
    RUN_TEST(blank_and_random_bytes_are_not_a_record);
    RUN_SLOW_TEST(a_sound_record_of_another_kind_or_version_is_named_so);
    RUN_TEST(a_length_shorter_than_any_record_is_refused);
    RUN_TEST(a_calibration_that_was_saved_is_loaded_and_so_is_its_record);
    RUN_TEST(what_is_saved_is_the_record_that_init_makes);
    RUN_TEST(a_failure_of_either_side_is_reported_and_changes_nothing);
    return UNITY_END() != 0;
}
