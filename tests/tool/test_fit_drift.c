/* SPDX-License-Identifier: MIT */
#include "fit/fit_drift.h"

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

enum { COUNT = 18, DRAWS = 400 };
static const double SIGMA = 1e-4;

static double tau[COUNT];

/* A sensor of errors of some percent, and what it reads in the directions of a program while its offsets
 * drift. Returns the nine parameters. */
static void draw(random_source *random, const double drift[3], double noise, double x[9],
                 double raw[COUNT][3])
{
    for (int r = 0; r < 9; r++) {
        x[r] = 0.02 * random_normal(random);
    }
    for (int k = 0; k < COUNT; k++) {
        const double *v = expected_plan18[(7 * k) % COUNT]; /* in an order that shows a drift */
        const double p[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                                {x[6] / 2, 1 + x[4], x[8] / 2},
                                {x[7] / 2, x[8] / 2, 1 + x[5]}};
        tau[k] = k / ((double)COUNT - 1) - 0.5;
        for (int a = 0; a < 3; a++) {
            raw[k][a] = p[a][0] * v[0] + p[a][1] * v[1] + p[a][2] * v[2] + x[a] +
                        tau[k] * drift[a] + (noise > 0 ? noise * random_normal(random) : 0);
        }
    }
}

static fit_settings settings_of(double noise)
{
    fit_settings s = {.field = 1, .noise = noise};

    for (int i = 0; i < 3; i++) {
        s.nominal.matrix[i][i] = 1;
    }
    return s;
}

static void without_noise_it_is_exact(void)
{
    random_source random = random_start(1);
    const double drift[3] = {0.005, -0.01, 0.002};
    const fit_settings settings = settings_of(0);
    double x[9];
    double raw[COUNT][3];
    double found[3];
    double sigma[3];
    fit_solution s;
    fit_quality q;

    draw(&random, drift, 0, x, raw);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          fit_drift_make(raw[0], tau, COUNT, &settings, &s, &q, found, sigma));
    for (int r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, x[r], s.x[r]);
    }
    for (int a = 0; a < 3; a++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, drift[a], found[a]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, COUNT - 12, q.dof);
}

/* Of every parameter and of the drift: the spread is that told, and 95 % of intervals hold the truth. */
static void sigma_is_honest(void)
{
    random_source random = random_start(2);
    const double drift[3] = {0.003, -0.004, 0.0005};
    const fit_settings settings = settings_of(SIGMA);
    double squares = 0;
    unsigned held = 0;

    for (int d = 0; d < DRAWS; d++) {
        double x[9];
        double raw[COUNT][3];
        double found[3];
        double sigma[3];
        fit_solution s;
        fit_quality q;
        draw(&random, drift, SIGMA, x, raw);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              fit_drift_make(raw[0], tau, COUNT, &settings, &s, &q, found, sigma));
        for (int r = 0; r < 12; r++) {
            const double error = r < 9 ? s.x[r] - x[r] : found[r - 9] - drift[r - 9];
            const double one = r < 9 ? q.sigma[r] : sigma[r - 9];
            squares += error * error / (one * one);
            held += fabs(error) <= q.coverage * one;
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.08, 1, sqrt(squares / (12.0 * (double)DRAWS)));
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.96, held / (12.0 * (double)DRAWS)); /* rule 8 at 6: 96.2 % */
}

static void too_few_positions_and_an_order_that_hides_it_are_refused(void)
{
    random_source random = random_start(3);
    const double drift[3] = {0, 0, 0};
    const fit_settings settings = settings_of(SIGMA);
    double x[9];
    double raw[COUNT][3];
    double found[3] = {7, 7, 7};
    double sigma[3];
    fit_solution s;
    fit_quality q;

    draw(&random, drift, SIGMA, x, raw);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, fit_drift_make(raw[0], tau, FIT_DRIFT_POSITIONS_MIN - 1,
                                                         &settings, &s, &q, found, sigma));
    for (int k = 0; k < COUNT; k++) {
        tau[k] = 0.25; /* all at once: as an offset */
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                          fit_drift_make(raw[0], tau, COUNT, &settings, &s, &q, found, sigma));
    TEST_ASSERT_DOUBLE_WITHIN(0, 7, found[0]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(without_noise_it_is_exact);
    RUN_TEST(sigma_is_honest);
    RUN_TEST(too_few_positions_and_an_order_that_hides_it_are_refused);
    return UNITY_END();
}
