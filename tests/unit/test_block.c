/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "invcal/block.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST = INVCAL_BLOCK_SIZE_MAX };
static int32_t sample[MOST][3];

static int32_t whole(double x)
{
    return x < -2147483648.0 ? INT32_MIN : x > 2147483647.0 ? INT32_MAX : (int32_t)floor(x + 0.5);
}

/* Normal noise about three centres. */
static void make_samples(uint32_t seed, unsigned size, const double centre[3], double sigma)
{
    random_source random = random_start(seed);

    for (unsigned i = 0; i < size; i++) {
        for (unsigned a = 0; a < 3; a++) {
            sample[i][a] = whole(centre[a] + sigma * random_normal(&random));
        }
    }
}

static invcal_block fill(unsigned size, int32_t low, int32_t high)
{
    invcal_block block;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_block_init(&block, size, low, high));
    for (unsigned i = 0; i < size; i++) {
        TEST_ASSERT_EQUAL_INT(i + 1 == size, invcal_block_add(&block, sample[i]));
    }
    return block;
}

/* Sums of the samples as they are, and their variance about the mean, in two passes. */
static void check_block(const invcal_block *block, double tolerance)
{
    const unsigned n = block->size;
    int32_t mean[3];
    double variance = 0;

    invcal_block_mean(block, mean);
    for (unsigned a = 0; a < 3; a++) {
        int64_t sum = 0;
        for (unsigned i = 0; i < n; i++) {
            sum += sample[i][a];
        }
        TEST_ASSERT_EQUAL_INT64(sum, block->sum[a] + (int64_t)n * block->first[a]);
        const int64_t off = sum - (int64_t)n * mean[a];
        TEST_ASSERT_TRUE(2 * (off < 0 ? -off : off) <= (int64_t)n);
        for (unsigned i = 0; i < n; i++) {
            const double d = (double)((int64_t)sample[i][a] * n - sum) / n;
            variance += d * d / (n - 1);
        }
    }
    /* The sum of 3 n squares is rounded too, which shows where double is float. */
    TEST_ASSERT_DOUBLE_WITHIN((tolerance + n * DBL_EPSILON) * variance + 1e-30, variance,
                              (double)invcal_block_variance(block));
    TEST_ASSERT_FALSE(block->wild);
}

static void sums_are_exact_and_variance_too_for_any_offset_and_noise(void)
{
    static const double centres[][3] = {
        {0, 0, 0}, {33000, -7, 2e6}, {1.9e9, -1.9e9, 40}, {-2147000000.0, 2147000000.0, 0}};
    static const double sigmas[] = {0, 0.4, 10, 1500, 6000, 1e5, 3e6};
    static const unsigned sizes[] = {2, 4, 13, 125, 1000};

    for (unsigned c = 0; c < 4; c++) {
        for (unsigned s = 0; s < 7; s++) {
            for (unsigned n = 0; n < 5; n++) {
                make_samples(10 * c + s, sizes[n], centres[c], sigmas[s]);
                const invcal_block block = fill(sizes[n], INT32_MIN, INT32_MAX);
                check_block(&block, FLOAT_OR_DOUBLE(3e-7, 1e-12));
            }
        }
    }
}

static void variance_beyond_64_bits_is_rounded_but_right(void)
{
    const double centre[3] = {1e9, -1e9, 0};

    make_samples(3, 1000, centre, 7e6);
    const invcal_block block = fill(1000, INT32_MIN, INT32_MAX);
    TEST_ASSERT_TRUE(block.square >> 54 != 0);
    check_block(&block, FLOAT_OR_DOUBLE(1e-5, 1e-12));
}

/* The largest that a block accepts: every sample but the first is FAR off, on all axes. */
static void nothing_overflows_at_the_largest_distance(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        memset(sample, 0, sizeof sample);
        for (unsigned i = 1; i < MOST; i++) {
            for (unsigned a = 0; a < 3; a++) {
                sample[i][a] = sign * (int32_t)INVCAL_BLOCK_FAR;
            }
        }
        const invcal_block block = fill(MOST, INT32_MIN, INT32_MAX);
        TEST_ASSERT_TRUE(block.square == 3 * UINT64_C(999) << 52);
        check_block(&block, FLOAT_OR_DOUBLE(1e-3, 1e-9));
    }
}

static void a_sample_too_far_from_the_first_makes_a_block_wild(void)
{
    static const int32_t value[][2] = {{0, (int32_t)INVCAL_BLOCK_FAR + 1},
                                       {0, -(int32_t)INVCAL_BLOCK_FAR - 1},
                                       {INT32_MIN, INT32_MAX},
                                       {INT32_MAX, INT32_MIN},
                                       {INT32_MAX - 5, INT32_MIN + 5},
                                       {INT32_MIN + 5, INT32_MAX - 5}};

    for (unsigned k = 0; k < 6; k++) {
        for (unsigned axis = 0; axis < 3; axis++) {
            memset(sample, 0, sizeof sample);
            for (unsigned i = 0; i < 8; i++) {
                sample[i][axis] = value[k][i & 1];
            }
            const invcal_block block = fill(8, INT32_MIN, INT32_MAX);
            TEST_ASSERT_TRUE(block.wild);
        }
    }
    memset(sample, 0, sizeof sample);
    TEST_ASSERT_FALSE(fill(8, INT32_MIN, INT32_MAX).wild); /* and the next is not */
}

static void a_sample_at_a_rail_or_beyond_is_clipped_on_any_axis_at_any_time(void)
{
    static const int32_t rails[][2] = {{-2048, 2047},          {-32768, 32767}, {0, 65535},
                                       {INT32_MIN, INT32_MAX}, {0, 1},          {7, 9}};

    for (unsigned k = 0; k < 6; k++) {
        const int32_t low = rails[k][0];
        const int32_t high = rails[k][1];
        const int32_t middle = (int32_t)(((int64_t)low + high) / 2);
        for (unsigned at = 0; at < 12; at++) {
            for (unsigned i = 0; i < 4; i++) {
                sample[i][0] = sample[i][1] = sample[i][2] = middle;
            }
            if (k != 4) { /* between 0 and 1 there is nothing */
                TEST_ASSERT_FALSE(fill(4, low, high).clipped);
                sample[at / 3][at % 3] = low + 1;
                sample[3 - at / 3][at % 3] = high - 1;
                TEST_ASSERT_FALSE(fill(4, low, high).clipped);
            }
            sample[at / 3][at % 3] = low;
            TEST_ASSERT_TRUE(fill(4, low, high).clipped);
            sample[at / 3][at % 3] = high;
            TEST_ASSERT_TRUE(fill(4, low, high).clipped);
            sample[at / 3][at % 3] = INT32_MAX;
            TEST_ASSERT_TRUE(fill(4, low, high).clipped);
        }
    }
}

/* What begins as far from a rail as differences may be that are added quickly, and reaches it. */
static void a_rail_is_seen_from_any_distance(void)
{
    static const int32_t low = -131072;
    static const int32_t high = 131071;

    for (int32_t distance = 1; distance <= 65536; distance *= 2) {
        for (int32_t off = -1; off <= 1; off++) {
            for (unsigned i = 0; i < 4; i++) {
                sample[i][0] = low + distance + off;
                sample[i][1] = high - distance - off;
                sample[i][2] = 0;
            }
            const int begins_there = distance + off == 0;
            TEST_ASSERT_EQUAL_INT(begins_there, fill(4, low, high).clipped);
            sample[2][0] = low;
            TEST_ASSERT_TRUE(fill(4, low, high).clipped);
            sample[2][0] = sample[1][0];
            sample[2][1] = high;
            TEST_ASSERT_TRUE(fill(4, low, high).clipped);
        }
    }
}

static void a_block_at_a_rail_is_summed_exactly(void)
{
    const double centre[3] = {2000, -2000, 0};

    make_samples(5, 100, centre, 30);
    for (unsigned i = 0; i < 100; i++) {
        for (unsigned a = 0; a < 3; a++) {
            sample[i][a] = sample[i][a] > 2047 ? 2047 : sample[i][a] < -2048 ? -2048 : sample[i][a];
        }
    }
    sample[0][0] = 2047;
    const invcal_block block = fill(100, -2048, 2047);
    TEST_ASSERT_TRUE(block.clipped);
    check_block(&block, FLOAT_OR_DOUBLE(3e-7, 1e-12));
}

static void quantum_is_the_smallest_change_and_outlives_the_block(void)
{
    invcal_block block;
    const int32_t steps[][3] = {{0, 0, 0}, {0, 0, 0},   {640, 0, 0}, {0, 0, -96},
                                {0, 0, 0}, {0, 160, 0}, {0, 0, 0},   {0, 0, 0}};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_block_init(&block, 2, 0, 0x7000));
    for (unsigned i = 0; i < 8; i++) {
        static const uint32_t expected[] = {0, 0, 0, 96, 96, 96, 96, 96};
        invcal_block_add(&block, steps[i]);
        TEST_ASSERT_EQUAL_UINT32(expected[i], block.quantum);
    }
    const int32_t one[3] = {0, 1, 0};
    invcal_block_add(&block, steps[0]);
    invcal_block_add(&block, one);
    TEST_ASSERT_EQUAL_UINT32(1, block.quantum);
}

static void a_dropped_block_leaves_nothing_in_the_next(void)
{
    const double centre[3] = {5, 6, 7};
    const int32_t other[3] = {INT32_MIN, 70000, -1};
    invcal_block block;

    make_samples(8, 20, centre, 9);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_block_init(&block, 20, INT32_MIN, INT32_MAX));
    for (unsigned i = 0; i < 19; i++) {
        TEST_ASSERT_EQUAL_INT(0, invcal_block_add(&block, other));
    }
    invcal_block_drop(&block);
    for (unsigned i = 0; i < 20; i++) {
        TEST_ASSERT_EQUAL_INT(i == 19, invcal_block_add(&block, sample[i]));
    }
    TEST_ASSERT_FALSE(block.clipped);
    check_block(&block, FLOAT_OR_DOUBLE(3e-7, 1e-12));
}

static void init_refuses_sizes_and_rails_out_of_range(void)
{
    invcal_block block;
    invcal_block before;

    memset(&block, 0x5A, sizeof block);
    before = block;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_block_init(&block, 1, 0, 9));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_block_init(&block, 1001, 0, 9));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_block_init(&block, 8, 9, 9));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_block_init(&block, 8, 9, -9));
    TEST_ASSERT_EQUAL_MEMORY(&before, &block, sizeof block);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_SLOW_TEST(sums_are_exact_and_variance_too_for_any_offset_and_noise);
    RUN_TEST(variance_beyond_64_bits_is_rounded_but_right);
    RUN_TEST(nothing_overflows_at_the_largest_distance);
    RUN_TEST(a_sample_too_far_from_the_first_makes_a_block_wild);
    RUN_TEST(a_sample_at_a_rail_or_beyond_is_clipped_on_any_axis_at_any_time);
    RUN_TEST(a_rail_is_seen_from_any_distance);
    RUN_TEST(a_block_at_a_rail_is_summed_exactly);
    RUN_TEST(quantum_is_the_smallest_change_and_outlives_the_block);
    RUN_TEST(a_dropped_block_leaves_nothing_in_the_next);
    RUN_TEST(init_refuses_sizes_and_rails_out_of_range);
    return UNITY_END();
}
