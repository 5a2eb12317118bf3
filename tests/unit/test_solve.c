/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "core/solve.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* Positions with errors of up to `size` on the paper's 18 directions, solved with exact rows. */
static void solve_plan18(const triad_truth *truth, invcal_calibration *out)
{
    const invcal_calibration nominal = unit_nominal();
    random_source unused = random_start(0);
    reading_set set;

    read_positions(truth, expected_plan18, 18, 0, &unused, &set);
    invcal_sums sums = sums_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &nominal, out));
}

/* Required: |calibrated| - 1 in 1000 other orientations, errors up to 10 %. */
static void other_orientations_have_unit_length(void)
{
    random_source random = random_start(1);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        invcal_calibration calibration;
        double squares = 0;
        double worst = 0;
        solve_plan18(&truth, &calibration);
        for (int i = 0; i < 1000; i++) {
            double eta[3];
            random_direction(&random, eta);
            const double error = fabs(calibrated_length(&calibration, &truth, eta) - 1);
            worst = larger(worst, error);
            squares += error * error;
        }
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(2e-7, sqrt(squares / 1000));
        if (INVCAL_DOUBLE) {
            TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1e-12, worst);
        }
    }
}

/* Errors up to 20 %: right to the last digits of the number type. */
static void the_nine_parameters_are_those_of_the_triad(void)
{
    random_source random = random_start(2);

    for (int draw = 0; draw < SOME(100); draw++) {
        const triad_truth truth = triad_random(&random, draw % 2 ? 0.1 : 0.2);
        invcal_calibration calibration;
        solve_plan18(&truth, &calibration);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(6e-7, 1e-15), truth.x[r],
                                      parameter(&calibration, r));
        }
    }
}

static void the_correction_is_symmetric(void)
{
    random_source random = random_start(4);

    for (int draw = 0; draw < SOME(50); draw++) {
        const triad_truth truth = triad_random(&random, 0.2);
        invcal_calibration calibration;
        solve_plan18(&truth, &calibration);
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-7, 4e-16),
                                      (double)calibration.matrix[i / 3][i % 3],
                                      (double)calibration.matrix[i % 3][i / 3]);
        }
    }
}

/* New case axes: u' = R u. Noise makes the fit a compromise, which must be the same one. */
static void a_rotation_of_the_case_does_not_change_lengths(void)
{
    random_source random = random_start(5);
    const invcal_calibration nominal = unit_nominal();

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        reading_set set;
        reading_set turned;
        double rotation[3][3];
        invcal_calibration calibration[2];
        read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
        random_rotation(&random, rotation);
        turned.count = set.count;
        for (unsigned i = 0; i < set.count; i++) {
            for (int k = 0; k < 3; k++) {
                turned.u[i][k] = (invcal_real)(rotation[k][0] * (double)set.u[i][0] +
                                               rotation[k][1] * (double)set.u[i][1] +
                                               rotation[k][2] * (double)set.u[i][2]);
            }
        }
        invcal_sums a = sums_of(&set);
        invcal_sums b = sums_of(&turned);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&a, &nominal, &calibration[0]));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&b, &nominal, &calibration[1]));
        for (unsigned i = 0; i < set.count; i++) {
            double length[2];
            for (int k = 0; k < 2; k++) {
                invcal_real v[3];
                const invcal_real *u = k ? turned.u[i] : set.u[i];
                invcal_apply(&calibration[k], u[0], u[1], u[2], v);
                const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
                length[k] = length3(d);
            }
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-12), length[0], length[1]);
        }
    }
}

static void the_order_of_the_positions_does_not_matter(void)
{
    random_source random = random_start(6);
    const invcal_calibration nominal = unit_nominal();
    const triad_truth truth = triad_random(&random, 0.1);
    reading_set set;
    invcal_calibration expected;
    invcal_calibration actual;
    invcal_sums backwards;

    read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
    invcal_sums sums = sums_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &nominal, &expected));
    invcal_sums_init(&backwards);
    for (int i = 18; i-- > 0;) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&backwards, &nominal, set.u[i], 1));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&backwards, &nominal, &actual));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-13), parameter(&expected, r),
                                  parameter(&actual, r));
    }
}

enum { MAGNETOMETER_POSITIONS = 18 };
static const double magnetometer_field = 48; /* uT */
static const double uT_per_count = 0.15;

/* Counts of a magnetometer with hard iron, in counts, and the soft iron of truth. */
static void read_magnetometer(const triad_truth *truth, const double iron[3], const double eta[3],
                              invcal_real raw[3])
{
    double u[3];

    triad_read(truth, eta, u);
    for (int k = 0; k < 3; k++) {
        raw[k] = (invcal_real)(iron[k] + u[k] * magnetometer_field / uT_per_count);
    }
}

/* The middle of the range of all readings: the usual first guess at hard iron. */
static void guess_iron(invcal_real raw[][3], invcal_real middle[3])
{
    for (int k = 0; k < 3; k++) {
        invcal_real low = raw[0][k];
        invcal_real high = raw[0][k];
        for (int i = 1; i < MAGNETOMETER_POSITIONS; i++) {
            low = raw[i][k] < low ? raw[i][k] : low;
            high = raw[i][k] > high ? raw[i][k] : high;
        }
        middle[k] = (low + high) / 2;
    }
}

/* Hard iron of up to a whole field, soft iron of up to 20 %, nothing known beforehand. */
static void a_magnetometer_is_calibrated_like_an_accelerometer(void)
{
    random_source random = random_start(7);

    for (int draw = 0; draw < SOME(50); draw++) {
        triad_truth truth = triad_random(&random, 0.2);
        double iron[3];
        invcal_real raw[MAGNETOMETER_POSITIONS][3];
        invcal_calibration nominal = unit_nominal();
        invcal_calibration calibration;
        invcal_quality quality;
        for (int k = 0; k < 3; k++) {
            iron[k] = random_uniform(&random, -48, 48) / uT_per_count;
            truth.x[k] = 0;
            nominal.matrix[k][k] = (invcal_real)(uT_per_count / magnetometer_field);
        }
        for (int i = 0; i < MAGNETOMETER_POSITIONS; i++) {
            read_magnetometer(&truth, iron, expected_plan18[i], raw[i]);
        }
        guess_iron(raw, nominal.offset);
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK,
            invcal_calibrate_plain(POSITIONS_OF(&raw[0][0], MAGNETOMETER_POSITIONS, &nominal, 0),
                                   &calibration, &quality));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_scale(&calibration, (invcal_real)magnetometer_field));
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
        for (int k = 0; k < 3; k++) { /* hard iron, counts */
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-3, 1e-10), iron[k],
                                      (double)calibration.offset[k]);
        }
        for (int i = 0; i < 100; i++) {
            double eta[3];
            invcal_real v[3];
            random_direction(&random, eta);
            read_magnetometer(&truth, iron, eta, v);
            invcal_apply(&calibration, v[0], v[1], v[2], v);
            const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-11), magnetometer_field, length3(d));
        }
    }
}

/* raw = T eta + zero, T turned, skewed and scaled at will; nominal is its inverse with errors of
 * 3 %. Nothing about it is diagonal or symmetric. */
static void any_regular_matrix_may_be_nominal(void)
{
    random_source random = random_start(10);

    for (int draw = 0; draw < SOME(50); draw++) {
        static const double zero[3] = {500, -300, 200};
        double turn[3][3];
        double t[3][3];
        double forward[3][3];
        double backward[3][3];
        invcal_calibration nominal;
        invcal_sums sums;
        invcal_calibration calibration;
        random_rotation(&random, turn);
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                t[r][c] = 1000 * (turn[r][c] + random_uniform(&random, -0.2, 0.2));
                forward[r][c] = t[r][c] + random_uniform(&random, -30, 30);
            }
        }
        inverse3((const double(*)[3])forward, backward);
        for (int r = 0; r < 3; r++) {
            nominal.offset[r] = (invcal_real)(zero[r] + 20);
            for (int c = 0; c < 3; c++) {
                nominal.matrix[r][c] = (invcal_real)backward[r][c];
            }
        }
        invcal_sums_init(&sums);
        for (int i = 0; i < 18 + 100; i++) {
            double eta[3];
            invcal_real raw[3];
            random_direction(&random, eta);
            const double *e = i < 18 ? expected_plan18[i] : eta;
            for (int k = 0; k < 3; k++) {
                raw[k] = (invcal_real)(zero[k] + t[k][0] * e[0] + t[k][1] * e[1] + t[k][2] * e[2]);
            }
            if (i < 18) {
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&sums, &nominal, raw, 1));
                continue;
            }
            if (i == 18) {
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &nominal, &calibration));
                for (int k = 0; k < 3; k++) {
                    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-3, 1e-10), zero[k],
                                              (double)calibration.offset[k]);
                }
            }
            invcal_apply(&calibration, raw[0], raw[1], raw[2], raw);
            const double v[3] = {(double)raw[0], (double)raw[1], (double)raw[2]};
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-6, 1e-13), 1, length3(v));
        }
    }
}

static void the_solution_may_overwrite_nominal(void)
{
    random_source random = random_start(11);
    const triad_truth truth = triad_random(&random, 0.1);
    invcal_calibration apart;
    invcal_calibration nominal = {{INVCAL_REAL(0.1), 0, 0},
                                  {{1, INVCAL_REAL(0.1), 0}, {0, 1, 0}, {0, 0, 2}}};
    invcal_sums sums;

    invcal_sums_init(&sums);
    for (int i = 0; i < 18; i++) {
        double u[3];
        triad_read(&truth, expected_plan18[i], u);
        const invcal_real raw[3] = {(invcal_real)u[0], (invcal_real)u[1], (invcal_real)u[2]};
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&sums, &nominal, raw, 1));
    }
    invcal_sums copy = sums;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&copy, &nominal, &apart));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &nominal, &nominal));
    TEST_ASSERT_EQUAL_MEMORY(&apart, &nominal, sizeof apart);
}

static void fewer_than_nine_positions_are_too_few(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(12);
    const triad_truth truth = triad_random(&random, 0.1);
    reading_set set;
    double v[9][3];
    invcal_calibration calibration = nominal;

    read_positions(&truth, expected_plan18, 8, 0, &random, &set);
    invcal_sums sums = sums_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_sums_solve(&sums, &nominal, &calibration));
    TEST_ASSERT_EQUAL_MEMORY(&nominal, &calibration, sizeof nominal);
    for (int i = 0; i < 9; i++) {
        random_direction(&random, v[i]);
    }
    read_positions(&truth, (const double(*)[3])v, 9, 0, &random, &set);
    sums = sums_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &nominal, &calibration));
}

/* Whatever it is solved with: a result that is not finite does not count. */
static void a_nominal_without_an_inverse_is_refused(void)
{
    const invcal_calibration singular = {{0, 0, 0}, {{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}};
    const invcal_calibration unreal = {{0, (invcal_real)NAN, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    random_source random = random_start(13);
    const triad_truth truth = triad_random(&random, 0.1);
    reading_set set;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    for (int i = 0; i < 2; i++) {
        invcal_sums sums = sums_of(&set);
        invcal_calibration calibration;
        invcal_calibration before;
        memset(&calibration, 7, sizeof calibration);
        before = calibration;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL,
                              invcal_sums_solve(&sums, i ? &unreal : &singular, &calibration));
        TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
    }
}

/* Newton's iteration halves what is far above 1 at each step: it ends before a singular matrix
 * converges. */
static void a_matrix_of_no_triad_terminates_as_well(void)
{
    invcal_real a[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, (invcal_real)1e-6}};
    invcal_real work[INVCAL_WORK];

    invcali_make_symmetric(a, work);
    for (unsigned i = 0; i < 9; i++) {
        TEST_ASSERT_TRUE(isfinite(a[i / 3][i % 3]));
    }
    TEST_ASSERT_TRUE(fabs((double)a[2][2]) > 1e-4); /* not yet 1e-6: no result */
}

static void unreal_sums_are_refused(void)
{
    random_source random = random_start(9);
    const triad_truth truth = triad_random(&random, 0.01);
    const invcal_calibration nominal = unit_nominal();
    reading_set set;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    for (unsigned i = 0; i < INVCAL_PACKED(INVCAL_PARAMETERS, INVCAL_PARAMETERS); i++) {
        invcal_sums sums = sums_of(&set);
        invcal_calibration calibration;
        invcal_calibration before;
        memset(&calibration, 7, sizeof calibration);
        before = calibration;
        sums.sum[i] = (invcal_real)NAN;
        TEST_ASSERT_TRUE(invcal_sums_solve(&sums, &nominal, &calibration) != INVCAL_OK);
        TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
    }
}

/* A semi-axis of 0.1 to 10 of nominal is a triad's. Readings are kept between 0.1 and 10, too. */
static void semi_axes_beyond_their_limits_are_not_triads(void)
{
    static const struct {
        int r;
        double error;
        invcal_status status;
    } limits[] = {
        {INVCAL_DK_X, 0.13 - 1, INVCAL_OK},
        {INVCAL_DK_X, 0.07 - 1, INVCAL_NOT_ELLIPSOID},
        {INVCAL_DK_Y, 0.13 - 1, INVCAL_OK},
        {INVCAL_DK_Z, 0.07 - 1, INVCAL_NOT_ELLIPSOID},
        /* a centre so far away that float does not resolve it */
        {INVCAL_DELTA_X, 9.8, INVCAL_DOUBLE ? INVCAL_OK : INVCAL_UNDETERMINED},
        {INVCAL_DELTA_Y, -10.2, INVCAL_DOUBLE ? INVCAL_NOT_ELLIPSOID : INVCAL_UNDETERMINED}};
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(15);

    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        triad_truth truth = {{0}};
        invcal_sums sums;
        invcal_calibration calibration;
        truth.x[limits[i].r] = limits[i].error;
        invcal_sums_init(&sums);
        while (sums.count < 40) {
            double eta[3];
            double u[3];
            random_direction(&random, eta);
            triad_read(&truth, eta, u);
            const invcal_real reading[3] = {(invcal_real)u[0], (invcal_real)u[1],
                                            (invcal_real)u[2]};
            (void)invcal_sums_add(&sums, &nominal, reading, 1);
        }
        TEST_ASSERT_EQUAL_INT(limits[i].status, invcal_sums_solve(&sums, &nominal, &calibration));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(other_orientations_have_unit_length);
    RUN_TEST(the_nine_parameters_are_those_of_the_triad);
    RUN_TEST(the_correction_is_symmetric);
    RUN_TEST(a_rotation_of_the_case_does_not_change_lengths);
    RUN_TEST(the_order_of_the_positions_does_not_matter);
    RUN_TEST(a_magnetometer_is_calibrated_like_an_accelerometer);
    RUN_TEST(any_regular_matrix_may_be_nominal);
    RUN_TEST(the_solution_may_overwrite_nominal);
    RUN_TEST(fewer_than_nine_positions_are_too_few);
    RUN_TEST(a_nominal_without_an_inverse_is_refused);
    RUN_TEST(a_matrix_of_no_triad_terminates_as_well);
    RUN_TEST(unreal_sums_are_refused);
    RUN_TEST(semi_axes_beyond_their_limits_are_not_triads);
    return UNITY_END() != 0;
}
