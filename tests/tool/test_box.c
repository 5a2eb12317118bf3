/* SPDX-License-Identifier: MIT
 *
 * The pictogram of a device: it is a rotation, and up is up.
 */
#include <math.h>

#include "draw/box.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double directions[][3] = {
    {1, 0, 0},  {-1, 0, 0},     {0, 1, 0},          {0, -1, 0},    {0, 0, 1},
    {0, 0, -1}, {0.6, 0, -0.8}, {0.6, -0.64, 0.48}, {1e-7, 0, -1},
};

static void up_is_turned_to_the_top(void)
{
    for (unsigned n = 0; n < sizeof directions / sizeof *directions; n++) {
        double turn[3][3];
        box_turn(directions[n], turn);
        for (unsigned i = 0; i < 3; i++) {
            double sum = 0;
            for (unsigned j = 0; j < 3; j++) {
                sum += turn[i][j] * directions[n][j];
            }
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, i == 2, sum);
        }
    }
}

static void it_is_a_rotation(void)
{
    for (unsigned n = 0; n < sizeof directions / sizeof *directions; n++) {
        double t[3][3];
        box_turn(directions[n], t);
        for (unsigned i = 0; i < 9; i++) {
            const double *a = t[i / 3];
            const double *b = t[i % 3];
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, i / 3 == i % 3,
                                      a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1,
                                  t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) -
                                      t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
                                      t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]));
    }
}

static void on_its_side_it_turns_the_shortest_way(void)
{
    double turn[3][3];

    box_turn((const double[]){1, 0, 0}, turn); /* x turns up, y stays in place */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1, turn[1][1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, -1, turn[0][2]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(up_is_turned_to_the_top);
    RUN_TEST(it_is_a_rotation);
    RUN_TEST(on_its_side_it_turns_the_shortest_way);
    return UNITY_END();
}
