/* SPDX-License-Identifier: MIT */
#include "read/log_rests.h"

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static recording log_read; /* large */

enum { SIZE = 100 };
static const double UNIT = 0.01;

/* A rest that was disturbed: 400 of 500 samples are summed. */
static const invcali_rest disturbed = {
    .sum = {40000, 0, 0}, .count = 400, .begin = 0, .end = 500, .variance = 16};

/* Without its blocks, the variance of its mean is that of a sample over their number. */
static void without_blocks_the_noise_is_that_of_the_samples_summed(void)
{
    positions p = {.name = "log"};

    log_read = (recording){.size = SIZE};
    TEST_ASSERT_EQUAL_INT(0, rests_take(&p, &disturbed, UNIT, &log_read));
    TEST_ASSERT_EQUAL_UINT(1, p.count);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 100 * UNIT, p.mean[0]);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 16.0 / 400 * UNIT * UNIT, p.noise_square[i]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 16 * UNIT * UNIT, p.scatter);
    positions_free(&p);
}

/* Means of 1, 2, 4, 7 and 11 counts: the average is 5, the squares of the deviations sum to 66;
 * over 5 times 4. */
static void with_blocks_it_is_the_scatter_of_their_means(void)
{
    static const double block_mean[] = {1, 2, 4, 7, 11};
    positions p = {.name = "log"};

    log_read = (recording){.size = SIZE, .blocks = 5};
    for (int k = 0; k < 5; k++) {
        log_read.block[k].line = 7 + (unsigned long)k;
        log_read.block[k].sum[1] = (double)SIZE * block_mean[k];
    }
    TEST_ASSERT_EQUAL_INT(0, rests_take(&p, &disturbed, UNIT, &log_read));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 66.0 / 20 * UNIT * UNIT, p.noise_square[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0, p.noise_square[0]);
    TEST_ASSERT_EQUAL_UINT(7, p.origin[0].line);
    positions_free(&p);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(without_blocks_the_noise_is_that_of_the_samples_summed);
    RUN_TEST(with_blocks_it_is_the_scatter_of_their_means);
    return UNITY_END();
}
