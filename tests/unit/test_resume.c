/* SPDX-License-Identifier: MIT
 *
 * Sessions that are fed samples, stored, and go on: as bytes, and through a simulated NOR flash
 * that loses power.
 */
#include <stdlib.h>
#include <string.h>

#include "invcal/resume.h"
#include "invcal/store.h"
#include "support.h"
#include "unity.h"

enum { SIZE = INVCAL_RESUME_SIZE, MOST = INVCAL_MAX_POSITIONS, MARGIN = 64 };
enum { REALS = 35, SUMS = INVCAL_MOMENTS + 10, REALS_AT = 24, TABLE_AT = 164, POSITION = 13 };
enum { MATRIX = 3, FIELD = 12, NOISE, PRIOR, START = 23, TARGET = 26, RATE = 29, TEMPERATURE };
enum { COLDEST = TEMPERATURE + 1, WARMEST, MEAN_SIGMA, HOLD };
enum { FILL = 0x5A };

/* ---- a device and what happens to it ----------------------------------------------------------- */

enum { PROGRAM, FREE_HAND, BACKGROUND, OVERFULL, KINDS };
enum { SCENES = KINDS * SOME(3) };

typedef struct {
    int kind;
    uint32_t seed;
    unsigned actions; /* positions, or days of a background session */
    triad_truth truth;
    invcal_session_setup setup;
} scene;

static const double counts = 417.5; /* per m/s^2 */
static const double zero[3] = {130, -70, 20};

static scene make_scene(int kind, uint32_t seed)
{
    static const unsigned actions[KINDS] = {15, 14, 24, MOST + 4};
    random_source random = random_start(seed);
    scene s;

    memset(&s, 0, sizeof s);
    s.kind = kind;
    s.seed = seed;
    s.actions = actions[kind];
    s.truth = triad_random(&random, 0.02);
    s.setup.settings = unit_settings(0.004);
    s.setup.settings.field = INVCAL_REAL(9.80665);
    s.setup.settings.frame = seed % 2 ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
    for (unsigned i = 0; i < 3; i++) {
        s.setup.settings.nominal.offset[i] = (invcal_real)zero[i];
        s.setup.settings.nominal.matrix[i][i] = (invcal_real)(1 / counts);
        s.setup.target[i] = (invcal_real)(kind == FREE_HAND ? 0.002 * (i + 1) : 0);
    }
    for (unsigned r = 0; kind == BACKGROUND && r < INVCAL_PARAMETERS; r++) {
        s.setup.settings.prior[r] = (invcal_real)(0.02 + 0.001 * r);
    }
    if (kind == PROGRAM) {
        s.setup.plan.per_group = 5;
        (void)invcal_plan_starts(5, s.setup.plan.start);
    }
    s.setup.rate = INVCAL_REAL(8.1);
    s.setup.low = -32768;
    s.setup.high = 32767 - (int32_t)seed;
    s.setup.background = kind == BACKGROUND;
    return s;
}

static invcal_session begin(const scene *s)
{
    invcal_session session;

    memset(&session, 0, sizeof session);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&session, &s->setup));
    return session;
}

static invcal_session_what feed(invcal_session *session, const scene *s, const double eta[3],
                                random_source *random, invcal_event *event)
{
    double u[3];
    int32_t raw[3];

    triad_read(&s->truth, eta, u);
    for (unsigned i = 0; i < 3; i++) {
        const double noise = 2 * random_normal(random);
        raw[i] = (int32_t)floor(u[i] * 9.80665 * counts + zero[i] + noise + 0.5);
    }
    const double celsius = 20 + 5 * sin(s->seed + 0.7 * session->normal.count);
    return invcal_session_feed(session, raw, (invcal_real)celsius, event);
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
static invcal_session_what hold_once(invcal_session *session, const scene *s, const double up[3],
                                     random_source *random)
{
    invcal_session_what what = INVCAL_SESSION_NOTHING;
    invcal_event event;
    double eta[3] = {up[0], up[1], up[2]};
    double other[3] = {eta[1], -eta[0], 0};
    const double length = length3(other);

    for (unsigned i = 0; i < 2; i++) {
        other[i] = length > 0 ? other[i] / length : i;
    }
    for (unsigned i = 0; i < 44; i++) {
        (void)feed(session, s, eta, random, &event);
    }
    for (unsigned i = 0; i < 24 && what < INVCAL_SESSION_TAKEN; i++) {
        turn(eta, other);
        what = feed(session, s, eta, random, &event);
    }
    return what;
}

/* Position n of a scene: the same samples whenever it is taken. Once in some hundred, noise makes
 * a rest no rest; then it is held again, as a person would. */
static invcal_session_what hold(invcal_session *session, const scene *s, unsigned n)
{
    random_source random = random_start(1000 * s->seed + n);
    invcal_plan_position position;
    double eta[3];

    random_direction(&random, eta);
    if (s->kind == PROGRAM) {
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_plan_position_at(&session->setup.plan, session->step, &position));
        for (unsigned i = 0; i < 3; i++) {
            eta[i] = (double)position.vertical[i];
        }
    }
    for (unsigned again = 0; again < 4; again++) {
        const invcal_session_what what = hold_once(session, s, eta, &random);
        if (what >= INVCAL_SESSION_TAKEN && what != INVCAL_SESSION_REFUSED) {
            return what;
        }
    }
    TEST_FAIL_MESSAGE("the position was not taken");
    return INVCAL_SESSION_NOTHING;
}

/* What is not kept: a stream begins. */
static void forget_stream(invcal_session *session)
{
    const invcal_session_setup *setup = &session->setup;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_still_init(&session->still, setup->rate, setup->low, setup->high));
}

/* Action n of a scene: a position; in the background every fourth is a day that goes by. */
static void act(invcal_session *session, const scene *s, unsigned n)
{
    if (s->kind == BACKGROUND && n % 4 == 3) {
        invcal_session_age(session);
    } else {
        (void)hold(session, s, n);
    }
}

static invcal_session session_after(const scene *s, unsigned actions)
{
    invcal_session session = begin(s);

    for (unsigned n = 0; n < actions; n++) {
        forget_stream(&session);
        act(&session, s, n);
    }
    return session;
}

/* ---- the format, written out from the table in resume.h ---------------------------------------- */

/* Real number i of a session, in the order of the table. */
static invcal_real *real_of(invcal_session *session, unsigned i)
{
    invcal_session_setup *setup = &session->setup;
    invcal_calibration *nominal = &setup->settings.nominal;
    invcal_real *const single[] = {&setup->rate,      &session->temperature, &session->coldest,
                                   &session->warmest, &setup->mean_sigma,    &session->hold};

    return i < MATRIX   ? &nominal->offset[i]
           : i < FIELD  ? &nominal->matrix[(i - MATRIX) / 3][(i - MATRIX) % 3]
           : i == FIELD ? &setup->settings.field
           : i == NOISE ? &setup->settings.noise
           : i < START  ? &setup->settings.prior[i - PRIOR]
           : i < TARGET ? &setup->plan.start[i - START]
           : i < RATE   ? &setup->target[i - TARGET]
                        : single[i - RATE];
}

static invcal_real *sum_of(invcal_session *session, unsigned i)
{
    return i < INVCAL_MOMENTS       ? &session->normal.moment[i]
           : i < INVCAL_MOMENTS + 9 ? &session->normal.htj[i - INVCAL_MOMENTS]
                                    : &session->normal.jtj;
}

static uint32_t crc_of(const uint8_t *bytes, uint32_t count) /* by polynomial division */
{
    uint32_t rest = 0xFFFFFFFFu;
    uint32_t reflected = 0;

    for (uint32_t i = 0; i < 8 * count; i++) {
        const uint32_t bit = (uint32_t)bytes[i / 8] >> i % 8 & 1u;
        const uint32_t out = rest >> 31 ^ bit;
        rest = rest << 1 ^ (out ? 0x04C11DB7u : 0);
    }
    for (unsigned i = 0; i < 32; i++) {
        reflected |= (rest >> i & 1u) << (31 - i);
    }
    return ~reflected;
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
    at = bytes + length - 4;
    put(&at, crc_of(bytes, length - 4), 4);
}

static uint32_t write_session(invcal_session *s, uint8_t *bytes)
{
    uint8_t *at = bytes;

    put(&at, 0x01C5, 4);
    put(&at, s->stored, 2);
    put(&at, s->step, 2);
    put(&at, s->normal.count, 4);
    put(&at, s->setup.plan.per_group, 2);
    put(&at, (uint32_t)s->setup.settings.frame, 1);
    put(&at, (s->setup.background ? 1u : 0u) + (s->is_enough ? 2u : 0u), 1);
    put(&at, (uint32_t)s->setup.low, 4);
    put(&at, (uint32_t)s->setup.high, 4);
    for (unsigned i = 0; i < REALS; i++) {
        const int is_angle = i >= START && i < START + 3;
        put_real(&at, is_angle && s->setup.plan.per_group == 0 ? 0 : *real_of(s, i));
    }
    for (unsigned i = 0; i < s->stored; i++) {
        for (unsigned k = 0; k < 3; k++) {
            put_real(&at, s->mean[i][k]);
        }
        put(&at, s->age[i], 1);
    }
    for (unsigned i = 0; s->normal.count > s->stored && i < SUMS; i++) {
        put_real(&at, *sum_of(s, i));
    }
    const uint32_t length = (uint32_t)(at - bytes) + 4;
    seal(bytes, length);
    return length;
}

/* ---- encoding and decoding --------------------------------------------------------------------- */

static uint32_t encode(const invcal_session *session, uint8_t bytes[SIZE])
{
    static uint8_t room[SIZE + 2 * MARGIN];
    uint32_t size = 0;

    memset(room, FILL, sizeof room);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_resume_encode(session, room + 1, &size)); /* odd */
    TEST_ASSERT_TRUE(size <= SIZE);
    TEST_ASSERT_EQUAL_HEX8(FILL, room[0]);
    TEST_ASSERT_EACH_EQUAL_HEX8(FILL, room + 1 + size, sizeof room - 1 - size);
    memcpy(bytes, room + 1, size);
    return size;
}

static invcal_session decode(const uint8_t *bytes, uint32_t size)
{
    uint8_t *exact = malloc(size + 1); /* so that a sanitizer sees a read behind it */
    invcal_session out;

    memcpy(exact + 1, bytes, size);
    memset(&out, FILL, sizeof out);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_resume_decode(exact + 1, size, &out));
    free(exact);
    return out;
}

static int is_refused(invcal_status expected, const uint8_t *bytes, uint32_t size)
{
    invcal_session out;
    const uint8_t *byte = (const uint8_t *)&out;

    memset(&out, FILL, sizeof out);
    if (invcal_resume_decode(bytes, size, &out) != expected) {
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
    uint32_t size = 0xABCDEF;

    memset(bytes, FILL, SIZE);
    TEST_ASSERT_EQUAL_INT(expected, invcal_resume_encode(session, bytes, &size));
    TEST_ASSERT_EACH_EQUAL_HEX8(FILL, bytes, SIZE);
    TEST_ASSERT_EQUAL_HEX32(0xABCDEF, size);
}

static void assert_float_of(invcal_real expected, invcal_real actual)
{
    const invcal_real e = (invcal_real)(float)expected;

    TEST_ASSERT_EQUAL_MEMORY(&e, &actual, sizeof e);
}

/* The sums that belong to the means and ages of a session. */
static invcal_normal sums_of_table(const invcal_session *s)
{
    invcal_normal normal;
    invcal_observation row;
    invcal_real u[3];

    invcal_normal_init(&normal);
    for (unsigned i = 0; i < s->stored; i++) {
        invcal_real weight = 1;
        for (unsigned day = 0; day < s->age[i]; day++) {
            weight *= INVCAL_REAL(0.96875); /* 31/32 of the day before */
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_observation_reading(&s->setup.settings.nominal,
                                                         s->setup.settings.field, s->mean[i], u));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(u, &row));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&normal, &row, weight));
    }
    return normal;
}

/* In float to the bit. In double each to that of a float, sums that are made again to that of the
 * means, and, more strictly, to what belongs to the means as they came back. */
static void assert_same_sums(invcal_session *before, invcal_session *after)
{
    const int made_again = before->normal.count == before->stored;
    const double error = FLOAT_OR_DOUBLE(0, 5e-7) * (before->normal.count + 1.0);

    for (unsigned i = 0; i < SUMS; i++) {
        if (made_again) {
            TEST_ASSERT_DOUBLE_WITHIN(error, (double)*sum_of(before, i), (double)*sum_of(after, i));
        } else {
            assert_float_of(*sum_of(before, i), *sum_of(after, i));
        }
    }
    if (made_again) {
        const invcal_normal belongs = sums_of_table(after);
        const double rounding = FLOAT_OR_DOUBLE(1e-5, 1e-13) * (before->normal.count + 1.0);
        for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(rounding, (double)belongs.moment[i],
                                      (double)after->normal.moment[i]);
        }
    }
}

/* All but still. */
static void assert_same(invcal_session *before, invcal_session *after)
{
    for (unsigned i = 0; i < REALS; i++) {
        assert_float_of(*real_of(before, i), *real_of(after, i));
    }
    TEST_ASSERT_EQUAL_UINT(before->setup.plan.per_group, after->setup.plan.per_group);
    TEST_ASSERT_EQUAL_INT(before->setup.settings.frame, after->setup.settings.frame);
    TEST_ASSERT_EQUAL_INT32(before->setup.low, after->setup.low);
    TEST_ASSERT_EQUAL_INT32(before->setup.high, after->setup.high);
    TEST_ASSERT_EQUAL_UINT(before->setup.background, after->setup.background);
    TEST_ASSERT_EQUAL_UINT(before->is_enough, after->is_enough);
    TEST_ASSERT_EQUAL_UINT(before->stored, after->stored);
    TEST_ASSERT_EQUAL_UINT(before->step, after->step);
    TEST_ASSERT_EQUAL_UINT(before->normal.count, after->normal.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_MODEL_ELLIPSOID, after->normal.model);
    for (unsigned i = 0; i < before->stored; i++) {
        for (unsigned k = 0; k < 3; k++) {
            assert_float_of(before->mean[i][k], after->mean[i][k]);
        }
        TEST_ASSERT_EQUAL_UINT(before->age[i], after->age[i]);
    }
    assert_same_sums(before, after);
}

static void assert_same_numbers(const invcal_real *before, const invcal_real *after,
                                unsigned number, double scale)
{
#if INVCAL_DOUBLE
    for (unsigned i = 0; i < number; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(3e-6 * scale, before[i], after[i]);
    }
#else
    (void)scale;
    TEST_ASSERT_EQUAL_MEMORY(before, after, number * sizeof *before);
#endif
}

/* The same result, in float to the bit. Returns 1 if there was one. */
static int assert_same_result(const invcal_session *before, const invcal_session *after)
{
    invcal_solution s[2];
    invcal_quality q[2];
    invcal_outliers o;
    const int with_outliers = before->stored >= INVCAL_OUTLIERS_FEWEST + 1;
    invcal_outliers *wanted = with_outliers ? &o : NULL;
    const invcal_status status = invcal_session_solve(before, &s[0], &q[0], wanted);

    const invcal_mask removed = status == INVCAL_OK && wanted ? o.removed : 0;
    TEST_ASSERT_EQUAL_INT(status, invcal_session_solve(after, &s[1], &q[1], wanted));
    if (status != INVCAL_OK) {
        return 0;
    }
    TEST_ASSERT_TRUE(!wanted || removed == o.removed);
    assert_same_numbers(s[0].delta, s[1].delta, 3, 1);
    assert_same_numbers(s[0].dk, s[1].dk, 3, 1);
    assert_same_numbers(s[0].gamma, s[1].gamma, 3, 1);
    assert_same_numbers(s[0].calibration.offset, s[1].calibration.offset, 3, 9.8 * counts);
    for (unsigned i = 0; i < 3; i++) {
        assert_same_numbers(s[0].calibration.matrix[i], s[1].calibration.matrix[i], 3, 1 / counts);
    }
    assert_same_numbers(q[0].sigma_delta, q[1].sigma_delta, 3, 1);
    assert_same_numbers(q[0].sigma_dk, q[1].sigma_dk, 3, 1);
    assert_same_numbers(q[0].sigma_gamma, q[1].sigma_gamma, 3, 1);
    TEST_ASSERT_EQUAL_INT(q[0].verdict, q[1].verdict);
    return 1;
}

/* ---- what is kept ------------------------------------------------------------------------------ */

/* The bytes of the session below, by Python:
 *
 *     import struct, zlib
 *     b = struct.pack('<BBHHHIHBBii35f', 0xC5, 1, 194, 2, 2, 2, 6, 1, 2, -32768, 32767, *reals)
 *     b += struct.pack('<3fB3fB', 119.5, -200.5, 51.5, 0, 101.25, -162.5, 50.5, 7)
 *     b += struct.pack('<I', zlib.crc32(b))
 */
static const uint8_t golden[194] = {
    0xC5, 0x01, 0xC2, 0x00, 0x02, 0x00, 0x02, 0x00, 0x02, 0x00, 0x00, 0x00, 0x06, 0x00, 0x01,
    0x02, 0x00, 0x80, 0xFF, 0xFF, 0xFF, 0x7F, 0x00, 0x00, 0x00, 0x00, 0xC9, 0x42, 0x00, 0x40,
    0x48, 0xC3, 0x00, 0x00, 0x4B, 0x42, 0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x00, 0x3C, 0x00,
    0x00, 0x80, 0xBC, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3E, 0x00, 0x00, 0x00, 0x3D,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x1D,
    0x41, 0x00, 0x00, 0x80, 0x3A, 0x0A, 0xD7, 0x23, 0x3C, 0x0A, 0xD7, 0xA3, 0x3C, 0x8F, 0xC2,
    0xF5, 0x3C, 0x0A, 0xD7, 0x23, 0x3D, 0xCD, 0xCC, 0x4C, 0x3D, 0x8F, 0xC2, 0x75, 0x3D, 0x29,
    0x5C, 0x8F, 0x3D, 0x0A, 0xD7, 0xA3, 0x3D, 0xEC, 0x51, 0xB8, 0x3D, 0x00, 0x00, 0xF0, 0x41,
    0x00, 0x00, 0xF0, 0xC1, 0x00, 0x00, 0xF0, 0x42, 0x6F, 0x12, 0x83, 0x3A, 0x6F, 0x12, 0x03,
    0x3B, 0xA6, 0x9B, 0x44, 0x3B, 0x00, 0x00, 0x48, 0x41, 0x00, 0x00, 0xAA, 0x41, 0x00, 0x00,
    0x90, 0xC0, 0x00, 0x00, 0x23, 0x42, 0x6F, 0x12, 0x03, 0x3A, 0x00, 0x00, 0x44, 0x41, 0x00,
    0x00, 0xEF, 0x42, 0x00, 0x80, 0x48, 0xC3, 0x00, 0x00, 0x4E, 0x42, 0x00, 0x00, 0x80, 0xCA,
    0x42, 0x00, 0x80, 0x22, 0xC3, 0x00, 0x00, 0x4A, 0x42, 0x07, 0x30, 0x0D, 0xF5, 0x6D,
};

static const double golden_reals[REALS] = {
    100.5, -200.25, 50.75, 0.5,    0.0078125,    -0.015625, 0,      0.25,  0.03125,
    0,     0,       1,     9.8125, 0.0009765625, 0.01,      0.02,   0.03,  0.04,
    0.05,  0.06,    0.07,  0.08,   0.09,         30,        -30,    120,   0.001,
    0.002, 0.003,   12.5,  21.25,  -4.5,         40.75,     0.0005, 12.25,
};

static invcal_session golden_session(void)
{
    static const double mean[2][3] = {{119.5, -200.5, 51.5}, {101.25, -162.5, 50.5}};
    invcal_session s;

    memset(&s, 0, sizeof s);
    for (unsigned i = 0; i < REALS; i++) {
        *real_of(&s, i) = (invcal_real)golden_reals[i];
    }
    for (unsigned i = 0; i < 6; i++) {
        s.mean[i / 3][i % 3] = (invcal_real)mean[i / 3][i % 3];
    }
    s.age[1] = 7;
    s.setup.settings.frame = INVCAL_FRAME_TRIANGULAR;
    s.setup.plan.per_group = 6;
    s.setup.low = -32768;
    s.setup.high = 32767;
    s.is_enough = 1;
    s.stored = 2;
    s.step = 2;
    s.normal = sums_of_table(&s);
    return s;
}

static void a_session_has_the_bytes_of_the_table(void)
{
    const invcal_session s = golden_session();
    uint8_t bytes[SIZE];

    TEST_ASSERT_EQUAL_UINT32(sizeof golden, encode(&s, bytes));
    TEST_ASSERT_EQUAL_HEX8_ARRAY(golden, bytes, sizeof golden);
}

static void the_bytes_of_the_table_give_the_session(void)
{
    invcal_session expected = golden_session();
    invcal_session s = decode(golden, sizeof golden);

    assert_same(&expected, &s);
}

/* It is the range that tells, however small: not which side of zero it lies on. */
static void a_thermometer_is_known_by_what_it_has_shown(void)
{
    static const struct {
        double coldest, warmest;
        unsigned measured;
    } shown[] = {{0, 0, 0}, {0, 0.25, 2}, {-0.25, 0, 2}, {-0.5, -0.25, 2}, {0.25, 0.5, 2}};

    for (unsigned k = 0; k < sizeof shown / sizeof shown[0]; k++) {
        invcal_session s = golden_session();
        uint8_t bytes[SIZE];
        s.coldest = (invcal_real)shown[k].coldest;
        s.warmest = (invcal_real)shown[k].warmest;
        const uint32_t size = encode(&s, bytes);
        TEST_ASSERT_EQUAL_UINT(shown[k].measured, decode(bytes, size).measured);
    }
}

static void the_length_depends_on_the_positions(void)
{
    const scene program = make_scene(PROGRAM, 1);
    const scene overfull = make_scene(OVERFULL, 2);
    uint8_t bytes[SIZE];

    for (unsigned n = 0; n <= 15; n++) {
        const invcal_session s = session_after(&program, n);
        TEST_ASSERT_EQUAL_UINT32(168 + 13 * n, encode(&s, bytes));
        TEST_ASSERT_EQUAL_UINT8((168 + 13 * n) % 256, bytes[2]);
        TEST_ASSERT_EQUAL_UINT8((168 + 13 * n) / 256, bytes[3]);
    }
    for (unsigned n = MOST; n <= MOST + 2; n++) {
        const invcal_session s = session_after(&overfull, n);
        TEST_ASSERT_EQUAL_UINT32(n > MOST ? SIZE : SIZE - 4 * SUMS, encode(&s, bytes));
    }
}

/* Sessions of all kinds, empty to complete. */
static void a_session_comes_back_as_it_was(void)
{
    int results = 0;
    unsigned enough = 0;
    unsigned overfull = 0;

    for (uint32_t seed = 0; seed < SCENES; seed++) {
        const scene s = make_scene((int)(seed % KINDS), seed);
        invcal_session session = begin(&s);
        for (unsigned n = 0; n <= s.actions; n++) {
            uint8_t bytes[SIZE];
            uint8_t written[SIZE];
            uint8_t again[SIZE];
            const uint32_t size = encode(&session, bytes);
            TEST_ASSERT_EQUAL_UINT32(size, write_session(&session, written));
            TEST_ASSERT_EQUAL_MEMORY(written, bytes, size);
            invcal_session back = decode(bytes, size);
            assert_same(&session, &back);
            results += assert_same_result(&session, &back);
            TEST_ASSERT_EQUAL_UINT32(size, encode(&back, again));
            TEST_ASSERT_EQUAL_MEMORY(bytes, again, size);
            enough += session.is_enough;
            overfull += session.normal.count > session.stored;
            if (n < s.actions) {
                act(&session, &s, n);
            }
        }
        TEST_ASSERT_TRUE(session.normal.count >= (s.kind == BACKGROUND ? 5 : s.actions));
        TEST_ASSERT_EQUAL_UINT(s.kind == PROGRAM ? 15 : 0, session.step);
    }
    TEST_ASSERT_TRUE(results > 8 * SCENES && enough > SCENES / 3 && overfull == SCENES);
}

/* Weights are those that the session gives: for every age that a position can reach. */
static void positions_fade_the_same_after_a_reset(void)
{
    const scene s = make_scene(BACKGROUND, 40);
    invcal_session session = session_after(&s, 14);
    unsigned oldest = 0;

    for (unsigned day = 0; day < 120; day++) {
        uint8_t bytes[SIZE];
        invcal_session back = decode(bytes, encode(&session, bytes));
        assert_same(&session, &back);
        invcal_session_age(&back);
        invcal_session_age(&session);
        assert_same(&session, &back);
        for (unsigned i = 0; i < session.stored; i++) {
            oldest = session.age[i] > oldest ? session.age[i] : oldest;
        }
        if (day % 20 == 10) {
            act(&session, &s, 100 + day);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(80, oldest);
}

/* Twins: only the stream of one is forgotten, the other is stored as well. */
static void a_session_goes_on_as_if_there_had_been_no_reset(void)
{
    for (uint32_t seed = 20; seed < 20 + SCENES; seed++) {
        const scene s = make_scene((int)(seed % KINDS), seed);
        const unsigned resets = s.actions - 2;
        invcal_session session = session_after(&s, resets);
        uint8_t bytes[SIZE];
        invcal_session back = decode(bytes, encode(&session, bytes));
        forget_stream(&session);
        TEST_ASSERT_TRUE(back.still.time == 0 && back.still.noise < 0);
        for (unsigned n = resets; n < s.actions; n++) {
            invcal_guidance next[2];
            const invcal_status status = invcal_session_next(&session, &next[0]);
            TEST_ASSERT_EQUAL_INT(status, invcal_session_next(&back, &next[1]));
            for (unsigned i = 0; status == INVCAL_OK && i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(0, 1e-5), (double)next[0].up[i],
                                          (double)next[1].up[i]);
            }
            if (s.kind == BACKGROUND && n % 4 == 3) {
                invcal_session_age(&session);
                invcal_session_age(&back);
            } else {
                TEST_ASSERT_EQUAL_INT(hold(&session, &s, n), hold(&back, &s, n));
            }
        }
        TEST_ASSERT_EQUAL_UINT(session.normal.count, back.normal.count);
        TEST_ASSERT_EQUAL_UINT(session.stored, back.stored);
        TEST_ASSERT_EQUAL_UINT(session.step, back.step);
        TEST_ASSERT_EQUAL_UINT(session.is_enough, back.is_enough);
        assert_same_numbers(&session.mean[0][0], &back.mean[0][0], 3u * session.stored, 100);
        assert_same_result(&session, &back);
    }
}

/* Also in the worst moment: in the middle of a rest, of which nothing must be left. */
static void a_rest_that_was_going_on_is_forgotten(void)
{
    const scene s = make_scene(FREE_HAND, 3);
    invcal_session session = session_after(&s, 5);
    random_source random = random_start(9);
    invcal_event event;
    uint8_t bytes[SIZE];
    uint8_t again[SIZE];
    const double eta[3] = {0.6, 0, 0.8};

    const uint32_t size = encode(&session, bytes);
    for (unsigned i = 0; i < 60; i++) {
        (void)feed(&session, &s, eta, &random, &event);
    }
    TEST_ASSERT_EQUAL_UINT32(size, encode(&session, again));
    TEST_ASSERT_EQUAL_MEMORY(bytes, again, size);
    invcal_session back = decode(bytes, size);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_MOVING, invcal_session_finish(&back, &event));
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, invcal_session_finish(&session, &event));
}

static void a_program_whose_device_went_into_the_background_is_kept(void)
{
    const scene s = make_scene(PROGRAM, 4);
    invcal_session session = session_after(&s, 15);
    uint8_t bytes[SIZE];

    session.setup.background = 16; /* any mark will do */
    session.is_enough = 9;
    for (unsigned day = 0; day < 100; day++) {
        const uint32_t size = encode(&session, bytes);
        TEST_ASSERT_EQUAL_HEX8(3, bytes[15]);
        invcal_session back = decode(bytes, size);
        TEST_ASSERT_EQUAL_UINT(session.stored, back.stored);
        TEST_ASSERT_EQUAL_UINT(15, back.step);
        invcal_session_age(&session);
    }
    TEST_ASSERT_EQUAL_UINT(0, session.normal.count);
}

static void start_angles_without_a_program_are_not_looked_at(void)
{
    scene s = make_scene(FREE_HAND, 5);
    uint8_t bytes[SIZE];

    s.setup.plan.start[1] = (invcal_real)NOT_A_NUMBER;
    s.setup.plan.start[2] = 1000;
    const invcal_session session = session_after(&s, 2);
    const uint32_t size = encode(&session, bytes);
    TEST_ASSERT_EACH_EQUAL_HEX8(0, bytes + REALS_AT + 4 * START, 12);
    const invcal_session back = decode(bytes, size);
    TEST_ASSERT_TRUE(back.setup.plan.start[1] >= 0 && back.setup.plan.start[1] <= 0);
}

static void start_angles_without_a_program_are_not_decoded(void)
{
    const scene s = make_scene(FREE_HAND, 5);
    const invcal_session session = session_after(&s, 2);
    uint8_t bytes[SIZE];
    const uint32_t size = encode(&session, bytes);

    for (unsigned i = 0; i < 12; i++) {
        uint8_t *at = bytes + REALS_AT + 4 * START + i;
        *at = 0x80; /* the fourth of each is -0 */
        seal(bytes, size);
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, size));
        *at = 0;
    }
}

static void many_positions_are_counted(void)
{
    static const uint32_t count[] = {3, 255, 256, 0xFFFF, 0x10000, 0x12345678, 0xFFFFFFFF};

    for (unsigned i = 0; i < 7; i++) {
        invcal_session session = golden_session();
        uint8_t bytes[SIZE];
        if ((unsigned)count[i] == count[i]) { /* an unsigned may have 16 bits */
            session.normal.count = (unsigned)count[i];
            invcal_session back = decode(bytes, encode(&session, bytes));
            assert_same(&session, &back);
        }
    }
}

static void bytes_behind_a_session_are_not_looked_at(void)
{
    uint8_t bytes[sizeof golden + MARGIN];
    invcal_session expected = golden_session();

    for (unsigned fill = 0; fill < 256; fill += 85) {
        memset(bytes, (int)fill, sizeof bytes);
        memcpy(bytes, golden, sizeof golden);
        invcal_session s = decode(bytes, sizeof bytes);
        assert_same(&expected, &s);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_resume_decode(bytes, 0xFFFFFFFFu, &s));
    }
}

static void rails_of_any_kind_come_back(void)
{
    static const int32_t rail[][2] = {
        {0, 0}, {-1, 0}, {0, 1}, {INT32_MIN, INT32_MAX}, {INT32_MIN, INT32_MIN + 1}, {-65536, 255}};

    for (unsigned i = 0; i < 6; i++) {
        uint8_t bytes[SIZE];
        scene s = make_scene(FREE_HAND, 6);
        s.setup.low = rail[i][0];
        s.setup.high = rail[i][1];
        const invcal_session session = begin(&s);
        const invcal_session back = decode(bytes, encode(&session, bytes));
        TEST_ASSERT_EQUAL_INT32(rail[i][0], back.setup.low);
        TEST_ASSERT_EQUAL_INT32(rail[i][1], back.setup.high);
    }
}

/* ---- what is refused --------------------------------------------------------------------------- */

static void a_number_that_is_not_finite_is_not_encoded(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    const scene s = make_scene(OVERFULL, 7);
    const invcal_session overfull = session_after(&s, MOST + 1);

    for (unsigned k = 0; k < 3; k++) {
        const invcal_real x = (invcal_real)bad[k];
        for (unsigned i = 0; i < REALS; i++) {
            invcal_session session = golden_session();
            *real_of(&session, i) = x;
            assert_not_encoded(INVCAL_NOT_FINITE, &session);
        }
        for (unsigned i = 0; i < 6; i++) {
            invcal_session session = golden_session();
            session.mean[i / 3][i % 3] = x;
            assert_not_encoded(INVCAL_NOT_FINITE, &session);
        }
        for (unsigned i = 0; i < SUMS; i++) {
            invcal_session session = overfull;
            *sum_of(&session, i) = x;
            assert_not_encoded(INVCAL_NOT_FINITE, &session);
        }
    }
}

static void a_number_beyond_float_is_not_encoded(void)
{
#if INVCAL_DOUBLE
    for (unsigned i = 0; i < REALS; i++) {
        invcal_session session = golden_session();
        *real_of(&session, i) = i % 2 ? -3.4028235e38 : 3.4028235e38; /* just above the largest */
        assert_not_encoded(INVCAL_NOT_FINITE, &session);
    }
    invcal_session session = golden_session();
    session.mean[1][2] = 1e39;
    assert_not_encoded(INVCAL_NOT_FINITE, &session);
    session = golden_session();
    session.setup.settings.field = 1e-46; /* 0 as a float */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.setup.settings.noise = 1e-46; /* and a prior wants one */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    scene s = make_scene(FREE_HAND, 8); /* of numbers that are floats; ten fields are none */
    s.setup.settings.field = 9.8125;
    for (unsigned i = 0; i < 3; i++) {
        s.setup.settings.nominal.offset[i] = 3.0 / 4096;
        s.setup.settings.nominal.matrix[i][i] = 1.0 / 128;
        session.mean[0][i] = 3.0 / 4096 + (i == 2 ? 12560 - 1e-7 : 0);
    }
    session.setup = s.setup;
    session.stored = 1;
    session.step = 0;
    session.normal = sums_of_table(&session); /* in range, */
    session.mean[0][2] = (double)(float)session.mean[0][2];
    TEST_ASSERT_TRUE(session.mean[0][2] > 12560 + 3.0 / 4096); /* but beyond as a float */
    session.mean[0][2] = 3.0 / 4096 + 12560 - 1e-7;
    assert_not_encoded(INVCAL_OUT_OF_RANGE, &session);
#else
    TEST_ASSERT_TRUE(INVCAL_REAL_MAX <= FLT_MAX); /* there is none */
#endif
}

static void counts_that_contradict_each_other_are_not_encoded(void)
{
    invcal_session session = golden_session();

    session.step = 0;
    session.normal.count = 1; /* less than the table */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.stored = MOST + 1;
    session.normal.count = MOST + 1;
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.stored = 0; /* but taken */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.step = 3; /* more than were taken */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.setup.plan.per_group = 0; /* a step of what? */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.coldest = 50;
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.hold = 4000; /* seconds: longer than anybody may demand */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    session = golden_session();
    session.hold = -1;
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
    memset(&session, 0, sizeof session); /* never begun */
    assert_not_encoded(INVCAL_BAD_SETTING, &session);
}

static void a_mean_that_is_no_reading_is_neither_encoded_nor_decoded(void)
{
    static const double bad[][3] = {{100.5, -200.25, 50.75}, {9e9, 0, 0}, {100.5, -200.25, 51.7}};

    for (unsigned k = 0; k < 3; k++) {
        for (unsigned i = 0; i < 2; i++) {
            invcal_session session = golden_session();
            uint8_t bytes[SIZE];
            for (unsigned j = 0; j < 3; j++) {
                session.mean[i][j] = (invcal_real)bad[k][j];
            }
            assert_not_encoded(INVCAL_OUT_OF_RANGE, &session);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, write_session(&session, bytes)));
        }
    }
}

static void nor_is_it_where_there_are_sums_besides(void)
{
    invcal_session session = golden_session();

    session.normal.count = 3; /* one of them is in the sums only */
    session.mean[1][0] = (invcal_real)9e9;
    assert_not_encoded(INVCAL_OUT_OF_RANGE, &session);
}

static void a_number_that_is_not_finite_is_not_decoded(void)
{
    static const uint32_t bits[] = {0x7FC00000, 0xFF800001, 0x7F800000, 0xFF800000};
    const scene s = make_scene(OVERFULL, 9);
    const invcal_session overfull = session_after(&s, MOST + 1);
    uint8_t bytes[SIZE];
    uint8_t sound[SIZE];
    const uint32_t size = encode(&overfull, sound);
    unsigned numbers = 0;

    for (uint32_t at = REALS_AT; at < size - 4; at += 4) {
        if (at >= TABLE_AT && at < TABLE_AT + POSITION * MOST && (at - TABLE_AT) % POSITION == 12) {
            at++; /* an age */
        }
        for (unsigned k = 0; k < 4; k++) {
            uint8_t *number = bytes + at;
            memcpy(bytes, sound, size);
            put(&number, bits[k], 4);
            seal(bytes, size);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, size));
        }
        numbers++;
        if (at + 4 == TABLE_AT + POSITION * MOST - 1) {
            at++; /* the last age */
        }
    }
    TEST_ASSERT_EQUAL_UINT(REALS + 3 * MOST + SUMS, numbers);
}

/* Field by field: where, how many bytes, and what must not stand there. */
static void contents_that_no_session_has_are_refused(void)
{
    static const struct {
        uint32_t at;
        unsigned size;
        uint32_t value;
    } bad[] = {
        {4, 2, 1},
        {4, 2, 3},
        {4, 2, 0},
        {4, 2, 0xFFFF},
        {8, 4, 1},
        {8, 4, 3},
        {8, 4, 0},
        {8, 4, 0xFFFFFFFF},
        {6, 2, 3},
        {6, 2, 19},
        {6, 2, 0xFFFF},
        {12, 2, 0},
        {12, 2, 1},
        {12, 2, 4},
        {12, 2, 1001},
        {12, 2, 0xFFFF},
        {14, 1, 2},
        {14, 1, 0xFF},
        {15, 1, 4},
        {15, 1, 0x82},
        {16, 4, 32767},
        {20, 4, 0x80000000},
        {72, 4, 0},
        {72, 4, 0xC0000000},
        {76, 4, 0xBA800000},
        {76, 4, 0},
        {76, 4, 0x42000000},
        {80, 4, 0xBF000000},
        {112, 4, 0xBF000000},
        {116, 4, 0x43B40001},
        {120, 4, 0xC3B40001},
        {128, 4, 0xBF000000},
        {136, 4, 0xBF000000},
        {140, 4, 0},
        {140, 4, 0x40E00000},
        {140, 4, 0x45FA0001},
        {140, 4, 0xC2000000},
        {148, 4, 0x42300000},
        {36, 4, 0x00000000},
        {68, 4, 0},
    };

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        uint8_t bytes[sizeof golden];
        uint8_t *at = bytes + bad[i].at;
        memcpy(bytes, golden, sizeof golden);
        put(&at, bad[i].value, bad[i].size);
        seal(bytes, sizeof golden);
        TEST_ASSERT_TRUE_MESSAGE(is_refused(INVCAL_DAMAGED, bytes, sizeof golden), "not refused");
    }
}

/* With a length that fits them, so that nothing else gives them away. */
static void counts_that_contradict_each_other_are_not_decoded(void)
{
    static const unsigned bad[][4] = {
        /* stored, count, step, per_group */
        {0, 1, 0, 0}, {2, 1, 0, 6},   {0, 40, 0, 6},   {2, 2, 3, 6},
        {2, 2, 1, 0}, {9, 40, 16, 5}, {9, 40, 41, 50},
    };

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_session session = golden_session();
        uint8_t bytes[SIZE];
        for (unsigned k = 2; k < 9; k++) {
            memcpy(session.mean[k], session.mean[0], sizeof session.mean[0]);
        }
        session.stored = (uint16_t)bad[i][0];
        session.normal.count = bad[i][1];
        session.step = (uint16_t)bad[i][2];
        session.setup.plan.per_group = bad[i][3];
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, bytes, write_session(&session, bytes)));
        session.stored = session.stored > 0 ? session.stored : (uint16_t)session.normal.count;
        session.stored = session.stored > 9 ? 9 : session.stored;
        session.normal.count += session.normal.count < session.stored;
        session.step = 0;
        (void)decode(bytes, write_session(&session, bytes)); /* it was that */
    }
}

/* Returns the length. The golden session with another size of its table. */
static uint32_t with_table(unsigned stored, uint32_t count, uint8_t *bytes)
{
    uint8_t *at = bytes + 4;
    const uint32_t length = 168 + POSITION * stored + (count > stored ? 4 * SUMS : 0);

    memset(bytes, 0, length);
    memcpy(bytes, golden, TABLE_AT);
    put(&at, stored, 2);
    at = bytes + 8;
    put(&at, count, 4);
    for (unsigned i = 0; i < stored; i++) {
        memcpy(bytes + TABLE_AT + POSITION * i, golden + TABLE_AT, POSITION);
    }
    seal(bytes, length);
    return length;
}

static void a_table_larger_than_that_of_this_build_has_no_space(void)
{
    static uint8_t bytes[ROOM(65535, 2400)];

    for (unsigned stored = 2; stored < ROOM(5000u, 150u); stored += stored < 80 ? 1 : 100) {
        for (uint32_t more = 0; more < 2; more++) {
            const uint32_t length = with_table(stored, stored + more, bytes);
            if (stored > MOST) {
                TEST_ASSERT_TRUE(is_refused(INVCAL_NO_SPACE, bytes, length));
            } else {
                const invcal_session s = decode(bytes, length);
                TEST_ASSERT_EQUAL_UINT(stored + more, s.normal.count);
                TEST_ASSERT_EQUAL_UINT(stored, s.stored);
            }
        }
    }
}

/* A full table of a small build is not full in a large one; what follows is in sums and table. */
static void the_overfull_session_of_a_smaller_build_goes_on(void)
{
    scene s = make_scene(OVERFULL, 10);
    invcal_session session = session_after(&s, 10);
    uint8_t bytes[SIZE];

    session.stored = 9;
    for (unsigned n = 10; n < 14; n++) {
        session = decode(bytes, encode(&session, bytes));
        TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, hold(&session, &s, n));
        TEST_ASSERT_EQUAL_UINT(n + 1, session.normal.count);
        TEST_ASSERT_EQUAL_UINT(n, session.stored);
    }
    invcal_session back = decode(bytes, encode(&session, bytes));
    assert_same(&session, &back);
}

static void any_wrong_bit_is_noticed(void)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const scene s = make_scene(kind, 11);
        const invcal_session session = session_after(&s, s.actions);
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
    for (int kind = 0; kind < KINDS; kind++) {
        const scene s = make_scene(kind, 12);
        const invcal_session session = session_after(&s, s.actions);
        uint8_t bytes[SIZE];
        const uint32_t whole = encode(&session, bytes);
        for (uint32_t size = 0; size < whole; size++) {
            uint8_t *exact = malloc(size + 1); /* so that a sanitizer sees a read behind it */
            memcpy(exact + 1, bytes, size);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, exact + 1, size));
            free(exact);
        }
    }
}

/* Nor is one that was sealed again: the length must be that of the content. */
static void a_length_that_is_not_that_of_the_content_is_refused(void)
{
    uint8_t bytes[sizeof golden + 300];

    for (uint32_t length = 8; length <= sizeof bytes; length++) {
        memset(bytes, 0, sizeof bytes);
        memcpy(bytes, golden, sizeof golden);
        seal(bytes, length);
        if (length != sizeof golden) {
            uint8_t *exact = malloc(length);
            memcpy(exact, bytes, length);
            TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, exact, length));
            free(exact);
        }
    }
    for (uint8_t length = 0; length < 8; length++) {
        uint8_t tiny[8] = {0xC5, 1, 0, 0, 0, 0, 0, 0};
        tiny[2] = length;
        TEST_ASSERT_TRUE(is_refused(INVCAL_DAMAGED, tiny, 8));
    }
}

static void sound_bytes_of_another_kind_or_version_are_named_so(void)
{
    static const uint16_t lengths[] = {8, 9, 159, 160, sizeof golden, 240};

    for (unsigned k = 0; k < 6; k++) {
        for (unsigned at = 0; at < 2; at++) {
            for (unsigned value = 0; value < 256; value++) {
                uint8_t bytes[sizeof golden + MARGIN] = {0};
                memcpy(bytes, golden, sizeof golden);
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
    record.calibration = golden_session().setup.settings.nominal;
    record.field = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_record_encode(&record, bytes));
    TEST_ASSERT_TRUE(is_refused(INVCAL_OTHER_VERSION, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_VERSION,
                          invcal_record_decode(golden, sizeof golden, &record));
}

static void random_contents_with_a_right_crc_do_no_harm(void)
{
    const scene s = make_scene(BACKGROUND, 13);
    const invcal_session session = session_after(&s, 8);
    random_source random = random_start(3);
    uint8_t sound[SIZE];
    const uint32_t size = encode(&session, sound);
    unsigned accepted = 0;

    for (unsigned k = 0; k < 20000; k++) {
        uint8_t bytes[SIZE];
        invcal_session out;
        invcal_solution solution;
        invcal_quality quality;
        invcal_guidance next;
        memcpy(bytes, sound, size);
        for (unsigned i = 0; i < 1 + k % 3; i++) {
            const uint32_t at = (uint32_t)random_uniform(&random, 4, k % 2 ? 24 : size - 4.0);
            bytes[at] = (uint8_t)random_uniform(&random, 0, 256);
        }
        seal(bytes, size);
        memset(&out, 0, sizeof out);
        if (invcal_resume_decode(bytes, size, &out) == INVCAL_OK) {
            accepted++;
            (void)invcal_session_solve(&out, &solution, &quality, NULL);
            (void)invcal_session_next(&out, &next);
            invcal_session_age(&out);
            (void)encode(&out, bytes);
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

/* The life of a session that is reset after each action: its bytes before the first, after the
 * first, and so on. */
enum { LONGEST = ROOM(MOST + 24, 1) }; /* actions of any scene; or one */
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

    for (unsigned n = 0; n <= lived.scene.actions && n <= LONGEST; n++) {
        lived.size[n] = encode(&session, lived.bytes[n]);
        session = decode(lived.bytes[n], lived.size[n]);
        if (n < lived.scene.actions) {
            act(&session, &lived.scene, n);
        }
    }
}

static int save(unsigned n)
{
    return invcal_store_save(&store, lived.bytes[n], lived.size[n]) == INVCAL_OK;
}

/* Loads what must be state n or n + 1. Returns which, and the session. */
static unsigned load(unsigned n, invcal_session *session)
{
    static uint8_t bytes[SIZE];
    uint32_t size = 0;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_load(&store, bytes, SIZE, &size));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_resume_decode(bytes, size, session));
    const int is_new = size == lived.size[n + 1] && memcmp(bytes, lived.bytes[n + 1], size) == 0;
    if (!is_new) {
        TEST_ASSERT_EQUAL_UINT32(lived.size[n], size);
        TEST_ASSERT_EQUAL_MEMORY(lived.bytes[n], bytes, size);
    }
    return n + (is_new ? 1u : 0u);
}

/* Action n, and the state must be the one that was lived. */
static void go_on(invcal_session *session, unsigned n)
{
    static uint8_t bytes[SIZE];

    act(session, &lived.scene, n);
    TEST_ASSERT_EQUAL_UINT32(lived.size[n + 1], encode(session, bytes));
    TEST_ASSERT_EQUAL_MEMORY(lived.bytes[n + 1], bytes, lived.size[n + 1]);
}

/* To the end, saved after each action. The last state is the one that was lived: as many
 * positions, the same sums, the same calibration. */
static void finish_life(invcal_session *session, unsigned n)
{
    for (; n < lived.scene.actions; n++) {
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
    if (which == lived.scene.actions) {
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

    if (lived.scene.actions > LONGEST) {
        skip_large();
    }
    TEST_ASSERT_TRUE(save(0));
    for (unsigned n = 0; n < lived.scene.actions; n++) {
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
        live(seed % 25 == 24 ? OVERFULL : (int)(seed % 3), 100 + seed);
        const invcal_session never = session_after(&lived.scene, lived.scene.actions);
        const invcal_session last =
            decode(lived.bytes[lived.scene.actions], lived.size[lived.scene.actions]);
        TEST_ASSERT_EQUAL_UINT(never.normal.count, last.normal.count);
        assert_same_result(&never, &last);
        taken += last.normal.count;
        new_flash(granularities[seed / 3 % 4]);
        cut_everywhere(0, found);
    }
    TEST_ASSERT_TRUE(taken > 1000 && found[0] > 10000 && found[1] > 1500);
}

static void a_power_cut_at_any_byte_of_a_save_loses_no_position(void)
{
    int found[2] = {0, 0};

    live(PROGRAM, 300);
    new_flash(8);
    cut_everywhere(1, found);
    TEST_ASSERT_TRUE(found[0] > 15 * SLOT && found[1] >= 15);
}

/* Nothing is there yet: what is found is nothing, or the session that was begun. */
static void a_power_cut_in_the_first_save_leaves_nothing_or_the_session(void)
{
    const int step = 1 + TEST_SHORT / 16;
    unsigned none = 0;

    live(FREE_HAND, 301);
    for (int cut = 0; cut < SLOT + SIZE; cut += step) {
        static uint8_t bytes[SIZE];
        uint32_t size;
        invcal_session session;
        new_flash(4);
        power = cut;
        (void)save(0);
        power_up();
        const invcal_status status = invcal_store_load(&store, bytes, SIZE, &size);
        none += status == INVCAL_NO_RECORD;
        if (status != INVCAL_NO_RECORD) {
            TEST_ASSERT_EQUAL_UINT(0, load(0, &session));
        }
        TEST_ASSERT_TRUE(save(1));
        TEST_ASSERT_EQUAL_UINT(1, load(0, &session));
    }
    TEST_ASSERT_GREATER_THAN_UINT((unsigned)(SLOT / step), none);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_session_has_the_bytes_of_the_table);
    RUN_TEST(the_bytes_of_the_table_give_the_session);
    RUN_TEST(a_thermometer_is_known_by_what_it_has_shown);
    RUN_SLOW_TEST(the_length_depends_on_the_positions);
    RUN_SLOW_TEST(a_session_comes_back_as_it_was);
    RUN_SLOW_TEST(positions_fade_the_same_after_a_reset);
    RUN_TEST(a_session_goes_on_as_if_there_had_been_no_reset);
    RUN_TEST(a_rest_that_was_going_on_is_forgotten);
    RUN_TEST(a_program_whose_device_went_into_the_background_is_kept);
    RUN_TEST(many_positions_are_counted);
    RUN_TEST(start_angles_without_a_program_are_not_looked_at);
    RUN_TEST(start_angles_without_a_program_are_not_decoded);
    RUN_TEST(bytes_behind_a_session_are_not_looked_at);
    RUN_TEST(rails_of_any_kind_come_back);
    RUN_TEST(a_number_that_is_not_finite_is_not_encoded);
    RUN_TEST(a_number_beyond_float_is_not_encoded);
    RUN_TEST(counts_that_contradict_each_other_are_not_encoded);
    RUN_TEST(a_mean_that_is_no_reading_is_neither_encoded_nor_decoded);
    RUN_TEST(nor_is_it_where_there_are_sums_besides);
    RUN_SLOW_TEST(a_number_that_is_not_finite_is_not_decoded);
    RUN_TEST(contents_that_no_session_has_are_refused);
    RUN_TEST(counts_that_contradict_each_other_are_not_decoded);
    RUN_SLOW_TEST(a_table_larger_than_that_of_this_build_has_no_space);
    RUN_TEST(the_overfull_session_of_a_smaller_build_goes_on);
    RUN_SLOW_TEST(any_wrong_bit_is_noticed);
    RUN_TEST(a_session_without_its_end_is_noticed);
    RUN_TEST(a_length_that_is_not_that_of_the_content_is_refused);
    RUN_SLOW_TEST(sound_bytes_of_another_kind_or_version_are_named_so);
    RUN_TEST(a_record_is_no_session_and_a_session_no_record);
    RUN_LONG_TEST(random_contents_with_a_right_crc_do_no_harm);
    RUN_LONG_TEST(a_power_cut_in_any_step_of_a_save_loses_no_position);
    RUN_LONG_TEST(a_power_cut_at_any_byte_of_a_save_loses_no_position);
    RUN_TEST(a_power_cut_in_the_first_save_leaves_nothing_or_the_session);
    return UNITY_END() != 0;
}
