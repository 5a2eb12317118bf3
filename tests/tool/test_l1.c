/* SPDX-License-Identifier: MIT
 *
 * The l1 estimate: optimal by its own conditions, and not pulled by a wrong position.
 */
#include "fit/l1.h"

#include <math.h>
#include <string.h>

#include "expected.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { COUNT = 18, DRAWS = 300 };
static const invcal_calibration unit_matrix = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
static double raw[3 * COUNT];

static void measure(random_source *random, const triad_truth *truth, double noise)
{
    for (unsigned i = 0; i < COUNT; i++) {
        triad_read(truth, expected_plan18[i], &raw[3 * (size_t)i]);
        for (unsigned a = 0; a < 3 && noise > 0; a++) {
            raw[3 * i + a] += noise * random_normal(random);
        }
    }
}

/* Half of |A (u - delta)|^2 - 1, A = (I + S)^-1, by Cramer's rule. */
static double residual_at(const double x[9], const double u[3])
{
    const double s[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                            {x[6] / 2, 1 + x[4], x[8] / 2},
                            {x[7] / 2, x[8] / 2, 1 + x[5]}};
    double c[3][3];
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            c[i][j] = s[(i + 1) % 3][(j + 1) % 3] * s[(i + 2) % 3][(j + 2) % 3] -
                      s[(i + 1) % 3][(j + 2) % 3] * s[(i + 2) % 3][(j + 1) % 3];
        }
    }
    const double det = s[0][0] * c[0][0] + s[0][1] * c[0][1] + s[0][2] * c[0][2];
    for (int i = 0; i < 3; i++) {
        double v = 0;
        for (int j = 0; j < 3; j++) {
            v += c[j][i] * (u[j] - x[j]) / det;
        }
        sum += v * v;
    }
    return (sum - 1) / 2;
}

static double sum_at(const double x[9])
{
    double sum = 0;

    for (unsigned i = 0; i < COUNT; i++) {
        sum += fabs(residual_at(x, &raw[3 * (size_t)i]));
    }
    return sum;
}

/* It is the minimum: no other nine parameters, near or far, have a sum that is smaller by a
 * thousandth; at least nearly as many residuals as there are parameters are zero. */
static void no_other_parameters_leave_less(void)
{
    random_source random = random_start(1);
    const triad_truth truth = triad_random(&random, 0.01);
    double x[9];
    double other[9];
    unsigned zero = 0;

    measure(&random, &truth, 1e-4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, l1_fit(raw, COUNT, &unit_matrix, x));
    const double least = sum_at(x);
    for (int d = 0; d < 20000; d++) {
        const double size = pow(10, -3 - 4 * random_uniform(&random, 0, 1));
        for (int p = 0; p < 9; p++) {
            other[p] = x[p] + size * random_normal(&random);
        }
        TEST_ASSERT_TRUE(sum_at(other) > least * (1 - 1e-3));
    }
    for (unsigned i = 0; i < COUNT; i++) {
        zero += fabs(residual_at(x, &raw[3 * (size_t)i])) < 1e-6;
    }
    TEST_ASSERT_TRUE(zero >= 7); /* nine in the limit, which the weights reach slowly */
}

static void a_wrong_position_does_not_pull_it(void)
{
    random_source random = random_start(2);

    for (int d = 0; d < 50; d++) {
        const triad_truth truth = triad_random(&random, 0.01);
        double x[9];
        measure(&random, &truth, 0);
        raw[3 * (d % COUNT)] += 0.05 * (expected_plan18[d % COUNT][0] < 0 ? -1 : 1);
        raw[3 * (d % COUNT) + 1] += 0.05 * (expected_plan18[d % COUNT][1] < 0 ? -1 : 1);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, l1_fit(raw, COUNT, &unit_matrix, x));
        for (int p = 0; p < 9; p++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-4, truth.x[p], x[p]); /* least squares: 1e-2 */
        }
    }
}

/* For normal noise it is no better than least squares, and the difference stays small. */
static void its_spread_is_somewhat_larger_than_that_of_least_squares(void)
{
    random_source random = random_start(3);
    const triad_truth truth = triad_random(&random, 0.01);
    double squares = 0;

    for (int d = 0; d < DRAWS; d++) {
        double x[9];
        measure(&random, &truth, 1e-4);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, l1_fit(raw, COUNT, &unit_matrix, x));
        for (int p = 0; p < 9; p++) {
            const double e = (x[p] - truth.x[p]) / (1e-4 * expected_plan18_root_k[p]);
            squares += e * e;
        }
    }
    const double times = sqrt(squares / (9.0 * (double)DRAWS));
    TEST_ASSERT_TRUE(times > 1.1 && times < 1.5); /* sqrt(pi/2) = 1.25 with many positions */
}

static void too_few_are_refused(void)
{
    double x[9] = {7};

    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, l1_fit(raw, 8, &unit_matrix, x));
    TEST_ASSERT_DOUBLE_WITHIN(0, 7, x[0]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(no_other_parameters_leave_less);
    RUN_TEST(a_wrong_position_does_not_pull_it);
    RUN_TEST(its_spread_is_somewhat_larger_than_that_of_least_squares);
    RUN_TEST(too_few_are_refused);
    return UNITY_END();
}
