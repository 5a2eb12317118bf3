/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "core/sums.h"
#include "support.h"
#include "core/system.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- rows ------------------------------------------------------------------------------------- */

static const double tiny = FLOAT_OR_DOUBLE(4e-7, 1e-15);

static void rows_stand_in_the_order_of_the_paper(void)
{
    const invcal_calibration nominal = unit_nominal();
    const invcal_real u[3] = {1, 2, 3};
    static const double expected[9] = {1, 2, 3, 1, 4, 9, 2, 3, 6};
    invcali_row row;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, u, &row));
    for (int r = 0; r < 9; r++) {
        TEST_ASSERT_EQUAL_DOUBLE(expected[r], (double)row.h[r]);
    }
    TEST_ASSERT_EQUAL_DOUBLE(6.5, (double)row.h[INVCAL_J]); /* (14 - 1)/2 */
}

/* A sphere of radius R about c: |u|^2 - 2 c u + |c|^2 = R^2. Times s = 1/(R^2 - |c|^2) this is
 * j + h p = 0 with p = (-s c, (s-1)/2, (s-1)/2, (s-1)/2, 0, 0, 0). */
static void the_exact_row_vanishes_on_a_sphere_of_any_size_and_place(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(1);

    for (int i = 0; i < SOME(500); i++) {
        const double radius = random_uniform(&random, 0.7, 1.4);
        double c[3];
        double eta[3];
        for (int k = 0; k < 3; k++) {
            c[k] = random_uniform(&random, -0.3, 0.3);
        }
        random_direction(&random, eta);
        const double s = 1 / (radius * radius - length3(c) * length3(c));
        const double p[9] = {-s * c[0],   -s * c[1],   -s * c[2],
                             (s - 1) / 2, (s - 1) / 2, (s - 1) / 2};
        invcal_real u[3];
        for (int k = 0; k < 3; k++) {
            u[k] = (invcal_real)(c[k] + radius * eta[k]);
        }
        invcali_row row;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, u, &row));
        double sum = (double)row.h[INVCAL_J];
        for (int r = 0; r < 9; r++) {
            sum += (double)row.h[r] * p[r];
        }
        TEST_ASSERT_DOUBLE_WITHIN(10 * tiny, 0, sum);
    }
}

static void a_reading_is_what_the_nominal_calibration_makes_of_it(void)
{
    const invcal_calibration nominal = {
        {1, 2, 3},
        {{INVCAL_REAL(0.125), 0, 0}, {0, INVCAL_REAL(0.25), 0}, {1, 0, INVCAL_REAL(0.5)}}};
    const invcal_real raw[3] = {2, 4, 6};
    invcali_row row;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, raw, &row));
    TEST_ASSERT_EQUAL_DOUBLE(0.125, (double)row.h[0]);
    TEST_ASSERT_EQUAL_DOUBLE(0.5, (double)row.h[1]);
    TEST_ASSERT_EQUAL_DOUBLE(2.5, (double)row.h[2]);
}

/* The sums are not touched. */
static void assert_refused(const double reading[3], invcal_status expected)
{
    const invcal_calibration nominal = unit_nominal();
    const invcal_real u[3] = {(invcal_real)reading[0], (invcal_real)reading[1],
                              (invcal_real)reading[2]};
    invcali_row row;
    invcal_sums sums;
    invcal_sums before;

    memset(&sums, 7, sizeof sums);
    before = sums;
    TEST_ASSERT_EQUAL_INT(expected, invcali_observe(&nominal, u, &row));
    TEST_ASSERT_EQUAL_INT(expected, invcal_sums_add(&sums, &nominal, u, 1));
    TEST_ASSERT_EQUAL_MEMORY(&before, &sums, sizeof sums);
}

static void readings_that_cannot_be_of_this_field_are_refused(void)
{
    static const double bad[][3] = {{0, 0, 0},      {1e-3, 0, 0},   {1e-40, 1e-40, 0},
                                    {0.0995, 0, 0}, {10.05, 0, 0},  {1e30, 0, 0},
                                    {0, -1e30, 1},  {0, 7.2, -7.2}, {1e19, 1e19, 1e19}};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_refused(bad[i], INVCAL_OUT_OF_RANGE);
    }
}

static void a_tenth_and_ten_times_the_field_are_readings(void)
{
    static const double good[][3] = {{0.1005, 0, 0}, {0, -9.95, 0}};
    invcali_row row;

    for (unsigned i = 0; i < sizeof good / sizeof good[0]; i++) {
        const invcal_real u[3] = {(invcal_real)good[i][0], (invcal_real)good[i][1],
                                  (invcal_real)good[i][2]};
        const invcal_calibration nominal = unit_nominal();
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, u, &row));
    }
}

static void readings_that_are_not_numbers_are_refused(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned i = 0; i < 9; i++) {
        double u[3] = {0.6, 0.6, 0.5};
        u[i % 3] = bad[i / 3];
        assert_refused(u, INVCAL_NOT_FINITE);
    }
}

static void readings_are_refused_whichever_number_of_the_nominal_is_invalid(void)
{
    for (int i = 0; i < 12; i++) {
        const invcal_real raw[3] = {(invcal_real)0.5, (invcal_real)0.5, (invcal_real)0.5};
        invcal_calibration nominal = unit_nominal();
        invcali_row row;
        if (i < 3) {
            nominal.offset[i] = (invcal_real)NAN;
        } else {
            nominal.matrix[i / 3 - 1][i % 3] = (invcal_real)NAN;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcali_observe(&nominal, raw, &row));
    }
}

/* ---- sums ------------------------------------------------------------------------------------- */

enum { COUNT = 20 };
static const double small = FLOAT_OR_DOUBLE(2e-5, 2e-14); /* of sums of about 20 numbers below 1 */

static invcali_row rows[COUNT];

/* Rows of a triad with errors of 10 %. */
static void make_rows(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(1);
    const triad_truth truth = triad_random(&random, 0.1);
    double direction[COUNT][3];
    reading_set set;

    for (int i = 0; i < COUNT; i++) {
        random_direction(&random, direction[i]);
    }
    read_positions(&truth, (const double(*)[3])direction, COUNT, 0, &random, &set);
    for (int i = 0; i < COUNT; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, set.u[i], &rows[i]));
    }
}

static invcal_sums sum_of(int first, int last)
{
    invcal_sums n;

    invcal_sums_init(&n);
    for (int i = first; i < last; i++) {
        invcali_sums_add_row(&n, &rows[i], 1);
    }
    return n;
}

static void assert_equal_sums(const invcal_sums *a, const invcal_sums *b)
{
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1); i++) {
        TEST_ASSERT_DOUBLE_WITHIN(small, (double)a->sum[i], (double)b->sum[i]);
    }
    TEST_ASSERT_EQUAL_UINT(a->count, b->count);
}

/* The sum of products of two columns of the matrix; column 9 is j. */
static double product_of(unsigned r, unsigned c)
{
    double sum = 0;

    for (int i = 0; i < COUNT; i++) {
        const double x = (double)rows[i].h[r];
        sum += x * (double)rows[i].h[c];
    }
    return sum;
}

static void sums_built_row_by_row_are_those_of_the_matrix(void)
{
    make_rows();
    const invcal_sums n = sum_of(0, COUNT);

    for (unsigned r = 0; r <= INVCAL_PARAMETERS; r++) {
        for (unsigned c = 0; c <= r; c++) {
            TEST_ASSERT_DOUBLE_WITHIN(small, product_of(r, c), element(&n, r, c));
        }
    }
    TEST_ASSERT_EQUAL_UINT(COUNT, n.count);
}

static void a_weight_that_is_not_positive_and_finite_is_refused(void)
{
    const double bad[] = {0, -0.0, -1, NOT_A_NUMBER, INFINITE, -INFINITE};
    const invcal_calibration nominal = unit_nominal();
    const invcal_real u[3] = {0, 0, 1};
    invcal_sums sums;
    invcal_sums before;

    memset(&sums, 7, sizeof sums);
    before = sums;
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE,
                              invcal_sums_add(&sums, &nominal, u, (invcal_real)bad[i]));
        TEST_ASSERT_EQUAL_MEMORY(&before, &sums, sizeof sums);
    }
}

static void a_position_added_is_its_row_added(void)
{
    const invcal_calibration nominal = {{INVCAL_REAL(0.5), 0, 0},
                                        {{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const invcal_real raw[3] = {1, INVCAL_REAL(0.25), INVCAL_REAL(0.5)};
    invcal_sums by_row;
    invcal_sums at_once;
    invcali_row row;

    invcal_sums_init(&by_row);
    invcal_sums_init(&at_once);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_observe(&nominal, raw, &row));
    invcali_sums_add_row(&by_row, &row, 1);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&at_once, &nominal, raw, 1));
    TEST_ASSERT_EQUAL_MEMORY(by_row.sum, at_once.sum, sizeof by_row.sum);
    TEST_ASSERT_EQUAL_UINT(by_row.count, at_once.count);
}

static void order_does_not_matter(void)
{
    invcal_sums backwards;

    make_rows();
    const invcal_sums n = sum_of(0, COUNT);
    invcal_sums_init(&backwards);
    for (int i = COUNT; i-- > 0;) {
        invcali_sums_add_row(&backwards, &rows[i], 1);
    }
    assert_equal_sums(&n, &backwards);
}

static void a_weight_counts_like_a_repetition(void)
{
    const invcal_calibration nominal = unit_nominal();
    const invcal_real u[3] = {INVCAL_REAL(0.6), INVCAL_REAL(-0.7), INVCAL_REAL(0.5)};

    make_rows();
    invcal_sums thrice = sum_of(0, 10);
    invcal_sums weighted = sum_of(0, 10);

    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&thrice, &nominal, u, 1));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&weighted, &nominal, u, 3));
    TEST_ASSERT_EQUAL_UINT(13, thrice.count);
    TEST_ASSERT_EQUAL_UINT(11, weighted.count); /* one position, however precise */
    weighted.count = thrice.count;
    assert_equal_sums(&thrice, &weighted);
}

static void all_bytes_zero_are_empty_sums(void)
{
    invcal_sums zero;
    invcal_sums empty;

    memset(&zero, 0, sizeof zero);
    memset(&empty, 7, sizeof empty);
    invcal_sums_init(&empty);
    TEST_ASSERT_EQUAL_MEMORY(zero.sum, empty.sum, sizeof empty.sum);
    TEST_ASSERT_EQUAL_UINT(0, empty.count);
}

/* On a machine of 16 bits a day of sums gets there. */
static void the_count_does_not_wrap(void)
{
    make_rows();
    invcal_sums n = sum_of(0, 9);

    n.count = UINT_MAX - 1;
    invcali_sums_add_row(&n, &rows[11], 1);
    TEST_ASSERT_EQUAL_UINT(UINT_MAX, n.count);
    invcali_sums_add_row(&n, &rows[12], 1);
    TEST_ASSERT_EQUAL_UINT(UINT_MAX, n.count);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(rows_stand_in_the_order_of_the_paper);
    RUN_TEST(the_exact_row_vanishes_on_a_sphere_of_any_size_and_place);
    RUN_TEST(a_reading_is_what_the_nominal_calibration_makes_of_it);
    RUN_TEST(readings_that_cannot_be_of_this_field_are_refused);
    RUN_TEST(a_tenth_and_ten_times_the_field_are_readings);
    RUN_TEST(readings_that_are_not_numbers_are_refused);
    RUN_TEST(readings_are_refused_whichever_number_of_the_nominal_is_invalid);
    RUN_TEST(sums_built_row_by_row_are_those_of_the_matrix);
    RUN_TEST(a_weight_that_is_not_positive_and_finite_is_refused);
    RUN_TEST(a_position_added_is_its_row_added);
    RUN_TEST(order_does_not_matter);
    RUN_TEST(a_weight_counts_like_a_repetition);
    RUN_TEST(all_bytes_zero_are_empty_sums);
    RUN_TEST(the_count_does_not_wrap);
    return UNITY_END() != 0;
}
