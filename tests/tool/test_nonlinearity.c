/* SPDX-License-Identifier: MIT
 *
 * Quadratic and cubic errors of the axes. Sensors are simulated here, figures are of reference.py.
 */
#include "fit/nonlinearity.h"

#include <math.h>

#include "design/design.h"
#include "expected.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST = 60, DRAWS = 300 };
static const double SIGMA = 1e-4;
static const double TRUTH[6] = {0.002, -0.003, 0.001, 0.004, 0.002, -0.005};

static double raw[3 * MOST];
static design set; /* large */

static fit_settings settings_of(double noise)
{
    fit_settings s = {.field = 1, .noise = noise};

    for (int i = 0; i < 3; i++) {
        s.nominal.matrix[i][i] = 1;
    }
    return s;
}

/* The readings of a triad with these errors, too, in N positions per group. */
static unsigned measure(random_source *random, const triad_truth *truth, unsigned per_group,
                        unsigned degree, double noise)
{
    invcal_plan plan;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_init(&plan, per_group));
    for (unsigned i = 0; i < 3 * per_group; i++) {
        invcal_plan_position p;
        double *u = &raw[3 * (size_t)i];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_get(&plan, i, &p));
        triad_read(truth, p.up, u);
        for (unsigned a = 0; a < 3; a++) {
            const double eta = p.up[a];
            u[a] += TRUTH[a] * eta * eta + (degree > 2 ? TRUTH[3 + a] * eta * eta * eta : 0) +
                    (noise > 0 ? noise * random_normal(random) : 0);
        }
    }
    return 3 * per_group;
}

static void programs_have_the_figures_of_the_reference(void)
{
    static const struct {
        unsigned per_group;
        unsigned degree;
        const double *expected;
    } rows[] = {{6, 2, expected_nonlinear18_2},
                {6, 3, expected_nonlinear18_3},
                {8, 2, expected_nonlinear24_2},
                {8, 3, expected_nonlinear24_3}};

    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const invcal_plan plan = stand_plan_make(rows[i].per_group);
        const unsigned n = 9 + 3 * (rows[i].degree - 1);
        nonlinearity_prospect p;
        double direction[24][3];
        design_stand(&set, &plan);
        for (unsigned k = 0; k < set.count; k++) {
            for (unsigned a = 0; a < 3; a++) {
                direction[k][a] = set.position[k].vertical[a];
            }
        }
        TEST_ASSERT_TRUE(nonlinearity_judge((const double(*)[3])direction, NULL, set.count,
                                            rows[i].degree, &p, NULL));
        for (unsigned r = 0; r < n; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-9, rows[i].expected[r], p.root[r]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-9 * p.condition, rows[i].expected[n], p.condition);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, rows[i].expected[9], p.quadratic);
        TEST_ASSERT_TRUE(rows[i].degree > 2 ? fabs(p.cubic - rows[i].expected[12]) < 1e-9
                                            : isnan(p.cubic));
    }
}

static void without_noise_it_is_exact(void)
{
    random_source random = random_start(1);
    const fit_settings settings = settings_of(0);

    for (unsigned degree = 2; degree <= 3; degree++) {
        for (int d = 0; d < 20; d++) {
            const triad_truth truth = triad_random(&random, 0.02);
            const unsigned count = measure(&random, &truth, 8, degree, 0);
            fit_solution s;
            fit_quality q;
            double out[6];
            double sigma[6];
            TEST_ASSERT_EQUAL_INT(
                INVCAL_OK, nonlinearity_fit(raw, count, &settings, degree, &s, &q, out, sigma));
            for (unsigned e = 0; e < 3 * (degree - 1); e++) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-6, TRUTH[e], out[e]);
            }
            for (int r = 0; r < 9; r++) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-6, truth.x[r], s.x[r]);
            }
        }
    }
}

/* For all parameters: the spread is as stated. */
static void sigma_is_honest(void)
{
    const fit_settings settings = settings_of(SIGMA);

    for (unsigned degree = 2; degree <= 3; degree++) {
        random_source random = random_start(degree);
        double squares[2] = {0, 0};
        double reported = 0;
        for (int d = 0; d < DRAWS; d++) {
            const triad_truth truth = triad_random(&random, 0.01);
            const unsigned count = measure(&random, &truth, degree == 2 ? 6 : 8, degree, SIGMA);
            fit_solution s;
            fit_quality q;
            double out[6];
            double sigma[6];
            TEST_ASSERT_EQUAL_INT(
                INVCAL_OK, nonlinearity_fit(raw, count, &settings, degree, &s, &q, out, sigma));
            for (unsigned e = 0; e < 3 * (degree - 1); e++) {
                squares[0] += (out[e] - TRUTH[e]) * (out[e] - TRUTH[e]) / (sigma[e] * sigma[e]);
            }
            for (int r = 0; r < 9; r++) {
                squares[1] +=
                    (s.x[r] - truth.x[r]) * (s.x[r] - truth.x[r]) / (q.sigma[r] * q.sigma[r]);
            }
            reported += sigma[0] / (double)DRAWS;
        }
        TEST_ASSERT_DOUBLE_WITHIN(0.1, 1, sqrt(squares[0] / (3.0 * (degree - 1) * (double)DRAWS)));
        TEST_ASSERT_DOUBLE_WITHIN(0.1, 1, sqrt(squares[1] / (9.0 * (double)DRAWS)));
        TEST_ASSERT_DOUBLE_WITHIN(0.1e-4, degree == 2 ? 1.63299e-4 : 1.41421e-4, reported);
    }
}

static void what_the_positions_do_not_determine_is_refused_by_name(void)
{
    random_source random = random_start(5);
    const triad_truth none = {{0}};
    const fit_settings settings = settings_of(SIGMA);
    double directions[20][3];
    nonlinearity_prospect p;
    unsigned open = 0;
    fit_solution s;
    fit_quality q;
    double out[6] = {7};
    double sigma[6];

    const unsigned count = measure(&random, &none, 6, 2, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          nonlinearity_fit(raw, 13, &settings, 2, &s, &q, out, sigma));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          nonlinearity_fit(raw, 16, &settings, 3, &s, &q, out, sigma));
    TEST_ASSERT_DOUBLE_WITHIN(0, 7, out[0]);
    TEST_ASSERT_EQUAL_UINT(18, count);
    for (unsigned i = 0; i < 20; i++) { /* corners and edges */
        const double f = i < 8 ? sqrt(1 / 3.0) : sqrt(0.5);
        const unsigned axis = (i - 8) / 4 % 3;
        for (unsigned a = 0; a < 3; a++) {
            const unsigned bit = i < 8 ? i >> a & 1 : i >> (a == (axis + 1) % 3) & 1;
            directions[i][a] = i >= 8 && a == axis ? 0 : bit ? f : -f;
        }
    }
    TEST_ASSERT_TRUE(nonlinearity_judge((const double(*)[3])directions, NULL, 20, 2, &p, NULL));
    for (unsigned i = 0; i < 20; i++) { /* z only up: z^2 and z are alike */
        directions[i][2] = 0.6;
        directions[i][0] = 0.8 * cos(i);
        directions[i][1] = 0.8 * sin(i);
    }
    TEST_ASSERT_FALSE(nonlinearity_judge((const double(*)[3])directions, NULL, 20, 2, &p, &open));
    TEST_ASSERT_TRUE(open & 4);
    TEST_ASSERT_EQUAL_STRING("quadratic z", nonlinearity_name(2));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(programs_have_the_figures_of_the_reference);
    RUN_TEST(without_noise_it_is_exact);
    RUN_TEST(sigma_is_honest);
    RUN_TEST(what_the_positions_do_not_determine_is_refused_by_name);
    return UNITY_END();
}
