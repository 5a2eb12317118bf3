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

static void apply_hands_a_nan_on(void)
{
    const invcal_real raw[3] = {(invcal_real)NAN, 0, 0};
    invcal_real out[3];

    invcal_apply(&example, raw, out);
    TEST_ASSERT_TRUE(isnan(out[0]) && isnan(out[2]));
}

static void nominal_puts_the_scale_on_the_diagonal(void)
{
    const invcal_real zero[3] = {10, -20, 30};
    const invcal_real scale[3] = {2, -4, 8};
    const invcal_calibration expected = {{10, -20, 30}, {{2, 0, 0}, {0, -4, 0}, {0, 0, 8}}};
    invcal_calibration c;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibration_nominal(zero, scale, &c));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &c, sizeof c);
}

static void nominal_refuses_what_is_no_scale_and_leaves_the_output_alone(void)
{
    static const double bad[] = {0, NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned axis = 0; axis < 3; axis++) {
            const invcal_real zero[3] = {0, 0, 0};
            invcal_real scale[3] = {1, 1, 1};
            invcal_calibration c = example;
            scale[axis] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_calibration_nominal(zero, scale, &c));
            TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
        }
    }
}

static void nominal_refuses_a_zero_that_is_not_finite(void)
{
    const invcal_real scale[3] = {1, 1, 1};
    const invcal_real zero[3] = {0, 0, (invcal_real)NAN};
    invcal_calibration c = example;

    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_calibration_nominal(zero, scale, &c));
    TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
}

static void inverse_agrees_with_the_one_worked_out_by_hand(void)
{
    /* det = 2 (3*4 - 1*0) - 1 (0*4 - 1*1) + 0 = 25 */
    static const double expected[3][3] = {{12, -4, 1}, {1, 8, -2}, {-3, 1, 6}};
    invcal_real inverse[3][3];

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibration_inverse(&example, inverse));
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c < 3; c++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-7, 1e-15), expected[r][c] / 25,
                                      (double)inverse[r][c]);
        }
    }
}

static void inverse_works_in_any_unit(void)
{
    static const double scale[] = {1e-30, 1e-15, 1e-9, 1e-5, 2.4e-3, 1, 1e3, 1e9, 1e15, 1e30};

    for (unsigned i = 0; i < sizeof scale / sizeof scale[0]; i++) {
        const invcal_real zero[3] = {0, 0, 0};
        const invcal_real s[3] = {(invcal_real)scale[i], (invcal_real)scale[i],
                                  (invcal_real)scale[i]};
        invcal_calibration c;
        invcal_real inverse[3][3];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibration_nominal(zero, s, &c));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibration_inverse(&c, inverse));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-14), 1,
                                  (double)inverse[1][1] * scale[i]);
    }
}

static void inverse_refuses_singular_and_unreal_matrices(void)
{
    static const double bad[][3] = {{1, 2, 3}, {0, 0, 0}, {NOT_A_NUMBER, 1, 1}, {INFINITE, 1, 1}};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_calibration c = example;
        invcal_real inverse[3][3] = {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}};
        invcal_real before[3][3];
        memcpy(before, inverse, sizeof before);
        for (unsigned k = 0; k < 3; k++) {
            c.matrix[0][k] = (invcal_real)bad[i][k];
            c.matrix[1][k] = 2 * c.matrix[0][k]; /* dependent, if finite */
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_calibration_inverse(&c, inverse));
        TEST_ASSERT_EQUAL_MEMORY(before, inverse, sizeof before);
    }
}

static void inverse_refuses_a_matrix_whose_inverse_is_not_finite(void)
{
    const invcal_real subnormal = (invcal_real)(FLOAT_OR_DOUBLE((double)FLT_MIN, DBL_MIN) / 100);
    const invcal_calibration c = {{0, 0, 0}, {{subnormal, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    invcal_real inverse[3][3] = {{7}};

    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_calibration_inverse(&c, inverse));
    TEST_ASSERT_TRUE(inverse[0][0] == 7);
}

static void inverse_refuses_what_is_singular_to_rounding(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < SOME(1000); i++) {
        invcal_calibration c = {{0, 0, 0}, {{0}}};
        invcal_real inverse[3][3];
        for (int k = 0; k < 3; k++) {
            const double a = random_normal(&random);
            const double b = random_normal(&random);
            c.matrix[0][k] = (invcal_real)a;
            c.matrix[1][k] = (invcal_real)b;
            c.matrix[2][k] = (invcal_real)(0.3 * a - 0.4 * b);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_calibration_inverse(&c, inverse));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(apply_computes_matrix_times_raw_minus_offset);
    RUN_TEST(apply_works_in_place);
    RUN_TEST(apply_hands_a_nan_on);
    RUN_TEST(nominal_puts_the_scale_on_the_diagonal);
    RUN_TEST(nominal_refuses_what_is_no_scale_and_leaves_the_output_alone);
    RUN_TEST(nominal_refuses_a_zero_that_is_not_finite);
    RUN_TEST(inverse_agrees_with_the_one_worked_out_by_hand);
    RUN_TEST(inverse_works_in_any_unit);
    RUN_TEST(inverse_refuses_singular_and_unreal_matrices);
    RUN_TEST(inverse_refuses_a_matrix_whose_inverse_is_not_finite);
    RUN_TEST(inverse_refuses_what_is_singular_to_rounding);
    return UNITY_END() != 0;
}
