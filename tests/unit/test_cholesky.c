/* SPDX-License-Identifier: MIT */
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

enum { N = INVCAL_MAX_PARAMETERS, SUMS = INVCAL_PACKED_SIZE(INVCAL_MAX_PARAMETERS) };
static const double tiny = FLOAT_OR_DOUBLE(1e-6, 1e-14);

static unsigned packed_size(unsigned n)
{
    return INVCAL_PACKED_SIZE(n);
}

static void from_double(const double *in, invcal_real *out, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        out[i] = (invcal_real)in[i];
    }
}

/* M(r,c) = min(r,c), counted from 1: L is all ones, the inverse is tridiagonal. */
static void fill_min(invcal_real *a, unsigned n)
{
    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[INVCAL_PACKED(r, c)] = (invcal_real)(c + 1);
        }
    }
}

static double inverse_of_min(unsigned n, unsigned r, unsigned c)
{
    return r == c ? (r + 1 == n ? 1 : 2) : r == c + 1 ? -1 : 0;
}

static void the_factor_of_the_min_matrix_is_all_ones_for_every_size(void)
{
    for (unsigned n = 1; n <= INVCAL_CHOLESKY_MAX; n++) {
        invcal_real a[INVCAL_PACKED_SIZE(INVCAL_CHOLESKY_MAX)];
        fill_min(a, n);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, n, INVCAL_PIVOT_FLOOR));
        for (unsigned i = 0; i < packed_size(n); i++) {
            TEST_ASSERT_EQUAL_DOUBLE(1, (double)a[i]);
        }
    }
}

static void inverse_and_its_diagonal_agree_with_the_closed_form(void)
{
    for (unsigned n = 1; n <= N; n++) {
        invcal_real a[SUMS];
        invcal_real diagonal[N];
        fill_min(a, n);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, n, INVCAL_PIVOT_FLOOR));
        invcal_cholesky_inverse_diagonal(a, n, diagonal);
        invcal_cholesky_inverse(a, n);
        for (unsigned r = 0; r < n; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(tiny, inverse_of_min(n, r, r), (double)diagonal[r]);
            for (unsigned c = 0; c <= r; c++) {
                TEST_ASSERT_DOUBLE_WITHIN(tiny, inverse_of_min(n, r, c),
                                          (double)a[INVCAL_PACKED(r, c)]);
            }
        }
    }
}

static void solve_finds_the_vector_behind_the_right_hand_side(void)
{
    for (unsigned n = 1; n <= N; n++) {
        invcal_real a[SUMS];
        invcal_real x[N];
        fill_min(a, n);
        for (unsigned r = 0; r < n; r++) { /* the vector is 1 2 3 ... n */
            double sum = 0;
            for (unsigned c = 0; c < n; c++) {
                sum += (r < c ? r + 1 : c + 1) * (c + 1.0);
            }
            x[r] = (invcal_real)sum;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, n, INVCAL_PIVOT_FLOOR));
        invcal_cholesky_solve(a, n, x);
        for (unsigned r = 0; r < n; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(n * 10 * tiny, r + 1.0, (double)x[r]);
        }
    }
}

static void forward_gives_the_variance_of_a_combination(void)
{
    invcal_real a[SUMS];
    invcal_real x[N] = {0};

    fill_min(a, 9);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, 9, INVCAL_PIVOT_FLOOR));
    x[3] = 1;
    x[4] = 1; /* 2 + 2 - 1 - 1 */
    invcal_cholesky_forward(a, 9, x);
    double square = 0;
    for (unsigned r = 0; r < 9; r++) {
        square += (double)x[r] * (double)x[r];
    }
    TEST_ASSERT_DOUBLE_WITHIN(tiny, 2, square);
}

static void assert_near(const double *expected, const invcal_real *actual, unsigned count,
                        double bound)
{
    double largest = 0;

    for (unsigned i = 0; i < count; i++) {
        largest = fmax(largest, fabs(expected[i]));
    }
    for (unsigned i = 0; i < count; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(bound * largest, expected[i], (double)actual[i]);
    }
}

static void assert_factored(unsigned n, const double *matrix, const double *factor,
                            const double *inverse, double inverse_bound)
{
    invcal_real a[SUMS];

    from_double(matrix, a, packed_size(n));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, n, INVCAL_PIVOT_FLOOR));
    assert_near(factor, a, packed_size(n), 10 * tiny);
    invcal_cholesky_inverse(a, n);
    assert_near(inverse, a, packed_size(n), inverse_bound);
}

static void a_random_matrix_agrees_with_exact_rational_arithmetic(void)
{
    assert_factored(9, expected_random9_matrix, expected_random9_factor, expected_random9_inverse,
                    100 * tiny);
}

static void the_pascal_matrix_agrees_with_its_integer_inverse(void)
{
    assert_factored(5, expected_pascal5_matrix, expected_pascal5_factor, expected_pascal5_inverse,
                    1000 * tiny);
}

/* A = M M' with M of `rank` random columns. */
static void random_of_rank(random_source *random, unsigned rank, invcal_real *a)
{
    double m[N][N];

    for (unsigned r = 0; r < N; r++) {
        for (unsigned k = 0; k < rank; k++) {
            m[r][k] = random_normal(random);
        }
    }
    for (unsigned r = 0; r < N; r++) {
        for (unsigned c = 0; c <= r; c++) {
            double sum = 0;
            for (unsigned k = 0; k < rank; k++) {
                sum += m[r][k] * m[c][k];
            }
            a[INVCAL_PACKED(r, c)] = (invcal_real)sum;
        }
    }
}

/* In float one in a hundred has no small pivot: see the header. */
static void matrices_of_deficient_rank_are_refused(void)
{
    random_source random = random_start(1);
    invcal_real a[SUMS];
    unsigned passed = 0;

    for (unsigned i = 0; i < SOME(8000); i++) {
        random_of_rank(&random, 1 + i % (N - 1), a);
        passed += invcal_cholesky_factor(a, N, INVCAL_PIVOT_FLOOR) == INVCAL_OK;
    }
    TEST_ASSERT_LESS_OR_EQUAL_UINT(FLOAT_OR_DOUBLE(SOME(160), 0), passed);
}

static void indefinite_zero_and_unreal_matrices_are_refused(void)
{
    static const double bad[] = {-1, 0, NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned r = 0; r < N; r++) {
            invcal_real a[SUMS];
            fill_min(a, N);
            a[INVCAL_PACKED(r, r)] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                                  invcal_cholesky_factor(a, N, INVCAL_PIVOT_FLOOR));
        }
    }
}

static void a_nan_beside_the_diagonal_is_refused(void)
{
    for (unsigned r = 1; r < N; r++) {
        for (unsigned c = 0; c < r; c++) {
            invcal_real a[SUMS];
            fill_min(a, N);
            a[INVCAL_PACKED(r, c)] = (invcal_real)NAN;
            TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                                  invcal_cholesky_factor(a, N, INVCAL_PIVOT_FLOOR));
        }
    }
}

/* A floor relative to the pivot's own diagonal element would let this one through. */
static void the_floor_is_relative_to_the_largest_diagonal_element(void)
{
    const invcal_real floor = (invcal_real)1e-3;
    invcal_real small[3] = {1, 0, (invcal_real)0.9e-3};
    invcal_real enough[3] = {1, 0, (invcal_real)1.1e-3};

    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_cholesky_factor(small, 2, floor));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(enough, 2, floor));
}

static void the_floor_does_not_depend_on_the_unit(void)
{
    for (int exponent = -12; exponent <= 12; exponent += 3) {
        invcal_real a[SUMS];
        fill_min(a, N);
        for (unsigned i = 0; i < packed_size(N); i++) {
            a[i] *= (invcal_real)pow(10, exponent);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cholesky_factor(a, N, INVCAL_PIVOT_FLOOR));
    }
}

static void a_floor_that_is_no_number_refuses_everything(void)
{
    invcal_real a[SUMS];

    fill_min(a, N);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_cholesky_factor(a, N, (invcal_real)NAN));
    a[0] = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_cholesky_factor(a, N, -100));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_factor_of_the_min_matrix_is_all_ones_for_every_size);
    RUN_TEST(inverse_and_its_diagonal_agree_with_the_closed_form);
    RUN_TEST(solve_finds_the_vector_behind_the_right_hand_side);
    RUN_TEST(forward_gives_the_variance_of_a_combination);
    RUN_TEST(a_random_matrix_agrees_with_exact_rational_arithmetic);
    RUN_TEST(the_pascal_matrix_agrees_with_its_integer_inverse);
    RUN_TEST(matrices_of_deficient_rank_are_refused);
    RUN_TEST(indefinite_zero_and_unreal_matrices_are_refused);
    RUN_TEST(a_nan_beside_the_diagonal_is_refused);
    RUN_TEST(the_floor_is_relative_to_the_largest_diagonal_element);
    RUN_TEST(the_floor_does_not_depend_on_the_unit);
    RUN_TEST(a_floor_that_is_no_number_refuses_everything);
    return UNITY_END() != 0;
}
