/* SPDX-License-Identifier: MIT */
#include "maths/f_tail.h"

#include <math.h>

#include "expected.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void the_tail_is_that_of_the_reference(void)
{
    for (int i = 0; i < EXPECTED_FISHER_COUNT; i++) {
        const double *row = expected_fisher[i];
        const double p = f_tail(row[2], (unsigned)row[0], (unsigned)row[1]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1, p / row[3]);
    }
}

/* P(F > f) of m and dof is P(1/F < 1/f) of dof and m; with m = 2 it is a power. */
static void the_tails_of_f_and_of_its_inverse_add_up_to_one(void)
{
    static const unsigned dof[] = {1, 2, 3, 9, 50, 1000, 60001};

    for (unsigned i = 0; i < 49; i++) {
        const unsigned m = dof[i / 7];
        const unsigned n = dof[i % 7];
        for (int k = 1; k < 64; k++) {
            const double z = k / 64.0;
            TEST_ASSERT_DOUBLE_WITHIN(1e-10, 1, f_tail(z, m, n) + f_tail(1 - z, n, m));
            TEST_ASSERT_DOUBLE_WITHIN(1e-10, pow(z, n / 2.0), f_tail(z, 2, n));
        }
    }
}

static void outside_of_0_and_1_it_is_certain_or_impossible(void)
{
    TEST_ASSERT_TRUE(f_tail(1, 1, 7) == 1 && f_tail(INFINITE, 1, 7) == 1);
    TEST_ASSERT_TRUE(f_tail(NOT_A_NUMBER, 1, 7) == 1);
    TEST_ASSERT_TRUE(f_tail(0, 1, 7) == 0 && f_tail(-INFINITE, 1, 7) == 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_tail_is_that_of_the_reference);
    RUN_TEST(the_tails_of_f_and_of_its_inverse_add_up_to_one);
    RUN_TEST(outside_of_0_and_1_it_is_certain_or_impossible);
    return UNITY_END() != 0;
}
