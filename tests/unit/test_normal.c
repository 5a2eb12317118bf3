/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { COUNT = 20, SUMS = INVCAL_MOMENTS };
static const double tiny = FLOAT_OR_DOUBLE(2e-5, 2e-14); /* of sums of about 20 numbers below 1 */

static invcal_observation rows[COUNT];

/* Rows of a triad with errors of 10 %. */
static void make_rows(void)
{
    random_source random = random_start(1);
    const triad_truth truth = triad_random(&random, 0.1);
    double direction[COUNT][3];
    reading_set set;

    for (int i = 0; i < COUNT; i++) {
        random_direction(&random, direction[i]);
    }
    read_positions(&truth, (const double(*)[3])direction, COUNT, 0, &random, &set);
    for (int i = 0; i < COUNT; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(set.u[i], &rows[i]));
    }
}

static invcal_normal sum_of(int first, int last)
{
    invcal_normal n;

    invcal_normal_init(&n);
    for (int i = first; i < last; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&n, &rows[i], 1));
    }
    return n;
}

static void assert_equal_normal(const invcal_normal *a, const invcal_normal *b, double factor)
{
    for (int i = 0; i < SUMS; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(tiny, (double)a->moment[i] * factor, (double)b->moment[i]);
    }
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(tiny, (double)a->htj[r] * factor, (double)b->htj[r]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(tiny, (double)a->jtj * factor, (double)b->jtj);
    TEST_ASSERT_EQUAL_UINT(a->count, b->count);
    TEST_ASSERT_EQUAL_INT(a->model, b->model);
}

static void sums_built_row_by_row_are_those_of_the_matrix(void)
{
    make_rows();
    const invcal_normal n = sum_of(0, COUNT);

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        double htj = 0;
        for (unsigned c = 0; c <= r; c++) {
            double hth = 0;
            for (int i = 0; i < COUNT; i++) {
                hth += (double)rows[i].h[r] * (double)rows[i].h[c];
            }
            TEST_ASSERT_DOUBLE_WITHIN(tiny, hth, element(&n, r, c));
        }
        for (int i = 0; i < COUNT; i++) {
            htj += (double)rows[i].h[r] * (double)rows[i].j;
        }
        TEST_ASSERT_DOUBLE_WITHIN(tiny, htj, (double)n.htj[r]);
    }
    double jtj = 0;
    for (int i = 0; i < COUNT; i++) {
        jtj += (double)rows[i].j * (double)rows[i].j;
    }
    TEST_ASSERT_DOUBLE_WITHIN(tiny, jtj, (double)n.jtj);
    TEST_ASSERT_EQUAL_UINT(COUNT, n.count);
}

static void order_does_not_matter(void)
{
    invcal_normal backwards;

    make_rows();
    const invcal_normal n = sum_of(0, COUNT);
    invcal_normal_init(&backwards);
    for (int i = COUNT; i-- > 0;) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&backwards, &rows[i], 1));
    }
    assert_equal_normal(&n, &backwards, 1);
}

static void a_weight_counts_like_a_repetition(void)
{
    make_rows();
    invcal_normal thrice = sum_of(0, 10);
    invcal_normal weighted = sum_of(0, 10);

    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&thrice, &rows[10], 1));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&weighted, &rows[10], 3));
    TEST_ASSERT_EQUAL_UINT(13, thrice.count);
    TEST_ASSERT_EQUAL_UINT(11, weighted.count); /* one position, however precise */
    weighted.count = thrice.count;
    assert_equal_normal(&thrice, &weighted, 1);
}

static void what_was_added_and_removed_was_never_there(void)
{
    make_rows();
    const invcal_normal expected = sum_of(0, 10);
    invcal_normal n = sum_of(0, COUNT);

    for (int i = 10; i < COUNT; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_remove(&n, &rows[i], 1));
    }
    assert_equal_normal(&expected, &n, 1);
}

static void two_halves_merged_are_the_whole(void)
{
    make_rows();
    const invcal_normal whole = sum_of(0, COUNT);
    const invcal_normal second = sum_of(7, COUNT);
    invcal_normal n = sum_of(0, 7);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_merge(&n, &second));
    assert_equal_normal(&whole, &n, 1);
}

static void merging_with_nothing_changes_nothing(void)
{
    invcal_normal empty;

    make_rows();
    const invcal_normal before = sum_of(0, 5);
    invcal_normal n = before;
    invcal_normal_init(&empty);
    empty.model = INVCAL_MODEL_LINEAR; /* without meaning in empty sums */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_merge(&n, &empty));
    TEST_ASSERT_EQUAL_MEMORY(&before, &n, sizeof n);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_merge(&empty, &n));
    assert_equal_normal(&n, &empty, 1);
}

static void scaling_lets_all_sums_fade_alike(void)
{
    make_rows();
    const invcal_normal before = sum_of(0, COUNT);
    invcal_normal n = before;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_scale(&n, (invcal_real)0.25));
    assert_equal_normal(&before, &n, 0.25);
    n = before;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_scale(&n, 1));
    TEST_ASSERT_EQUAL_MEMORY(&before, &n, sizeof n);
}

static void unusable_weights_and_factors_are_refused(void)
{
    static const double bad[] = {0, -1, NOT_A_NUMBER, INFINITE};

    make_rows();
    const invcal_normal before = sum_of(0, COUNT);
    invcal_normal n = before;
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const invcal_real x = (invcal_real)bad[i];
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_normal_add(&n, &rows[0], x));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_normal_remove(&n, &rows[0], x));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_normal_scale(&n, x));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_normal_scale(&n, (invcal_real)1.01));
    TEST_ASSERT_EQUAL_MEMORY(&before, &n, sizeof n);
}

static void exact_and_linear_rows_do_not_mix(void)
{
    const invcal_real up[3] = {0, 0, 1};
    invcal_observation vertical;
    invcal_normal linear;

    make_rows();
    const invcal_normal before = sum_of(0, COUNT);
    invcal_normal n = before;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_vertical(up, up, &vertical));
    TEST_ASSERT_EQUAL_INT(INVCAL_MIXED, invcal_normal_add(&n, &vertical, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_MIXED, invcal_normal_remove(&n, &vertical, 1));
    invcal_normal_init(&linear);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&linear, &vertical, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_MIXED, invcal_normal_merge(&n, &linear));
    TEST_ASSERT_EQUAL_MEMORY(&before, &n, sizeof n);
}

/* Of one row, too: it is the first that tells. */
static void empty_sums_take_the_kind_of_those_merged_in(void)
{
    const invcal_real up[3] = {0, 0, 1};
    invcal_observation vertical;
    invcal_normal linear;
    invcal_normal n;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_vertical(up, up, &vertical));
    invcal_normal_init(&linear);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&linear, &vertical, 1));
    invcal_normal_init(&n);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_merge(&n, &linear));
    TEST_ASSERT_EQUAL_MEMORY(&linear, &n, sizeof n);
}

static void without_their_last_row_the_sums_are_empty(void)
{
    invcal_normal n;
    invcal_normal empty;

    make_rows();
    invcal_normal_init(&empty);
    n = empty;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&n, &rows[0], 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&n, &rows[1], 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_scale(&n, (invcal_real)0.3));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_remove(&n, &rows[0], (invcal_real)0.3));
    TEST_ASSERT_EQUAL_UINT(1, n.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_remove(&n, &rows[1], (invcal_real)0.3));
    TEST_ASSERT_EQUAL_MEMORY(&empty, &n, sizeof n);
}

/* On a machine of 16 bits a day of fading sums gets there. */
static void the_count_does_not_wrap(void)
{
    invcal_normal n = sum_of(0, 9);
    const invcal_normal two = sum_of(9, 11);
    const invcal_observation linear = {.h = {1}, .j = 1, .model = INVCAL_MODEL_LINEAR};

    n.count = UINT_MAX - 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&n, &rows[11], 1));
    TEST_ASSERT_EQUAL_UINT(UINT_MAX, n.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&n, &rows[12], 1));
    TEST_ASSERT_EQUAL_UINT(UINT_MAX, n.count);
    TEST_ASSERT_EQUAL_INT(INVCAL_MIXED, invcal_normal_add(&n, &linear, 1));
    n.count = UINT_MAX - 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_merge(&n, &two));
    TEST_ASSERT_EQUAL_UINT(UINT_MAX, n.count);
}

static void nothing_can_be_removed_from_empty_sums(void)
{
    invcal_normal n;

    make_rows();
    invcal_normal_init(&n);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_normal_remove(&n, &rows[0], 1));
    TEST_ASSERT_TRUE(n.count == 0 && n.moment[0] == 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(sums_built_row_by_row_are_those_of_the_matrix);
    RUN_TEST(order_does_not_matter);
    RUN_TEST(a_weight_counts_like_a_repetition);
    RUN_TEST(what_was_added_and_removed_was_never_there);
    RUN_TEST(two_halves_merged_are_the_whole);
    RUN_TEST(merging_with_nothing_changes_nothing);
    RUN_TEST(scaling_lets_all_sums_fade_alike);
    RUN_TEST(unusable_weights_and_factors_are_refused);
    RUN_TEST(exact_and_linear_rows_do_not_mix);
    RUN_TEST(empty_sums_take_the_kind_of_those_merged_in);
    RUN_TEST(without_their_last_row_the_sums_are_empty);
    RUN_TEST(the_count_does_not_wrap);
    RUN_TEST(nothing_can_be_removed_from_empty_sums);
    return UNITY_END() != 0;
}
