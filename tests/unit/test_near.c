/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "../../src/near.h"
#include "expected.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double tiny = FLOAT_OR_DOUBLE(6e-7, 2e-15);

/* R diag(value) R', packed, with an arbitrary rotation. */
static void make(random_source *random, const double value[3], double m[6])
{
    double rotation[3][3];

    random_rotation(random, rotation);
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            m[INVCAL_PACKED(r, c)] = 0;
            for (unsigned k = 0; k < 3; k++) {
                m[INVCAL_PACKED(r, c)] += rotation[k][r] * value[k] * rotation[k][c];
            }
        }
    }
}

static void to_real(const double m[6], double less, invcal_real e[6])
{
    for (unsigned i = 0; i < 6; i++) {
        e[i] = (invcal_real)(m[i] - (i == 0 || i == 2 || i == 5 ? less : 0));
    }
}

/* M = B B: its root is the B that it was made from, and the other is B^-1. */
static void the_root_of_a_square_is_what_was_squared(void)
{
    for (unsigned i = 0; i < EXPECTED_ROOTS; i++) {
        invcal_real e[6];
        invcal_real root[6];
        invcal_real inverse[6];
        invcal_real back[6];
        to_real(expected_root_square[i], 1, e);
        invcal_near_root(e, root, inverse);
        invcal_near_inverse(inverse, back);
        for (unsigned k = 0; k < 6; k++) {
            const double one = k == 0 || k == 2 || k == 5;
            TEST_ASSERT_DOUBLE_WITHIN(10 * tiny, expected_root[i][k] - one, (double)root[k]);
            TEST_ASSERT_DOUBLE_WITHIN(20 * tiny, expected_root[i][k] - one, (double)back[k]);
        }
    }
}

/* In the axes of M: any eigenvalues from 0.01 to 100 have their roots and inverse roots. Every
 * third M has one large one beside two small ones, where an inverse by the adjoint
 * would lose the square of the condition. */
static void roots_are_right_for_axes_of_any_length_within_the_limits(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < 300; i++) {
        double square[3];
        double root[3];
        double inverse[3];
        double least = 10;
        double most = 0.1;
        double m[6];
        double expected[2][6];
        invcal_real e[6];
        invcal_real found[2][6];
        for (unsigned k = 0; k < 3; k++) {
            root[k] = pow(10, random_uniform(&random, -1, 1));
            if (i % 3 == 0) {
                root[k] = k == 0 ? fmax(root[k], 1 / root[k]) : 1 / root[0];
            }
            square[k] = root[k] * root[k];
            inverse[k] = 1 / root[k];
            least = fmin(least, root[k]);
            most = fmax(most, root[k]);
        }
        const double condition = most * most / (least * least);
        random_source same = random;
        make(&random, square, m);
        random = same;
        make(&random, root, expected[0]);
        random = same;
        make(&random, inverse, expected[1]);
        to_real(m, 1, e);
        invcal_near_root(e, found[0], found[1]);
        for (unsigned k = 0; k < 6; k++) {
            const double one = k == 0 || k == 2 || k == 5;
            TEST_ASSERT_DOUBLE_WITHIN(6 * tiny * condition * most, expected[0][k] - one,
                                      (double)found[0][k]);
            TEST_ASSERT_DOUBLE_WITHIN(6 * tiny * condition / least, expected[1][k] - one,
                                      (double)found[1][k]);
        }
    }
}

/* (I + E)^-1 - I of an E of any size, to the digits of E: 1/(1 + e) - 1 = -e / (1 + e). */
static void small_deviations_keep_their_digits(void)
{
    random_source random = random_start(2);

    for (int exponent = 0; exponent <= 30; exponent++) {
        const double size = pow(10, -exponent);
        const double value[3] = {0.3 * size, -0.5 * size, 0.1 * size};
        double inverse[3];
        double m[6];
        double expected[6];
        invcal_real e[6];
        invcal_real found[6];
        for (unsigned k = 0; k < 3; k++) {
            inverse[k] = -value[k] / (1 + value[k]);
        }
        random_source same = random;
        make(&random, value, m);
        random = same;
        make(&random, inverse, expected);
        to_real(m, 0, e);
        invcal_near_inverse(e, found);
        for (unsigned k = 0; k < 6; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(5 * tiny * size, expected[k], (double)found[k]);
        }
    }
}

/* Twelve steps of Newton from x = 1 end at sqrt(a) coth(2^12 artanh(1 / sqrt(a))), still far from
 * the root of an a so large. */
static void the_iteration_ends_after_twelve_steps_wherever_it_has_come(void)
{
    const double root = 1e5;
    const double angle = 4096 * 0.5 * log((1 + 1 / root) / (1 - 1 / root));
    const double expected = root * (1 + exp(-2 * angle)) / (1 - exp(-2 * angle));
    const invcal_real e[6] = {(invcal_real)(root * root - 1), 0, 0, 0, 0, 0};
    invcal_real y[6];
    invcal_real z[6];

    needs_53_bits();
    invcal_near_root(e, y, z);
    TEST_ASSERT_TRUE(expected > 20 * root);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-3, 1e-8) * expected, expected, 1 + (double)y[0]);
    TEST_ASSERT_TRUE(y[2] == 0 && y[5] == 0);
}

static void eigenvalues_within_the_limits_are_told_from_those_beyond(void)
{
    static const double values[][3] = {{0.5, 1, 2},     {0.51, 1.9, 1.9}, {0.3, 1, 1},
                                       {2.2, 1, 1},     {-1, -1, 1},      {-1, 1, 1},
                                       {3, 3, 1},       {-2, -3, -4},     {0.49, 1, 1.9},
                                       {0.55, 1, 2.01}, {3, 3, 3},        {0.2, 0.2, 0.2}};
    random_source random = random_start(3);

    for (unsigned i = 0; i < sizeof values / sizeof values[0]; i++) {
        int within = 1;
        double m[6];
        invcal_real e[6];
        for (unsigned k = 0; k < 3; k++) {
            within &= values[i][k] > 0.4999 && values[i][k] < 2.0001;
        }
        for (int repetition = 0; repetition < 20; repetition++) {
            make(&random, values[i], m);
            to_real(m, 1, e);
            TEST_ASSERT_EQUAL_INT(
                within, invcal_near_is_between(e, (invcal_real)0.4999, (invcal_real)2.0001));
        }
    }
}

static void a_nan_lies_within_no_limits(void)
{
    for (unsigned k = 0; k < 6; k++) {
        invcal_real e[6] = {0, 0, 0, 0, 0, 0};
        e[k] = (invcal_real)NAN;
        TEST_ASSERT_FALSE(invcal_near_is_between(e, (invcal_real)0.01, 100));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_root_of_a_square_is_what_was_squared);
    RUN_TEST(roots_are_right_for_axes_of_any_length_within_the_limits);
    RUN_TEST(small_deviations_keep_their_digits);
    RUN_TEST(the_iteration_ends_after_twelve_steps_wherever_it_has_come);
    RUN_TEST(eigenvalues_within_the_limits_are_told_from_those_beyond);
    RUN_TEST(a_nan_lies_within_no_limits);
    return UNITY_END() != 0;
}
