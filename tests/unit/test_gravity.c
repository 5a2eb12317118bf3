/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "expected.h"
#include "invcal/gravity.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static double gravity(double latitude, double height)
{
    invcal_real g = -1;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_gravity((invcal_real)latitude, (invcal_real)height, &g));
    return (double)g;
}

static const double tolerance = FLOAT_OR_DOUBLE(2e-6, 1e-9);

static void equator_45_degrees_and_poles_are_those_of_wgs84(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.7803253359, gravity(0, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8061977694, gravity(45, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8321849379, gravity(90, 0));
    TEST_ASSERT_DOUBLE_WITHIN(tolerance, 9.8321849379, gravity(-90, 0));
    TEST_ASSERT_DOUBLE_WITHIN(0, gravity(33, 0), gravity(-33, 0));
}

/* The reference takes the gradient of the potential of the rotating ellipsoid itself. */
static void latitudes_and_heights_agree_with_the_field_of_the_ellipsoid(void)
{
    const unsigned count = sizeof expected_gravity / sizeof *expected_gravity;

    for (unsigned i = 0; i < count; i++) {
        const double *row = expected_gravity[i];
        const double left = 1e-9 + 1.4e-10 * fabs(row[1]); /* the series in f, m and h ends there */
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, left), row[2], gravity(row[0], row[1]));
    }
}

static void a_metre_of_height_takes_3_micro(void)
{
    needs_53_bits();
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-9, 1e-9), 3.086e-6,
                              (gravity(45, -500) - gravity(45, 500)) / 1000);
}

static void what_is_no_place_on_earth_is_refused(void)
{
    static const double bad[][2] = {{90.01, 0},     {-90.01, 0},     {NOT_A_NUMBER, 0},
                                    {INFINITE, 0},  {45, -501},      {45, 10001},
                                    {45, INFINITE}, {45, -INFINITE}, {45, NOT_A_NUMBER}};

    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
        invcal_real g = 7;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_gravity((invcal_real)bad[i][0], (invcal_real)bad[i][1], &g));
        TEST_ASSERT_TRUE(g == 7);
    }
    (void)gravity(90, -500);
    (void)gravity(-90, 10000);
}

/* g' for g: matrix times g'/g, all else as it was. */
static void a_wrong_g_scales_the_matrix_and_nothing_else(void)
{
    const double ratio = 1.003;
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.03);
    double direction[12][3];
    reading_set set;
    invcal_settings settings = unit_settings(0);
    invcal_solution right, wrong;
    invcal_quality quality;

    for (unsigned i = 0; i < 12; i++) {
        random_direction(&random, direction[i]);
    }
    read_positions(&truth, (const double(*)[3])direction, 12, 1e-4, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &settings, &right, &quality, NULL));
    settings.field = (invcal_real)ratio;
    settings.nominal.matrix[0][0] = (invcal_real)ratio;
    settings.nominal.matrix[1][1] = (invcal_real)ratio;
    settings.nominal.matrix[2][2] = (invcal_real)ratio;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &settings, &wrong, &quality, NULL));
    for (unsigned i = 0; i < 3; i++) {
        const double near = FLOAT_OR_DOUBLE(3e-6, 1e-14);
        TEST_ASSERT_DOUBLE_WITHIN(near, (double)right.delta[i], (double)wrong.delta[i]);
        TEST_ASSERT_DOUBLE_WITHIN(near, (double)right.gamma[i], (double)wrong.gamma[i]);
        TEST_ASSERT_DOUBLE_WITHIN(near, (double)right.calibration.offset[i],
                                  (double)wrong.calibration.offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            TEST_ASSERT_DOUBLE_WITHIN(near, ratio * (double)right.calibration.matrix[i][j],
                                      (double)wrong.calibration.matrix[i][j]);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(equator_45_degrees_and_poles_are_those_of_wgs84);
    RUN_TEST(latitudes_and_heights_agree_with_the_field_of_the_ellipsoid);
    RUN_TEST(a_metre_of_height_takes_3_micro);
    RUN_TEST(what_is_no_place_on_earth_is_refused);
    RUN_TEST(a_wrong_g_scales_the_matrix_and_nothing_else);
    return UNITY_END();
}
