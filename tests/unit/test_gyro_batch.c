/* SPDX-License-Identifier: MIT
 *
 * Two tours of the six faces against the batch solution.
 */
#include "gyro_batch.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void on_a_table_errors_are_those_of_the_batch(void)
{
    are_as_the_batch(NULL, 100, 3e-4, 8, 1.5e-4);
}

static void in_the_hand_errors_are_those_of_the_batch(void)
{
    are_as_the_batch(NULL, 100, 1e-3, 8, 4.2e-4);
}

static void so_they_are_at_200_hertz(void)
{
    are_as_the_batch(NULL, 200, 3e-4, 4, 1.5e-4);
}

static void so_they_are_at_400_hertz(void)
{
    are_as_the_batch(NULL, 400, 3e-4, 4, 1.5e-4);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(on_a_table_errors_are_those_of_the_batch);
    RUN_LONG_TEST(in_the_hand_errors_are_those_of_the_batch);
    RUN_LONG_TEST(so_they_are_at_200_hertz);
    RUN_LONG_TEST(so_they_are_at_400_hertz);
    return UNITY_END();
}
