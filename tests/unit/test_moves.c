/* SPDX-License-Identifier: MIT
 *
 * Moves out of a stream: what is kept, what is refused and why; with the session's own rests; and real logs.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "gyro_logs.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static world w;
static invcal_imu imu;
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
    world_rest(&w, 20); /* goes on */
    w.count--;
    quarter(1);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(3, w.moves.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_moves_reason(&w.moves, 0));
    const invcal_segment *s = w.moves.segment;
    for (unsigned i = 1; i < 3; i++) {
        double angle[3] = {0, 0, 0};
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, i));
        TEST_ASSERT_TRUE(w.moves.rest[i].move >= 5 && w.moves.rest[i].move <= 8);
        for (int k = 0; k < w.moves.rest[i].move; k++) {
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
            TEST_ASSERT_DOUBLE_WITHIN(2e-5, w.bias[a],
                                      (double)w.moves.bias[a] + w.moves.rest[i].bias[a] / 262144.0);
        }
    }
}

static invcal_status reason_of(unsigned rest)
{
    world_end(&w);
    return rest < w.moves.count ? invcal_moves_reason(&w.moves, rest) : INVCAL_STATUS_COUNT;
}

static void lost_samples_spoil_a_move_and_no_more(void)
{
    begin();
    world_rest(&w, 1.5);
    quarter(1);
    for (int i = 0; i < 50; i++) {
        world_sample(&w, none, 0);
    }
    invcal_moves_gap(&w.moves);
    quarter(1);
    quarter(1);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, reason_of(3));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_moves_reason(&w.moves, 2));
}

static void a_clipped_or_a_long_move_is_refused(void)
{
    begin();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_rails(&w.moves, -150000, 150000)); /* 1.5 rad/s */
    world_rest(&w, 1.5);
    quarter(3);
    quarter(1);
    quarter(3);
    quarter(12);
    quarter(3);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, reason_of(5));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_CLIPPED, invcal_moves_reason(&w.moves, 2));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 3));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_LONG, invcal_moves_reason(&w.moves, 4));
}

/* A device that turns slowly where it should rest: the moves on both sides are of no use. */
static void a_rest_that_turns_is_no_rest(void)
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
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, invcal_moves_reason(&w.moves, 2));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, invcal_moves_reason(&w.moves, 3));
}

/* The table of segments is full: what is there stays, and biases are right all the same. */
static void without_room_moves_are_refused_and_rests_go_on(void)
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
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.moves.count);
    TEST_ASSERT_TRUE(w.moves.used <= INVCAL_MAX_SEGMENTS);
    int refused = 0;
    for (unsigned i = 1; i < w.moves.count; i++) {
        const invcal_status status = invcal_moves_reason(&w.moves, i);
        TEST_ASSERT_TRUE(status == INVCAL_OK || status == INVCAL_NO_SPACE);
        refused += status == INVCAL_NO_SPACE;
        TEST_ASSERT_DOUBLE_WITHIN(2e-5, 0.1,
                                  (double)w.moves.bias[0] + w.moves.rest[i].bias[0] / 262144.0);
    }
    TEST_ASSERT_TRUE(refused > 0 && refused < 20);
}

static void nonsense_is_refused_or_does_no_harm(void)
{
    const int32_t ends[3] = {INT32_MIN, INT32_MAX, INT32_MIN};
    invcal_calibration nominal = unit_nominal();
    invcal_moves untouched;

    begin();
    untouched = w.moves;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_moves_init(&w.moves, &nominal, 7));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_moves_init(&w.moves, &nominal, (invcal_real)NAN));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE,
                          invcal_moves_init(&w.moves, &nominal, (invcal_real)INFINITY));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_moves_init(&w.moves, &nominal, 8001));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RAILS, invcal_moves_rails(&w.moves, 5, 5));
    nominal.matrix[0][0] = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_moves_init(&w.moves, &nominal, 100));
    TEST_ASSERT_EQUAL_MEMORY(&untouched, &w.moves, sizeof untouched);
    nominal = unit_nominal();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_init(&w.moves, &nominal, 100));
    world_rest(&w, 1.5);
    for (int i = 0; i < 1000; i++) {
        invcal_moves_feed(&w.moves, ends);
        world_sample(&w, none, 0);
    }
    world_rest(&w, 1.5);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(2, w.moves.count);
    TEST_ASSERT_TRUE(invcal_moves_reason(&w.moves, 1) != INVCAL_OK);
}

/* ---- blocks by hand ----------------------------------------------------------------------------- */

static void turn_on(double x, double y, double z, int samples)
{
    const int32_t raw[3] = {(int32_t)(x * COUNTS), (int32_t)(y * COUNTS), (int32_t)(z * COUNTS)};

    for (int i = 0; i < samples; i++) {
        invcal_moves_feed(&w.moves, raw);
    }
}

static void blocks(int count, invcal_event event, int is_quiet)
{
    for (int i = 0; i < count; i++) {
        turn_on(0, 0, 0, WORLD_BLOCK);
        w.rests.begin = w.rests.pended > 0 ? w.rests.begin : w.rests.time;
        w.rests.time += WORLD_BLOCK;
        w.rests.pended = is_quiet ? 2 : w.rests.pended;
        w.rests.end = is_quiet ? w.rests.time : w.rests.end;
        invcal_moves_follow(&w.moves, &w.rests, event);
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
    w.rests.pended = 0;
}

/* Seven turns and more take more segments than a move has. */
static void a_move_of_eight_turns_is_refused(void)
{
    begin();
    rest_by_hand();
    leave_by_hand();
    for (int i = 0; i < 28; i++) { /* 19 degrees a sample, and so each a segment */
        turn_on(33.2, 0, 0, 5);
        blocks(1, INVCAL_MOVING, 0);
    }
    rest_by_hand();
    leave_by_hand();
    TEST_ASSERT_EQUAL_INT(2, w.moves.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOUNTING, invcal_moves_reason(&w.moves, 1));
}

/* A device that is stirred goes nowhere, but turns: what that adds up to does not fit one segment. */
static void stirring_fills_a_segment(void)
{
    unsigned segments = 0;

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
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 1));
    segments = (unsigned)w.moves.rest[1].move;
    TEST_ASSERT_TRUE(segments >= 3 && segments <= 10);
    double angle = 0;
    for (unsigned k = 0; k < segments; k++) {
        angle += (w.moves.segment[k].v[2] / 32768.0) + (w.moves.segment[k].kappa[2] / 262144.0);
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-3, 40 * 0.09 * 0.09, angle); /* the area that was gone around */
}

/* 8000 samples a second: segments and blocks of as many as they can count. */
static void a_segment_counts_no_more_than_it_can(void)
{
    const invcal_calibration gyro = (begin(), w.moves.nominal);
    unsigned samples = 0;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_init(&w.moves, &gyro, 8000));
    rest_by_hand();
    leave_by_hand();
    for (int i = 0; i < 3; i++) {
        turn_on(0, 0, 0, 20000);
        blocks(1, INVCAL_MOVING, 0);
    }
    rest_by_hand();
    leave_by_hand();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_reason(&w.moves, 1));
    for (int k = 0; k < w.moves.rest[1].move; k++) {
        samples += w.moves.segment[k].time / 2u;
    }
    TEST_ASSERT_TRUE(samples >= 60000 && samples < 60300);
    turn_on(0, 0, 0, 40000); /* without a block */
    TEST_ASSERT_TRUE(w.moves.missing < 7300);
}

/* Events that no detector brings about in that order do no harm. */
static void events_out_of_order_do_no_harm(void)
{
    begin();
    w.rests.pended = 0;
    blocks(1, INVCAL_READY, 0);
    blocks(1, INVCAL_TAKEN, 0);
    TEST_ASSERT_EQUAL_INT(1, w.moves.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_moves_reason(&w.moves, 0));
    for (int i = 0; i < INVCAL_MAX_MOVES + 2; i++) { /* no move is of any use, and the oldest go */
        invcal_moves_gap(&w.moves);
        rest_by_hand();
        leave_by_hand();
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.moves.count);
    TEST_ASSERT_EQUAL_INT(0, w.moves.first);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_moves_reason(&w.moves, 0));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_moves_reason(&w.moves, 1));
}

/* The detector itself, and another rate of the gyroscope: every sample of both. */
static void the_session_says_where_rests_are(void)
{
    static invcal_session session;
    random_source random = random_start(3);
    invcal_event event;
    int taken = 0;

    begin();
    world_draw(&w, 0.02, 0.02);
    (void)invcal_session_init(&session, 16384, 100);
    static const double turns[][3] = {{90, 0, 0}, {0, 0, 90}, {0, 90, 0}};
    for (unsigned k = 0; k < 14; k++) {
        const double *turn = turns[(k + 4) / 5 % 3 == 0 ? 2 : (k + 4) / 5 % 3 - 1];
        const int samples = k == 0 ? 0 : 480; /* of the gyroscope, at 400 Hz */
        double step[3], r[3][3], up[3], u[3], nominal[3], inverse[3][3];
        if (k == 0) {
            const invcal_calibration gyro = w.moves.nominal;
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_init(&w.moves, &gyro, 400));
        }
        world_unit(w.c);
        world_inverse((const double(*)[3])w.m, inverse);
        for (int n = 0; n < samples + 1000; n++) {
            const double tau = n < samples ? (n + 0.5) / samples : 0;
            int32_t raw[3];
            for (int i = 0; i < 3; i++) {
                step[i] = turn[i] * DEGREE * 30 * tau * tau * (1 - tau) * (1 - tau) / 480;
            }
            world_exp(step, r);
            world_turn(w.c, (const double(*)[3])r);
            for (int i = 0; i < 3; i++) {
                nominal[i] = 400 * (inverse[i][0] * step[0] + inverse[i][1] * step[1] +
                                    inverse[i][2] * step[2]);
                raw[i] =
                    (int32_t)lround(COUNTS * (0.02 + nominal[i] + 1e-3 * random_normal(&random)));
            }
            invcal_moves_feed(&w.moves, raw);
            if (n % 4 == 3) {
                world_up((const double(*)[3])w.c, w.up, up);
                triad_read(&w.triad, up, u);
                for (int i = 0; i < 3; i++) {
                    raw[i] = (int32_t)lround(16384 * u[i] + 20 * random_normal(&random));
                }
                event = invcal_session_feed(&session, raw);
                invcal_moves_follow(&w.moves, &session.rests, event);
                taken += event == INVCAL_TAKEN;
            }
        }
        memcpy(w.up, up, sizeof up);
    }
    event = invcal_session_finish(&session);
    invcal_moves_follow(&w.moves, &session.rests, event);
    taken += event == INVCAL_TAKEN;
    TEST_ASSERT_EQUAL_INT(taken, session.count);
    TEST_ASSERT_EQUAL_INT(session.count, w.moves.count);
    TEST_ASSERT_TRUE(session.count >= 10);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_solve(session.mean[0], session.count,
                                                      &session.nominal, &w.moves, NULL, &imu));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
        TEST_ASSERT_TRUE(imu.sigma[i] < INVCAL_REAL(1e-3));
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0.02, (double)imu.gyro.offset[0] / COUNTS);
}

/* ---- real logs ---------------------------------------------------------------------------------- */

#define LOAD(name, zero, acceleration, rate)                                                       \
    load(name##_mean, sizeof name##_mean / sizeof name##_mean[0], name##_rest,                     \
         sizeof name##_rest / sizeof name##_rest[0], name##_segment, sizeof name##_segment, zero,  \
         acceleration, rate)

static invcal_status load(const double mean[][3], unsigned means, const invcal_still *rest,
                          unsigned rests, const invcal_segment *segment, size_t bytes, double zero,
                          double acceleration, double rate)
{
    invcal_calibration nominal = unit_nominal();
    invcal_real raw[WORLD_RESTS][3];

    for (int i = 0; i < 3; i++) {
        nominal.offset[i] = (invcal_real)zero;
        nominal.matrix[i][i] = (invcal_real)rate;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_moves_init(&w.moves, &nominal, 100));
    TEST_ASSERT_TRUE(bytes <= sizeof w.moves.segment && rests <= INVCAL_MAX_MOVES);
    memcpy(w.moves.segment, segment, bytes);
    memcpy(w.moves.rest, rest, rests * sizeof *rest);
    w.moves.count = (uint8_t)rests;
    w.moves.first = w.moves.fixed = w.moves.used = (uint16_t)(bytes / sizeof *segment);
    for (unsigned i = 0; i < 3 * means; i++) {
        raw[i / 3][i % 3] = (invcal_real)mean[i / 3][i % 3];
    }
    for (int i = 0; i < 3; i++) {
        nominal.matrix[i][i] = (invcal_real)acceleration;
    }
    return invcal_imu_solve(raw[0], means, &nominal, &w.moves, NULL, &imu);
}

/* O12: against the joint solution of all 37 moves from their samples (gyro.md; real_xsens.txt), where G is
 * that of all 38 rests. */
static void xsens_is_as_the_solution_from_all_samples(void)
{
    /* inverse scales there 4780.3 4763.5 4763.4; here of 1/4772, without g-sensitivity there */
    static const double sample[3][3] = {
        {0.99953, 0.00734, 0.00588}, {0.00644, 1.00305, -0.04263}, {0.02009, -0.01239, 1.00307}};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(xsens, 32768, 1 / (414.4 * 9.81744), 1 / 4772.0));
    TEST_ASSERT_TRUE(imu.moves >= 12);
    TEST_ASSERT_TRUE(imu.move_rms < INVCAL_REAL(1.6e-3));
    TEST_ASSERT_EQUAL_INT(1, imu.g_is_used);
    TEST_ASSERT_DOUBLE_WITHIN(3 * (double)imu.slope_sigma[1][0] + 0.006 * DEGREE, -0.154 * DEGREE,
                              (double)imu.slope[1][0]);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.006, sample[i / 3][i % 3], (double)imu.parameter[i]);
    }
}

/* O13: an MPU-9150 with the rests that its authors took: 2.06 mrad of the batch with means of two rests, 1.8
 * with all rests. */
static void mpu_is_as_the_batch(void)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(mpu0, 0, 1 / 16384.0, DEGREE / 131));
    TEST_ASSERT_EQUAL_INT(21, imu.moves);
    TEST_ASSERT_TRUE(imu.move_rms < INVCAL_REAL(2.1e-3));
    TEST_ASSERT_EQUAL_HEX32(0, imu.left_out);
    TEST_ASSERT_EQUAL_INT(0, imu.g_is_used);
}

/* Another one, with the session's own rests, in two of which it was turned about the vertical: what leads there
 * and from there is refused, and the move to a bad one left out. */
static void mpu_leaves_out_what_turned(void)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(mpu1, 0, 1 / 16384.0, DEGREE / 131));
    TEST_ASSERT_EQUAL_INT(15, imu.moves);
    for (unsigned i = 1; i < w.moves.count; i++) {
        const int is_bad = i == 3 || i == 4 || i == 11 || i == 12;
        TEST_ASSERT_EQUAL_INT(is_bad ? INVCAL_REST_DRIFT : INVCAL_OK,
                              invcal_moves_reason(&w.moves, i));
    }
    TEST_ASSERT_EQUAL_HEX32(1u << 6, imu.left_out);
    TEST_ASSERT_TRUE(imu.move_rms < INVCAL_REAL(1.8e-3));
    TEST_ASSERT_EQUAL_INT(0, imu.g_is_used);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_move_keeps_its_angle_and_rests_their_bias);
    RUN_TEST(lost_samples_spoil_a_move_and_no_more);
    RUN_TEST(a_clipped_or_a_long_move_is_refused);
    RUN_TEST(a_rest_that_turns_is_no_rest);
    RUN_TEST(without_room_moves_are_refused_and_rests_go_on);
    RUN_TEST(nonsense_is_refused_or_does_no_harm);
    RUN_TEST(a_move_of_eight_turns_is_refused);
    RUN_TEST(stirring_fills_a_segment);
    RUN_TEST(a_segment_counts_no_more_than_it_can);
    RUN_TEST(events_out_of_order_do_no_harm);
    RUN_TEST(the_session_says_where_rests_are);
    RUN_TEST(xsens_is_as_the_solution_from_all_samples);
    RUN_TEST(mpu_is_as_the_batch);
    RUN_TEST(mpu_leaves_out_what_turned);
    return UNITY_END();
}
