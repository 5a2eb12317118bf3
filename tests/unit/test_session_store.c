/* SPDX-License-Identifier: MIT
 *
 * Sessions that are fed samples, saved, and resumed: by their bytes, and through a simulated NOR
 * flash that loses power.
 */
#include <stddef.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/store.h"
#include "support.h"
#include "unity.h"

enum {
    HEAD = offsetof(invcal_session, mean),
    SIZE = HEAD + sizeof(((invcal_session *)NULL)->mean),
    MEAN = 3 * sizeof(invcal_real),
    MOST = INVCAL_MAX_POSITIONS,
    FILL = 0x5A
};

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

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_session_init_nominal(&session, sizeof session, &s->nominal, RATE));
    if (s->kind == TUNED) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(&session, (invcal_real)0.0011));
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_session_set_limits(&session, -32768, 32767 - (int32_t)s->seed));
        invcal_session_set_hold(&session, (invcal_real)(1000 + s->seed) / 1000);
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
    return invcal_session_feed(session, raw[0], raw[1], raw[2]);
}

/* Turns eta by 0.2 rad towards other, which is not noise. */
static void turn(double eta[3], double other[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const double from = eta[i];
        eta[i] = cos(0.2) * from + sin(0.2) * other[i];
        other[i] = cos(0.2) * other[i] - sin(0.2) * from;
    }
}

/* Holds eta, then moves away. */
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

/* What is not saved: the stream starts. */
static void forget_stream(invcal_session *session, const scene *s)
{
    const invcal_session fresh = begin(s);

    session->rests = fresh.rests;
    session->last = fresh.last;
    session->reason = fresh.reason;
}

static invcal_session session_after(const scene *s, unsigned positions)
{
    invcal_session session = begin(s);

    for (unsigned n = 0; n < positions; n++) {
        forget_stream(&session, s);
        hold(&session, s, n);
    }
    return session;
}

/* ---- keeping, and going on ---------------------------------------------------------------------- */

/* The last event is not resumed. */
static uint32_t keep(const invcal_session *session, uint8_t bytes[SIZE])
{
    const uint32_t size = invcal_session_size(session);
    invcal_session quiet = *session;

    quiet.last = INVCAL_MOVING;
    quiet.reason = INVCAL_OK;
    quiet.good = 0;
    TEST_ASSERT_TRUE(size <= SIZE);
    memcpy(bytes, &quiet, size);
    return size;
}

/* After a reset: memory has any contents, and the saved bytes any alignment. */
static invcal_session resume(const scene *s, const uint8_t *bytes, uint32_t size)
{
    static uint8_t odd[SIZE + 1];
    invcal_session out = begin(s);

    memset(out.mean, FILL, sizeof out.mean);
    memcpy(odd + 1, bytes, size);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_resume(&out, odd + 1, size));
    return out;
}

/* As it was begun, and with nothing in its table. */
static void assert_as_begun(const invcal_session *begun, const invcal_session *session)
{
    TEST_ASSERT_EQUAL_MEMORY(begun, session, HEAD);
    TEST_ASSERT_EQUAL_MEMORY(&begun->rests, &session->rests, sizeof begun->rests);
    TEST_ASSERT_EQUAL_UINT(0, session->count);
}

static void assert_refused(invcal_status expected, const invcal_session *begun,
                           const invcal_session *saved, uint32_t size)
{
    static uint8_t bytes[SIZE + 100];
    invcal_session s = *begun;

    memset(bytes, FILL, sizeof bytes);
    memcpy(bytes, saved, SIZE);
    TEST_ASSERT_EQUAL_INT(expected, invcal_session_resume(&s, bytes, size));
    assert_as_begun(begun, &s);
}

/* Everything except its state of the stream: that is as after its start. */
static void assert_same(const scene *s, const invcal_session *before, const invcal_session *after)
{
    invcal_session fresh = *before;

    forget_stream(&fresh, s);
    fresh.good = 0; /* to be asked again */
    TEST_ASSERT_EQUAL_MEMORY(&fresh, after, invcal_session_size(before));
    TEST_ASSERT_EQUAL_MEMORY(&fresh.rests, &after->rests, sizeof fresh.rests);
}

/* The same result. Returns 1 if there was one. */
static int assert_same_result(const invcal_session *before, const invcal_session *after)
{
    invcal_calibration c[2];
    invcal_quality q[2];
    const invcal_status status = invcal_session_solve(before, &c[0], &q[0]);

    TEST_ASSERT_EQUAL_INT(status, invcal_session_solve(after, &c[1], &q[1]));
    if (status != INVCAL_OK) {
        return 0;
    }
    TEST_ASSERT_EQUAL_MEMORY(&c[0], &c[1], sizeof c[0]);
    TEST_ASSERT_EQUAL_MEMORY(q[0].sigma, q[1].sigma, sizeof q[0].sigma);
    TEST_ASSERT_EQUAL_INT(q[0].verdict, q[1].verdict);
    TEST_ASSERT_TRUE(q[0].left_out == q[1].left_out);
    return 1;
}

/* ---- what is kept ------------------------------------------------------------------------------ */

static const invcal_calibration golden_nominal = {
    {INVCAL_REAL(100.5), INVCAL_REAL(-200.25), INVCAL_REAL(50.75)},
    {{INVCAL_REAL(0.5), INVCAL_REAL(0.0078125), INVCAL_REAL(-0.015625)},
     {0, INVCAL_REAL(0.25), INVCAL_REAL(0.03125)},
     {0, 0, 1}}};
static const double golden_mean[2][3] = {{102.5, -200.5, 51.5}, {101.25, -196.5, 50.5}};

/* What a device states whenever it begins. */
static invcal_session golden_begun(void)
{
    invcal_session s;

    memset(&s, FILL, sizeof s);
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_session_init_nominal(&s, sizeof s, &golden_nominal, INVCAL_REAL(12.5)));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_limits(&s, -32768, 32767));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(&s, INVCAL_REAL(0.0009765625)));
    invcal_session_set_hold(&s, INVCAL_REAL(2.5));
    return s;
}

static invcal_session golden_session(void)
{
    invcal_session s = golden_begun();

    for (unsigned i = 0; i < 6; i++) {
        s.mean[i / 3].v[i % 3] = (invcal_real)golden_mean[i / 3][i % 3];
    }
    s.count = 2;
    return s;
}

/* The positions of the golden session are there, and everything else is as it was begun. */
static void assert_golden_positions(const invcal_session *begun, const invcal_session *session)
{
    invcal_session expected = *begun;

    expected.count = 2;
    TEST_ASSERT_EQUAL_MEMORY(&expected, session, HEAD);
    TEST_ASSERT_EQUAL_MEMORY(&expected.rests, &session->rests, sizeof expected.rests);
    for (unsigned i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE((double)session->mean[i / 3].v[i % 3] == golden_mean[i / 3][i % 3]);
    }
}

static void the_length_depends_on_the_positions(void)
{
    const scene s = make_scene(OVERFULL, 2);
    invcal_session session = begin(&s);

    for (unsigned n = 0; n <= MOST + 2; n++) {
        TEST_ASSERT_EQUAL_UINT32(HEAD + MEAN * (n < MOST ? n : MOST),
                                 invcal_session_size(&session));
        hold(&session, &s, n);
    }
    TEST_ASSERT_EQUAL_UINT32(INVCAL_SESSION_SIZE, invcal_session_size(&session));
}

/* Nothing in between is random. */
static void what_lasts_has_no_gaps(void)
{
    const size_t words = 4 + sizeof(uint32_t);

    TEST_ASSERT_EQUAL_size_t(words + 14 * sizeof(invcal_real), HEAD);
    TEST_ASSERT_EQUAL_size_t(0, offsetof(invcal_session, reason)); /* of these, in every build */
    TEST_ASSERT_EQUAL_size_t(4, offsetof(invcal_session, layout));
    TEST_ASSERT_EQUAL_size_t(words, offsetof(invcal_session, rate));
    TEST_ASSERT_EQUAL_size_t(HEAD + MEAN * MOST, SIZE);
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
            invcal_session back = resume(&s, bytes, keep(&session, bytes));
            assert_same(&s, &session, &back);
            results += assert_same_result(&session, &back);
            TEST_ASSERT_EQUAL_INT(invcal_session_is_good(&session), invcal_session_is_good(&back));
            if (n < s.positions) {
                hold(&session, &s, n);
            }
        }
        TEST_ASSERT_EQUAL_UINT(s.positions < MOST ? s.positions : MOST, session.count);
        TEST_ASSERT_EQUAL_INT(1, invcal_session_is_good(&session));
    }
    TEST_ASSERT_GREATER_THAN_INT(4 * SCENES, results);
}

/* Twins: one only forgets its stream, the other is also stored. */
static void a_session_goes_on_as_if_there_had_been_no_reset(void)
{
    for (uint32_t seed = 20; seed < 20 + SCENES; seed++) {
        const scene s = make_scene((int)(seed % KINDS), seed);
        const unsigned resets = s.positions - 2;
        invcal_session session = session_after(&s, resets);
        uint8_t bytes[SIZE];
        invcal_session back = resume(&s, bytes, keep(&session, bytes));
        forget_stream(&session, &s);
        for (unsigned n = resets; n < s.positions; n++) {
            invcal_real next[2][3];
            invcal_session_next(&session, next[0]);
            invcal_session_next(&back, next[1]);
            TEST_ASSERT_EQUAL_MEMORY(next[0], next[1], sizeof next[0]);
            hold(&session, &s, n);
            hold(&back, &s, n);
        }
        TEST_ASSERT_EQUAL_UINT(session.count, back.count);
        TEST_ASSERT_EQUAL_MEMORY(session.mean, back.mean, session.count * sizeof session.mean[0]);
        TEST_ASSERT_EQUAL_INT(1, assert_same_result(&session, &back));
    }
}

/* Also at the worst moment: in the middle of a rest, of which nothing must remain. */
static void a_rest_that_was_going_on_is_forgotten(void)
{
    const scene s = make_scene(PLAIN, 3);
    invcal_session session = session_after(&s, 5);
    random_source random = random_start(9);
    uint8_t bytes[SIZE];
    const double eta[3] = {0.6, 0, 0.8};

    for (unsigned i = 0; i < 60; i++) {
        (void)feed(&session, &s, eta, &random);
    }
    TEST_ASSERT_EQUAL_UINT(100, invcal_session_progress(&session));
    invcal_session back = resume(&s, bytes, keep(&session, bytes));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcal_session_end(&back));
    TEST_ASSERT_EQUAL_INT(INVCAL_TAKEN, invcal_session_end(&session));
}

/* ---- settings: those of the device, not those of the bytes -------------------------------------- */

/* Sessions with other rails, another time to hold, another noise: all positions come, and what was
 * stated now stays. */
static void what_was_stated_stays_as_it_was_begun(void)
{
    static const int32_t rail[][2] = {
        {-1, 0}, {0, 1}, {INT32_MIN, INT32_MAX}, {INT32_MIN, INT32_MIN + 1}, {-65536, 255}};
    static const uint32_t milliseconds[] = {0, 600, 601, 65536, 3600001};
    static const double noise[] = {1e-6, 0.999, 0.001, 0.0009765625, 0.5};

    for (unsigned i = 0; i < 25; i++) {
        const unsigned now = i / 5;
        const unsigned then = i % 5;
        invcal_session saved = golden_session();
        invcal_session begun = golden_begun();
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_set_limits(&saved, rail[then][0], rail[then][1]));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_set_noise(&saved, (invcal_real)noise[then]));
        invcal_session_set_hold(&saved, (invcal_real)(milliseconds[then]) / 1000);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_set_limits(&begun, rail[now][0], rail[now][1]));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(&begun, (invcal_real)noise[now]));
        invcal_session_set_hold(&begun, (invcal_real)(milliseconds[now]) / 1000);
        invcal_session back = begun;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_resume(&back, (const uint8_t *)&saved,
                                                               invcal_session_size(&saved)));
        assert_golden_positions(&begun, &back);
        TEST_ASSERT_EQUAL_INT32(rail[now][0], back.rests.low);
        TEST_ASSERT_TRUE(back.noise == (invcal_real)noise[now]);
    }
}

/* The end of a rest is that of the time to hold stated now, not then. */
static void the_time_to_hold_is_that_of_now(void)
{
    const scene s = make_scene(PLAIN, 8);
    const invcal_session saved = session_after(&s, 3);
    const double eta[3] = {0.6, 0, 0.8};

    for (uint32_t i = 0; i < 2; i++) {
        random_source random = random_start(11);
        invcal_session session = begin(&s);
        unsigned ready = 0;
        invcal_session_set_hold(&session, (invcal_real)(i ? 20000 : 1000) / 1000);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_resume(&session, (const uint8_t *)&saved,
                                                               invcal_session_size(&saved)));
        for (unsigned n = 0; n < 10 * RATE; n++) {
            ready += feed(&session, &s, eta, &random) == INVCAL_READY;
        }
        TEST_ASSERT_EQUAL_UINT(1 - i, ready);
    }
}

static void another_rate_is_refused(void)
{
    static const double rate[] = {8, 9, 12, 12.5, 100, 1000, 7999, 8000};
    const scene s = make_scene(PLAIN, 6);
    invcal_session session[8];

    for (unsigned i = 0; i < 8; i++) {
        memset(&session[i], FILL, sizeof session[i]);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_init_nominal(&session[i], sizeof session[i],
                                                          &s.nominal, (invcal_real)rate[i]));
    }
    for (unsigned i = 0; i < 8; i++) {
        for (unsigned k = 0; k < 8; k++) {
            assert_refused(i == k ? INVCAL_OK : INVCAL_OTHER_SETTINGS, &session[i], &session[k],
                           HEAD);
        }
    }
}

/* In any bit of any number: a sensor of another range, or renewed from another calibration. */
static void another_nominal_calibration_is_refused(void)
{
    const invcal_session begun = golden_begun();
    const invcal_session good = golden_session();

    for (unsigned i = 0; i < 12; i++) {
        for (unsigned bit = 0; bit < 8 * sizeof(invcal_real); bit++) {
            invcal_session saved = good;
            uint8_t *bytes = (uint8_t *)&saved.nominal + i * sizeof(invcal_real);
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            assert_refused(INVCAL_OTHER_SETTINGS, &begun, &saved, invcal_session_size(&saved));
        }
    }
}

/* ---- what is refused --------------------------------------------------------------------------- */

/* Damage that no CRC has noticed: of the settings that must be the same it is refused, those of the
 * others are not read. */
static void numbers_that_no_session_has_are_refused_or_not_read(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 0, -1, 1};
    const invcal_session begun = golden_begun();

    for (unsigned k = 0; k < 6; k++) {
        invcal_session saved = golden_session();
        const uint32_t size = invcal_session_size(&saved);
        saved.rate = (invcal_real)bad[k];
        assert_refused(INVCAL_OTHER_SETTINGS, &begun, &saved, size);
        for (unsigned i = 0; i < 3; i++) {
            saved = golden_session();
            saved.nominal.offset[i] = (invcal_real)bad[k];
            assert_refused(INVCAL_OTHER_SETTINGS, &begun, &saved, size);
            saved = golden_session();
            saved.nominal.matrix[0][i] = (invcal_real)bad[k];
            assert_refused(INVCAL_OTHER_SETTINGS, &begun, &saved, size);
        }
        saved = golden_session();
        saved.noise = (invcal_real)bad[k];
        saved.reason = 0xFF;
        saved.last = 0xFF;
        saved.good = 0xFF;
        memset(&saved.rests, 0xFF, sizeof saved.rests);
        invcal_session back = begun;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_resume(&back, (const uint8_t *)&saved, size));
        assert_golden_positions(&begun, &back);
    }
}

static void a_length_that_is_not_that_of_the_table_is_refused(void)
{
    const invcal_session begun = golden_begun();
    invcal_session s = golden_session();
    const uint32_t whole = invcal_session_size(&s);

    TEST_ASSERT_EQUAL_UINT32(HEAD + 2 * MEAN, whole);
    for (uint32_t size = 0; size <= SIZE + 20; size++) {
        if (size != whole) {
            assert_refused(size <= SIZE ? INVCAL_DAMAGED : INVCAL_NO_SPACE, &begun, &s, size);
        }
    }
    assert_refused(INVCAL_NO_SPACE, &begun, &s, 0xFFFFFFFFu);
    for (unsigned count = 0; count < 256; count++) {
        s.count = (uint8_t)count;
        if (count != 2) {
            assert_refused(INVCAL_DAMAGED, &begun, &s, whole);
        }
        if (count > MOST) {
            assert_refused(INVCAL_NO_SPACE, &begun, &s, HEAD + MEAN * count);
        }
    }
}

/* Any bit of it: another layout, number type, order of bytes. */
static void another_layout_is_of_another_build(void)
{
    const invcal_session begun = golden_begun();
    const invcal_session good = golden_session();

    for (unsigned bit = 0; bit < 32; bit++) {
        invcal_session s = good;
        s.layout ^= UINT32_C(1) << bit;
        assert_refused(INVCAL_OTHER_SETTINGS, &begun, &s, invcal_session_size(&s));
    }
    /* of the number type, by the size of what is before the means; in another byte order, another */
    TEST_ASSERT_EQUAL_HEX32(INVCAL_DOUBLE ? 0x07900000 : 0x04100000, good.layout);
}

/* Into a session that has positions already: those go, too. */
static void a_refused_load_leaves_no_positions(void)
{
    static const struct {
        uint32_t size;
        invcal_status status;
    } wrong[] = {{HEAD - 1, INVCAL_DAMAGED},
                 {HEAD, INVCAL_DAMAGED},
                 {SIZE, INVCAL_DAMAGED},
                 {SIZE + 1, INVCAL_NO_SPACE}};
    static uint8_t bytes[SIZE + 1];
    const invcal_session good = golden_session();

    memcpy(bytes, &good, HEAD + 2 * MEAN);
    for (unsigned i = 0; i < 4; i++) {
        invcal_session session = golden_session();
        TEST_ASSERT_EQUAL_INT(wrong[i].status,
                              invcal_session_resume(&session, bytes, wrong[i].size));
        TEST_ASSERT_EQUAL_UINT(0, session.count);
    }
}

/* Before it is begun, or if that failed: nothing is taken over, and every sample is refused. */
static void a_session_that_was_not_begun_is_not_resumed(void)
{
    const invcal_session saved = golden_session();
    const uint32_t size = invcal_session_size(&saved);
    invcal_session session;

    for (unsigned i = 0; i < 3; i++) {
        static const invcal_status why[] = {INVCAL_NOT_BEGUN, INVCAL_BAD_RATE, INVCAL_OTHER_BUILD};
        memset(&session, 0, sizeof session);
        if (i > 0) {
            TEST_ASSERT_EQUAL_INT(why[i],
                                  invcal_session_init_nominal(&session, sizeof session + i - 1,
                                                              &golden_nominal, i == 1 ? 5 : 100));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN,
                              invcal_session_resume(&session, (const uint8_t *)&saved, size));
        TEST_ASSERT_EQUAL_UINT(0, session.count);
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(&session, 1, 2, 3));
        TEST_ASSERT_EQUAL_INT(why[i], invcal_session_reason(&session));
    }
}

/* What is accepted can be fed, solved and guided. */
static void any_content_does_no_harm(void)
{
    const scene s = make_scene(TUNED, 13);
    const invcal_session session = session_after(&s, 12);
    random_source random = random_start(3);
    uint8_t sound[SIZE];
    const uint32_t size = keep(&session, sound);
    const invcal_session begun = begin(&s);
    unsigned accepted = 0;

    for (unsigned k = 0; k < 20000; k++) {
        uint8_t bytes[SIZE];
        invcal_session out = begun;
        invcal_calibration calibration;
        invcal_quality quality;
        invcal_real next[3];
        memcpy(bytes, sound, size);
        for (unsigned i = 0; i < 1 + k % 3; i++) {
            bytes[(uint32_t)random_uniform(&random, 0, k % 2 ? HEAD : size)] =
                (uint8_t)random_uniform(&random, 0, 256);
        }
        const invcal_status status = invcal_session_resume(&out, bytes, size);
        if (status != INVCAL_OK) {
            assert_as_begun(&begun, &out);
            continue;
        }
        accepted++;
        (void)invcal_session_solve(&out, &calibration, &quality);
        invcal_session_next(&out, next);
        TEST_ASSERT_DOUBLE_WITHIN(
            1e-6, 1, length3((double[3]){(double)next[0], (double)next[1], (double)next[2]}));
        (void)invcal_session_feed(&out, 1, -2, 3);
    }
    TEST_ASSERT_TRUE(accepted > 1000 && accepted < 19500);
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
static long steps; /* that still complete before power fails in one */
static long power; /* the same in bytes */
static int dead;
static int rules_broken;

/* How many of all bytes are written before power fails. */
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
        lived.size[n] = keep(&session, lived.bytes[n]);
        session = resume(&lived.scene, lived.bytes[n], lived.size[n]);
        if (n < lived.scene.positions) {
            hold(&session, &lived.scene, n);
        }
    }
}

static int save(unsigned n)
{
    const invcal_session session = resume(&lived.scene, lived.bytes[n], lived.size[n]);

    return invcal_session_save(&session, &store) == INVCAL_OK;
}

/* Loads what must be state n or n + 1. Returns which, and the session. */
static unsigned load(unsigned n, invcal_session *session)
{
    static uint8_t bytes[SIZE];

    *session = begin(&lived.scene);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_load(session, &store));
    const uint32_t size = keep(session, bytes);
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
    TEST_ASSERT_EQUAL_UINT32(lived.size[n + 1], keep(session, bytes));
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

/* The save of state n + 1 is cut; then the session goes on, and its next save is cut, too. Returns
 * 1 if the first was not cut, but completed. */
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
        const invcal_session last = resume(&lived.scene, lived.bytes[end], lived.size[end]);
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

/* Nothing is stored yet: nothing is found, or the session that was begun. */
static void a_power_cut_in_the_first_save_leaves_nothing_or_the_session(void)
{
    const int step = 1 + TEST_SHORT / 16;
    unsigned none = 0;

    live(PLAIN, 301);
    for (int cut = 0; cut < SLOT + SIZE; cut += step) {
        invcal_session session = begin(&lived.scene);
        new_flash(4);
        power = cut;
        (void)save(0);
        power_up();
        const invcal_status status = invcal_session_load(&session, &store);
        none += status == INVCAL_NO_RECORD;
        if (status != INVCAL_NO_RECORD) {
            TEST_ASSERT_EQUAL_UINT(0, load(0, &session));
        }
        TEST_ASSERT_TRUE(save(1));
        TEST_ASSERT_EQUAL_UINT(1, load(0, &session));
    }
    TEST_ASSERT_GREATER_THAN_UINT((unsigned)(SLOT / step), none);
}

/* The session is then as it was begun, and can be used: to ignore the failure is to begin again. */
static void what_is_not_a_session_is_not_loaded(void)
{
    static const uint8_t large[SIZE + 1] = {0xC5, 1}; /* as release 0.1.0 began */
    static const struct {
        const uint8_t *bytes;
        uint32_t size;
        invcal_status status;
    } stored[] = {{NULL, 0, INVCAL_NO_RECORD},
                  {large, 1, INVCAL_DAMAGED},
                  {large, HEAD, INVCAL_OTHER_SETTINGS},
                  {large, SIZE, INVCAL_OTHER_SETTINGS},
                  {large, SIZE + 1, INVCAL_NO_SPACE}};
    const scene s = make_scene(TUNED, 14);
    const invcal_session begun = begin(&s);

    new_flash(8);
    for (unsigned i = 0; i < 5; i++) {
        invcal_session session = begun;
        if (stored[i].size > 0) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                                  invcal_store_save(&store, stored[i].bytes, stored[i].size));
        }
        TEST_ASSERT_EQUAL_INT(stored[i].status, invcal_session_load(&session, &store));
        assert_as_begun(&begun, &session);
        hold(&session, &s, 0);
        TEST_ASSERT_EQUAL_UINT(1, session.count);
        TEST_ASSERT_EQUAL_INT(stored[i].status, invcal_session_load(&session, &store));
        TEST_ASSERT_EQUAL_UINT(0, session.count);
    }
    store.granularity = 3;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_STORE, invcal_session_save(&begun, &store));
}

static void a_session_of_other_settings_is_not_loaded(void)
{
    const invcal_session saved = golden_session();
    const invcal_session begun = golden_begun();
    invcal_session session = begun;

    new_flash(8);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_save(&saved, &store));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_load(&session, &store));
    assert_golden_positions(&begun, &session);
    for (unsigned i = 0; i < 2; i++) {
        invcal_calibration nominal = golden_nominal;
        nominal.matrix[2][1] = i == 0 ? INVCAL_REAL(1e-6) : 0;
        memset(&session, FILL, sizeof session);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_session_init_nominal(&session, sizeof session, &nominal,
                                                          i == 0 ? INVCAL_REAL(12.5) : 12));
        const invcal_session other = session;
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_SETTINGS, invcal_session_load(&session, &store));
        assert_as_begun(&other, &session);
    }
}

static void what_was_not_begun_is_not_loaded(void)
{
    const invcal_session saved = golden_session();
    invcal_session session;

    new_flash(8);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_save(&saved, &store));
    for (unsigned i = 0; i < 2; i++) {
        memset(&session, 0, sizeof session);
        if (i > 0) {
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE,
                                  invcal_session_init(&session, sizeof session, 16384, 5));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_session_load(&session, &store));
        TEST_ASSERT_EQUAL_UINT(0, session.count);
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(&session, 1, 2, 3));
        TEST_ASSERT_EQUAL_INT(i > 0 ? INVCAL_BAD_RATE : INVCAL_NOT_BEGUN,
                              invcal_session_reason(&session));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_SLOW_TEST(the_length_depends_on_the_positions);
    RUN_TEST(what_lasts_has_no_gaps);
    RUN_SLOW_TEST(a_session_comes_back_as_it_was);
    RUN_TEST(a_session_goes_on_as_if_there_had_been_no_reset);
    RUN_TEST(a_rest_that_was_going_on_is_forgotten);
    RUN_TEST(what_was_stated_stays_as_it_was_begun);
    RUN_TEST(the_time_to_hold_is_that_of_now);
    RUN_TEST(another_rate_is_refused);
    RUN_TEST(another_nominal_calibration_is_refused);
    RUN_TEST(numbers_that_no_session_has_are_refused_or_not_read);
    RUN_TEST(a_length_that_is_not_that_of_the_table_is_refused);
    RUN_TEST(another_layout_is_of_another_build);
    RUN_TEST(a_refused_load_leaves_no_positions);
    RUN_TEST(a_session_that_was_not_begun_is_not_resumed);
    RUN_LONG_TEST(any_content_does_no_harm);
    RUN_LONG_TEST(a_power_cut_in_any_step_of_a_save_loses_no_position);
    RUN_LONG_TEST(a_power_cut_at_any_byte_of_a_save_loses_no_position);
    RUN_TEST(a_power_cut_in_the_first_save_leaves_nothing_or_the_session);
    RUN_TEST(what_is_not_a_session_is_not_loaded);
    RUN_TEST(a_session_of_other_settings_is_not_loaded);
    RUN_TEST(what_was_not_begun_is_not_loaded);
    return UNITY_END() != 0;
}
