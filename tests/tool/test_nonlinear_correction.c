/* SPDX-License-Identifier: MIT
 *
 * Quadratic and cubic errors are corrected: the truth is simulated, by its definition.
 */
#include "apply/nonlinear_correction.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "maths/matrix.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

#define FIELD 9.80665
static const double TERM[2][3] = {{0.01, -0.02, 0.015}, {-0.012, 0.02, 0.01}};
static const double ZERO[3] = {33000, 32700, 32900};
static const double NOMINAL[3][3] = {{6e-4, 0, 0}, {1e-6, 5.9e-4, 0}, {0, -2e-6, 6.1e-4}};

static calibration_file file; /* its description */
static nonlinear_correction correction;
static triad_truth sensor;

/* raw = zero + N^-1 FIELD (u + e(eta)), u what the triad reads without e. */
static void read_raw(const double eta[3], double raw[3])
{
    invcal_calibration nominal = {.offset = {0, 0, 0}};
    double inverse[3][3];
    double u[3];

    memcpy(nominal.matrix, NOMINAL, sizeof NOMINAL);
    TEST_ASSERT_TRUE(matrix_inverse(&nominal, inverse));
    triad_read(&sensor, eta, u);
    for (int a = 0; a < 3; a++) {
        const double x = fmax(-NONLINEAR_EDGE, fmin(NONLINEAR_EDGE, eta[a]));
        u[a] += TERM[0][a] * x * x + TERM[1][a] * x * x * x;
    }
    for (int a = 0; a < 3; a++) {
        raw[a] =
            ZERO[a] + FIELD * (inverse[a][0] * u[0] + inverse[a][1] * u[1] + inverse[a][2] * u[2]);
    }
}

/* The calibration of this sensor, turned by `turn` about z: R (I + S)^-1 N, and the zero of u. */
static void know(double turn)
{
    const double r[3][3] = {{cos(turn), -sin(turn), 0}, {sin(turn), cos(turn), 0}, {0, 0, 1}};
    const double *x = sensor.x;
    const invcal_calibration skew = {.matrix = {{1 + x[3], x[6] / 2, x[7] / 2},
                                                {x[6] / 2, 1 + x[4], x[8] / 2},
                                                {x[7] / 2, x[8] / 2, 1 + x[5]}}};
    invcal_calibration nominal = {.offset = {0, 0, 0}};
    double a[3][3];
    double inverse[3][3];
    double symmetric[3][3];

    memset(&file, 0, sizeof file);
    memcpy(nominal.matrix, NOMINAL, sizeof NOMINAL);
    TEST_ASSERT_TRUE(matrix_inverse(&skew, a));
    TEST_ASSERT_TRUE(matrix_inverse(&nominal, inverse));
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            symmetric[i][j] = 0;
            for (int k = 0; k < 3; k++) {
                symmetric[i][j] += a[i][k] * NOMINAL[k][j];
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        file.calibration.offset[i] = ZERO[i];
        for (int k = 0; k < 3; k++) {
            file.calibration.offset[i] += FIELD * inverse[i][k] * x[k];
            for (int j = 0; j < 3; j++) {
                file.calibration.matrix[i][j] += r[i][k] * symmetric[k][j];
            }
        }
    }
    file.has_nonlinear = 1;
    file.nonlinear.field = FIELD;
    file.nonlinear.nominal = nominal;
    memcpy(file.nonlinear.term, TERM, sizeof TERM);
}

/* The largest error after correction, over the field, of readings at TIMES the field. */
static double worst(double times, double turn)
{
    random_source random = random_start(3);
    double most = 0;

    for (int n = 0; n < 200; n++) {
        double eta[3];
        double raw[3];
        double out[3];
        random_direction(&random, eta);
        for (int a = 0; a < 3; a++) {
            eta[a] *= times;
        }
        read_raw(eta, raw);
        nonlinear_correction_remove(&correction, raw);
        invcal_apply(&file.calibration, raw[0], raw[1], raw[2], out);
        most = larger(most, fabs(out[0] / FIELD - (cos(turn) * eta[0] - sin(turn) * eta[1])));
        most = larger(most, fabs(out[1] / FIELD - (sin(turn) * eta[0] + cos(turn) * eta[1])));
        most = larger(most, fabs(out[2] / FIELD - eta[2]));
    }
    return most;
}

static void errors_are_corrected_to_rounding_in_any_frame(void)
{
    random_source random = random_start(1);

    for (int n = 0; n < 10; n++) {
        const double turn = n * 0.7; /* as a mounting might be */
        sensor = triad_random(&random, 0.05);
        know(turn);
        TEST_ASSERT_EQUAL_INT(EXIT_GOOD, nonlinear_correction_begin(&correction, &file, "test"));
        for (int k = 0; k < 4; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-11, 0, worst(0.3 * k, turn));
        }
        TEST_ASSERT_EQUAL_UINT(0, correction.beyond);
    }
}

static void beyond_the_edge_the_error_is_that_of_the_edge(void)
{
    random_source random = random_start(2);

    sensor = triad_random(&random, 0.02);
    know(0);
    TEST_ASSERT_EQUAL_INT(EXIT_GOOD, nonlinear_correction_begin(&correction, &file, "test"));
    TEST_ASSERT_DOUBLE_WITHIN(1e-11, 0, worst(16, 0));
    TEST_ASSERT_EQUAL_UINT(200, correction.readings);
    TEST_ASSERT_GREATER_THAN_UINT(190, correction.beyond);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 16, correction.farthest);
}

static void without_terms_a_reading_stays(void)
{
    double raw[3] = {1, 2, 3};

    know(0);
    file.has_nonlinear = 0;
    TEST_ASSERT_EQUAL_INT(EXIT_GOOD, nonlinear_correction_begin(&correction, &file, "test"));
    nonlinear_correction_remove(&correction, raw);
    TEST_ASSERT_EQUAL_DOUBLE(1, raw[0]);
    TEST_ASSERT_EQUAL_DOUBLE(3, raw[2]);
}

static void terms_that_are_not_small_errors_are_refused(void)
{
    know(0);
    file.nonlinear.term[0][1] = 0.3;
    TEST_ASSERT_EQUAL_INT(EXIT_FILE, nonlinear_correction_begin(&correction, &file, "test"));
    file.nonlinear.term[0][1] = (double)NAN;
    TEST_ASSERT_EQUAL_INT(EXIT_FILE, nonlinear_correction_begin(&correction, &file, "test"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(errors_are_corrected_to_rounding_in_any_frame);
    RUN_TEST(beyond_the_edge_the_error_is_that_of_the_edge);
    RUN_TEST(without_terms_a_reading_stays);
    RUN_TEST(terms_that_are_not_small_errors_are_refused);
    return UNITY_END();
}
