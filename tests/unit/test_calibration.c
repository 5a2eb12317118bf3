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

/* Small whole numbers, so that the expected figures are exact in float too. */
static const invcal_calibration example = {{1, 2, 3}, {{2, 1, 0}, {0, 3, 1}, {1, 0, 4}}};

static void apply_computes_matrix_times_raw_minus_offset(void)
{
    const invcal_real raw[3] = {2, 4, 6}; /* minus offset: 1 2 3 */
    const invcal_real expected[3] = {4, 9, 13};
    invcal_real out[3];

    invcal_apply(&example, raw, out);
    TEST_ASSERT_EQUAL_MEMORY(expected, out, sizeof out);
}

static void apply_works_in_place(void)
{
    const invcal_real expected[3] = {4, 9, 13};
    invcal_real v[3] = {2, 4, 6};

    invcal_apply(&example, v, v);
    TEST_ASSERT_EQUAL_MEMORY(expected, v, sizeof v);
}

static void apply_takes_a_sample_in_counts(void)
{
    const int32_t raw[3] = {2, 4, 6};
    const invcal_real expected[3] = {4, 9, 13};
    invcal_real out[3];

    invcal_apply_counts(&example, raw, out);
    TEST_ASSERT_EQUAL_MEMORY(expected, out, sizeof out);
}

static void apply_hands_a_nan_on(void)
{
    const invcal_real raw[3] = {(invcal_real)NAN, 0, 0};
    invcal_real out[3];

    invcal_apply(&example, raw, out);
    TEST_ASSERT_TRUE(isnan(out[0]) && isnan(out[2]));
}

static void nominal_puts_the_inverse_of_the_counts_on_the_diagonal(void)
{
    const invcal_real zero[3] = {10, -20, 30};
    const invcal_real counts[3] = {2, -4, 8};
    const invcal_calibration expected = {
        {10, -20, 30},
        {{INVCAL_REAL(0.5), 0, 0}, {0, INVCAL_REAL(-0.25), 0}, {0, 0, INVCAL_REAL(0.125)}}};
    invcal_calibration c;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(zero, counts, &c));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &c, sizeof c);
}

static void assert_nominal(invcal_status expected, unsigned axis, double zero, double counts)
{
    invcal_real z[3] = {0, 0, 0};
    invcal_real n[3] = {1, 1, 1};
    invcal_calibration c = example;

    z[axis] = (invcal_real)zero;
    n[axis] = (invcal_real)counts;
    TEST_ASSERT_EQUAL_INT(expected, invcal_nominal(z, n, &c));
    if (expected != INVCAL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
    }
}

static void nominal_refuses_what_is_no_scale_and_leaves_the_output_alone(void)
{
    static const double bad[] = {0, NOT_A_NUMBER, INFINITE, -INFINITE, 0.9e-10, -0.9e-10, 1.1e10};
    static const double good[] = {1.1e-10, 1e-5, -1, 16384, 0.9e10};

    for (unsigned axis = 0; axis < 3; axis++) {
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            assert_nominal(INVCAL_BAD_NOMINAL, axis, 0, bad[i]);
        }
        for (unsigned i = 0; i < sizeof good / sizeof good[0]; i++) {
            assert_nominal(INVCAL_OK, axis, 0, good[i]);
        }
    }
}

static void nominal_refuses_a_zero_that_is_not_finite_or_absurd(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 1.1e20, -1.1e20};

    for (unsigned axis = 0; axis < 3; axis++) {
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            assert_nominal(INVCAL_BAD_NOMINAL, axis, bad[i], 100);
        }
        assert_nominal(INVCAL_OK, axis, -0.9e20, 100);
    }
}

/* What it makes of a calibration in hand is seen where one is needed. */
static invcal_status status_of(const invcal_calibration *nominal)
{
    const invcal_real raw[3] = {0};
    invcal_calibration c;
    invcal_quality q;

    return invcal_calibrate(raw, 0, nominal, 0, &c, &q);
}

static void matrices_that_are_singular_to_rounding_are_no_nominal(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < SOME(1000); i++) {
        invcal_calibration c = {{0, 0, 0}, {{0}}};
        for (int k = 0; k < 3; k++) {
            const double a = random_normal(&random);
            const double b = random_normal(&random);
            c.matrix[0][k] = (invcal_real)a;
            c.matrix[1][k] = (invcal_real)b;
            c.matrix[2][k] = (invcal_real)(0.3 * a - 0.4 * b);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, status_of(&c));
    }
}

/* From side to side it is as good as from count to count. */
static void a_turned_matrix_of_any_scale_is_a_nominal(void)
{
    static const double scale[] = {1e-9, 1e-5, 2.4e-3, 1, 1e3, 1e9};
    random_source random = random_start(2);

    for (unsigned i = 0; i < sizeof scale / sizeof scale[0]; i++) {
        double turn[3][3];
        invcal_calibration c = {{0, 0, 0}, {{0}}};
        random_rotation(&random, turn);
        for (int k = 0; k < 9; k++) {
            c.matrix[k / 3][k % 3] = (invcal_real)(scale[i] * turn[k / 3][k % 3]);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, status_of(&c)); /* positions, that is */
    }
}

static void a_field_scales_the_matrix_and_not_the_offset(void)
{
    const invcal_calibration expected = {{1, 2, 3}, {{4, 2, 0}, {0, 6, 2}, {2, 0, 8}}};
    invcal_calibration c = example;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_scale(&c, 2));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &c, sizeof c);
}

static void a_field_that_is_no_length_is_refused(void)
{
    static const double bad[] = {0, -9.8, NOT_A_NUMBER, INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_calibration c = example;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_FIELD, invcal_scale(&c, (invcal_real)bad[i]));
        TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(apply_computes_matrix_times_raw_minus_offset);
    RUN_TEST(apply_works_in_place);
    RUN_TEST(apply_takes_a_sample_in_counts);
    RUN_TEST(apply_hands_a_nan_on);
    RUN_TEST(nominal_puts_the_inverse_of_the_counts_on_the_diagonal);
    RUN_TEST(nominal_refuses_what_is_no_scale_and_leaves_the_output_alone);
    RUN_TEST(nominal_refuses_a_zero_that_is_not_finite_or_absurd);
    RUN_TEST(matrices_that_are_singular_to_rounding_are_no_nominal);
    RUN_TEST(a_turned_matrix_of_any_scale_is_a_nominal);
    RUN_TEST(a_field_scales_the_matrix_and_not_the_offset);
    RUN_TEST(a_field_that_is_no_length_is_refused);
    return UNITY_END() != 0;
}
