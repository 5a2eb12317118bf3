/* SPDX-License-Identifier: MIT */
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

static const double tiny = FLOAT_OR_DOUBLE(4e-7, 1e-15);

static void to_real(const double v[3], invcal_real out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = (invcal_real)v[i];
    }
}

/* h X in double, h written out from the paper. */
static double row_times(const double a[3], const double x[9])
{
    const double h[9] = {a[0],        a[1],        a[2],        a[0] * a[0], a[1] * a[1],
                         a[2] * a[2], a[0] * a[1], a[0] * a[2], a[1] * a[2]};
    double sum = 0;

    for (int r = 0; r < 9; r++) {
        sum += h[r] * x[r];
    }
    return sum;
}

static void rows_stand_in_the_order_of_the_paper(void)
{
    const invcal_real u[3] = {1, 2, 3};
    static const double expected[9] = {1, 2, 3, 1, 4, 9, 2, 3, 6};
    invcal_observation o;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(u, &o));
    for (int r = 0; r < 9; r++) {
        TEST_ASSERT_EQUAL_DOUBLE(expected[r], (double)o.h[r]);
    }
    TEST_ASSERT_EQUAL_DOUBLE(6.5, (double)o.j); /* (14 - 1)/2 */
    TEST_ASSERT_EQUAL_INT(INVCAL_MODEL_ELLIPSOID, o.model);
}

/* A sphere of radius R about c: |u|^2 - 2 c u + |c|^2 = R^2. Times s = 1/(R^2 - |c|^2) this is
 * j + h p = 0 with p = (-s c, (s-1)/2, (s-1)/2, (s-1)/2, 0, 0, 0). */
static void the_exact_row_vanishes_on_a_sphere_of_any_size_and_place(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < SOME(500); i++) {
        const double radius = random_uniform(&random, 0.7, 1.4);
        double c[3];
        double eta[3];
        for (int k = 0; k < 3; k++) {
            c[k] = random_uniform(&random, -0.3, 0.3);
        }
        random_direction(&random, eta);
        const double s = 1 / (radius * radius - length3(c) * length3(c));
        const double p[9] = {-s * c[0],   -s * c[1],   -s * c[2],
                             (s - 1) / 2, (s - 1) / 2, (s - 1) / 2};
        invcal_real u[3];
        for (int k = 0; k < 3; k++) {
            u[k] = (invcal_real)(c[k] + radius * eta[k]);
        }
        invcal_observation o;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(u, &o));
        double sum = (double)o.j;
        for (int r = 0; r < 9; r++) {
            sum += (double)o.h[r] * p[r];
        }
        TEST_ASSERT_DOUBLE_WITHIN(10 * tiny, 0, sum);
    }
}

static void the_vertical_row_is_linear_for_errors_of_any_size(void)
{
    random_source random = random_start(2);

    for (int i = 0; i < SOME(500); i++) {
        const triad_truth truth = triad_random(&random, 0.5);
        double eta[3];
        double u[3];
        random_direction(&random, eta);
        triad_read(&truth, eta, u);
        invcal_real ur[3];
        invcal_real vertical[3];
        to_real(u, ur);
        to_real(eta, vertical);
        invcal_observation o;
        const invcal_status status = invcal_observation_vertical(ur, vertical, &o);
        if (length3(u) > 0.1) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, status);
            TEST_ASSERT_DOUBLE_WITHIN(4 * tiny, row_times(eta, truth.x), (double)o.j);
            TEST_ASSERT_EQUAL_INT(INVCAL_MODEL_LINEAR, o.model);
        }
    }
}

static void the_first_order_row_is_wrong_by_the_square_of_the_errors(void)
{
    random_source random = random_start(3);
    double worst[2] = {0, 0};

    for (int i = 0; i < 2000; i++) {
        triad_truth truth = triad_random(&random, 0.01);
        double eta[3];
        random_direction(&random, eta);
        for (int size = 0; size < 2; size++) {
            double u[3];
            invcal_real ur[3];
            invcal_real vertical[3];
            invcal_observation o;
            triad_read(&truth, eta, u);
            to_real(u, ur);
            to_real(eta, vertical);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_first_order(ur, vertical, &o));
            const double error = fabs((double)o.j - row_times(eta, truth.x));
            worst[size] = error > worst[size] ? error : worst[size];
            for (int r = 0; r < 9; r++) {
                truth.x[r] *= 10;
            }
        }
    }
    /* |X'|^2 / 2 at most: 3 components of up to 3 x 1 % */
    TEST_ASSERT_DOUBLE_WITHIN(4e-4, 5e-4, worst[0]);
    TEST_ASSERT_DOUBLE_WITHIN(5, 100, worst[1] / worst[0]);
}

static void readings_that_cannot_be_of_this_field_are_refused(void)
{
    static const double bad[][3] = {{0, 0, 0},          {1e-3, 0, 0},   {1e-40, 1e-40, 0},
                                    {0.09, 0.01, 0.01}, {10.1, 0, 0},   {1e30, 0, 0},
                                    {0, -1e30, 1},      {0, 7.2, -7.2}, {1e19, 1e19, 1e19}};
    const invcal_real up[3] = {0, 0, 1};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_observation o;
        invcal_observation before;
        invcal_real u[3];
        memset(&o, 7, sizeof o);
        before = o;
        to_real(bad[i], u);
        TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_observation_exact(u, &o));
        TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_observation_vertical(u, up, &o));
        TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_observation_first_order(u, up, &o));
        TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
    }
}

static void readings_that_are_no_numbers_are_refused(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    const invcal_real up[3] = {0, 0, 1};

    for (unsigned i = 0; i < 9; i++) {
        invcal_observation o;
        invcal_observation before;
        invcal_real u[3] = {(invcal_real)0.6, (invcal_real)0.6, (invcal_real)0.5};
        memset(&o, 7, sizeof o);
        before = o;
        u[i % 3] = (invcal_real)bad[i / 3];
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_observation_exact(u, &o));
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_observation_vertical(u, up, &o));
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_observation_first_order(u, up, &o));
        TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
    }
}

static void directions_that_are_not_unit_vectors_are_refused(void)
{
    static const double bad[][3] = {{0, 0, 1.0002},       {0, 0, 0.9998},   {0, 0, 0},
                                    {NOT_A_NUMBER, 0, 1}, {INFINITE, 0, 0}, {1, 1, 1}};
    const invcal_real u[3] = {0, 0, 1};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_observation o;
        invcal_observation before;
        invcal_real vertical[3];
        memset(&o, 7, sizeof o);
        before = o;
        to_real(bad[i], vertical);
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_UNIT, invcal_observation_vertical(u, vertical, &o));
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_UNIT, invcal_observation_first_order(u, vertical, &o));
        TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
    }
}

static void a_reading_is_the_nominal_calibration_over_the_field(void)
{
    const invcal_calibration nominal = {{1, 2, 3}, {{2, 0, 0}, {0, 4, 0}, {0, 0, 8}}};
    const invcal_real raw[3] = {2, 4, 6};
    invcal_real u[3];

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_reading(&nominal, 16, raw, u));
    TEST_ASSERT_EQUAL_DOUBLE(0.125, (double)u[0]);
    TEST_ASSERT_EQUAL_DOUBLE(0.5, (double)u[1]);
    TEST_ASSERT_EQUAL_DOUBLE(1.5, (double)u[2]);
}

static void a_field_that_is_no_length_is_refused(void)
{
    static const double bad[] = {0, -9.8, NOT_A_NUMBER, INFINITE};
    const invcal_calibration nominal = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const invcal_real raw[3] = {1, 1, 1};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_real u[3] = {7, 7, 7};
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_observation_reading(&nominal, (invcal_real)bad[i], raw, u));
        TEST_ASSERT_TRUE(u[0] == 7 && u[1] == 7 && u[2] == 7);
        invcal_observation row = {.j = 7};
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_observe(&nominal, (invcal_real)bad[i], raw, &row));
        TEST_ASSERT_TRUE(row.j == 7 && row.h[0] == 0);
    }
}

static void a_raw_value_that_is_no_number_is_refused(void)
{
    const invcal_calibration nominal = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const invcal_real raw[3] = {1, (invcal_real)NAN, 1};
    invcal_real u[3] = {7, 7, 7};

    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_observation_reading(&nominal, 1, raw, u));
    TEST_ASSERT_TRUE(u[0] == 7 && u[1] == 7 && u[2] == 7);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(rows_stand_in_the_order_of_the_paper);
    RUN_TEST(the_exact_row_vanishes_on_a_sphere_of_any_size_and_place);
    RUN_TEST(the_vertical_row_is_linear_for_errors_of_any_size);
    RUN_TEST(the_first_order_row_is_wrong_by_the_square_of_the_errors);
    RUN_TEST(readings_that_cannot_be_of_this_field_are_refused);
    RUN_TEST(readings_that_are_no_numbers_are_refused);
    RUN_TEST(directions_that_are_not_unit_vectors_are_refused);
    RUN_TEST(a_reading_is_the_nominal_calibration_over_the_field);
    RUN_TEST(a_field_that_is_no_length_is_refused);
    RUN_TEST(a_raw_value_that_is_no_number_is_refused);
    return UNITY_END() != 0;
}
