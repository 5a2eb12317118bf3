/* SPDX-License-Identifier: MIT
 *
 * Moves of real logs, as moves.c kept them, against solutions from all samples (gyro_samples.h).
 */
#include <string.h>

#include "gyro_world.h"
#include "gyro_logs.h"
#include "gyro_samples.h"
#include "invcal/result.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static world w;
static world_solution imu;
static invcal_calibration data_sheet; /* of the accelerometer */

#define LOAD(name, zero, acceleration, rate)                                                       \
    load(name##_mean, sizeof name##_mean / sizeof name##_mean[0], name##_rest,                     \
         sizeof name##_rest / sizeof name##_rest[0], name##_segment, sizeof name##_segment, zero,  \
         acceleration, rate)

static invcal_status load(const double mean[][3], unsigned means, const invcal_private_still *rest,
                          unsigned rests, const invcal_private_segment *segment, size_t bytes,
                          double zero, double acceleration, double rate)
{
    invcal_calibration nominal = unit_nominal();
    invcal_real raw[WORLD_RESTS][3];

    for (int i = 0; i < 3; i++) {
        nominal.offset[i] = (invcal_real)zero;
        nominal.matrix[i][i] = (invcal_real)rate;
    }
    world_begin(&w, 100, 1);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init_nominal(&w.imu, sizeof w.imu, &nominal, 100));
    TEST_ASSERT_TRUE(bytes <= sizeof w.imu.own.segment && rests <= INVCAL_MAX_MOVES);
    memcpy(w.imu.own.segment, segment, bytes);
    memcpy(w.imu.own.rest, rest, rests * sizeof *rest);
    w.imu.rests = (uint8_t)rests;
    w.imu.own.first = w.imu.own.fixed = w.imu.own.used = (uint16_t)(bytes / sizeof *segment);
    data_sheet = nominal;
    for (int i = 0; i < 3; i++) {
        data_sheet.matrix[i][i] = (invcal_real)acceleration;
    }
    w.count = (int)means;
    memcpy(w.mean, mean, means * sizeof mean[0]);
    const invcal_positions positions = world_positions(&w, raw, &data_sheet);
    return world_solve_of(&w, &positions, NULL, &imu);
}

static void expect_both(const double gyro[9], double within, const double accelerometer[9])
{
    invcal_real x[INVCAL_PARAMETERS];

    invcal_deviation(&imu.result.accelerometer, &data_sheet, x);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(within, gyro[i], (double)imu.parameter[i]);
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, accelerometer[i], (double)x[i]);
    }
}

/* Those solutions take the means of the two rests for the bias of a move. A fit to all rests leaves less. */
static void xsens_agrees_with_the_solution_from_all_samples(void)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(xsens, 32768, 1 / (414.4 * 9.81744), 1 / 4772.0));
    TEST_ASSERT_EQUAL_INT(15, imu.result.moves);
    TEST_ASSERT_TRUE((double)imu.result.move_rms < 0.95 * xsens_residual);
    TEST_ASSERT_EQUAL_INT(1, imu.result.g_is_used);
    expect_both(xsens_gyro, 0.001, xsens_accelerometer);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.006 * DEGREE, xsens_slope[i] * DEGREE,
                                  (double)imu.result.slope[i / 3][i % 3]);
    }
}

/* An MPU-9150 with the rests that its authors took. */
static void mpu_agrees_with_the_solution_from_all_samples(void)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(mpu0, 0, 1 / 16384.0, DEGREE / 131));
    TEST_ASSERT_EQUAL_INT(21, imu.result.moves);
    TEST_ASSERT_TRUE((double)imu.result.move_rms < 0.9 * mpu_residual);
    TEST_ASSERT_EQUAL_HEX32(0, imu.result.left_out);
    TEST_ASSERT_EQUAL_INT(0, imu.result.g_is_used);
    expect_both(mpu_gyro, 0.0015, mpu_accelerometer);
}

/* Another one, with the session's own rests; in two of them it was turned about the vertical: moves
 * to and from these are refused, and the move to a bad one is left out. */
static void mpu_leaves_out_what_turned(void)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, LOAD(mpu1, 0, 1 / 16384.0, DEGREE / 131));
    TEST_ASSERT_EQUAL_INT(15, imu.result.moves);
    for (unsigned i = 1; i < w.imu.rests; i++) {
        const int is_bad = i == 3 || i == 4 || i == 11 || i == 12;
        TEST_ASSERT_EQUAL_INT(is_bad ? INVCAL_REST_DRIFT : INVCAL_OK,
                              invcal_imu_move_reason(&w.imu, i));
    }
    TEST_ASSERT_EQUAL_HEX32(1u << 6, imu.result.left_out);
    TEST_ASSERT_TRUE(imu.result.move_rms < INVCAL_REAL(1.8e-3));
    TEST_ASSERT_EQUAL_INT(0, imu.result.g_is_used);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(xsens_agrees_with_the_solution_from_all_samples);
    RUN_TEST(mpu_agrees_with_the_solution_from_all_samples);
    RUN_TEST(mpu_leaves_out_what_turned);
    return UNITY_END();
}
