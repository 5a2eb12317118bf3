/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

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

/* Up to three polynomials of temperature of the nine parameters; a row more for the right side. */
enum { MOST = 27, N = 9, SUMS = INVCAL_PACKED_SIZE(MOST + 1) };
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
    for (unsigned n = 1; n <= MOST; n++) {
        invcal_real a[SUMS];
        fill_min(a, n);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, n, n, INVCAL_FLOOR));
        for (unsigned i = 0; i < packed_size(n); i++) {
            TEST_ASSERT_EQUAL_DOUBLE(1, (double)a[i]);
        }
    }
}

/* Element (r, c) of A^-1, from L^-1 in double. */
static double inverse_of(const invcal_real *inverse, unsigned n, unsigned r, unsigned c)
{
    double sum = 0;

    for (unsigned i = r > c ? r : c; i < n; i++) {
        sum += (double)inverse[INVCAL_PACKED(i, r)] * (double)inverse[INVCAL_PACKED(i, c)];
    }
    return sum;
}

static void inverse_and_variances_agree_with_the_closed_form(void)
{
    for (unsigned n = 1; n <= MOST; n++) {
        invcal_real a[SUMS];
        fill_min(a, n);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, n, n, INVCAL_FLOOR));
        invcali_invert(a, n);
        for (unsigned r = 0; r < n; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(tiny, inverse_of_min(n, r, r),
                                      (double)invcali_variance(a, n, r));
            for (unsigned c = 0; c <= r; c++) {
                TEST_ASSERT_DOUBLE_WITHIN(tiny, inverse_of_min(n, r, c), inverse_of(a, n, r, c));
            }
        }
    }
}

/* A p = -b with p = -(1 2 3 ... n), and p'A p behind b: A leaves nothing of it. */
static void a_system_is_solved_along_with_its_matrix(void)
{
    for (unsigned n = 1; n <= MOST; n++) {
        invcal_real a[SUMS];
        invcal_real *b = &a[INVCAL_PACKED(n, 0)];
        double constant = 0;
        fill_min(a, n);
        for (unsigned r = 0; r < n; r++) {
            double sum = 0;
            for (unsigned c = 0; c < n; c++) {
                sum += (r < c ? r + 1 : c + 1) * (c + 1.0);
            }
            b[r] = (invcal_real)sum;
            constant += sum * (r + 1);
        }
        b[n] = (invcal_real)(constant + 5);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, n, n + 1, INVCAL_FLOOR));
        TEST_ASSERT_DOUBLE_WITHIN(tiny * constant + tiny, 5, (double)b[n]);
        invcali_back_substitute(a, n);
        for (unsigned r = 0; r < n; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(n * 10 * tiny, -(r + 1.0), (double)b[r]);
        }
    }
}

static void leverage_is_the_variance_of_a_combination(void)
{
    invcal_real a[SUMS];
    invcal_real h[INVCAL_PARAMETERS] = {0};

    fill_min(a, 9);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, 9, 9, INVCAL_FLOOR));
    invcali_invert(a, 9);
    h[3] = 1;
    h[4] = 1; /* 2 + 2 - 1 - 1 */
    TEST_ASSERT_DOUBLE_WITHIN(tiny, 2, (double)invcali_leverage(a, h));
}

/* The elements on the diagonal are 1 2 ... n; the largest ignores a NaN. */
static void trace_and_largest_element_are_of_the_diagonal(void)
{
    invcal_real a[SUMS];

    for (unsigned n = 1; n <= N; n++) {
        fill_min(a, n);
        TEST_ASSERT_EQUAL_DOUBLE(n * (n + 1) / 2, (double)invcali_trace(a, n));
        TEST_ASSERT_EQUAL_DOUBLE(n, (double)invcali_largest_diagonal(a, n));
    }
    a[INVCAL_PACKED(8, 8)] = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_DOUBLE(8, (double)invcali_largest_diagonal(a, N));
    a[0] = -1;
    TEST_ASSERT_EQUAL_DOUBLE(0, (double)invcali_largest_diagonal(a, 1));
}

static void assert_close(const double *expected, const invcal_real *actual, unsigned count,
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
    invcal_real whole[SUMS];

    from_double(matrix, a, packed_size(n));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, n, n, INVCAL_FLOOR));
    for (unsigned i = 0; i < packed_size(n); i++) {
        whole[i] = a[i];
    }
    for (unsigned r = 0; r < n; r++) { /* kept as its inverse */
        whole[INVCAL_PACKED(r, r)] = 1 / a[INVCAL_PACKED(r, r)];
    }
    assert_close(factor, whole, packed_size(n), 10 * tiny);
    invcali_invert(a, n);
    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            whole[INVCAL_PACKED(r, c)] = (invcal_real)inverse_of(a, n, r, c);
        }
    }
    assert_close(inverse, whole, packed_size(n), inverse_bound);
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

/* In float one in a hundred has no small pivot: a combination that is open but hardly involves the
 * last parameters shows in none. It shows in the condition. */
static void matrices_of_deficient_rank_are_refused(void)
{
    random_source random = random_start(1);
    invcal_real a[SUMS];
    unsigned passed = 0;

    for (unsigned i = 0; i < SOME(8000); i++) {
        random_of_rank(&random, 1 + i % (N - 1), a);
        passed += invcali_factor(a, N, N, INVCAL_FLOOR) == INVCAL_OK;
    }
    TEST_ASSERT_LESS_OR_EQUAL_UINT(FLOAT_OR_DOUBLE(SOME(160) + 1, 0), passed);
}

static void indefinite_zero_and_unreal_matrices_are_refused(void)
{
    const double bad[] = {-1, 0, NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned r = 0; r < N; r++) {
            invcal_real a[SUMS];
            fill_min(a, N);
            a[INVCAL_PACKED(r, r)] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcali_factor(a, N, N, INVCAL_FLOOR));
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
            TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcali_factor(a, N, N, INVCAL_FLOOR));
        }
    }
}

/* A floor relative to the pivot's own diagonal element would accept this one. */
static void the_floor_is_relative_to_the_largest_diagonal_element(void)
{
    const invcal_real floor = (invcal_real)1e-3;
    invcal_real small[3] = {1, 0, (invcal_real)0.9e-3};
    invcal_real enough[3] = {1, 0, (invcal_real)1.1e-3};

    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcali_factor(small, 2, 2, floor));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(enough, 2, 2, floor));
}

static void the_floor_does_not_depend_on_the_unit(void)
{
    for (int exponent = -12; exponent <= 12; exponent += 3) {
        invcal_real a[SUMS];
        fill_min(a, N);
        for (unsigned i = 0; i < packed_size(N); i++) {
            a[i] *= (invcal_real)pow(10, exponent);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(a, N, N, INVCAL_FLOOR));
    }
}

static void a_floor_that_is_not_a_number_refuses_everything(void)
{
    invcal_real a[SUMS];

    fill_min(a, N);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcali_factor(a, N, N, (invcal_real)NAN));
    a[0] = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcali_factor(a, N, N, -100));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_factor_of_the_min_matrix_is_all_ones_for_every_size);
    RUN_TEST(inverse_and_variances_agree_with_the_closed_form);
    RUN_TEST(a_system_is_solved_along_with_its_matrix);
    RUN_TEST(leverage_is_the_variance_of_a_combination);
    RUN_TEST(trace_and_largest_element_are_of_the_diagonal);
    RUN_TEST(a_random_matrix_agrees_with_exact_rational_arithmetic);
    RUN_TEST(the_pascal_matrix_agrees_with_its_integer_inverse);
    RUN_TEST(matrices_of_deficient_rank_are_refused);
    RUN_TEST(indefinite_zero_and_unreal_matrices_are_refused);
    RUN_TEST(a_nan_beside_the_diagonal_is_refused);
    RUN_TEST(the_floor_is_relative_to_the_largest_diagonal_element);
    RUN_TEST(the_floor_does_not_depend_on_the_unit);
    RUN_TEST(a_floor_that_is_not_a_number_refuses_everything);
    return UNITY_END() != 0;
}
