/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "expected.h"
#include "fisher.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* What fisher.h says, relative. */
static const double promised = FLOAT_OR_DOUBLE(3e-6, 1e-12);

static double tail(double z, unsigned m, unsigned dof)
{
    return (double)invcal_fisher_tail((invcal_real)z, m, dof);
}

static void the_tail_is_that_of_the_reference(void)
{
    for (int i = 0; i < EXPECTED_FISHER_COUNT; i++) {
        const double *row = expected_fisher[i];
        const double p = tail(row[2], (unsigned)row[0], (unsigned)row[1]);
        TEST_ASSERT_DOUBLE_WITHIN(promised, 1, p / row[3]);
    }
}

/* P(F > f) of m and dof is P(1/F < 1/f) of dof and m: the two sides change places. */
static void the_tails_of_f_and_of_its_inverse_make_one(void)
{
    for (unsigned m = 1; m < 60; m++) {
        for (unsigned dof = 1; dof < 60; dof++) {
            for (int k = 1; k < 16; k++) {
                const double z = k / 16.0;
                TEST_ASSERT_DOUBLE_WITHIN(promised, 1, tail(z, m, dof) + tail(1 - z, dof, m));
            }
        }
    }
}

static void with_two_degrees_of_freedom_the_tail_is_a_power(void)
{
    for (unsigned dof = 1; dof < 60; dof++) {
        for (int k = 1; k < 16; k++) {
            const double z = k / 16.0;
            /* the power is rounded in proportion to its exponent, seen where double is float */
            TEST_ASSERT_DOUBLE_WITHIN(promised + dof * DBL_EPSILON, 1,
                                      tail(z, 2, dof) / pow(z, dof / 2.0));
        }
    }
}

static void a_larger_f_is_less_likely(void)
{
    for (unsigned m = 1; m < 32; m++) {
        for (unsigned dof = 1; dof < 60; dof++) {
            for (int k = 1; k < 64; k++) {
                const double here = tail(k / 64.0, m, dof);
                const double next = tail((k + 1) / 64.0, m, dof);
                TEST_ASSERT_TRUE(here >= 0 && next <= 1);
                TEST_ASSERT_TRUE(here <= next + promised * next);
            }
        }
    }
}

static void outside_of_0_and_1_it_is_certain_or_impossible(void)
{
    static const double certain[] = {1, 1.5, INFINITE, NOT_A_NUMBER};
    static const double impossible[] = {0, -0.0, -1, -INFINITE};

    for (int i = 0; i < 4; i++) {
        for (unsigned m = 1; m < 5; m++) {
            TEST_ASSERT_TRUE(tail(certain[i], m, 7) == 1);
            TEST_ASSERT_TRUE(tail(impossible[i], m, 7) == 0);
        }
    }
}

static void next_to_0_and_1_it_is_neither_negative_nor_above_1(void)
{
    for (unsigned m = 1; m < 32; m++) {
        for (unsigned dof = 1; dof < 60; dof++) {
            const double low = tail((double)INVCAL_EPSILON, m, dof);
            const double high = tail(1 - (double)INVCAL_EPSILON, m, dof);
            TEST_ASSERT_TRUE(low >= 0 && low < 0.01);
            TEST_ASSERT_TRUE(high > 0.97 && high <= 1);
        }
    }
}

/* Many more than the accuracy is promised for: it ends, within a probability's range. With so
 * many residuals F is the square of a normal number. */
static void a_thousand_degrees_of_freedom_come_near_the_normal_law(void)
{
    const double dof = 1000;
    const double z = 1 / (1 + 1.959964 * 1.959964 / dof);

    TEST_ASSERT_DOUBLE_WITHIN(0.001, 0.05, tail(z, 1, 1000));
    TEST_ASSERT_TRUE(tail(0.999, 1001, 60001) > 0.999);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_tail_is_that_of_the_reference);
    RUN_LONG_TEST(the_tails_of_f_and_of_its_inverse_make_one);
    RUN_TEST(with_two_degrees_of_freedom_the_tail_is_a_power);
    RUN_LONG_TEST(a_larger_f_is_less_likely);
    RUN_TEST(outside_of_0_and_1_it_is_certain_or_impossible);
    RUN_TEST(next_to_0_and_1_it_is_neither_negative_nor_above_1);
    RUN_TEST(a_thousand_degrees_of_freedom_come_near_the_normal_law);
    return UNITY_END() != 0;
}
