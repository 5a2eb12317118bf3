/* SPDX-License-Identifier: MIT
 *
 * The smallest tables that hold twelve quarter turns, as gyro.h says for devices with little memory: compiled
 * here with that choice.
 */
#undef INVCAL_MAX_SEGMENTS
#define INVCAL_MAX_SEGMENTS 100
#include "gyro_tables.h"
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

static unsigned refused(invcal_status why)
{
    unsigned count = 0;

    for (unsigned i = 0; i < w.imu.rests; i++) {
        count += invcal_imu_move_reason(&w.imu, i) == why;
    }
    return count;
}

static void twelve_quarter_turns_fit(void)
{
    TEST_ASSERT_TRUE(sizeof(invcal_private_moves) <= (INVCAL_DOUBLE ? 1900 : 1700));
    world_begin(&w, 100, 11);
    world_draw(&w, 0.03, 0.02);
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(13, w.imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(12, imu.result.moves);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
    }
}

/* New ones replace the oldest; moves that do not fit are refused, with that reason. */
static void more_than_fit_are_dropped_or_refused(void)
{
    world_begin(&w, 100, 12);
    world_draw(&w, 0.03, 0.02);
    world_tour(&w);
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES, w.imu.rests);
    TEST_ASSERT_TRUE(w.imu.own.used <= INVCAL_MAX_SEGMENTS);
    TEST_ASSERT_EQUAL_INT(INVCAL_MAX_MOVES,
                          refused(INVCAL_OK) + refused(INVCAL_NO_SPACE) + refused(INVCAL_TOO_FEW));
    TEST_ASSERT_TRUE(refused(INVCAL_OK) >= 10);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(5 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(twelve_quarter_turns_fit);
    RUN_SLOW_TEST(more_than_fit_are_dropped_or_refused);
    return UNITY_END();
}
