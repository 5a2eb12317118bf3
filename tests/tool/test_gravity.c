/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "expected.h"
#include "fit/gravity.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double tolerance = 1e-9;

static void equator_45_degrees_and_poles_are_those_of_wgs84(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.7803253359, gravity_at(0, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8061977694, gravity_at(45, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8321849379, gravity_at(90, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8321849379, gravity_at(-90, 0));
    TEST_ASSERT_DOUBLE_WITHIN(0, gravity_at(33, 0), gravity_at(-33, 0));
}

/* The reference differentiates the potential of the rotating ellipsoid. */
static void latitudes_and_heights_agree_with_the_field_of_the_ellipsoid(void)
{
    const unsigned count = sizeof expected_gravity / sizeof *expected_gravity;

    for (unsigned i = 0; i < count; i++) {
        const double *row = expected_gravity[i];
        const double left = 1e-9 + 1.4e-10 * fabs(row[1]); /* the series in f, m and h ends there */
        TEST_ASSERT_DOUBLE_WITHIN(left, row[2], gravity_at(row[0], row[1]));
    }
}

static void a_metre_of_height_takes_3_micro(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 3.086e-6, (gravity_at(45, -500) - gravity_at(45, 500)) / 1000);
}

static void what_is_not_a_place_on_earth_has_no_gravity(void)
{
    const double bad[][2] = {{90.01, 0},     {-90.01, 0},     {NOT_A_NUMBER, 0},
                             {INFINITE, 0},  {45, -501},      {45, 10001},
                             {45, INFINITE}, {45, -INFINITE}, {45, NOT_A_NUMBER}};

    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
        TEST_ASSERT_TRUE(isnan(gravity_at(bad[i][0], bad[i][1])));
    }
    TEST_ASSERT_TRUE(isfinite(gravity_at(90, -500)) && isfinite(gravity_at(-90, 10000)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(equator_45_degrees_and_poles_are_those_of_wgs84);
    RUN_TEST(latitudes_and_heights_agree_with_the_field_of_the_ellipsoid);
    RUN_TEST(a_metre_of_height_takes_3_micro);
    RUN_TEST(what_is_not_a_place_on_earth_has_no_gravity);
    return UNITY_END();
}
