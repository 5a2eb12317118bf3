/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <string.h>

#include "maths/eigen.h"
#include "expected.h"
#include "support.h"
#include "core/system.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = EIGEN_MAX, SUMS = INVCAL_PACKED_SIZE(EIGEN_MAX) };
static const double tiny = 2e-15;

/* The largest eigenvalue; a NaN if there is one among them. */
static double largest_of(const double *a, unsigned n)
{
    double value[N];
    double most = -HUGE_VAL;

    eigenvalues(a, n, value);
    for (unsigned r = 0; r < n; r++) {
        most = value[r] <= most ? most : value[r];
        if (isnan(most)) {
            break;
        }
    }
    return most;
}

/* M = R diag(a) R' with known a: equal, close and far apart. */
static void eigenvalues_are_those_the_matrix_was_made_from(void)
{
    static const double values[][3] = {{1, 1, 1}, {1, 1, 2},          {1, 1 + 1e-6, 1 - 1e-6},
                                       {1, 2, 3}, {1e-3, 1, 1e3},     {-1, 0, 1},
                                       {0, 0, 0}, {1, 1e-30, -1e-30}, {0.81, 1, 1.21}};
    random_source random = random_start(1);

    for (unsigned i = 0; i < sizeof values / sizeof values[0]; i++) {
        for (int repetition = 0; repetition < 50; repetition++) {
            double rotation[3][3];
            double m[6];
            double value[3];
            random_rotation(&random, rotation);
            for (unsigned r = 0; r < 3; r++) {
                for (unsigned c = 0; c <= r; c++) {
                    double sum = 0;
                    for (unsigned k = 0; k < 3; k++) {
                        sum += rotation[r][k] * values[i][k] * rotation[c][k];
                    }
                    m[INVCAL_PACKED(r, c)] = sum;
                }
            }
            eigenvalues(m, 3, value);
            double trace[4] = {0};
            double sum[4] = {0};
            for (unsigned k = 0; k < 3; k++) {
                for (int power = 1; power <= 3; power++) {
                    trace[power] += pow(values[i][k], power);
                    sum[power] += pow(value[k], power);
                }
            }
            const double scale = fmax(1, fabs(values[i][2]));
            for (int power = 1; power <= 3; power++) {
                TEST_ASSERT_DOUBLE_WITHIN(10 * tiny * pow(scale, power), trace[power], sum[power]);
            }
        }
    }
}

static void a_nan_in_the_matrix_shows_in_the_values(void)
{
    for (unsigned k = 0; k < 6; k++) {
        double m[6] = {1, 0.1, 1, 0.1, 0.1, 1};
        double value[3];
        m[k] = NOT_A_NUMBER;
        eigenvalues(m, 3, value);
        TEST_ASSERT_TRUE(isnan(value[0]) || isnan(value[1]) || isnan(value[2]));
    }
}

/* The tridiagonal matrix of 2 and -1 has the eigenvalues 2 - 2 cos(k pi / (n + 1)). */
static void condition_of_a_toeplitz_matrix_agrees_with_its_closed_form(void)
{
    for (unsigned n = 1; n <= N; n++) {
        const double step = acos(-1.0) / (n + 1);
        const double expected = (1 - cos(n * step)) / (1 - cos(step));
        double a[SUMS] = {0};
        for (unsigned r = 0; r < n; r++) {
            a[INVCAL_PACKED(r, r)] = 2;
            if (r > 0) {
                a[INVCAL_PACKED(r, r - 1)] = -1;
            }
        }
        TEST_ASSERT_DOUBLE_WITHIN(10 * tiny * expected * expected, expected, eigen_condition(a, n));
    }
}

/* P = I - 2 v v' keeps eigenvalues: P diag P is full, with known condition. */
static void condition_does_not_depend_on_the_axes(void)
{
    random_source random = random_start(3);

    for (int i = 0; i < 200; i++) {
        const double condition = pow(10, random_uniform(&random, 0, 3));
        double v[N];
        double square = 0;
        double d[N];
        double a[SUMS];
        for (unsigned r = 0; r < N; r++) {
            v[r] = random_normal(&random);
            square += v[r] * v[r];
            d[r] = pow(condition, random_uniform(&random, 0, 1));
        }
        d[3] = 1;
        d[5] = condition;
        for (unsigned r = 0; r < N; r++) {
            for (unsigned c = 0; c <= r; c++) {
                double sum = 0;
                for (unsigned k = 0; k < N; k++) {
                    const double pr = (r == k) - 2 * v[r] * v[k] / square;
                    const double pc = (c == k) - 2 * v[c] * v[k] / square;
                    sum += pr * d[k] * pc;
                }
                a[INVCAL_PACKED(r, c)] = sum;
            }
        }
        TEST_ASSERT_DOUBLE_WITHIN(9 * tiny * condition * condition, condition,
                                  eigen_condition(a, N));
    }
}

static void condition_of_a_diagonal_matrix_is_its_spread(void)
{
    for (unsigned n = 2; n <= N; n++) {
        double a[SUMS] = {0};
        for (unsigned r = 0; r < n; r++) {
            a[INVCAL_PACKED(r, r)] = (r + 1);
        }
        TEST_ASSERT_DOUBLE_WITHIN(n * n * tiny, n, eigen_condition(a, n));
    }
}

static void condition_does_not_depend_on_the_unit(void)
{
    for (int exponent = -30; exponent <= 30; exponent += 5) {
        const double scale = pow(10, exponent);
        double a[6] = {1, 0.5, 1, 0, 0.5, 1};
        double one[6] = {1, 1, 1, 1, 1, 1}; /* singular */
        for (int k = 0; k < 6; k++) {
            a[k] = (a[k] * scale);
            one[k] = (one[k] * scale);
        }
        const double expected = (2 + sqrt(2)) / (2 - sqrt(2)); /* 1 +- 1/sqrt(2) */
        TEST_ASSERT_DOUBLE_WITHIN(60 * tiny, expected, eigen_condition(a, 3));
        TEST_ASSERT_TRUE(eigen_condition(one, 3) == HUGE_VAL);
    }
}

static void elements_too_small_to_matter_do_not(void)
{
    for (int exponent = -38; exponent <= -8; exponent++) {
        const double e = pow(10, exponent);
        double three[6] = {1, e, 1e-3, e, e, 1};
        double two[3] = {1e-3, e, 1};
        const double bound = 5e6 * tiny + 1001 * e;
        TEST_ASSERT_DOUBLE_WITHIN(bound, 1000, eigen_condition(three, 3));
        TEST_ASSERT_DOUBLE_WITHIN(bound, 1000, eigen_condition(two, 2));
    }
}

static void what_is_not_positive_definite_has_no_condition(void)
{
    const double bad[] = {-1, 0, NOT_A_NUMBER, -INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned k = 0; k < N; k++) {
            double a[SUMS] = {0};
            for (unsigned r = 0; r < N; r++) {
                a[INVCAL_PACKED(r, r)] = 1;
            }
            a[INVCAL_PACKED(k, k)] = bad[i];
            TEST_ASSERT_TRUE(eigen_condition(a, N) == HUGE_VAL);
        }
    }
}

static void a_nan_beside_the_diagonal_has_no_condition(void)
{
    for (unsigned r = 1; r < N; r++) {
        double a[SUMS] = {0};
        for (unsigned k = 0; k < N; k++) {
            a[INVCAL_PACKED(k, k)] = 1;
        }
        a[INVCAL_PACKED(r, r - 1)] = NOT_A_NUMBER;
        TEST_ASSERT_TRUE(eigen_condition(a, N) == HUGE_VAL);
    }
}

/* ---- the largest eigenvalue alone ---- */

static const double epsilon = DBL_EPSILON;

static void copy_of(const double *from, unsigned n, double factor, double *to)
{
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(n); i++) {
        to[i] = (from[i] * factor);
    }
}

/* The tridiagonal matrix of 2 and -1, and that of 2 and 1: 2 + 2 cos(pi / (n + 1)). */
static void the_largest_eigenvalue_of_a_toeplitz_matrix_agrees_with_its_closed_form(void)
{
    for (unsigned n = 1; n <= N; n++) {
        const double expected = 2 + 2 * cos(acos(-1.0) / (n + 1));
        for (int beside = -1; beside <= 1; beside += 2) {
            double a[SUMS] = {0};
            for (unsigned r = 0; r < n; r++) {
                a[INVCAL_PACKED(r, r)] = 2;
                if (r > 0) {
                    a[INVCAL_PACKED(r, r - 1)] = beside;
                }
            }
            TEST_ASSERT_DOUBLE_WITHIN((n + 1) * epsilon * expected, expected, largest_of(a, n));
        }
    }
}

static void the_largest_eigenvalue_of_a_diagonal_matrix_is_its_largest_element(void)
{
    for (unsigned n = 1; n <= N; n++) {
        for (unsigned at = 0; at < n; at++) {
            double a[SUMS] = {0};
            for (unsigned r = 0; r < n; r++) {
                a[INVCAL_PACKED(r, r)] = (r == at ? 7 : 1 + 0.125 * r);
            }
            TEST_ASSERT_DOUBLE_WITHIN(2 * 7 * epsilon, 7, largest_of(a, n));
        }
    }
}

/* All ones and t more on the diagonal: n + t, and t for all others. Rank one to rounding. */
static void the_largest_eigenvalue_does_not_need_the_others(void)
{
    for (unsigned n = 2; n <= N; n++) {
        for (int exponent = 0; exponent <= 12; exponent++) {
            const double more = pow(10, -exponent);
            double a[SUMS];
            for (unsigned r = 0; r < n; r++) {
                for (unsigned c = 0; c <= r; c++) {
                    a[INVCAL_PACKED(r, c)] = (r == c ? 1 + more : 1);
                }
            }
            TEST_ASSERT_DOUBLE_WITHIN((n + 0.5) * epsilon * (n + more), n + more, largest_of(a, n));
        }
    }
}

static void the_largest_eigenvalue_scales_with_the_unit(void)
{
    for (int exponent = -30; exponent <= 30; exponent++) {
        const double scale = pow(10, exponent);
        double a[SUMS];
        copy_of(expected_random9_matrix, 9, scale, a);
        const double expected = expected_random9_largest * scale;
        TEST_ASSERT_DOUBLE_WITHIN(14 * epsilon * expected, expected, largest_of(a, 9));
    }
}

/* P = I - 2 v v' keeps eigenvalues. The elements of P diag P are rounded too, to half of epsilon
 * of the norm each. */
static void the_largest_eigenvalue_does_not_depend_on_the_axes(void)
{
    random_source random = random_start(4);

    for (int i = 0; i < 500; i++) {
        const unsigned n = 2 + (unsigned)i % (N - 1);
        const double largest = pow(10, random_uniform(&random, -3, 3));
        const double spread = pow(10, random_uniform(&random, 0, 10));
        double v[N];
        double d[N];
        double square = 0;
        double a[SUMS];
        for (unsigned r = 0; r < n; r++) {
            v[r] = random_normal(&random);
            square += v[r] * v[r];
            d[r] = largest * pow(spread, -random_uniform(&random, 0, 1));
        }
        d[(unsigned)i / N % n] = largest;
        for (unsigned r = 0; r < n; r++) {
            for (unsigned c = 0; c <= r; c++) {
                double sum = 0;
                for (unsigned k = 0; k < n; k++) {
                    const double pr = (r == k) - 2 * v[r] * v[k] / square;
                    const double pc = (c == k) - 2 * v[c] * v[k] / square;
                    sum += pr * d[k] * pc;
                }
                a[INVCAL_PACKED(r, c)] = sum;
            }
        }
        TEST_ASSERT_DOUBLE_WITHIN(2 * n * epsilon * largest, largest, largest_of(a, n));
    }
}

/* Largest of A times largest of A^-1: the condition without being multiplied by itself. The
 * elements of A^-1 are rounded to half of epsilon each. */
static void assert_condition_of_two(const double *matrix, const double *inverse, unsigned n,
                                    double largest, double largest_of_inverse)
{
    const double condition = largest * largest_of_inverse;
    double a[SUMS];

    copy_of(matrix, n, 1, a);
    const double first = largest_of(a, n);
    copy_of(inverse, n, 1, a);
    const double second = largest_of(a, n);
    TEST_ASSERT_DOUBLE_WITHIN(n * epsilon * largest, largest, first);
    TEST_ASSERT_DOUBLE_WITHIN(1.5 * n * epsilon * largest_of_inverse, largest_of_inverse, second);
    TEST_ASSERT_DOUBLE_WITHIN(2.5 * n * epsilon * condition, condition, first * second);
}

static void the_largest_of_a_matrix_and_its_inverse_give_its_condition(void)
{
    assert_condition_of_two(expected_pascal5_matrix, expected_pascal5_inverse, 5,
                            expected_pascal5_largest, expected_pascal5_inverse_largest);
    assert_condition_of_two(expected_random9_matrix, expected_random9_inverse, 9,
                            expected_random9_largest, expected_random9_inverse_largest);
    /* The inverse is tridiagonal: 4 cos^2 and 4 sin^2 of multiples of pi / 38. */
    const double step = acos(-1.0) / 38;
    assert_condition_of_two(expected_min_matrix, expected_min_inverse[8], 9,
                            1 / (4 * sin(step) * sin(step)), 4 * cos(2 * step) * cos(2 * step));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(eigenvalues_are_those_the_matrix_was_made_from);
    RUN_TEST(a_nan_in_the_matrix_shows_in_the_values);
    RUN_TEST(condition_of_a_toeplitz_matrix_agrees_with_its_closed_form);
    RUN_TEST(condition_does_not_depend_on_the_axes);
    RUN_TEST(condition_of_a_diagonal_matrix_is_its_spread);
    RUN_TEST(condition_does_not_depend_on_the_unit);
    RUN_TEST(elements_too_small_to_matter_do_not);
    RUN_TEST(what_is_not_positive_definite_has_no_condition);
    RUN_TEST(a_nan_beside_the_diagonal_has_no_condition);
    RUN_TEST(the_largest_eigenvalue_of_a_toeplitz_matrix_agrees_with_its_closed_form);
    RUN_TEST(the_largest_eigenvalue_of_a_diagonal_matrix_is_its_largest_element);
    RUN_TEST(the_largest_eigenvalue_does_not_need_the_others);
    RUN_TEST(the_largest_eigenvalue_scales_with_the_unit);
    RUN_TEST(the_largest_eigenvalue_does_not_depend_on_the_axes);
    RUN_TEST(the_largest_of_a_matrix_and_its_inverse_give_its_condition);
    return UNITY_END() != 0;
}
