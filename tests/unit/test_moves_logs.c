/* SPDX-License-Identifier: MIT
 *
 * Moves of real logs, as moves.c kept them, against solutions from all samples.
 */
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
    RUN_TEST(xsens_is_as_the_solution_from_all_samples);
    RUN_TEST(mpu_is_as_the_batch);
    RUN_TEST(mpu_leaves_out_what_turned);
    return UNITY_END();
}
