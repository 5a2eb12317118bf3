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

/* Small whole numbers, so that the expected figures are exact in float, too. */
static const invcal_calibration example = {{1, 2, 3}, {{2, 1, 0}, {0, 3, 1}, {1, 0, 4}}};

static void apply_computes_matrix_times_raw_minus_offset(void)
{
    const invcal_real raw[3] = {2, 4, 6}; /* minus offset: 1 2 3 */
    const invcal_real expected[3] = {4, 9, 13};
    invcal_real out[3];

    invcal_apply(&example, raw[0], raw[1], raw[2], out);
    TEST_ASSERT_EQUAL_MEMORY(expected, out, sizeof out);
}

static void apply_works_in_place(void)
{
    const invcal_real expected[3] = {4, 9, 13};
    invcal_real v[3] = {2, 4, 6};

    invcal_apply(&example, v[0], v[1], v[2], v);
    TEST_ASSERT_EQUAL_MEMORY(expected, v, sizeof v);
}

static void apply_passes_a_nan_on(void)
{
    const invcal_real raw[3] = {(invcal_real)NAN, 0, 0};
    invcal_real out[3];

    invcal_apply(&example, raw[0], raw[1], raw[2], out);
    TEST_ASSERT_TRUE(isnan(out[0]) && isnan(out[2]));
}

static void samples_are_applied_as_their_numbers_are(void)
{
    const int32_t raw[3] = {2, 4, -30000};
    const invcal_real same[3] = {2, 4, -30000};
    invcal_real out[3];
    invcal_real expected[3];

    invcal_apply(&example, same[0], same[1], same[2], expected);
    invcal_apply(&example, (invcal_real)raw[0], (invcal_real)raw[1], (invcal_real)raw[2], out);
    TEST_ASSERT_EQUAL_MEMORY(expected, out, sizeof out);
}

static void a_unit_multiplies_the_matrix_and_no_offset(void)
{
    invcal_calibration c = example;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_scale(&c, 4));
    TEST_ASSERT_EQUAL_MEMORY(example.offset, c.offset, sizeof c.offset);
    for (unsigned i = 0; i < 9; i++) {
        TEST_ASSERT_TRUE(c.matrix[i / 3][i % 3] == 4 * example.matrix[i / 3][i % 3]);
    }
}

static void a_unit_that_is_not_a_length_is_refused(void)
{
    static const double bad[] = {0, -9.8, NOT_A_NUMBER, INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_calibration c = example;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_FIELD, invcal_scale(&c, (invcal_real)bad[i]));
        TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
    }
}

static void nominal_puts_the_inverse_of_the_counts_on_the_diagonal(void)
{
    const invcal_real zero[3] = {10, -20, 30};
    const invcal_real counts[3] = {2, -4, 8};
    const invcal_calibration expected = {
        {10, -20, 30},
        {{(invcal_real)0.5, 0, 0}, {0, (invcal_real)-0.25, 0}, {0, 0, (invcal_real)0.125}}};
    invcal_calibration c;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(zero, counts, &c));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &c, sizeof c);
}

static void nominal_refuses_what_is_not_a_scale_and_leaves_the_output_alone(void)
{
    const double bad[] = {0, NOT_A_NUMBER, INFINITE, -INFINITE, 1e-11, 0.95e-10, 1.05e10, 1e11};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned axis = 0; axis < 3; axis++) {
            const invcal_real zero[3] = {0, 0, 0};
            invcal_real counts[3] = {1, 1, 1};
            invcal_calibration c = example;
            counts[axis] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_nominal(zero, counts, &c));
            TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
        }
    }
}

static void nominal_refuses_a_zero_that_is_not_finite_or_absurd(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 2e18, -2e18};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const invcal_real counts[3] = {1, 1, 1};
        const invcal_real zero[3] = {0, 0, (invcal_real)bad[i]};
        invcal_calibration c = example;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_nominal(zero, counts, &c));
        TEST_ASSERT_EQUAL_MEMORY(&example, &c, sizeof c);
    }
}

static void nominal_takes_any_unit_within_reason(void)
{
    static const double scale[] = {1e-9, 1e-5, 2.4e-3, 1, 1e3, 16384, 1e6, 1e9};

    for (unsigned i = 0; i < sizeof scale / sizeof scale[0]; i++) {
        const invcal_real zero[3] = {0, 0, 0};
        const invcal_real s[3] = {(invcal_real)scale[i], (invcal_real)scale[i],
                                  (invcal_real)scale[i]};
        invcal_calibration c;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(zero, s, &c));
    }
}

/* Like an earlier calibration that must be renewed: a session asks for it. */
static invcal_status begin_with(const invcal_calibration *nominal)
{
    static invcal_session session;

    return invcal_session_init_nominal(&session, sizeof session, nominal, 100);
}

static void a_nominal_that_is_singular_or_unreal_is_refused(void)
{
    static const double bad[][3] = {{1, 2, 3}, {0, 0, 0}, {NOT_A_NUMBER, 1, 1}, {INFINITE, 1, 1}};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, begin_with(&example));
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_calibration c = example;
        for (unsigned k = 0; k < 3; k++) {
            c.matrix[0][k] = (invcal_real)bad[i][k];
            c.matrix[1][k] = 2 * c.matrix[0][k]; /* dependent, if finite */
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, begin_with(&c));
    }
}

static void a_nominal_that_is_singular_to_rounding_is_refused(void)
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
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, begin_with(&c));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(apply_computes_matrix_times_raw_minus_offset);
    RUN_TEST(apply_works_in_place);
    RUN_TEST(apply_passes_a_nan_on);
    RUN_TEST(samples_are_applied_as_their_numbers_are);
    RUN_TEST(a_unit_multiplies_the_matrix_and_no_offset);
    RUN_TEST(a_unit_that_is_not_a_length_is_refused);
    RUN_TEST(nominal_puts_the_inverse_of_the_counts_on_the_diagonal);
    RUN_TEST(nominal_refuses_what_is_not_a_scale_and_leaves_the_output_alone);
    RUN_TEST(nominal_refuses_a_zero_that_is_not_finite_or_absurd);
    RUN_TEST(nominal_takes_any_unit_within_reason);
    RUN_TEST(a_nominal_that_is_singular_or_unreal_is_refused);
    RUN_TEST(a_nominal_that_is_singular_to_rounding_is_refused);
    return UNITY_END() != 0;
}
