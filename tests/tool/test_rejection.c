/* SPDX-License-Identifier: MIT */
#include "fit/rejection.h"

#include <math.h>
#include <string.h>

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MANY = 200 };

static double mean[3 * MANY];
static position_origin origin[MANY];

static fit_settings settings_of_one(void)
{
    fit_settings s = {.field = 1};

    for (int i = 0; i < 3; i++) {
        s.nominal.matrix[i][i] = 1;
    }
    return s;
}

/* The readings of a sensor without errors in the directions of a spiral (golden angle), which cover
 * the sphere evenly; lengths differ by 1e-4, in an order that is unrelated to the directions. */
static positions spiral(unsigned count)
{
    memset(origin, 0, sizeof origin);
    for (unsigned n = 0; n < count; n++) {
        const double z = 1 - (2 * n + 1.0) / count;
        const double angle = 2.399963229728653 * n;
        const double length = 1 + 1e-4 * sin(12.9898 * n * n);
        mean[3 * n] = length * sqrt(1 - z * z) * cos(angle);
        mean[3 * n + 1] = length * sqrt(1 - z * z) * sin(angle);
        mean[3 * n + 2] = length * z;
        origin[n].temperature = (double)NAN;
    }
    return (positions){.name = "spiral", .mean = mean, .origin = origin, .count = count};
}

static void lengthen(unsigned n, double times)
{
    for (unsigned i = 0; i < 3; i++) {
        mean[3 * n + i] *= times;
    }
}

/* How many are left out of `count`, of which the first `wrong` read forty times the field. */
static unsigned left_out_of(unsigned count, unsigned wrong)
{
    const fit_settings settings = settings_of_one();
    const positions p = spiral(count);
    rejection r;

    for (unsigned n = 0; n < wrong; n++) {
        lengthen(n, 40);
    }
    TEST_ASSERT_EQUAL_INT(0, rejection_begin(&r, &p, &settings, 0));
    const unsigned left_out = r.count;
    rejection_free(&r);
    return left_out;
}

/* There must be eleven others, and seven times as many. */
static void one_in_eight_may_be_impossible(void)
{
    TEST_ASSERT_EQUAL_UINT(1, left_out_of(12, 1));
    TEST_ASSERT_EQUAL_UINT(0, left_out_of(11, 1));
    TEST_ASSERT_EQUAL_UINT(3, left_out_of(24, 3));
    TEST_ASSERT_EQUAL_UINT(0, left_out_of(23, 3));
    TEST_ASSERT_EQUAL_UINT(0, left_out_of(24, 4));
    TEST_ASSERT_EQUAL_UINT(25, left_out_of(200, 25));
    TEST_ASSERT_EQUAL_UINT(0, left_out_of(200, 26));
}

/* 0 1 . 3 4 . . 7 8 */
static void the_numbers_of_those_that_are_kept_are_found_again(void)
{
    static const unsigned out[] = {2, 5, 6};
    static const unsigned expected[] = {0, 1, 3, 4, 7, 8};
    const fit_settings settings = settings_of_one();
    const positions p = spiral(9);
    rejection r;

    TEST_ASSERT_EQUAL_INT(0, rejection_begin(&r, &p, &settings, 1));
    for (unsigned i = 0; i < 3; i++) {
        rejection_add(&r, (rejected_position){.position = out[2 - i]}); /* in any order */
    }
    rejection_finish(&r, &p);
    TEST_ASSERT_EQUAL_UINT(6, r.kept_count);
    for (unsigned k = 0; k < 6; k++) {
        TEST_ASSERT_EQUAL_UINT(expected[k], rejection_original(&r, k));
        TEST_ASSERT_EQUAL_DOUBLE(mean[3 * expected[k]], r.kept[3 * k]);
    }
    for (unsigned i = 0; i < 9; i++) {
        TEST_ASSERT_EQUAL_INT(i == 2 || i == 5 || i == 6, rejection_has(&r, r.count, i));
    }
    TEST_ASSERT_EQUAL_DOUBLE(3, r.number[0]);
    rejection_free(&r);
}

/* An impossible one that comes after those that were found must not hide them from the last look,
 * and neither must one that drifted: 200 are four turns. */
static void what_contradicts_all_the_others_is_left_out(void)
{
    const fit_settings settings = settings_of_one();
    const positions p = spiral(MANY);
    rejection r;

    lengthen(7, 1.004);
    lengthen(90, 0.996);
    lengthen(150, 40);
    TEST_ASSERT_EQUAL_INT(0, rejection_begin(&r, &p, &settings, 0));
    rejection_add(&r, (rejected_position){.position = 30, .drift = 2});
    rejection_search(&r, &p, &settings);
    rejection_finish(&r, &p);
    TEST_ASSERT_EQUAL_UINT(4, r.count);
    TEST_ASSERT_EQUAL_UINT(7, r.list[0].position);
    TEST_ASSERT_EQUAL_UINT(30, r.list[1].position);
    TEST_ASSERT_EQUAL_UINT(90, r.list[2].position);
    TEST_ASSERT_EQUAL_UINT(150, r.list[3].position);
    TEST_ASSERT_EQUAL_DOUBLE(2, r.list[1].drift);
    TEST_ASSERT_EQUAL_UINT(0, r.suspected);
    rejection_free(&r);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(one_in_eight_may_be_impossible);
    RUN_TEST(the_numbers_of_those_that_are_kept_are_found_again);
    RUN_TEST(what_contradicts_all_the_others_is_left_out);
    return UNITY_END();
}
