/* SPDX-License-Identifier: MIT
 *
 * Sessions that are fed samples, stored, and go on: as bytes, and through a simulated NOR flash
 * that loses power.
 */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/store.h"
#include "support.h"
#include "unity.h"

enum { SIZE = INVCAL_SESSION_SIZE, MOST = INVCAL_MAX_POSITIONS, MARGIN = 64 };
enum { REALS = 13, REALS_AT = 20, MEANS_AT = 72, MEAN = 12 };
enum { NOISE = 12 };
enum { FILL = 0x5A };

/* ---- a device and what happens to it ----------------------------------------------------------- */

enum { PLAIN, TUNED, OVERFULL, KINDS };
enum { SCENES = KINDS * SOME(3), RATE = 8 };

typedef struct {
    int kind;
    uint32_t seed;
    unsigned positions;
    triad_truth truth;
    invcal_calibration nominal;
} scene;

static const double counts = 4096; /* per g */
static const double zero[3] = {130, -70, 20};

static scene make_scene(int kind, uint32_t seed)
{
    random_source random = random_start(seed);
    scene s;

    memset(&s, 0, sizeof s);
    s.kind = kind;
    s.seed = seed;
    s.positions = kind == OVERFULL ? MOST + 4 : 14;
    s.truth = triad_random(&random, 0.02);
    for (unsigned i = 0; i < 3; i++) {
        s.nominal.offset[i] = (invcal_real)zero[i];
        s.nominal.matrix[i][i] = (invcal_real)(1 / counts);
    }
    if (kind == TUNED) { /* as after an earlier calibration */
        s.nominal.offset[2] = (invcal_real)21.3;
        s.nominal.matrix[0][1] = (invcal_real)1.7e-6;
    }
    return s;
}

static invcal_session begin(const scene *s)
{
    invcal_session session;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_begin(&session, &s->nominal, RATE));
    if (s->kind == TUNED) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_noise(&session, (invcal_real)0.0011));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_rails(&session, -32768, 32767 - (int32_t)s->seed));
        invcal_session_hold(&session, 1000 + s->seed);
    }
    return session;
}

static invcal_event feed(invcal_session *session, const scene *s, const double eta[3],
                         random_source *random)
{
    double u[3];
    int32_t raw[3];

    triad_read(&s->truth, eta, u);
    for (unsigned i = 0; i < 3; i++) {
        const double noise = 2 * random_normal(random);
        raw[i] = (int32_t)floor(u[i] * counts + zero[i] + noise + 0.5);
    }
    return invcal_session_feed(session, raw);
}

/* Turns eta by 0.2 rad towards other, which is no noise. */
static void turn(double eta[3], double other[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const double from = eta[i];
        eta[i] = cos(0.2) * from + sin(0.2) * other[i];
        other[i] = cos(0.2) * other[i] - sin(0.2) * from;
    }
}

/* Holds eta, and leaves it. */
static invcal_event hold_once(invcal_session *session, const scene *s, const double up[3],
                              random_source *random)
{
    invcal_event event = INVCAL_NOTHING;
    double eta[3] = {up[0], up[1], up[2]};
    double other[3] = {eta[1], -eta[0], 0};
    const double length = length3(other);

    for (unsigned i = 0; i < 2; i++) {
        other[i] = length > 0 ? other[i] / length : i;
    }
    for (unsigned i = 0; i < 44; i++) {
        (void)feed(session, s, eta, random);
    }
    for (unsigned i = 0; i < 24 && event < INVCAL_TAKEN; i++) {
        turn(eta, other);
        event = feed(session, s, eta, random);
    }
    return event;
}

/* Position n of a scene: the same samples whenever it is taken. Once in some hundred, noise makes
 * a rest no rest; then it is held again, as a person would. */
static void hold(invcal_session *session, const scene *s, unsigned n)
{
    random_source random = random_start(1000 * s->seed + n);
    double eta[3];

    random_direction(&random, eta);
    for (unsigned again = 0; again < 4; again++) {
        if (hold_once(session, s, eta, &random) == INVCAL_TAKEN) {
            return;
        }
    }
    TEST_FAIL_MESSAGE("the position was not taken");
}

static int32_t high_of(const invcal_rests *rests)
{
    return (int32_t)((int64_t)rests->low + rests->between + 1);
}

/* What is not kept: a stream begins. */
static void forget_stream(invcal_session *session)
{
    const invcal_rests old = session->rests;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_rests_init(&session->rests, old.rate));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_rests_rails(&session->rests, old.low, high_of(&old)));
    invcal_rests_hold(&session->rests, session->hold);
}

static invcal_session session_after(const scene *s, unsigned positions)
{
    invcal_session session = begin(s);

    for (unsigned n = 0; n < positions; n++) {
        forget_stream(&session);
        hold(&session, s, n);
    }
    return session;
}

/* ---- the format, written out from the table in store.h ----------------------------------------- */

/* Real number i of a session, in the order of the table. */
static invcal_real *real_of(invcal_session *session, unsigned i)
{
    return i < 3       ? &session->nominal.offset[i]
           : i < NOISE ? &session->nominal.matrix[(i - 3) / 3][(i - 3) % 3]
           : i < REALS ? &session->noise
                       : &session->mean[(i - REALS) / 3][(i - REALS) % 3];
}

static void put(uint8_t **at, uint32_t value, unsigned size)
{
    for (unsigned i = 0; i < size; i++) {
        *(*at)++ = (uint8_t)(value >> 8 * i & 0xFFu);
    }
}

static void put_real(uint8_t **at, invcal_real x)
{
    const float f = (float)x;
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    put(at, bits, 4);
}

static void seal(uint8_t *bytes, uint32_t length)
{
    uint8_t *at = bytes + 2;

    put(&at, length, 2);
    seal_bytes(bytes, length - 4);
}

static uint32_t write_session(invcal_session *s, uint8_t *bytes)
{
    uint8_t *at = bytes;

    put(&at, 0x02C5, 4);
    put(&at, s->count, 2);
    put(&at, s->rests.rate, 2);
    put(&at, s->hold, 4);
    put(&at, (uint32_t)s->rests.low, 4);
    put(&at, (uint32_t)high_of(&s->rests), 4);
    for (unsigned i = 0; i < REALS + 3u * s->count; i++) {
        put_real(&at, *real_of(s, i));
    }
    const uint32_t length = (uint32_t)(at - bytes) + 4;
    seal(bytes, length);
    return length;
}

/* ---- encoding and decoding --------------------------------------------------------------------- */

static uint32_t encode(const invcal_session *session, uint8_t bytes[SIZE])
{
    static uint8_t buffer[SIZE + 2 * MARGIN];
    uint32_t size = 0;

    memset(buffer, FILL, sizeof buffer);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_encode(session, buffer + 1, &size)); /* odd */
    TEST_ASSERT_TRUE(size <= SIZE);
    TEST_ASSERT_EQUAL_HEX8(FILL, buffer[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(FILL, buffer + 1 + size, sizeof buffer - 1 - size);
    memcpy(bytes, buffer + 1, size);
    return size;
}

static invcal_session decode(const uint8_t *bytes, uint32_t size)
{
    uint8_t *exact = malloc(size + 1); /* so that a sanitizer sees a read behind it */
    invcal_session out;

    memcpy(exact + 1, bytes, size);
    memset(&out, FILL, sizeof out);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_decode(exact + 1, size, &out));
    free(exact);
    return out;
}

static int is_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    invcal_session out;
    const uint8_t *byte = (const uint8_t *)&out;

    memset(&out, FILL, sizeof out);
    if (invcal_session_decode(bytes, size, &out) != expected) {
        return 0;
    }
    for (size_t i = 0; i < sizeof out; i++) {
        if (byte[i] != FILL) {
            return 0;
        }
    }
    return 1;
}

static void assert_not_encoded(invcal_status expected, const invcal_session *session)
{
    uint8_t bytes[SIZE];
    uint32_t size;

    TEST_ASSERT_EQUAL_INT(expected, invcal_session_encode(session, bytes, &size));
}

/* How many of the means are readings of the field. */
static unsigned readings_of(const invcal_session *session)
{
    unsigned count = 0;
    invcal_row row;

    for (unsigned i = 0; i < session->count; i++) {
        count += invcal_observe(&session->nominal, session->mean[i], &row) == INVCAL_OK;
    }
    return count;
}

/* All but what it knows of the stream: that is as after its beginning. */
static void assert_same(invcal_session *before, invcal_session *after)
{
    invcal_session fresh = *before;

    TEST_ASSERT_EQUAL_UINT(before->count, after->count);
    for (unsigned i = 0; i < REALS + 3u * before->count; i++) {
        const invcal_real e = (invcal_real)(float)*real_of(before, i);
        TEST_ASSERT_EQUAL_MEMORY(&e, real_of(after, i), sizeof e);
    }
    TEST_ASSERT_EQUAL_UINT32(before->hold, after->hold);
    forget_stream(&fresh);
    TEST_ASSERT_EQUAL_MEMORY(&fresh.rests, &after->rests, sizeof fresh.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcal_session_last(after));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_reason(after));
}

static void assert_same_numbers(const invcal_real *before, const invcal_real *after,
                                unsigned number, double scale)
{
#if INVCAL_DOUBLE
    for (unsigned i = 0; i < number; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-5 * scale, before[i], after[i]);
    }
#else
    (void)scale;
    TEST_ASSERT_EQUAL_MEMORY(before, after, number * sizeof *before);
#endif
}

/* The same result, in float to the bit. Returns 1 if there was one. */
static int assert_same_result(const invcal_session *before, const invcal_session *after)
{
    invcal_calibration c[2];
    invcal_quality q[2];
    const invcal_status status = invcal_session_solve(before, &c[0], &q[0]);

    TEST_ASSERT_EQUAL_INT(status, invcal_session_solve(after, &c[1], &q[1]));
    if (status != INVCAL_OK) {
        return 0;
    }
    assert_same_numbers(c[0].offset, c[1].offset, 3, counts);
    for (unsigned i = 0; i < 3; i++) {
        assert_same_numbers(c[0].matrix[i], c[1].matrix[i], 3, 1 / counts);
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) { /* of a weak one there is more to differ */
        assert_same_numbers(&q[0].sigma[r], &q[1].sigma[r], 1, 1 + (double)q[0].sigma[r]);
    }
    TEST_ASSERT_EQUAL_INT(q[0].verdict, q[1].verdict);
    TEST_ASSERT_TRUE(q[0].left_out == q[1].left_out);
    return 1;
}

/* ---- what is kept ------------------------------------------------------------------------------ */

/* The bytes of the session below, by Python:
 *
 *     import struct, zlib
 *     b = struct.pack('<BBHHHIii19f', 0xC5, 2, 100, 2, 125, 2500, -32768, 32767, *reals, *means)
 *     b += struct.pack('<I', zlib.crc32(b))
 */
enum { GOLDEN = 100 };
static const uint8_t golden[GOLDEN] = {
    0xC5, 0x02, 0x64, 0x00, 0x02, 0x00, 0x7D, 0x00, 0xC4, 0x09, 0x00, 0x00, 0x00, 0x80, 0xFF,
    0xFF, 0xFF, 0x7F, 0x00, 0x00, 0x00, 0x00, 0xC9, 0x42, 0x00, 0x40, 0x48, 0xC3, 0x00, 0x00,
    0x4B, 0x42, 0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x00, 0x3C, 0x00, 0x00, 0x80, 0xBC, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3E, 0x00, 0x00, 0x00, 0x3D, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x80, 0x3A, 0x00, 0x00, 0xCD,
    0x42, 0x00, 0x80, 0x48, 0xC3, 0x00, 0x00, 0x4E, 0x42, 0x00, 0x80, 0xCA, 0x42, 0x00, 0x80,
    0x44, 0xC3, 0x00, 0x00, 0x4A, 0x42, 0xA2, 0xCD, 0x22, 0xFE,
};

static invcal_session golden_session(void)
{
    static const invcal_calibration nominal = {
        {INVCAL_REAL(100.5), INVCAL_REAL(-200.25), INVCAL_REAL(50.75)},
        {{INVCAL_REAL(0.5), INVCAL_REAL(0.0078125), INVCAL_REAL(-0.015625)},
         {0, INVCAL_REAL(0.25), INVCAL_REAL(0.03125)},
         {0, 0, 1}}};
    static const double mean[2][3] = {{102.5, -200.5, 51.5}, {101.25, -196.5, 50.5}};
    invcal_session s;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_begin(&s, &nominal, 125));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_rails(&s, -32768, 32767));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_noise(&s, INVCAL_REAL(0.0009765625)));
    invcal_session_hold(&s, 2500);
    for (unsigned i = 0; i < 6; i++) {
        s.mean[i / 3][i % 3] = (invcal_real)mean[i / 3][i % 3];
    }
    s.count = 2;
    return s;
}

static void a_session_has_the_bytes_of_the_table(void)
{
    const invcal_session s = golden_session();
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_UINT32(GOLDEN, encode(&s, bytes));
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, GOLDEN);
}

static void the_bytes_of_the_table_give_the_session(void)
{
    invcal_session expected = golden_session();
    invcal_session s = decode(golden, GOLDEN);

    assert_same(&expected, &s);
}

static void the_length_depends_on_the_positions(void)
{
    const scene s = make_scene(OVERFULL, 2);
    invcal_session session = begin(&s);
    uint8_t bytes[SIZE];

    for (unsigned n = 0; n <= MOST + 2; n++) {
        const unsigned length = 76 + 12 * (n < MOST ? n : MOST);
        TEST_ASSERT_EQUAL_UINT32(length, encode(&session, bytes));
        TEST_ASSERT_EQUAL_UINT8(length % 256, bytes[2]);
        TEST_ASSERT_EQUAL_UINT8(length / 256, bytes[3]);
        hold(&session, &s, n);
    }
}

/* Sessions of all kinds, empty to complete. */
static void a_session_comes_back_as_it_was(void)
{
    int results = 0;

    for (uint32_t seed = 0; seed < SCENES; seed++) {
        const scene s = make_scene((int)(seed % KINDS), seed);
        invcal_session session = begin(&s);
        for (unsigned n = 0; n <= s.positions; n++) {
            uint8_t bytes[SIZE];
            uint8_t written[SIZE];
            uint8_t again[SIZE];
            const uint32_t size = encode(&session, bytes);
            TEST_ASSERT_EQUAL_UINT32(size, write_session(&session, written));
            TEST_ASSERT_EQUAL_MEMORY(written, bytes, size);
            invcal_session back = decode(bytes, size);
            assert_same(&session, &back);
            results += assert_same_result(&session, &back);
            TEST_ASSERT_EQUAL_INT(invcal_session_is_good(&session), invcal_session_is_good(&back));
            TEST_ASSERT_EQUAL_UINT32(size, encode(&back, again));
            TEST_ASSERT_EQUAL_MEMORY(bytes, again, size);
            if (n < s.positions) {
                hold(&session, &s, n);
            }
        }
        TEST_ASSERT_EQUAL_UINT(s.positions < MOST ? s.positions : MOST, session.count);
        TEST_ASSERT_EQUAL_INT(1, invcal_session_is_good(&session));
    }
    TEST_ASSERT_GREATER_THAN_INT(4 * SCENES, results);
}

/* Twins: only the stream of one is forgotten, the other is stored as well. */
static void a_session_goes_on_as_if_there_had_been_no_reset(void)
{
    for (uint32_t seed = 20; seed < 20 + SCENES; seed++) {
        const scene s = make_scene((int)(seed % KINDS), seed);
        const unsigned resets = s.positions - 2;
        invcal_session session = session_after(&s, resets);
        uint8_t bytes[SIZE];
        invcal_session back = decode(bytes, encode(&session, bytes));
        forget_stream(&session);
        session.last = INVCAL_MOVING;
        for (unsigned n = resets; n < s.positions; n++) {
            invcal_real next[2][3];
            invcal_session_next(&session, next[0]);
            invcal_session_next(&back, next[1]);
            for (unsigned i = 0; i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(0, 1e-5), (double)next[0][i],
                                          (double)next[1][i]);
            }
            hold(&session, &s, n);
            hold(&back, &s, n);
        }
        TEST_ASSERT_EQUAL_UINT(session.count, back.count);
        assert_same_numbers(&session.mean[0][0], &back.mean[0][0], 3u * session.count, counts);
        TEST_ASSERT_EQUAL_INT(1, assert_same_result(&session, &back));
    }
}

/* Also in the worst moment: in the middle of a rest, of which nothing must be left. */
static void a_rest_that_was_going_on_is_forgotten(void)
{
    const scene s = make_scene(PLAIN, 3);
    invcal_session session = session_after(&s, 5);
    random_source random = random_start(9);
    uint8_t bytes[SIZE];
    uint8_t again[SIZE];
    const double eta[3] = {0.6, 0, 0.8};

    const uint32_t size = encode(&session, bytes);
    for (unsigned i = 0; i < 60; i++) {
        (void)feed(&session, &s, eta, &random);
    }
    TEST_ASSERT_EQUAL_UINT(100, invcal_session_progress(&session));
    TEST_ASSERT_EQUAL_UINT32(size, encode(&session, again));
    TEST_ASSERT_EQUAL_MEMORY(bytes, again, size);
    invcal_session back = decode(bytes, size);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcal_session_finish(&back));
    TEST_ASSERT_EQUAL_INT(INVCAL_TAKEN, invcal_session_finish(&session));
}

static void bytes_behind_a_session_are_not_looked_at(void)
{
    uint8_t bytes[GOLDEN + MARGIN];
    invcal_session expected = golden_session();

    for (unsigned fill = 0; fill < 256; fill += 85) {
        memset(bytes, (int)fill, sizeof bytes);
        memcpy(bytes, golden, GOLDEN);
        invcal_session s = decode(bytes, sizeof bytes);
        assert_same(&expected, &s);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_decode(bytes, 0xFFFFFFFFu, &s));
    }
}

static void rails_of_any_kind_come_back(void)
{
    static const int32_t rail[][2] = {
        {-1, 0}, {0, 1}, {INT32_MIN, INT32_MAX}, {INT32_MIN, INT32_MIN + 1}, {-65536, 255}};
    const scene s = make_scene(PLAIN, 6);

    for (unsigned i = 0; i < 5; i++) {
        uint8_t bytes[SIZE];
        invcal_session session = begin(&s);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_rails(&session, rail[i][0], rail[i][1]));
        invcal_session back = decode(bytes, encode(&session, bytes));
        assert_same(&session, &back);
    }
}

/* However long a rest was asked for: what comes back is what was stated, and what holds is the same. */
static void every_rate_and_time_to_hold_comes_back(void)
{
    static const uint32_t milliseconds[] = {0,     1,       599,     600,        601,
                                            65536, 3600000, 3600001, 0xFFFFFFFFu};
    static const unsigned rate[] = {8, 9, 12, 100, 1000, 7999, 8000};
    const scene s = make_scene(PLAIN, 6);

    for (unsigned i = 0; i < 7; i++) {
        for (unsigned k = 0; k < 9; k++) {
            uint8_t bytes[SIZE];
            invcal_session session;
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_begin(&session, &s.nominal, rate[i]));
            invcal_session_hold(&session, milliseconds[k]);
            invcal_session back = decode(bytes, encode(&session, bytes));
            TEST_ASSERT_EQUAL_UINT32(milliseconds[k], back.hold);
            assert_same(&session, &back);
        }
    }
}

/* ---- what is refused --------------------------------------------------------------------------- */

/* In the order of the table: nominal, noise, means. */
static invcal_status status_of_bad_real(unsigned i)
{
    return i < NOISE ? INVCAL_BAD_NOMINAL : i < REALS ? INVCAL_BAD_NOISE : INVCAL_NOT_FINITE;
}

static void a_number_that_is_not_finite_is_not_encoded(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned k = 0; k < 3; k++) {
        for (unsigned i = 0; i < REALS + 6; i++) {
            invcal_session session = golden_session();
            *real_of(&session, i) = (invcal_real)bad[k];
            assert_not_encoded(status_of_bad_real(i), &session);
        }
    }
}

static void a_number_that_leaves_its_range_as_a_float_is_not_encoded(void)
{
#if INVCAL_DOUBLE
    invcal_session session = golden_session();
    session.mean[1][2] = 1e39;
    assert_not_encoded(INVCAL_NOT_FINITE, &session);
    session = golden_session();
    session.noise = 1 - 1e-9;
    assert_not_encoded(INVCAL_BAD_NOISE, &session);
    session = golden_session();
    session.nominal.matrix[1][0] = session.nominal.matrix[0][0];
    session.nominal.matrix[1][1] =
        session.nominal.matrix[0][1] * (1 + 1e-9); /* singular as floats */
    session.nominal.matrix[1][2] = session.nominal.matrix[0][2];
    assert_not_encoded(INVCAL_BAD_NOMINAL, &session);
    session = golden_session(); /* of numbers that are floats; ten fields are none */
    memset(&session.nominal, 0, sizeof session.nominal);
    for (unsigned i = 0; i < 3; i++) {
        session.nominal.offset[i] = 3.0 / 4096;
        session.nominal.matrix[i][i] = 1.0 / 1256;
        session.mean[0][i] = 3.0 / 4096 + (i == 2 ? 12560 - 1e-7 : 0);
    }
    session.count = 1;
    TEST_ASSERT_EQUAL_UINT(1, readings_of(&session));
    TEST_ASSERT_TRUE((double)(float)session.mean[0][2] > 12560 + 3.0 / 4096);
    assert_not_encoded(INVCAL_OUT_OF_RANGE, &session);
#else
    TEST_ASSERT_TRUE(INVCAL_REAL_MAX <= FLT_MAX); /* there is none */
#endif
}

static void a_session_that_was_never_begun_is_not_encoded(void)
{
    invcal_session session;

    memset(&session, 0, sizeof session);
    assert_not_encoded(INVCAL_BAD_NOMINAL, &session);
}

static void a_mean_that_is_no_reading_is_neither_encoded_nor_decoded(void)
{
    static const double bad[][3] = {{100.5, -200.25, 50.75}, {9e9, 0, 0}, {100.5, -200.25, 50.84}};

    for (unsigned k = 0; k < 3; k++) {
        for (unsigned i = 0; i < 2; i++) {
            invcal_session session = golden_session();
            uint8_t bytes[SIZE];
            for (unsigned j = 0; j < 3; j++) {
                session.mean[i][j] = (invcal_real)bad[k][j];
            }
            assert_not_encoded(INVCAL_OUT_OF_RANGE, &session);
            TEST_ASSERT_TRUE(
                is_refused(INVCAL_OUT_OF_RANGE, bytes, write_session(&session, bytes)));
        }
    }
}

static void a_number_that_is_not_finite_is_not_decoded(void)
{
    static const uint32_t bits[] = {0x7FC00000, 0xFF800001, 0x7F800000, 0xFF800000};
    const scene s = make_scene(OVERFULL, 9);
    const invcal_session overfull = session_after(&s, MOST + 1);
    uint8_t bytes[SIZE];
    uint8_t sound[SIZE];
    const uint32_t size = encode(&overfull, sound);

    for (unsigned i = 0; i < REALS + 3 * MOST; i++) {
        for (unsigned k = 0; k < 4; k++) {
            uint8_t *number = bytes + REALS_AT + 4 * i;
            memcpy(bytes, sound, size);
            put(&number, bits[k], 4);
            seal(bytes, size);
            TEST_ASSERT_TRUE(is_refused(status_of_bad_real(i), bytes, size));
        }
    }
}

/* Field by field: where, how many bytes, and what must not stand there. */
static void contents_that_no_session_has_are_refused(void)
{
    static const struct {
        uint32_t at;
        unsigned size;
        uint32_t value;
        invcal_status status;
    } bad[] = {
        {4, 2, 1, INVCAL_DAMAGED}, /* a count that the length does not bear out */
        {4, 2, 3, INVCAL_DAMAGED},
        {4, 2, 0, INVCAL_DAMAGED},
        {4, 2, 0xFFFF, INVCAL_DAMAGED},
        {5, 1, 0x80, INVCAL_DAMAGED},
        {6, 2, 0, INVCAL_BAD_RATE},
        {6, 2, 7, INVCAL_BAD_RATE},
        {6, 2, 8001, INVCAL_BAD_RATE},
        {6, 2, 0xFFFF, INVCAL_BAD_RATE},
        {12, 4, 32767, INVCAL_BAD_RAILS},
        {12, 4, 0x7FFFFFFF, INVCAL_BAD_RAILS},
        {16, 4, 0x80000000, INVCAL_BAD_RAILS},
        {16, 4, 0xFFFF8000, INVCAL_BAD_RAILS},
        {48, 4, 0, INVCAL_BAD_NOMINAL}, /* a matrix without its middle; the readings remain some */
        {68, 4, 0xBA800000, INVCAL_BAD_NOISE},
        {68, 4, 0x3F800000, INVCAL_BAD_NOISE},
        {72, 4, 0x50000000, INVCAL_OUT_OF_RANGE},
    };

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        uint8_t bytes[GOLDEN];
        uint8_t *at = bytes + bad[i].at;
        memcpy(bytes, golden, GOLDEN);
        put(&at, bad[i].value, bad[i].size);
        seal(bytes, GOLDEN);
        TEST_ASSERT_TRUE_MESSAGE(is_refused(bad[i].status, bytes, GOLDEN), "not refused");
    }
}

/* Returns the length. The golden session with another size of its table. */
static uint32_t with_table(unsigned count, uint8_t *bytes)
{
    uint8_t *at = bytes + 4;
    const uint32_t length = 76 + MEAN * count;

    memcpy(bytes, golden, MEANS_AT);
    put(&at, count, 2);
    for (unsigned i = 0; i < count; i++) {
        memcpy(bytes + MEANS_AT + MEAN * i, golden + MEANS_AT, MEAN);
    }
    seal(bytes, length);
    return length;
}

static void a_table_larger_than_that_of_this_build_has_no_space(void)
{
    static uint8_t bytes[ROOM(65535, 2400)];

    for (unsigned count = 0; count < ROOM(5000u, 150u); count += count < 80 ? 1 : 100) {
        const uint32_t length = with_table(count, bytes);
        if (count > MOST) {
            TEST_ASSERT_TRUE(is_refused(INVCAL_NO_SPACE, bytes, length));
        } else {
            TEST_ASSERT_EQUAL_UINT(count, decode(bytes, length).count);
        }
    }
}

static void any_wrong_bit_is_noticed(void)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const scene s = make_scene(kind, 11);
        const invcal_session session = session_after(&s, s.positions);
        uint8_t bytes[SIZE];
        const uint32_t size = encode(&session, bytes);
        for (uint32_t bit = 0; bit < 8 * size; bit++) {
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, size));
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
    }
}

static void a_session_without_its_end_is_noticed(void)
{
    const scene s = make_scene(PLAIN, 12);
    const invcal_session session = session_after(&s, s.positions);
    uint8_t bytes[SIZE];
    const uint32_t whole = encode(&session, bytes);

    for (uint32_t size = 0; size < whole; size++) {
        uint8_t *exact = malloc(size + 1); /* so that a sanitizer sees a read behind it */
        memcpy(exact + 1, bytes, size);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, exact + 1, size));
        free(exact);
    }
}

/* Nor is one that was sealed again: the length must be that of the content. */
static void a_length_that_is_not_that_of_the_content_is_refused(void)
{
    uint8_t bytes[GOLDEN + 300];

    for (uint32_t length = 8; length <= sizeof bytes; length++) {
        memset(bytes, 0, sizeof bytes);
        memcpy(bytes, golden, GOLDEN);
        seal(bytes, length);
        if (length != GOLDEN) {
            uint8_t *exact = malloc(length);
            memcpy(exact, bytes, length);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, exact, length));
            free(exact);
        }
    }
    for (uint8_t length = 0; length < 8; length++) {
        uint8_t tiny[8] = {0xC5, 2, 0, 0, 0, 0, 0, 0};
        tiny[2] = length;
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, tiny, 8));
    }
}

static void sound_bytes_of_another_kind_or_version_are_named_so(void)
{
    static const uint16_t lengths[] = {8, 9, 75, 76, GOLDEN, 140};

    for (unsigned k = 0; k < 6; k++) {
        for (unsigned at = 0; at < 2; at++) {
            for (unsigned value = 0; value < 256; value++) {
                uint8_t bytes[GOLDEN + MARGIN] = {0};
                memcpy(bytes, golden, GOLDEN);
                bytes[at] = (uint8_t)value;
                seal(bytes, lengths[k]);
                if (value != golden[at]) {
                    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, bytes, lengths[k]));
                }
                TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, lengths[k] - 1u));
            }
        }
    }
}

static void a_record_is_no_session_and_a_session_no_record(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    memset(&record, 0, sizeof record);
    record.calibration = golden_session().nominal;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_record_encode(&record, bytes));
    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_VERSION, invcal_record_decode(golden, GOLDEN, &record));
}

/* What is accepted can be fed, solved, guided, and gives the same bytes again. */
static void random_contents_with_a_right_crc_do_no_harm(void)
{
    const scene s = make_scene(TUNED, 13);
    const invcal_session session = session_after(&s, 12);
    random_source random = random_start(3);
    uint8_t sound[SIZE];
    const uint32_t size = encode(&session, sound);
    unsigned accepted = 0;

    for (unsigned k = 0; k < 20000; k++) {
        uint8_t bytes[SIZE];
        uint8_t again[SIZE];
        invcal_session out;
        invcal_calibration calibration;
        invcal_quality quality;
        invcal_real next[3];
        const int32_t raw[3] = {1, -2, 3};
        memcpy(bytes, sound, size);
        for (unsigned i = 0; i < 1 + k % 3; i++) {
            const uint32_t at = (uint32_t)random_uniform(&random, 4, k % 2 ? 24 : size - 4.0);
            bytes[at] = (uint8_t)random_uniform(&random, 0, 256);
        }
        seal(bytes, size);
        memset(&out, 0, sizeof out);
        if (invcal_session_decode(bytes, size, &out) == INVCAL_OK) {
            accepted++;
            TEST_ASSERT_EQUAL_UINT(out.count, readings_of(&out));
            (void)invcal_session_solve(&out, &calibration, &quality);
            invcal_session_next(&out, next);
            (void)invcal_session_feed(&out, raw);
            TEST_ASSERT_EQUAL_UINT32(size, encode(&out, again));
            TEST_ASSERT_EQUAL_MEMORY(bytes, again, size);
        }
    }
    TEST_ASSERT_TRUE(accepted > 1000 && accepted < 19000);
}

/* ---- a memory that loses power ------------------------------------------------------------------ */

enum { SLOT = SIZE + 100 };
#define NEVER 1000000L

static struct {
    uint8_t bytes[2][SLOT];
    uint8_t used[2][SLOT]; /* programmed since it was erased */
} flash;

static invcal_store store; /* its driver */
static random_source chance;
static long steps; /* that are still done before power fails within one */
static long power; /* bytes likewise */
static int dead;
static int rules_broken;

/* How many of all bytes are done before power fails. */
static uint32_t done_of(uint32_t all)
{
    uint32_t done = all;

    if (steps-- == 0) {
        done = (uint32_t)random_uniform(&chance, 0, all);
    }
    if (power < (int)done) {
        done = (uint32_t)power;
    }
    power -= (int)done;
    dead = done < all;
    return done;
}

static int flash_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    rules_broken += slot > 1 || size > 32 || offset + size > SLOT;
    if (dead || rules_broken) {
        return 1;
    }
    memcpy(bytes, &flash.bytes[slot][offset], size);
    return 0;
}

static int flash_erase(void *context, unsigned slot)
{
    (void)context;
    rules_broken += slot > 1;
    if (dead || rules_broken) {
        return 1;
    }
    const uint32_t done = done_of(SLOT);
    const uint32_t from = steps % 2 ? 0 : SLOT - done; /* from either end */
    memset(&flash.bytes[slot][from], 0xFF, done);
    if (!dead) {
        memset(flash.used[slot], 0, SLOT);
    }
    return dead;
}

static int flash_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context;
    rules_broken +=
        slot > 1 || size > 32 || offset + size > SLOT || (offset | size) % store.granularity != 0;
    if (dead || rules_broken) {
        return 1;
    }
    const uint32_t done = done_of(size);
    for (uint32_t i = 0; i < size; i++) {
        uint8_t *byte = &flash.bytes[slot][offset + i];
        const uint8_t any = (uint8_t)random_uniform(&chance, 0, 256);
        rules_broken += flash.used[slot][offset + i] && i < done;
        flash.used[slot][offset + i] = i <= done;
        *byte = (uint8_t)(*byte & (i < done ? bytes[i] : i == done ? bytes[i] | any : 0xFFu));
    }
    return dead;
}

static void power_up(void)
{
    dead = 0;
    steps = NEVER;
    power = NEVER;
}

static void new_flash(uint32_t granularity)
{
    memset(&flash, 0, sizeof flash);
    memset(flash.bytes, 0xFF, sizeof flash.bytes);
    store = (invcal_store){flash_read, flash_erase, flash_program, NULL, SLOT, granularity};
    power_up();
}

void setUp(void)
{
    chance = random_start(77);
    rules_broken = 0;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, rules_broken, "a rule of the memory was broken");
}

/* The life of a session that is reset after each position: its bytes before the first, after the
 * first, and so on. */
enum { LONGEST = ROOM(MOST + 4, 1) }; /* positions of any scene; or one */
typedef struct {
    scene scene;
    uint32_t size[LONGEST + 1];
    uint8_t bytes[LONGEST + 1][SIZE];
} life;

static life lived;

static void live(int kind, uint32_t seed)
{
    lived.scene = make_scene(kind, seed);
    invcal_session session = begin(&lived.scene);

    for (unsigned n = 0; n <= lived.scene.positions && n <= LONGEST; n++) {
        lived.size[n] = encode(&session, lived.bytes[n]);
        session = decode(lived.bytes[n], lived.size[n]);
        if (n < lived.scene.positions) {
            hold(&session, &lived.scene, n);
        }
    }
}

static int save(unsigned n)
{
    const invcal_session session = decode(lived.bytes[n], lived.size[n]);

    return invcal_save_session(&store, &session) == INVCAL_OK;
}

/* Loads what must be state n or n + 1. Returns which, and the session. */
static unsigned load(unsigned n, invcal_session *session)
{
    static uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_load_session(&store, session));
    const uint32_t size = encode(session, bytes);
    const int is_new = size == lived.size[n + 1] && memcmp(bytes, lived.bytes[n + 1], size) == 0;
    if (!is_new) {
        TEST_ASSERT_EQUAL_UINT32(lived.size[n], size);
        TEST_ASSERT_EQUAL_MEMORY(lived.bytes[n], bytes, size);
    }
    return n + (is_new ? 1u : 0u);
}

/* Position n, and the state must be the one that was lived. */
static void go_on(invcal_session *session, unsigned n)
{
    static uint8_t bytes[SIZE];

    hold(session, &lived.scene, n);
    TEST_ASSERT_EQUAL_UINT32(lived.size[n + 1], encode(session, bytes));
    TEST_ASSERT_EQUAL_MEMORY(lived.bytes[n + 1], bytes, lived.size[n + 1]);
}

/* To the end, saved after each position. The last state is the one that was lived: as many
 * positions, the same calibration. */
static void finish_life(invcal_session *session, unsigned n)
{
    for (; n < lived.scene.positions; n++) {
        go_on(session, n);
        TEST_ASSERT_TRUE(save(n + 1));
        TEST_ASSERT_EQUAL_UINT(n + 1, load(n, session));
    }
}

/* The save of state n + 1 is cut; then the session goes on, and its next save is cut too.
 * Returns 1 if the first was not cut, having come to its end. */
static int cut_and_go_on(unsigned n, int to_the_end, int found[2])
{
    static invcal_session session;

    const int saved = save(n + 1);
    power_up();
    unsigned which = load(n, &session);
    found[which - n]++;
    TEST_ASSERT_TRUE(which == n + 1 || !saved);
    if (which == lived.scene.positions) {
        return saved;
    }
    go_on(&session, which);
    steps = (int)random_uniform(&chance, 0, 40);
    (void)save(which + 1);
    power_up();
    which = load(which, &session);
    if (to_the_end) {
        finish_life(&session, which);
    }
    return saved;
}

/* Every save of a life is cut: in steps, or in bytes, until it is not cut any more. */
static void cut_everywhere(int by_bytes, int found[2])
{
    static uint8_t before[sizeof flash];

    if (lived.scene.positions > LONGEST) {
        skip_large();
    }
    TEST_ASSERT_TRUE(save(0));
    for (unsigned n = 0; n < lived.scene.positions; n++) {
        int saved = 0;
        memcpy(before, &flash, sizeof flash);
        for (int cut = 0; !saved; cut++) {
            steps = by_bytes ? NEVER : cut;
            power = by_bytes ? cut : NEVER;
            saved = cut_and_go_on(n, n % 8 == lived.scene.seed % 8 && cut % 16 == 3, found);
            memcpy(&flash, before, sizeof flash);
        }
        TEST_ASSERT_TRUE(save(n + 1));
    }
}

/* 100 sessions, each save cut within each erasure and each programming. */
static void a_power_cut_in_any_step_of_a_save_loses_no_position(void)
{
    static const uint32_t granularities[] = {8, 1, 4, 32};
    int found[2] = {0, 0};
    unsigned taken = 0;

    for (uint32_t seed = 0; seed < 100; seed++) {
        live(seed % 25 == 24 ? OVERFULL : (int)(seed % 2), 100 + seed);
        const unsigned end = lived.scene.positions;
        const invcal_session never = session_after(&lived.scene, end);
        const invcal_session last = decode(lived.bytes[end], lived.size[end]);
        TEST_ASSERT_EQUAL_UINT(never.count, last.count);
        assert_same_result(&never, &last);
        taken += last.count;
        new_flash(granularities[seed / 3 % 4]);
        cut_everywhere(0, found);
    }
    TEST_ASSERT_TRUE(taken > 1000 && found[0] > (int)(6 * taken) && found[1] > (int)taken);
}

static void a_power_cut_at_any_byte_of_a_save_loses_no_position(void)
{
    int found[2] = {0, 0};

    live(PLAIN, 300);
    new_flash(8);
    cut_everywhere(1, found);
    TEST_ASSERT_TRUE(found[0] > 14 * SLOT && found[1] >= 14);
}

/* Nothing is there yet: what is found is nothing, or the session that was begun. */
static void a_power_cut_in_the_first_save_leaves_nothing_or_the_session(void)
{
    const int step = 1 + TEST_SHORT / 16;
    unsigned none = 0;

    live(PLAIN, 301);
    for (int cut = 0; cut < SLOT + SIZE; cut += step) {
        invcal_session session;
        new_flash(4);
        power = cut;
        (void)save(0);
        power_up();
        const invcal_status status = invcal_load_session(&store, &session);
        none += status == INVCAL_NO_RECORD;
        if (status != INVCAL_NO_RECORD) {
            TEST_ASSERT_EQUAL_UINT(0, load(0, &session));
        }
        TEST_ASSERT_TRUE(save(1));
        TEST_ASSERT_EQUAL_UINT(1, load(0, &session));
    }
    TEST_ASSERT_GREATER_THAN_UINT((unsigned)(SLOT / step), none);
}

/* And whatever stands there instead: a running session stays as it is. */
static void a_session_that_cannot_be_loaded_leaves_the_present_one_as_it_was(void)
{
    static const uint8_t large[SIZE + 1] = {0xC5};
    static const struct {
        const uint8_t *bytes;
        uint32_t size;
        invcal_status status;
    } stored[] = {{NULL, 0, INVCAL_NO_RECORD},
                  {large, SIZE, INVCAL_DAMAGED},
                  {large, SIZE + 1, INVCAL_NO_SPACE}};
    const invcal_session before = golden_session();

    new_flash(8);
    for (unsigned i = 0; i < 3; i++) {
        invcal_session session;
        memcpy(&session, &before, sizeof session);
        if (stored[i].size > 0) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                                  invcal_store_save(&store, stored[i].bytes, stored[i].size));
        }
        TEST_ASSERT_EQUAL_INT(stored[i].status, invcal_load_session(&store, &session));
        TEST_ASSERT_EQUAL_MEMORY(&before, &session, sizeof session);
    }
    invcal_session bad = before;
    bad.mean[1][0] = (invcal_real)9e9;
    const invcal_store blind = store;
    store.granularity = 3;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_save_session(&blind, &bad));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_STORE, invcal_save_session(&store, &before));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_session_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_session);
    RUN_SLOW_TEST(the_length_depends_on_the_positions);
    RUN_SLOW_TEST(a_session_comes_back_as_it_was);
    RUN_TEST(a_session_goes_on_as_if_there_had_been_no_reset);
    RUN_TEST(a_rest_that_was_going_on_is_forgotten);
    RUN_TEST(bytes_behind_a_session_are_not_looked_at);
    RUN_TEST(rails_of_any_kind_come_back);
    RUN_TEST(every_rate_and_time_to_hold_comes_back);
    RUN_TEST(a_number_that_is_not_finite_is_not_encoded);
    RUN_TEST(a_number_that_leaves_its_range_as_a_float_is_not_encoded);
    RUN_TEST(a_session_that_was_never_begun_is_not_encoded);
    RUN_TEST(a_mean_that_is_no_reading_is_neither_encoded_nor_decoded);
    RUN_SLOW_TEST(a_number_that_is_not_finite_is_not_decoded);
    RUN_TEST(contents_that_no_session_has_are_refused);
    RUN_SLOW_TEST(a_table_larger_than_that_of_this_build_has_no_space);
    RUN_SLOW_TEST(any_wrong_bit_is_noticed);
    RUN_TEST(a_session_without_its_end_is_noticed);
    RUN_TEST(a_length_that_is_not_that_of_the_content_is_refused);
    RUN_SLOW_TEST(sound_bytes_of_another_kind_or_version_are_named_so);
    RUN_TEST(a_record_is_no_session_and_a_session_no_record);
    RUN_LONG_TEST(random_contents_with_a_right_crc_do_no_harm);
    RUN_LONG_TEST(a_power_cut_in_any_step_of_a_save_loses_no_position);
    RUN_LONG_TEST(a_power_cut_at_any_byte_of_a_save_loses_no_position);
    RUN_TEST(a_power_cut_in_the_first_save_leaves_nothing_or_the_session);
    RUN_TEST(a_session_that_cannot_be_loaded_leaves_the_present_one_as_it_was);
    return UNITY_END() != 0;
}
