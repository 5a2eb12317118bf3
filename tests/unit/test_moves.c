/* SPDX-License-Identifier: MIT
 *
 * Moves from a stream: what is kept, what is refused and why; also with the session's own rests.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static world w;
static world_solution imu;
static const double none[3] = {0, 0, 0};

static void quarter(double seconds)
{
    const double vector[3] = {0, 90 * DEGREE, 0};

    world_move(&w, vector, seconds);
}

static void begin(void)
{
    world_begin(&w, 100, 7);
    w.wobble = 0;
}

/* The integral of a move about one axis, and the bias of its rests, are those of the truth. */
static void a_move_keeps_its_angle_and_rests_their_bias(void)
{
    begin();
    world_without_noise(&w);
    w.bias[0] = 0.2;
    w.bias[1] = -0.3;
    world_rest(&w, 1.5);
    quarter(1);
    world_rest(&w, 8); /* continues */
    w.count--;
    quarter(1);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(3, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&w.imu, 0));
    const invcal_private_segment *s = w.imu.own.segment;
    for (unsigned i = 1; i < 3; i++) {
        double angle[3] = {0, 0, 0};
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, i));
        TEST_ASSERT_TRUE(w.imu.own.rest[i].move >= 5 && w.imu.own.rest[i].move <= 8);
        for (int k = 0; k < w.imu.own.rest[i].move; k++) {
            TEST_ASSERT_TRUE(s->v[1] < 0.36 * 32768);
            for (int a = 0; a < 3; a++) {
                angle[a] += s->v[a] / 32768.0;
                TEST_ASSERT_TRUE(s->kappa[a] >= -2 && s->kappa[a] <= 2);
            }
            s++;
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0, angle[0]);
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, 90 * DEGREE, angle[1]);
        for (int a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(
                2e-5, w.bias[a], (double)w.imu.own.bias[a] + w.imu.own.rest[i].bias[a] / 262144.0);
        }
    }
}

static invcal_status reason_of(unsigned rest)
{
    world_end(&w);
    return rest < w.imu.rests ? invcal_imu_move_reason(&w.imu, rest) : INVCAL_STATUS_END;
}

static void lost_samples_spoil_only_one_move(void)
{
    begin();
    world_rest(&w, 1.5);
    quarter(1);
    for (int i = 0; i < 50; i++) {
        world_sample(&w, none, 0);
    }
    invcal_imu_gap(&w.imu);
    quarter(1);
    quarter(1);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, reason_of(3));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&w.imu, 2));
}

static void a_clipped_or_a_long_move_is_refused(void)
{
    begin();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_imu_set_limits(&w.imu, -150000, 150000)); /* 1.5 rad/s */
    world_rest(&w, 1.5);
    quarter(2.2);
    quarter(1);
    quarter(2.2);
    quarter(10.5);
    quarter(2.2);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, reason_of(5));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_CLIPPED, invcal_imu_move_reason(&w.imu, 2));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 3));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_LONG, invcal_imu_move_reason(&w.imu, 4));
}

/* A device that turns slowly when it should rest: the moves on both sides are unusable. */
static void a_rest_that_turns_is_not_a_rest(void)
{
    begin();
    world_rest(&w, 1.5);
    quarter(1);
    w.bias[2] += 3 * DEGREE;
    quarter(1);
    w.bias[2] -= 3 * DEGREE;
    quarter(1);
    quarter(1);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, reason_of(4));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, invcal_imu_move_reason(&w.imu, 2));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, invcal_imu_move_reason(&w.imu, 3));
}

/* The table of segments is full: its contents stay, and biases are still right. */
static void without_space_moves_are_refused_and_rests_continue(void)
{
    const double far[3] = {0, 150 * DEGREE, 0};

    begin();
    world_without_noise(&w);
    w.bias[0] = 0.1;
    world_rest(&w, 1.5);
    for (int i = 0; i < 45; i++) {
        if (w.count == WORLD_RESTS) {
            w.count--;
        }
        world_move(&w, far, 1.5);
    }
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.imu.rests);
    TEST_ASSERT_TRUE(w.imu.own.used <= INVCAL_MAX_SEGMENTS);
    int refused = 0;
    for (unsigned i = 1; i < w.imu.rests; i++) {
        const invcal_status status = invcal_imu_move_reason(&w.imu, i);
        TEST_ASSERT_TRUE(status == INVCAL_OK || status == INVCAL_NO_SPACE);
        refused += status == INVCAL_NO_SPACE;
        TEST_ASSERT_DOUBLE_WITHIN(2e-5, 0.1,
                                  (double)w.imu.own.bias[0] + w.imu.own.rest[i].bias[0] / 262144.0);
    }
    TEST_ASSERT_TRUE(refused > 0 && refused < 20);
}

/* A failed beginning writes a word and a byte, which say that it was not begun, and why: at the same
 * place in every build. The session says why as well. */
static void assert_not_begun(invcal_imu *before, invcal_status why)
{
    before->own.layout = 0;
    before->own.fault = w.imu.own.fault;
    before->session.reason = (uint8_t)why;
    TEST_ASSERT_EQUAL_INT(why, invcal_session_reason(&w.imu.session));
    TEST_ASSERT_EQUAL_MEMORY(before, &w.imu, sizeof *before);
}

static void feed_all(void)
{
    for (int32_t n = 0; n < 300; n++) {
        invcal_imu_feed_gyro(&w.imu, 1000, -1000, n);
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_imu_feed(&w.imu, 100, 200, n % 2));
    }
    invcal_imu_gap(&w.imu);
}

/* Also if nobody looks at the status: no sample is used, and each is refused. */
static void what_was_not_begun_refuses_every_sample_and_says_why(void)
{
    static const uint8_t fills[] = {0, 0x5A, 0xFF};
    static const double rates[] = {5, NOT_A_NUMBER, 7.99, 8001, INFINITE};
    const invcal_calibration nominal = unit_nominal();
    static invcal_imu before;

    for (unsigned i = 0; i < 5 * sizeof fills; i++) {
        begin();
        memset(&w.imu.own, fills[i / 5], sizeof w.imu.own);
        memcpy(&before, &w.imu, sizeof before);
        TEST_ASSERT_EQUAL_INT(
            INVCAL_BAD_RATE,
            invcal_imu_init_nominal(&w.imu, sizeof w.imu, &nominal, (invcal_real)rates[i % 5]));
        feed_all();
        assert_not_begun(&before, INVCAL_BAD_RATE);
    }
    begin();
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_imu_init(&w.imu, sizeof w.imu, 0, 100));
    feed_all();
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_session_reason(&w.imu.session));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init(&w.imu, sizeof w.imu, 1, 100));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_reason(&w.imu.session));
}

/* Nobody began it. */
static void a_session_alone_is_not_enough(void)
{
    world_solution none_yet;
    int8_t axes[3] = {7, 8, 9};
    invcal_real unit = 5;

    begin();
    memset(&w.imu.own, 0, sizeof w.imu.own);
    feed_all();
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_session_reason(&w.imu.session));
    TEST_ASSERT_EQUAL_INT(0, w.imu.session.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_solve(&w.imu, NULL, &none_yet.result));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_mounting(&w.imu, axes, &unit));
    TEST_ASSERT_TRUE(axes[0] == 7 && axes[1] == 8 && axes[2] == 9 && unit == 5);
}

/* The reason of the session stays: it is the earlier one. */
static void moves_need_a_session(void)
{
    begin();
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE,
                          invcal_session_init(&w.imu.session, sizeof w.imu.session, 16384, 5));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_init(&w.imu, sizeof w.imu, 3753, 100));
    feed_all();
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_session_reason(&w.imu.session));
    memset(&w.imu, 0, sizeof w.imu);
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_init(&w.imu, sizeof w.imu, 3753, 100));
    feed_all();
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_session_reason(&w.imu.session));
}

/* A program with tables of another size: its structure ends with the session, which says why; and
 * nothing is written beyond its end. */
static void another_build_is_refused_and_the_session_says_why(void)
{
    static const int others[] = {-616, -8, 8, 616};
    static union {
        invcal_imu imu;
        uint8_t bytes[sizeof(invcal_imu) + 1000];
    } memory, before;

    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        const size_t size = sizeof(invcal_imu) + (size_t)others[i];
        invcal_session session;
        memset(&memory, 0x5A, sizeof memory);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&session, sizeof session, 16384, 100));
        memcpy(&memory.bytes[size - sizeof session], &session, sizeof session);
        memcpy(&before, &memory, sizeof before);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, invcal_imu_init(&memory.imu, size, 3753, 100));
        for (int32_t n = 0; n < 300; n++) {
            invcal_imu_feed_gyro(&memory.imu, 1000, -1000, n);
            TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_imu_feed(&memory.imu, 100, 200, n % 2));
        }
        invcal_imu_gap(&memory.imu);
        memcpy(&session, &memory.bytes[size - sizeof session], sizeof session);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, invcal_session_reason(&session));
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(&session, 1, 2, 3));
        before.imu.own.layout = 0;
        before.imu.own.fault = INVCAL_OTHER_BUILD;
        uint8_t *of = &before.bytes[size - sizeof session];
        of[offsetof(invcal_session, reason)] = INVCAL_OTHER_BUILD;
        memset(&of[offsetof(invcal_session, layout)], 0, sizeof session.layout);
        TEST_ASSERT_EQUAL_MEMORY(&before, &memory, sizeof before);
    }
    for (size_t size = 0; size < sizeof(invcal_session) + 200; size++) { /* of nothing */
        memset(&memory, 0x5A, sizeof memory);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, invcal_imu_init(&memory.imu, size, 3753, 100));
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_imu_feed(&memory.imu, 100, 200, 300));
    }
}

static void nonsense_is_refused_or_does_no_harm(void)
{
    const int32_t ends[3] = {INT32_MIN, INT32_MAX, INT32_MIN};
    invcal_calibration nominal = unit_nominal();
    static invcal_imu untouched;

    begin();
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcal_imu_set_limits(&w.imu, 5, 5));
    memcpy(&untouched, &w.imu, sizeof untouched);
    nominal.matrix[0][0] = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL,
                          invcal_imu_init_nominal(&w.imu, sizeof w.imu, &nominal, 100));
    assert_not_begun(&untouched, INVCAL_BAD_NOMINAL);
    nominal = unit_nominal();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init_nominal(&w.imu, sizeof w.imu, &nominal, 100));
    world_rest(&w, 1.5);
    for (int i = 0; i < 300; i++) {
        invcal_imu_feed_gyro(&w.imu, ends[0], ends[1], ends[2]);
        world_sample(&w, none, 0);
    }
    world_rest(&w, 1.5);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
    TEST_ASSERT_TRUE(invcal_imu_move_reason(&w.imu, 1) != INVCAL_OK);
}

/* ---- blocks by hand ----------------------------------------------------------------------------- */

static void turn_on(double x, double y, double z, int samples)
{
    const int32_t raw[3] = {(int32_t)(x * COUNTS), (int32_t)(y * COUNTS), (int32_t)(z * COUNTS)};

    for (int i = 0; i < samples; i++) {
        invcal_imu_feed_gyro(&w.imu, raw[0], raw[1], raw[2]);
    }
}

static void blocks(int count, invcal_event event, int is_quiet)
{
    for (int i = 0; i < count; i++) {
        turn_on(0, 0, 0, WORLD_BLOCK);
        w.imu.session.rests.begin =
            w.imu.session.rests.pended > 0 ? w.imu.session.rests.begin : w.imu.session.rests.time;
        w.imu.session.rests.time += WORLD_BLOCK;
        w.imu.session.rests.pended = is_quiet ? 2 : w.imu.session.rests.pended;
        w.imu.session.rests.end = is_quiet ? w.imu.session.rests.time : w.imu.session.rests.end;
        invcali_imu_follow(&w.imu, event);
    }
}

static void rest_by_hand(void)
{
    blocks(8, INVCAL_SETTLING, 1);
    blocks(1, INVCAL_READY, 1);
}

static void leave_by_hand(void)
{
    blocks(4, INVCAL_MOVING, 0);
    blocks(1, INVCAL_TAKEN, 0);
    w.imu.session.rests.pended = 0;
}

/* 127 segments of 20 degrees are 7.06 turns. */
static void a_move_of_more_than_seven_turns_is_refused(void)
{
    begin();
    rest_by_hand();
    leave_by_hand();
    for (int i = 0; i < 28; i++) { /* 19 degrees a sample, and so each a segment: 7.4 turns */
        turn_on(33.2, 0, 0, 5);
        blocks(1, INVCAL_MOVING, 0);
    }
    rest_by_hand();
    leave_by_hand();
    TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOUNTING, invcal_imu_move_reason(&w.imu, 1));
}

/* A device that is stirred goes nowhere, but turns: the sum does not fit one segment. */
static void stirring_fills_a_segment(void)
{
    begin();
    rest_by_hand();
    leave_by_hand();
    for (int i = 0; i < 10; i++) {
        for (int k = 0; k < 4; k++) { /* 0.01 rad about z each time */
            turn_on(9, 0, 0, 1);
            turn_on(0, 9, 0, 1);
            turn_on(-9, 0, 0, 1);
            turn_on(0, -9, 0, 1);
        }
        blocks(1, INVCAL_MOVING, 0);
    }
    rest_by_hand();
    leave_by_hand();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 1));
    const unsigned segments = (unsigned)w.imu.own.rest[1].move;
    TEST_ASSERT_TRUE(segments >= 3 && segments <= 10);
    double angle = 0;
    for (unsigned k = 0; k < segments; k++) {
        angle += (w.imu.own.segment[k].v[2] / 32768.0) + (w.imu.own.segment[k].kappa[2] / 262144.0);
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-3, 40 * 0.09 * 0.09, angle); /* the area that was gone around */
}

/* 8000 samples a second: segments of as many samples as they can count, 32767. */
static void a_segment_counts_no_more_than_it_can(void)
{
    static const int samples[] = {5 * WORLD_BLOCK, 32767, 32767, 26};

    begin();
    const invcal_calibration gyro = w.imu.nominal;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init_nominal(&w.imu, sizeof w.imu, &gyro, 8000));
    rest_by_hand();
    leave_by_hand(); /* five blocks of these belong to the move */
    turn_on(0, 0, 0, 32767);
    TEST_ASSERT_EQUAL_INT(0, w.imu.own.missing);
    turn_on(0, 0, 0, 10000);
    TEST_ASSERT_EQUAL_INT(10000, w.imu.own.missing);
    blocks(1, INVCAL_MOVING, 0);
    turn_on(0, 0, 0, 32767 - 10000 - 2 * WORLD_BLOCK);
    blocks(1, INVCAL_MOVING, 0); /* merged with those before */
    turn_on(0, 0, 0, 10);
    blocks(1, INVCAL_MOVING, 0); /* not merged */
    rest_by_hand();
    leave_by_hand();
    TEST_ASSERT_EQUAL_INT(4, w.imu.own.rest[1].move);
    for (int k = 0; k < 4; k++) {
        TEST_ASSERT_EQUAL_INT(samples[k], w.imu.own.segment[k].time / 2u);
    }
}

/* Events in an order that no detector produces do no harm. */
static void events_out_of_order_do_no_harm(void)
{
    begin();
    w.imu.session.rests.pended = 0;
    blocks(1, INVCAL_READY, 0);
    blocks(1, INVCAL_TAKEN, 0);
    TEST_ASSERT_EQUAL_INT(1, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&w.imu, 0));
    for (int i = 0; i < INVCAL_MAX_MOVES + 2; i++) { /* no move is usable, and the oldest go */
        invcal_imu_gap(&w.imu);
        rest_by_hand();
        leave_by_hand();
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(0, w.imu.own.first);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&w.imu, 0));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&w.imu, 1));
}

/* ---- to the sample: blocks in which a count is 2^-18 rad/s, and nothing is rounded -------------- */

enum { EXACT_RATE = 8, EXACT_BLOCK = 8 };

static void begin_at(int rate)
{
    invcal_calibration nominal = unit_nominal();

    begin();
    for (int i = 0; i < 3; i++) {
        nominal.matrix[i][i] = INVCAL_REAL(1.0) / 262144;
    }
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_imu_init_nominal(&w.imu, sizeof w.imu, &nominal, (invcal_real)rate));
    w.imu.session.rests.bits = 3;
}

static void begin_exactly(void)
{
    begin_at(EXACT_RATE);
}

static void feed(int32_t x, int32_t y, int32_t z)
{
    const int32_t raw[3] = {x, y, z};

    invcal_imu_feed_gyro(&w.imu, raw[0], raw[1], raw[2]);
}

/* The end of a block: eight samples of the accelerometer, however many of the gyroscope. */
static void end_block(invcal_event event, int is_quiet)
{
    w.imu.session.rests.begin = is_quiet && w.imu.session.rests.pended == 0
                                    ? w.imu.session.rests.time
                                    : w.imu.session.rests.begin;
    w.imu.session.rests.time += EXACT_BLOCK;
    w.imu.session.rests.pended = is_quiet ? 1 : w.imu.session.rests.pended;
    w.imu.session.rests.end = is_quiet ? w.imu.session.rests.time : w.imu.session.rests.end;
    invcali_imu_follow(&w.imu, event);
}

static void block(int32_t x, int32_t y, int32_t z, invcal_event event, int is_quiet)
{
    for (int i = 0; i < EXACT_BLOCK; i++) {
        feed(x, y, z);
    }
    end_block(event, is_quiet);
}

/* Ten quiet blocks, the last two of which do not count. */
static void rest_exactly(int32_t x, int32_t y, int32_t z)
{
    for (int i = 0; i < 9; i++) {
        block(x, y, z, INVCAL_SETTLING, 1);
    }
    block(x, y, z, INVCAL_READY, 1);
}

static void leave_exactly(void)
{
    for (int i = 0; i < 4; i++) {
        block(0, 0, 0, INVCAL_MOVING, 0);
    }
    block(0, 0, 0, INVCAL_TAKEN, 0);
    w.imu.session.rests.pended = 0;
}

/* The blocks of a move before those that a test adds: two of the rest, and five. Those of the first are dropped. */
enum { BEFORE = 7, BEFORE_FIRST = 5 };

/* One sample of an angle. */
static int32_t angle(double degrees)
{
    return (int32_t)lround(degrees * DEGREE * 262144 * (double)w.imu.own.rate);
}

/* So large that each one is a segment. */
static void large_turns(int count)
{
    for (int i = 0; i < count; i++) {
        feed(angle(19), 0, 0);
    }
}

static long samples_of_move(unsigned from, unsigned to)
{
    long samples = 0;

    for (unsigned k = from; k < to; k++) {
        samples += w.imu.own.segment[k].time / 2u;
    }
    return samples;
}

static void sum_of_move(unsigned from, unsigned to, int32_t sum[3])
{
    memset(sum, 0, 3 * sizeof sum[0]);
    for (unsigned k = from; k < to; k++) {
        for (int a = 0; a < 3; a++) {
            sum[a] += w.imu.own.segment[k].v[a];
        }
    }
}

/* The bias is the mean of all but two blocks; the two, which contain motion perhaps, are the move's, which lasts
 * until the next rest begins: 80 samples are 10 seconds. */
static void a_move_is_what_lies_between_two_rests(void)
{
    for (int more = 0; more < 2; more++) {
        int32_t sum[3];
        begin_exactly();
        for (int i = 0; i < 8; i++) {
            block(80, -40, 16, INVCAL_SETTLING, 1);
        }
        TEST_ASSERT_EQUAL_INT(0, w.imu.rests);
        block(88, 0, 0, INVCAL_SETTLING, 1);
        block(96, 0, 0, INVCAL_READY, 1);
        TEST_ASSERT_TRUE(w.imu.own.bias[0] * 262144 == 80 && w.imu.own.bias[1] * 262144 == -40 &&
                         w.imu.own.bias[2] * 262144 == 16);
        block(80, -40, 16, INVCAL_SETTLING, 1);
        for (int i = 0; i < 2; i++) { /* for the two that were dropped */
            block(88, -48, 16, INVCAL_SETTLING, 1);
        }
        leave_exactly();
        block(880, -40, 16, INVCAL_MOVING, 0);
        block(80, 760, 16, INVCAL_MOVING, 0);
        for (int i = 0; i < more; i++) {
            feed(80, -40, 16);
        }
        block(80, -40, 1616, INVCAL_MOVING, 0);
        rest_exactly(96, -56, 24);
        TEST_ASSERT_EQUAL_INT(1, w.imu.rests);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
        TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&w.imu, 0));
        TEST_ASSERT_EQUAL_INT(more ? INVCAL_MOVE_LONG : INVCAL_OK,
                              invcal_imu_move_reason(&w.imu, 1));
        TEST_ASSERT_EQUAL_INT(8, w.imu.own.rest[0].when);
        for (int a = 0; a < 3; a++) {
            TEST_ASSERT_EQUAL_INT(0, w.imu.own.rest[0].bias[a]);
        }
        TEST_ASSERT_EQUAL_INT(26, w.imu.own.rest[1].when);
        TEST_ASSERT_EQUAL_INT(16, w.imu.own.rest[1].bias[0]);
        TEST_ASSERT_EQUAL_INT(-16, w.imu.own.rest[1].bias[1]);
        TEST_ASSERT_EQUAL_INT(8, w.imu.own.rest[1].bias[2]);
        if (more) {
            TEST_ASSERT_EQUAL_INT(0, w.imu.own.first);
            continue;
        }
        TEST_ASSERT_EQUAL_INT((BEFORE + 3) * EXACT_BLOCK, samples_of_move(0, w.imu.own.first));
        sum_of_move(0, w.imu.own.first, sum);
        TEST_ASSERT_EQUAL_INT(2 * 1 + 5 * -10 + 100, sum[0]);
        TEST_ASSERT_EQUAL_INT(2 * -1 + 5 * 5 + 100, sum[1]);
        TEST_ASSERT_EQUAL_INT(5 * -2 + 200, sum[2]);
    }
}

/* 0.5 degrees/s are 2287.6; from the rest before, not from the first. */
static void a_bias_may_change_by_half_a_degree(void)
{
    for (int i = 0; i < 12; i++) {
        const int axis = i / 4;
        const int is_more = i % 2;
        const int sign = i % 4 < 2 ? 1 : -1;
        int32_t x[3] = {0, 0, 0};
        begin_exactly();
        rest_exactly(0, 0, 0);
        leave_exactly();
        x[axis] = sign * 1000;
        rest_exactly(x[0], x[1], x[2]);
        leave_exactly();
        x[axis] = sign * (is_more ? 3296 : 3288);
        block(x[0], x[1], x[2], INVCAL_SETTLING, 1);
        x[axis] = sign * 3288;
        for (int k = 0; k < 8; k++) {
            block(x[0], x[1], x[2], INVCAL_SETTLING, 1);
        }
        block(x[0], x[1], x[2], INVCAL_READY, 1);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(1, w.imu.own.rest[1].move);
        TEST_ASSERT_EQUAL_INT(is_more ? INVCAL_REST_DRIFT : INVCAL_OK,
                              invcal_imu_move_reason(&w.imu, 2));
        TEST_ASSERT_EQUAL_INT(sign * (3288 + is_more), w.imu.own.rest[2].bias[axis]);
        TEST_ASSERT_EQUAL_INT(is_more ? 1 : 2, w.imu.own.first);
    }
}

/* Everything about a rest moves with it when the oldest go. */
static void the_oldest_moves_go_with_their_segments(void)
{
    enum { GONE = 4, RESTS = INVCAL_MAX_MOVES + GONE };
    unsigned at = 0;

    begin_exactly();
    for (int k = 0; k < RESTS; k++) {
        for (int i = 0; i < k % 3; i++) {
            feed(0, angle(19), 0);
        }
        block(0, 0, 64 * k, INVCAL_MOVING, 0);
        if (k == 2) { /* has no segments */
            invcal_imu_gap(&w.imu);
        }
        rest_exactly(8 * k, 0, 0);
        leave_exactly();
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.imu.rests);
    for (int i = 0; i < INVCAL_MAX_MOVES; i++) {
        const int k = i + GONE;
        const int segments = i == 0 ? 0 : k % 3 == 2 ? 2 : 1;
        int32_t sum[3];
        TEST_ASSERT_EQUAL_INT(8 * k, w.imu.own.rest[i].bias[0]);
        TEST_ASSERT_EQUAL_INT(5 + 16 * k, w.imu.own.rest[i].when);
        TEST_ASSERT_EQUAL_INT(i == 0 ? -INVCAL_TOO_FEW : segments, w.imu.own.rest[i].move);
        sum_of_move(at, at + (unsigned)segments, sum);
        if (i > 0) {
            TEST_ASSERT_EQUAL_INT(2 * (k - 1), sum[0]);
            TEST_ASSERT_INT_WITHIN(1, k % 3 * 10866, sum[1]); /* 19 degrees */
            TEST_ASSERT_EQUAL_INT(8 * k, sum[2]);
            TEST_ASSERT_EQUAL_INT((BEFORE + 1) * EXACT_BLOCK + k % 3,
                                  samples_of_move(at, at + (unsigned)segments));
        }
        at += (unsigned)segments;
    }
    TEST_ASSERT_EQUAL_UINT(at, w.imu.own.first);
}

/* A sample of 6 degrees closes a segment; neighbours are merged up to 20 degrees, on any axis. */
static void segments_have_at_most_twenty_degrees(void)
{
    begin_exactly();
    for (int a = 0; a < 3; a++) {
        const int32_t nearly = angle(5.95), beyond = angle(6.05);
        feed(a == 0 ? nearly : 0, a == 1 ? nearly : 0, a == 2 ? nearly : 0);
        TEST_ASSERT_EQUAL_INT(1, w.imu.own.missing);
        invcal_imu_gap(&w.imu);
        feed(a == 0 ? -beyond : 0, a == 1 ? -beyond : 0, a == 2 ? -beyond : 0);
        TEST_ASSERT_EQUAL_INT(0, w.imu.own.missing);
    }
    for (int i = 0; i < 6; i++) {
        const int32_t each = angle(i % 2 ? 4.98 : 5.02); /* four of them: 19.92, 20.08 */
        begin_exactly();
        rest_exactly(0, 0, 0);
        leave_exactly();
        for (int k = 0; k < 12; k++) {
            feed(i / 2 == 0 ? each : 0, i / 2 == 1 ? each : 0, i / 2 == 2 ? each : 0);
            end_block(INVCAL_MOVING, 0);
        }
        rest_exactly(0, 0, 0);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(i % 2 ? 3 : 4, w.imu.own.rest[1].move);
        TEST_ASSERT_EQUAL_INT(BEFORE_FIRST * EXACT_BLOCK + 12, samples_of_move(0, w.imu.own.first));
    }
}

/* To the nearest 2^-15 rad; what is rounded off begins the next segment, and 1 rad is too much. */
static void a_segment_is_rounded_to_the_nearest(void)
{
    static const struct {
        int32_t counts; /* 64 are one */
        int v;          /* INT16_MIN: refused */
    } cases[] = {{33, 1},
                 {31, 0},
                 {-31, 0},
                 {-33, -1},
                 {INT32_C(64) * 5000 + 31, 5000},
                 {INT32_C(64) * 5000 + 33, 5001},
                 {INT32_C(-64) * 5000 - 31, -5000},
                 {INT32_C(-64) * 5000 - 33, -5001},
                 {INT32_C(64) * 32766 + 31, 32766},
                 {INT32_C(-64) * 32766 - 31, -32766},
                 {INT32_C(64) * 32767 + 1, INT16_MIN},
                 {INT32_C(-64) * 32767 - 1, INT16_MIN}};

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (int a = 0; a < 3; a++) {
            const invcal_private_segment *s = w.imu.own.segment;
            const int32_t x = cases[i].counts;
            const int is_refused = cases[i].v == INT16_MIN;
            begin_exactly();
            feed(a == 0 ? x : 0, a == 1 ? x : 0, a == 2 ? x : 0);
            const int is_small = w.imu.own.missing > 0; /* closed by the block */
            if (is_small) {
                end_block(INVCAL_MOVING, 0);
            }
            TEST_ASSERT_EQUAL_INT(1, w.imu.own.used);
            TEST_ASSERT_EQUAL_INT(2 + is_small, s->time);
            TEST_ASSERT_EQUAL_INT(is_small, cases[i].v > -2 && cases[i].v < 2);
            TEST_ASSERT_EQUAL_INT(is_refused ? INT16_MIN : a == 0 ? cases[i].v : 0, s->v[0]);
            TEST_ASSERT_EQUAL_INT(is_refused ? INVCAL_MOUNTING : 0, s->kappa[0]);
            TEST_ASSERT_TRUE(is_refused || s->v[a] == cases[i].v);
            const double rest = is_refused ? 0 : x / 64.0 - cases[i].v;
            TEST_ASSERT_TRUE((double)w.imu.own.v[a] * 32768 == rest);
            TEST_ASSERT_TRUE((double)w.imu.own.rho[a] * 32768 == rest);
        }
    }
}

/* rho, then th, by the series of mathematics_imu.md. */
static void add_rotation(double rho[3], const double th[3])
{
    const double dot = rho[0] * th[0] + rho[1] * th[1] + rho[2] * th[2];
    double a[3], d[3];

    for (int i = 0; i < 3; i++) {
        a[i] = rho[(i + 1) % 3] * th[(i + 2) % 3] - rho[(i + 2) % 3] * th[(i + 1) % 3];
        d[i] = rho[i] - th[i];
    }
    for (int i = 0; i < 3; i++) {
        rho[i] += th[i] + (0.5 + dot / 24) * a[i] +
                  (d[(i + 1) % 3] * a[(i + 2) % 3] - d[(i + 2) % 3] * a[(i + 1) % 3]) / 12;
    }
}

static const double stirred[][3] = {
    {0.08, 0.05, 0}, {-0.12, 0, 0.05}, {0.05, -0.1, -0.06}, {0.04, 0.09, -0.05}};

/* One sample of stirred. */
static void stir(int n, double th[3])
{
    int32_t raw[3];

    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)lround(stirred[n][i] * 262144 * (double)EXACT_RATE);
        th[i] = raw[i] / 262144.0 / (double)EXACT_RATE;
    }
    invcal_imu_feed_gyro(&w.imu, raw[0], raw[1], raw[2]);
}

static void rotations_are_added_by_the_series(void)
{
    double rho[3] = {0, 0, 0};
    double th[3];

    begin_exactly();
    for (int n = 0; n < 4; n++) {
        stir(n, th);
        add_rotation(rho, th);
        TEST_ASSERT_EQUAL_INT(n + 1, w.imu.own.missing);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(3e-8, rho[i], (double)w.imu.own.rho[i]);
        }
    }
}

/* Two blocks, each of a rotation and its coning, and their sum: to a unit or two of rounding. */
static void segments_are_merged_by_the_series(void)
{
    static const int order[] = {0, 1, -1, 3, 2, -1};
    const invcal_private_segment *s = w.imu.own.segment;
    double v[3] = {0, 0, 0};
    double rho[3] = {0, 0, 0};
    double of_block[3] = {0, 0, 0};

    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    for (int n = 0; n < 6; n++) {
        double th[3];
        if (order[n] < 0) {
            end_block(INVCAL_MOVING, 0);
            add_rotation(rho, of_block);
            memset(of_block, 0, sizeof of_block);
            continue;
        }
        stir(order[n], th);
        add_rotation(of_block, th);
        for (int i = 0; i < 3; i++) {
            v[i] += th[i];
        }
    }
    rest_exactly(0, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(1, w.imu.own.rest[1].move);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1, v[i] * 32768, s->v[i]);
        TEST_ASSERT_DOUBLE_WITHIN(5, rho[i] * 262144, s->v[i] * 8.0 + s->kappa[i]);
    }
}

/* 127 segments are a move, and 24 of all are kept for the next. */
static void a_move_and_the_table_have_so_many_segments(void)
{
    const int space = INVCAL_MAX_SEGMENTS - 24 - 1; /* one for the end, before it is merged */

    for (int more = 0; more < 2; more++) {
        begin_at(64);
        rest_exactly(0, 0, 0);
        leave_exactly();
        large_turns(127 + more);
        block(0, 0, 0, INVCAL_MOVING, 0);
        rest_exactly(0, 0, 0);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(more ? -INVCAL_MOUNTING : 127, w.imu.own.rest[1].move);
        begin_at(64);
        rest_exactly(0, 0, 0);
        leave_exactly();
        for (int left = space + more; left > 0; left -= 16) {
            large_turns(left < 16 ? left : 16);
            block(0, 0, 0, INVCAL_MOVING, 0);
            rest_exactly(0, 0, 0);
            leave_exactly();
        }
        const unsigned last = w.imu.rests - 1u;
        TEST_ASSERT_EQUAL_INT(more ? INVCAL_NO_SPACE : INVCAL_OK,
                              invcal_imu_move_reason(&w.imu, last));
        TEST_ASSERT_EQUAL_INT(more ? (space + more - 1) / 16 * 16 : space, w.imu.own.first);
        for (unsigned i = 1; i < last; i++) {
            TEST_ASSERT_EQUAL_INT(16, w.imu.own.rest[i].move);
        }
    }
}

/* More than the table holds before any of it is settled: the move is refused, but neither its rests
 * nor the next move. */
static void a_full_table_costs_the_current_move(void)
{
    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    block(0, 0, 0, INVCAL_MOVING, 0);
    large_turns(INVCAL_MAX_SEGMENTS + 10);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_SEGMENTS, w.imu.own.used);
    TEST_ASSERT_EQUAL_INT(0, w.imu.own.marks);
    block(0, 0, 0, INVCAL_MOVING, 0);
    for (int i = 0; i < 10; i++) { /* nine blocks fall out of the table */
        block(16, 0, 0, INVCAL_SETTLING, 1);
    }
    rest_exactly(16, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(16, w.imu.own.rest[1].bias[0]);
    block(0, 80, 0, INVCAL_MOVING, 0);
    rest_exactly(8, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(1, w.imu.own.rest[2].move);
    TEST_ASSERT_EQUAL_INT((BEFORE + 1) * EXACT_BLOCK, samples_of_move(0, w.imu.own.first));
    TEST_ASSERT_EQUAL_INT(10, w.imu.own.segment[0].v[1]);
    TEST_ASSERT_EQUAL_INT(8, w.imu.own.rest[2].bias[0]);
}

/* The same where a rest lies among them: the moves on both sides. */
static void a_full_table_costs_both_moves_in_it(void)
{
    enum { HALF = INVCAL_MAX_SEGMENTS / 2 + 4 };

    begin_at(64);
    rest_exactly(0, 0, 0);
    leave_exactly();
    large_turns(HALF);
    block(0, 0, 0, INVCAL_MOVING, 0);
    for (int i = 0; i < 3; i++) {
        block(0, 0, 0, INVCAL_SETTLING, 1);
    }
    large_turns(HALF);
    block(0, 0, 0, INVCAL_MOVING, 0);
    block(0, 0, 0, INVCAL_TAKEN, 0);
    w.imu.session.rests.pended = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_imu_move_reason(&w.imu, 1));
    rest_exactly(0, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_imu_move_reason(&w.imu, 2));
}

/* As a session may be resumed: with full tables. */
static void a_table_of_complete_moves_stays(void)
{
    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    memset(w.imu.own.segment, 0x11, sizeof w.imu.own.segment);
    w.imu.own.first = w.imu.own.fixed = w.imu.own.used = INVCAL_MAX_SEGMENTS;
    w.imu.own.marks = 0;
    large_turns(3);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_SEGMENTS, w.imu.own.used);
    rest_exactly(0, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_SEGMENTS, w.imu.own.first);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_SEGMENTS, w.imu.own.used);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x11, w.imu.own.segment, sizeof w.imu.own.segment);
    TEST_ASSERT_TRUE(w.imu.own.rest[1].move < 0);
}

/* A reading at a rail, on any axis; the first reason is reported. */
static void a_rail_is_a_reading_that_clips(void)
{
    for (int i = 0; i < 12; i++) {
        const int32_t x = (i / 6 ? 2000 : -1000) + (i / 3 % 2 ? 0 : i / 6 ? -1 : 1);
        begin_exactly();
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_set_limits(&w.imu, -1000, 2000));
        rest_exactly(0, 0, 0);
        leave_exactly();
        feed(i % 3 == 0 ? x : 0, i % 3 == 1 ? x : 0, i % 3 == 2 ? x : 0);
        block(0, 0, 0, INVCAL_MOVING, 0);
        if (i / 3 % 2) {
            invcal_imu_gap(&w.imu);
        }
        rest_exactly(0, 0, 0);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(i / 3 % 2 ? INVCAL_REST_CLIPPED : INVCAL_OK,
                              invcal_imu_move_reason(&w.imu, 1));
    }
}

/* Samples lost in a rest: the move to it is refused, its bias is that of the others, and the next
 * move is good. */
static void a_gap_in_a_rest_costs_the_move_before(void)
{
    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    block(24 + 64, 0, 0, INVCAL_SETTLING, 1);
    for (int i = 0; i < 3; i++) {
        block(24, 0, 0, INVCAL_SETTLING, 1);
    }
    feed(1000, 1000, 1000);
    invcal_imu_gap(&w.imu);
    for (int i = 0; i < 5; i++) {
        block(24, 0, 0, INVCAL_SETTLING, 1);
    }
    block(24, 0, 0, INVCAL_READY, 1);
    leave_exactly();
    rest_exactly(16, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(24 + 64 / 8, w.imu.own.rest[1].bias[0]);
    TEST_ASSERT_EQUAL_INT(1, w.imu.own.rest[2].move);
    TEST_ASSERT_EQUAL_INT(BEFORE * EXACT_BLOCK, samples_of_move(0, w.imu.own.first));
}

/* The move continues across it. */
static void a_refused_rest_ends_no_move(void)
{
    int32_t sum[3];

    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    for (int i = 0; i < 6; i++) {
        feed(0, 64, 0);
        end_block(INVCAL_SETTLING, 1);
    }
    for (int i = 0; i < 8; i++) {
        feed(0, 0, 64);
        end_block(i == 4 ? INVCAL_REFUSED : INVCAL_MOVING, 0);
        w.imu.session.rests.pended = i >= 4 ? 0 : w.imu.session.rests.pended;
    }
    rest_exactly(16, 0, 0);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_move_reason(&w.imu, 1));
    TEST_ASSERT_EQUAL_INT(BEFORE_FIRST * EXACT_BLOCK + 14, samples_of_move(0, w.imu.own.first));
    sum_of_move(0, w.imu.own.first, sum);
    TEST_ASSERT_TRUE(sum[0] == 0 && sum[1] == 6 && sum[2] == 8);
    TEST_ASSERT_EQUAL_INT(16, w.imu.own.rest[1].bias[0]);
    TEST_ASSERT_EQUAL_INT(0, w.imu.own.rest[1].bias[1]);
}

/* Eight blocks stay separate; no event means no block, and time stops at 65535. */
static void blocks_are_counted_as_far_as_they_can(void)
{
    begin_exactly();
    rest_exactly(0, 0, 0);
    TEST_ASSERT_EQUAL_INT(0, w.imu.own.blocks); /* waiting for the first rest does not count */
    begin_exactly();
    for (int i = 1; i < 12; i++) {
        block(0, 0, 0, INVCAL_MOVING, 0);
        TEST_ASSERT_EQUAL_INT(i, w.imu.own.blocks);
        TEST_ASSERT_EQUAL_INT(i < 8 ? i : 8, w.imu.own.marks);
        TEST_ASSERT_EQUAL_INT(i < 8 ? i : 8, w.imu.own.used - w.imu.own.fixed);
    }
    w.imu.own.blocks = 65533;
    for (int i = 0; i < 4; i++) {
        block(0, 0, 0, INVCAL_MOVING, 0);
        TEST_ASSERT_EQUAL_UINT(i == 0 ? 65534 : 65535, w.imu.own.blocks);
    }
}

/* More than 2^15 times the unit of a bias, 7 degrees/s: not that of any rest. */
static void a_bias_that_does_not_fit_is_a_turn(void)
{
    for (int32_t rate = 32000; rate <= 34000; rate += 2000) {
        begin_exactly();
        rest_exactly(0, 0, 0);
        leave_exactly();
        w.imu.own.rest[0].bias[2] = 32000;
        rest_exactly(0, 0, rate);
        leave_exactly();
        TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
        TEST_ASSERT_EQUAL_INT(rate < 32767 ? INVCAL_OK : INVCAL_REST_DRIFT,
                              invcal_imu_move_reason(&w.imu, 1));
    }
    begin_exactly();
    rest_exactly(0, 0, 0);
    leave_exactly();
    rest_exactly(0, 0, -34000);
    leave_exactly();
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, invcal_imu_move_reason(&w.imu, 1));
}

/* Events that no detector produces: a rest without a sample has no bias, but is still a rest. */
static void a_rest_without_samples_has_no_bias(void)
{
    begin_exactly();
    w.imu.session.rests.pended = 0;
    memset(w.imu.own.rest, 0x55, sizeof w.imu.own.rest);
    end_block(INVCAL_TAKEN, 0);
    TEST_ASSERT_EQUAL_INT(1, w.imu.rests);
    for (int a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT(0, w.imu.own.rest[0].bias[a]);
    }
    end_block(INVCAL_TAKEN, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&w.imu, 1));
    invcal_imu_gap(&w.imu);
    rest_exactly(0, 0, 0);
    leave_exactly();
    end_block(INVCAL_TAKEN, 0); /* nothing is between them */
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&w.imu, 3));
}

/* One sample is enough. */
static void a_sample_is_a_bias(void)
{
    begin_exactly();
    feed(128, -64, 0);
    end_block(INVCAL_SETTLING, 1);
    end_block(INVCAL_SETTLING, 1);
    end_block(INVCAL_READY, 1);
    TEST_ASSERT_TRUE(w.imu.own.bias[0] * 262144 == 128 && w.imu.own.bias[1] * 262144 == -64 &&
                     w.imu.own.bias[2] == 0);
}

/* ---- the detector itself, and every sample of both ---------------------------------------------- */

enum {
    FAST = SLOW(400, 200),
    TURNING = FAST * 6 / 5,
    RESTING = FAST * 5 / 2
}; /* samples of the gyroscope: per second; of a turn; of a rest */

/* Feeds what the gyroscope reads of a step. */
static void feed_rate(const double step[3], random_source *random)
{
    double inverse[3][3];
    int32_t raw[3];

    inverse3((const double(*)[3])w.m, inverse);
    for (int i = 0; i < 3; i++) {
        const double rate = (double)FAST * (inverse[i][0] * step[0] + inverse[i][1] * step[1] +
                                            inverse[i][2] * step[2]);
        raw[i] = (int32_t)lround(COUNTS * (0.02 + rate + 1e-3 * random_normal(random)));
    }
    invcal_imu_feed_gyro(&w.imu, raw[0], raw[1], raw[2]);
}

/* Feeds what the accelerometer reads. Returns 1 if that took a position. */
static int feed_up(const double up[3], random_source *random)
{
    double u[3];
    int32_t raw[3];

    triad_read(&w.triad, up, u);
    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)lround(16384 * u[i] + 20 * random_normal(random));
    }
    return invcal_imu_feed(&w.imu, raw[0], raw[1], raw[2]) == INVCAL_TAKEN;
}

/* Turns by that many degrees about each axis, and rests. Returns how many positions were taken. */
static int turn_and_rest(const double degrees[3], random_source *random)
{
    double up[3];
    int taken = 0;

    world_unit(w.c);
    for (int n = 0; n < TURNING + RESTING; n++) {
        double step[3] = {0};
        if (n < TURNING) {
            const double tau = (n + 0.5) / (double)TURNING;
            double r[3][3];
            for (int i = 0; i < 3; i++) {
                step[i] =
                    degrees[i] * DEGREE * 30 * tau * tau * (1 - tau) * (1 - tau) / (double)TURNING;
            }
            rotation_by(step, r);
            world_turn(w.c, (const double(*)[3])r);
        }
        feed_rate(step, random);
        if (n % 4 == 3) {
            world_up((const double(*)[3])w.c, w.up, up);
            taken += feed_up(up, random);
        }
    }
    memcpy(w.up, up, sizeof up);
    return taken;
}

static void the_session_says_where_rests_are(void)
{
    static const double turns[][3] = {{90, 0, 0}, {0, 0, 90}, {0, 90, 0}};
    invcal_session *session = &w.imu.session;
    random_source random = random_start(3);

    begin();
    world_draw(&w, 0.02, 0.02);
    const invcal_calibration gyro = w.imu.nominal;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_session_init(session, sizeof *session, 16384, FAST / 4));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init_nominal(&w.imu, sizeof w.imu, &gyro, FAST));
    int taken = turn_and_rest(none, &random);
    for (int k = 0; k < 13; k++) {
        taken += turn_and_rest(turns[k / 5], &random);
    }
    const invcal_event event = invcal_session_end(session);
    invcali_imu_follow(&w.imu, event);
    taken += event == INVCAL_TAKEN;
    TEST_ASSERT_EQUAL_INT(taken, session->count);
    TEST_ASSERT_EQUAL_INT(session->count, w.imu.rests);
    TEST_ASSERT_TRUE(session->count >= 10);
    const invcal_positions positions = invcali_imu_positions(&w.imu);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve_of(&w, &positions, NULL, &imu));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
        TEST_ASSERT_TRUE(imu.sigma[i] < INVCAL_REAL(1e-3));
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0.02, (double)imu.result.gyro.offset[0] / COUNTS);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_move_keeps_its_angle_and_rests_their_bias);
    RUN_TEST(lost_samples_spoil_only_one_move);
    RUN_SLOW_TEST(a_clipped_or_a_long_move_is_refused);
    RUN_TEST(a_rest_that_turns_is_not_a_rest);
    RUN_SLOW_TEST(without_space_moves_are_refused_and_rests_continue);
    RUN_TEST(what_was_not_begun_refuses_every_sample_and_says_why);
    RUN_TEST(a_session_alone_is_not_enough);
    RUN_TEST(moves_need_a_session);
    RUN_TEST(another_build_is_refused_and_the_session_says_why);
    RUN_TEST(nonsense_is_refused_or_does_no_harm);
    RUN_TEST(a_move_of_more_than_seven_turns_is_refused);
    RUN_TEST(stirring_fills_a_segment);
    RUN_TEST(a_segment_counts_no_more_than_it_can);
    RUN_TEST(events_out_of_order_do_no_harm);
    RUN_TEST(a_move_is_what_lies_between_two_rests);
    RUN_TEST(a_bias_may_change_by_half_a_degree);
    RUN_TEST(the_oldest_moves_go_with_their_segments);
    RUN_TEST(segments_have_at_most_twenty_degrees);
    RUN_TEST(a_segment_is_rounded_to_the_nearest);
    RUN_TEST(rotations_are_added_by_the_series);
    RUN_TEST(a_move_and_the_table_have_so_many_segments);
    RUN_TEST(a_full_table_costs_the_current_move);
    RUN_TEST(a_rail_is_a_reading_that_clips);
    RUN_TEST(a_gap_in_a_rest_costs_the_move_before);
    RUN_TEST(a_refused_rest_ends_no_move);
    RUN_TEST(blocks_are_counted_as_far_as_they_can);
    RUN_TEST(a_bias_that_does_not_fit_is_a_turn);
    RUN_TEST(a_rest_without_samples_has_no_bias);
    RUN_TEST(segments_are_merged_by_the_series);
    RUN_TEST(a_full_table_costs_both_moves_in_it);
    RUN_TEST(a_table_of_complete_moves_stays);
    RUN_TEST(a_sample_is_a_bias);
    RUN_TEST(the_session_says_where_rests_are);
    return UNITY_END();
}
