/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/background.h"
#include "core/solve.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* A nominal calibration of no particular kind, about 1000 counts per field. */
static invcal_calibration random_nominal(random_source *random)
{
    double rotation[3][3];
    invcal_calibration nominal;

    random_rotation(random, rotation);
    for (int i = 0; i < 3; i++) {
        nominal.offset[i] = (invcal_real)random_uniform(random, -100, 100);
        for (int j = 0; j < 3; j++) {
            nominal.matrix[i][j] =
                (invcal_real)(1e-3 * (rotation[i][j] + random_uniform(random, -0.2, 0.2)));
        }
    }
    return nominal;
}

/* matrix = (I + S)^-1 N, offset = zero + N^-1 delta, in double. */
static invcal_calibration calibration_of(const triad_truth *truth,
                                         const invcal_calibration *nominal)
{
    const double *x = truth->x;
    const double p[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                            {x[6] / 2, 1 + x[4], x[8] / 2},
                            {x[7] / 2, x[8] / 2, 1 + x[5]}};
    double a[3][3];
    double n[3][3];
    double inverse[3][3];
    invcal_calibration out;

    for (int i = 0; i < 9; i++) {
        n[i / 3][i % 3] = (double)nominal->matrix[i / 3][i % 3];
    }
    inverse3(p, a);
    inverse3((const double(*)[3])n, inverse);
    for (int i = 0; i < 3; i++) {
        double offset = (double)nominal->offset[i];
        for (int j = 0; j < 3; j++) {
            offset += inverse[i][j] * x[j];
            out.matrix[i][j] =
                (invcal_real)(a[i][0] * n[0][j] + a[i][1] * n[1][j] + a[i][2] * n[2][j]);
        }
        out.offset[i] = (invcal_real)offset;
    }
    return out;
}

static void the_deviation_is_that_of_the_triad_behind_any_nominal(void)
{
    random_source random = random_start(1);

    for (int draw = 0; draw < SOME(100); draw++) {
        const triad_truth truth = triad_random(&random, 0.2);
        const invcal_calibration nominal = random_nominal(&random);
        const invcal_calibration calibration = calibration_of(&truth, &nominal);
        invcal_real x[INVCAL_PARAMETERS];
        invcal_deviation(&calibration, &nominal, x);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 4e-15), truth.x[r], (double)x[r]);
        }
    }
}

static void nominal_itself_deviates_by_nothing(void)
{
    random_source random = random_start(2);
    const invcal_calibration nominal = random_nominal(&random);
    invcal_real x[INVCAL_PARAMETERS];

    invcal_deviation(&nominal, &nominal, x);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-15), 0, (double)x[r]);
    }
}

/* A'A of a calibration after nominal, A = M N^-1. */
static void correction_of(const invcal_calibration *calibration, const invcal_calibration *nominal,
                          double a[3][3])
{
    double n[3][3];
    double inverse[3][3];

    for (int i = 0; i < 9; i++) {
        n[i / 3][i % 3] = (double)nominal->matrix[i / 3][i % 3];
    }
    inverse3((const double(*)[3])n, inverse);
    for (int i = 0; i < 9; i++) {
        const invcal_real *m = calibration->matrix[i / 3];
        a[i / 3][i % 3] = (double)m[0] * inverse[0][i % 3] + (double)m[1] * inverse[1][i % 3] +
                          (double)m[2] * inverse[2][i % 3];
    }
}

static double gram(double a[3][3], int r, int c)
{
    return a[0][r] * a[0][c] + a[1][r] * a[1][c] + a[2][r] * a[2][c];
}

static void the_two_frames_differ_by_a_rotation_only(void)
{
    random_source random = random_start(4);

    for (int draw = 0; draw < SOME(50); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        const invcal_calibration nominal = draw % 2 ? random_nominal(&random) : unit_nominal();
        const invcal_calibration symmetric = calibration_of(&truth, &nominal);
        invcal_calibration triangular = symmetric;
        double a[3][3];
        double b[3][3];
        invcali_make_triangular(&triangular, &nominal);
        correction_of(&symmetric, &nominal, a);
        correction_of(&triangular, &nominal, b);
        for (int r = 0; r < 3; r++) {
            TEST_ASSERT_TRUE(b[r][r] > 0);
            for (int c = 0; c < 3; c++) {
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(4e-6, 1e-14), gram(a, r, c),
                                          gram(b, r, c));
                TEST_ASSERT_TRUE(c >= r || fabs(b[r][c]) < FLOAT_OR_DOUBLE(1e-6, 1e-15));
            }
        }
        TEST_ASSERT_EQUAL_MEMORY(symmetric.offset, triangular.offset, sizeof triangular.offset);
    }
}

/* Zero, to the last digit. */
static void a_diagonal_nominal_gives_an_upper_triangular_matrix(void)
{
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.1);
    const invcal_calibration nominal = {{1, 2, 3}, {{2, 0, 0}, {0, 4, 0}, {0, 0, -8}}};
    invcal_calibration calibration = calibration_of(&truth, &nominal);

    invcali_make_triangular(&calibration, &nominal);
    TEST_ASSERT_TRUE(calibration.matrix[1][0] == 0 && calibration.matrix[2][0] == 0 &&
                     calibration.matrix[2][1] == 0);
    TEST_ASSERT_TRUE(calibration.matrix[0][0] > 0 && calibration.matrix[2][2] < 0);
}

static void what_is_not_a_calibration_is_not_turned(void)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_calibration calibration = {{0, 0, 0}, {{1, 0, 0}, {0, (invcal_real)NAN, 0}, {0, 0, 1}}};
    const invcal_calibration before = calibration;

    invcali_make_triangular(&calibration, &nominal);
    TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
}

/* In any field unit: its squares would overflow a float, or vanish. */
static void the_offset_sigma_is_that_of_delta_in_counts(void)
{
    invcal_quality quality = {.sigma = {INVCAL_REAL(1e-3), INVCAL_REAL(2e-3), INVCAL_REAL(5e-4)}};
    invcal_real sigma[3];

    for (int exponent = -12; exponent <= 12; exponent += 4) {
        const double scale = pow(10, exponent);
        invcal_calibration nominal = unit_nominal();
        for (int k = 0; k < 3; k++) {
            nominal.matrix[k][k] = (invcal_real)(scale * (k == 1 ? -2 : 1));
        }
        invcal_sigma_offset(&quality, &nominal, sigma);
        for (int k = 0; k < 3; k++) {
            const double expected = (double)quality.sigma[k] / scale / (k == 1 ? 2 : 1);
            TEST_ASSERT_DOUBLE_WITHIN(1e-5 * expected, expected, (double)sigma[k]);
        }
    }
}

/* Three sigma at right angles: a nominal turned by 45 degrees about z mixes x and y alike. */
static void the_offset_sigma_goes_through_the_inverse_of_nominal(void)
{
    const invcal_quality quality = {.sigma = {3, 4, 7}};
    const invcal_calibration nominal = {{0, 0, 0}, {{1, -1, 0}, {1, 1, 0}, {0, 0, 2}}};
    invcal_real sigma[3];

    /* N^-1 = [1 1 0; -1 1 0; 0 0 1] / 2: sqrt(9 + 16) / 2 twice, 7 / 2 */
    invcal_sigma_offset(&quality, &nominal, sigma);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 2.5, (double)sigma[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 2.5, (double)sigma[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 3.5, (double)sigma[2]);
}

/* Every sigma counts, and a smaller one is better. */
static void of_equal_verdicts_the_smaller_sigma_improves(void)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        invcal_quality small = {.sigma_dof = 9, .verdict = INVCAL_GOOD};
        for (unsigned k = 0; k < INVCAL_PARAMETERS; k++) {
            small.sigma[k] = INVCAL_REAL(1e-3);
        }
        invcal_quality large = small;
        const invcal_quality like = small;
        large.sigma[r] *= 2;
        TEST_ASSERT_EQUAL_INT(1, invcal_improves(&small, &large));
        TEST_ASSERT_EQUAL_INT(0, invcal_improves(&large, &small));
        TEST_ASSERT_EQUAL_INT(0, invcal_improves(&small, &like));
    }
}

static void a_worse_verdict_never_improves(void)
{
    for (unsigned i = 0; i <= INVCAL_WEAK; i++) {
        for (unsigned k = 0; k <= INVCAL_WEAK; k++) {
            const invcal_quality found = {.sigma = {1}, .sigma_dof = 9, .verdict = (uint8_t)i};
            const invcal_quality present = {.sigma = {2}, .sigma_dof = 9, .verdict = (uint8_t)k};
            TEST_ASSERT_EQUAL_INT(i <= k, invcal_improves(&found, &present));
        }
    }
}

/* Student's factor is 12.7 for one degree of freedom, 2.2 for ten. It is those behind sigma that
 * count, a stated noise among them, not those of the residuals. */
static void a_sigma_that_is_small_by_luck_does_not_win(void)
{
    invcal_quality lucky = {.sigma = {1}, .dof = 10, .sigma_dof = 1, .verdict = INVCAL_GOOD};
    const invcal_quality sound = {.sigma = {3}, .dof = 1, .sigma_dof = 10, .verdict = INVCAL_GOOD};

    TEST_ASSERT_EQUAL_INT(0, invcal_improves(&lucky, &sound));
    lucky.sigma_dof = 10;
    TEST_ASSERT_EQUAL_INT(1, invcal_improves(&lucky, &sound));
}

static void what_is_not_a_number_never_improves(void)
{
    const invcal_quality nan = {
        .sigma = {(invcal_real)NAN}, .sigma_dof = 9, .verdict = INVCAL_GOOD};
    const invcal_quality present = {.sigma = {2}, .sigma_dof = 9, .verdict = INVCAL_GOOD};

    TEST_ASSERT_EQUAL_INT(0, invcal_improves(&nan, &present));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_deviation_is_that_of_the_triad_behind_any_nominal);
    RUN_TEST(nominal_itself_deviates_by_nothing);
    RUN_TEST(the_two_frames_differ_by_a_rotation_only);
    RUN_TEST(a_diagonal_nominal_gives_an_upper_triangular_matrix);
    RUN_TEST(what_is_not_a_calibration_is_not_turned);
    RUN_TEST(the_offset_sigma_is_that_of_delta_in_counts);
    RUN_TEST(the_offset_sigma_goes_through_the_inverse_of_nominal);
    RUN_TEST(of_equal_verdicts_the_smaller_sigma_improves);
    RUN_TEST(a_worse_verdict_never_improves);
    RUN_TEST(a_sigma_that_is_small_by_luck_does_not_win);
    RUN_TEST(what_is_not_a_number_never_improves);
    return UNITY_END() != 0;
}
