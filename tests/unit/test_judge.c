/* SPDX-License-Identifier: MIT
 *
 * How good a calibration claims to be.
 */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/result.h"
#include "calibrate/judge.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* The paper's 18 positions with errors of `size`, calibrated. */
typedef struct {
    reading_set set;
    invcal_calibration calibration;
    invcal_quality quality;
} scene;

static scene plan18(uint32_t seed, double size, double sigma, double stated)
{
    random_source random = random_start(seed);
    const triad_truth truth = triad_random(&random, size);
    scene s;

    read_positions(&truth, expected_plan18, 18, sigma, &random, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, stated, &s.calibration, &s.quality));
    return s;
}

static void sigma_over_noise_of_the_papers_program_is_the_papers(void)
{
    /* Without errors of the triad: they would weight the rows. The noise is that of rounding. */
    const scene s = plan18(1, 0, 0, 0);
    const double noise = (double)s.quality.noise;
    double of_inverse = 0;
    double trace = 0;

    for (int i = 0; i < 18; i++) {
        const double *u = expected_plan18[i];
        trace += u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + pow(u[0], 4) + pow(u[1], 4) +
                 pow(u[2], 4) + pow(u[0] * u[1], 2) + pow(u[0] * u[2], 2) + pow(u[1] * u[2], 2);
    }
    for (unsigned r = 0; r < 9; r++) {
        const double root = expected_plan18_root_k[r];
        of_inverse += root * root;
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-12) * noise, noise * root,
                                  (double)s.quality.sigma[r]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-3, 1e-10), trace * of_inverse,
                              (double)s.quality.condition);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, s.quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0, s.quality.weak);
    TEST_ASSERT_EQUAL_UINT(18, s.quality.positions);
    TEST_ASSERT_EQUAL_UINT(9, s.quality.dof);
    TEST_ASSERT_EQUAL_UINT(9, s.quality.sigma_dof);
    TEST_ASSERT_TRUE(s.quality.left_out == 0);
}

/* It judges only by the size of the residuals, and says so. */
static void what_was_not_looked_for_is_unchecked(void)
{
    const scene s = plan18(1, 0.01, 1e-3, 0);

    TEST_ASSERT_EQUAL_HEX8(0x1E, s.quality.unchecked); /* drift, quadratic, cubic, hysteresis */
    TEST_ASSERT_EQUAL_UINT(INVCAL_NO_SYSTEMATIC, s.quality.systematic);
    TEST_ASSERT_TRUE(s.quality.left_out == 0 && s.quality.suspected == 0);
    TEST_ASSERT_TRUE(s.quality.axis == 0 && s.quality.size == 0);
}

static void residuals_are_calibrated_lengths_minus_one(void)
{
    const scene s = plan18(2, 0.1, 1e-3, 0);
    double squares = 0;
    double worst = 0;
    unsigned at = 0;

    for (unsigned i = 0; i < 18; i++) {
        invcal_real v[3];
        invcal_apply(&s.calibration, s.set.u[i][0], s.set.u[i][1], s.set.u[i][2], v);
        const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
        const double expected = length3(d) - 1;
        squares += expected * expected;
        at = fabs(expected) > worst ? i : at;
        worst = fmax(worst, fabs(expected));
    }
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15), sqrt(squares / 18),
                              (double)s.quality.rms);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15), worst, (double)s.quality.max);
    TEST_ASSERT_EQUAL_UINT(at, s.quality.worst);
}

/* The length of eta where u = (I + S) eta + delta, by Cramer's rule. */
static double length_at(const double x[9], const double u[3])
{
    const double s[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                            {x[6] / 2, 1 + x[4], x[8] / 2},
                            {x[7] / 2, x[8] / 2, 1 + x[5]}};
    double eta[3] = {0, 0, 0};
    double determinant = 0;

    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            const double cofactor = s[(r + 1) % 3][(c + 1) % 3] * s[(r + 2) % 3][(c + 2) % 3] -
                                    s[(r + 1) % 3][(c + 2) % 3] * s[(r + 2) % 3][(c + 1) % 3];
            eta[c] += cofactor * (u[r] - x[r]);
            determinant += s[r][c] * cofactor / 3;
        }
    }
    return length3(eta) / determinant;
}

/* The noise of u that residuals show: r(i) = |A (u - delta)| - 1 moves by |A eta| times it. */
static double observed_noise(const scene *s, unsigned count)
{
    double squares = 0;

    for (unsigned i = 0; i < count; i++) {
        invcal_real v[3];
        double eta[3];
        double gradient = 0;
        invcal_apply(&s->calibration, s->set.u[i][0], s->set.u[i][1], s->set.u[i][2], v);
        for (int k = 0; k < 3; k++) {
            eta[k] = (double)v[k];
        }
        for (int k = 0; k < 3; k++) {
            const double x = (double)s->calibration.matrix[0][k] * eta[0] +
                             (double)s->calibration.matrix[1][k] * eta[1] +
                             (double)s->calibration.matrix[2][k] * eta[2];
            gradient += x * x;
        }
        const double j = (eta[0] * eta[0] + eta[1] * eta[1] + eta[2] * eta[2] - 1) / 2;
        squares += j * j / gradient;
    }
    return sqrt(squares / (count - 9));
}

/* Calibrates again, with this stated noise. */
static const invcal_quality *judge_again(scene *s, double stated)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s->set, stated, &s->calibration, &s->quality));
    return &s->quality;
}

static void a_noise_that_is_not_stated_is_the_one_observed(void)
{
    const scene s = plan18(3, 0.1, 1e-3, 0);
    const double observed = observed_noise(&s, 18);

    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 1e-3, observed);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3 * observed, observed, (double)s.quality.noise);
    TEST_ASSERT_EQUAL_UINT(9, s.quality.sigma_dof);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, s.quality.verdict);
}

static void a_noise_that_is_stated_counts_as_four_residuals(void)
{
    static const double times[] = {0.75, 1, 1.5, 2};
    scene s = plan18(3, 0.1, 1e-3, 0);
    const double observed = observed_noise(&s, 18);

    for (unsigned i = 0; i < sizeof times / sizeof times[0]; i++) {
        const double stated = times[i] * observed;
        const double both = sqrt((4 * stated * stated + 9 * observed * observed) / 13);
        const invcal_quality *q = judge_again(&s, stated);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * both, both, (double)q->noise);
        TEST_ASSERT_EQUAL_UINT(13, q->sigma_dof);
        TEST_ASSERT_EQUAL_UINT(9, q->dof);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q->verdict);
    }
}

/* More than it shows in one of 20 sets is not believed, nor less than in one of 2000; and more than in one
 * of 333 is no noise. The quantiles below are Fisher's; three residuals have none. */
static void residuals_that_chi_squared_excludes_overrule_the_noise_stated(void)
{
    static const struct {
        unsigned positions;
        double at005, at95, at997; /* quantiles of chi squared */
    } of[] = {{12, 0, 7.8147, 13.9314},
              {15, 0.133451, 12.5916, 19.8047},
              {18, 0.875302, 16.9190, 24.9741}};
    random_source random = random_start(14);
    const triad_truth truth = triad_random(&random, 0.1);

    for (unsigned i = 0; i < sizeof of / sizeof of[0]; i++) {
        const unsigned n = of[i].positions;
        double v[18][3];
        scene s;
        for (unsigned k = 0; k < n; k++) {
            random_direction(&random, v[k]);
        }
        read_positions(&truth, (const double(*)[3])v, n, 1e-4, &random, &s.set);
        (void)judge_again(&s, 0);
        const double observed = observed_noise(&s, n);
        const double at95 = observed * sqrt((n - 9) / of[i].at95);
        const double at997 = observed * sqrt((n - 9) / of[i].at997);
        if (of[i].at005 > 0) {
            const double at005 = observed * sqrt((n - 9) / of[i].at005);
            TEST_ASSERT_EQUAL_UINT(n - 9, judge_again(&s, 100 * observed)->sigma_dof);
            TEST_ASSERT_EQUAL_UINT(n - 9, judge_again(&s, 1.01 * at005)->sigma_dof);
            TEST_ASSERT_DOUBLE_WITHIN(1e-3 * observed, observed, (double)s.quality.noise);
            TEST_ASSERT_EQUAL_UINT(n - 9 + 4, judge_again(&s, 0.99 * at005)->sigma_dof);
        }
        TEST_ASSERT_EQUAL_UINT(n - 9 + 4, judge_again(&s, 1.01 * at95)->sigma_dof);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, s.quality.verdict);
        TEST_ASSERT_EQUAL_UINT(n - 9, judge_again(&s, 0.99 * at95)->sigma_dof);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * observed, observed, (double)s.quality.noise);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, s.quality.verdict);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, judge_again(&s, 1.01 * at997)->verdict);
        TEST_ASSERT_EQUAL_INT(INVCAL_ROUGH, judge_again(&s, 0.99 * at997)->verdict);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * observed, observed, (double)s.quality.noise);
        TEST_ASSERT_EQUAL_UINT(n - 9, s.quality.sigma_dof);
        TEST_ASSERT_EQUAL_INT(INVCAL_ROUGH, judge_again(&s, 1e-6 * observed)->verdict);
        TEST_ASSERT_EQUAL_HEX16(0, s.quality.weak);
    }
}

/* Six residuals: 2 chi squared of 0.02, 12, 32 and 60 against 2 dof - 1 = 11. */
static void a_stated_noise_is_weighed_against_residuals_of_other_equations(void)
{
    static const struct {
        double stated, squares;
        unsigned dof;
        double variance;
        unsigned sigma_dof;
        invcal_verdict verdict;
    } of[] = {
        {1e-3, 6e-6, 6, 1e-6, 10, INVCAL_GOOD},      {1e-3, 9e-6, 6, 1.3e-6, 10, INVCAL_GOOD},
        {1e-3, 16e-6, 6, 16e-6 / 6, 6, INVCAL_GOOD}, {1e-3, 30e-6, 6, 5e-6, 6, INVCAL_ROUGH},
        {1e-3, 1e-8, 6, 1e-8 / 6, 6, INVCAL_GOOD},   {0, 6e-6, 6, 1e-6, 6, INVCAL_GOOD},
        {1e-3, 0, 0, 1e-6, 4, INVCAL_GOOD},          {0, 0, 0, 1, 0, INVCAL_GOOD},
        {1e-3, (double)NAN, 6, 0, 6, INVCAL_ROUGH},  {(double)NAN, 6e-6, 6, 0, 6, INVCAL_ROUGH}};

    for (unsigned i = 0; i < sizeof of / sizeof of[0]; i++) {
        invcal_quality q = {0};
        q.dof = (uint16_t)of[i].dof;
        q.verdict = INVCAL_GOOD;
        invcali_weigh_noise((invcal_real)of[i].stated, (invcal_real)of[i].squares, &q);
        if (of[i].variance > 0) {
            const double noise = sqrt(of[i].variance);
            TEST_ASSERT_DOUBLE_WITHIN(1e-6 * noise, noise, (double)q.noise);
        } else {
            TEST_ASSERT_FALSE((double)q.noise < 1);
        }
        TEST_ASSERT_EQUAL_UINT(of[i].sigma_dof, q.sigma_dof);
        TEST_ASSERT_EQUAL_UINT(of[i].dof, q.dof);
        TEST_ASSERT_EQUAL_INT(of[i].verdict, q.verdict);
        q.verdict = INVCAL_WEAK; /* the worse one stays */
        invcali_weigh_noise((invcal_real)of[i].stated, (invcal_real)of[i].squares, &q);
        TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, q.verdict);
    }
}

/* Noise of a reading in calibrated units, over noise: mean square over all directions. */
static double gain2(const invcal_calibration *calibration)
{
    double sum = 0;

    for (int i = 0; i < 9; i++) {
        const double x = (double)calibration->matrix[i / 3][i % 3];
        sum += x * x / 3;
    }
    return sum;
}

/* One redundant residual shows the noise, however poorly: a parameter is weak if its sigma is more
 * than ten times that, or if the information on it is no more than ten times what noise in ten
 * readings creates from nothing. */
static void one_residual_is_enough_to_tell_what_is_weak(void)
{
    random_source random = random_start(12);
    const triad_truth truth = triad_random(&random, 0.01);
    unsigned count[2] = {0, 0};

    for (unsigned draw = 0; draw < 40; draw++) {
        scene s;
        unsigned weak = 0;
        read_positions(&truth, &expected_faces_and_edges[draw % 9], 10, 0.02, &random, &s.set);
        if (calibrate_set(&s.set, 0, &s.calibration, &s.quality) != INVCAL_OK) {
            continue;
        }
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double sigma = (double)s.quality.sigma[r];
            const int is_large = sigma > 10 * (double)s.quality.noise;
            const int is_noisy = 10 * sigma * sigma * gain2(&s.calibration) > 0.1;
            weak |= (unsigned)(is_large || is_noisy) << r;
            count[is_noisy] += !is_large;
        }
        TEST_ASSERT_EQUAL_UINT(1, s.quality.dof);
        TEST_ASSERT_EQUAL_HEX16(weak, s.quality.weak);
    }
    TEST_ASSERT_TRUE(count[0] > 0 && count[1] > 0);
}

static const double nine_directions[9][3] = {{1, 0, 0},     {0, 1, 0},     {0, 0, 1},
                                             {-1, 0, 0},    {0, -1, 0},    {0, 0, -1},
                                             {0.6, 0.8, 0}, {0.6, 0, 0.8}, {0, 0.6, 0.8}};

static void nine_positions_of_absurd_noise_are_weak(void)
{
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    scene s;

    read_positions(&none, nine_directions, 9, 0, &unused, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, 0.2, &s.calibration, &s.quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, s.quality.verdict);
}

static void nine_positions_have_no_redundancy(void)
{
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.01);
    scene s;

    read_positions(&truth, nine_directions, 9, 1e-4, &random, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, 1e-4, &s.calibration, &s.quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, s.quality.verdict);
    TEST_ASSERT_EQUAL_UINT(0, s.quality.dof);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1e-4, (double)s.quality.noise);
    TEST_ASSERT_EQUAL_UINT(4, s.quality.sigma_dof);
    /* The noise is unknown: sigma is finite, and absurd enough not to be believed. */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, 0, &s.calibration, &s.quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, s.quality.verdict);
    TEST_ASSERT_TRUE(s.quality.noise == 1);
    TEST_ASSERT_EQUAL_UINT(0, s.quality.sigma_dof);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_TRUE((double)s.quality.sigma[r] > 0.1 && s.quality.sigma[r] < 10);
    }
}

/* Every position within 18 degrees of an axis, as with the T265: angles hardly show. */
static void positions_close_to_the_axes_are_weak_and_name_the_angles(void)
{
    random_source random = random_start(6);
    const triad_truth truth = triad_random(&random, 0.01);
    double v[30][3];
    scene s;

    for (int i = 0; i < 30; i++) {
        for (int k = 0; k < 3; k++) {
            v[i][k] = random_uniform(&random, -0.03, 0.03);
        }
        v[i][i % 3] = (i / 3) % 2 ? 1 : -1;
        const double length = length3(v[i]);
        for (int k = 0; k < 3; k++) {
            v[i][k] /= length;
        }
    }
    read_positions(&truth, (const double(*)[3])v, 30, 1e-5, &random, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, 0, &s.calibration, &s.quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, s.quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, s.quality.weak);
    /* And it is weak, even if it is rough, too. */
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, judge_again(&s, 1e-6)->verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, s.quality.weak);
}

/* Adds a position with noise sigma in u to the information on x, by central differences. */
static void inform(const double x[9], const double u[3], double sigma, double information[9][9])
{
    const double step = 1e-5;
    double slope[9];
    double of_u = 0;

    for (int r = 0; r < 9; r++) {
        double high[9];
        double low[9];
        memcpy(high, x, sizeof high);
        memcpy(low, x, sizeof low);
        high[r] += step;
        low[r] -= step;
        slope[r] = (length_at(high, u) - length_at(low, u)) / (2 * step);
        of_u += r < 3 ? slope[r] * slope[r] : 0; /* u and delta differ by the sign */
    }
    for (int r = 0; r < 9; r++) {
        for (int c = 0; c < 9; c++) {
            information[r][c] += slope[r] * slope[c] / (sigma * sigma * of_u);
        }
    }
}

/* K of a set of positions, for a noise of 1, and its lower bound for unbiased estimates. */
static void covariance(const triad_truth *truth, const double v[][3], int count, double k[9][9])
{
    memset(k, 0, 81 * sizeof k[0][0]);
    for (int i = 0; i < count; i++) {
        double u[3];
        triad_read(truth, v[i], u);
        inform(truth->x, u, 1, k);
    }
    invert(k[0], 9);
}

/* Noise of the readings adds about 9 noise^2 to every information, 1 / K. Without residuals it is that
 * stated. */
static void noise_of_a_tenth_of_the_information_is_weak(void)
{
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    double k[9][9];
    double most = 0;
    scene s;

    covariance(&none, nine_directions, 9, k);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        most = fmax(most, k[r][r]);
    }
    const double border = sqrt(0.1 / 9 / most);
    read_positions(&none, nine_directions, 9, 0, &unused, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, judge_again(&s, 0.98 * border)->verdict);
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, judge_again(&s, 1.02 * border)->verdict);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_EQUAL_INT(k[r][r] > most / 1.01, s.quality.weak >> r & 1);
    }
}

/* With the noise of rounding. */
static double worst_ratio(const triad_truth *truth)
{
    random_source unused = random_start(0);
    double k[9][9];
    double worst = 0;
    scene s;

    read_positions(truth, expected_plan18, 18, 0, &unused, &s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&s.set, 0, &s.calibration, &s.quality));
    covariance(truth, expected_plan18, 18, k);
    for (unsigned r = 0; r < 9; r++) {
        const double bound = (double)s.quality.noise * sqrt(k[r][r]);
        worst = larger(worst, fabs((double)s.quality.sigma[r] / bound - 1));
    }
    return worst;
}

static void sigma_is_the_cramer_rao_bound_for_errors_of_any_size(void)
{
    random_source random = random_start(11);

    needs_53_bits();
    for (int draw = 0; draw < 50; draw++) {
        const triad_truth truth = triad_random(&random, draw % 2 ? 0.1 : 0.2);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(FLOAT_OR_DOUBLE(1e-5, 1e-8), worst_ratio(&truth));
    }
}

static void sigma_is_the_cramer_rao_bound_beside_large_cross_terms(void)
{
    static const triad_truth truth = {{0.05, -0.1, 0.08, 0.1, -0.05, 0.15, 0.3, -0.2, 0.25}};

    needs_53_bits();
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(FLOAT_OR_DOUBLE(1e-5, 1e-8), worst_ratio(&truth));
}

/* The same sensor with another scale in its data sheet: then everything is over that field. */
static void a_wrong_scale_of_nominal_scales_what_is_over_field_only(void)
{
    const scene s = plan18(7, 0.01, 1e-3, 0);
    scene twice = s;

    for (unsigned i = 0; i < 18; i++) {
        for (int k = 0; k < 3; k++) {
            twice.set.u[i][k] *= 2;
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          calibrate_set(&twice.set, 0, &twice.calibration, &twice.quality));
    for (unsigned r = 0; r < 9; r++) {
        const double expected = 2 * (double)s.quality.sigma[r];
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * expected, expected, (double)twice.quality.sigma[r]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 2 * (double)s.quality.noise, (double)twice.quality.noise);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15), (double)s.quality.rms,
                              (double)twice.quality.rms);
    TEST_ASSERT_EQUAL_HEX16(s.quality.weak, twice.quality.weak);
}

/* Lengths are wrong by h X, and the mean of h h' over all directions is known. What it makes of all of K,
 * with the correlations, is near what it makes of the diagonal. */
static void accuracy_is_the_error_of_lengths(void)
{
    const triad_truth none = {{0}};
    random_source random = random_start(31);

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double length = 3.18245e-3 * sqrt(r < 3 ? 1. / 3 : r < 6 ? 1. / 5 : 1. / 15);
        invcal_quality q = {.sigma_dof = 3};
        q.sigma[r] = INVCAL_REAL(1e-3);
        TEST_ASSERT_DOUBLE_WITHIN(2e-3 * length, length, (double)invcal_accuracy(&q, 0));
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, hypot(length, 1.959964 * 0.0027),
                                  (double)invcal_accuracy(&q, INVCAL_REAL(0.0027)));
    }
    for (unsigned draw = 0; draw < 40; draw++) {
        double v[18][3];
        double k[9][9];
        double square = 0;
        scene s;
        for (unsigned i = 0; i < 18; i++) {
            random_direction(&random, v[i]);
        }
        covariance(&none, (const double(*)[3])v, 18, k);
        for (unsigned r = 0; r < 9; r++) {
            square += k[r][r] * (r < 3 ? 1. / 3 : r < 6 ? 1. / 5 : 1. / 15);
        }
        square += (k[3][4] + k[3][5] + k[4][5]) * 2 / 15; /* the mean of x^2 y^2 is 1/15 */
        read_positions(&none, (const double(*)[3])v, 18, 1e-4, &random, &s.set);
        (void)judge_again(&s, 0);
        const double length = 2.262157 * (double)s.quality.noise * sqrt(square);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * length, length, (double)invcal_accuracy(&s.quality, 0));
    }
}

/* Student's t of 3 degrees of freedom for what was measured, the normal quantile for what was
 * stated: of parameters and field. */
static void what_is_held_counts_as_stated(void)
{
    for (unsigned held = 0; held < 512; held += 37) {
        invcal_quality q = {.sigma_dof = 3, .held = (uint16_t)held};
        double square = pow(1.959964 * 0.0027, 2);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double sigma = 1e-3 * (r + 1);
            const double wide = held >> r & 1u ? 1.959964 : 3.18245;
            q.sigma[r] = (invcal_real)sigma;
            square += pow(wide * sigma, 2) * (r < 3 ? 1. / 3 : r < 6 ? 1. / 5 : 1. / 15);
        }
        TEST_ASSERT_DOUBLE_WITHIN(2e-3 * sqrt(square), sqrt(square),
                                  (double)invcal_accuracy(&q, INVCAL_REAL(0.0027)));
    }
}

/* Nine degrees of freedom: Student's t is 2.2622 where the normal distribution has 1.9600. */
static void a_target_is_reached_when_every_sigma_is_within_it(void)
{
    invcal_quality good = {.verdict = INVCAL_GOOD, .sigma_dof = 9};
    double target[3] = {1, 2, 3};

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        good.sigma[r] = (invcal_real)(target[r / 3] / 1.155);
    }
    TEST_ASSERT_EQUAL_INT(1, invcal_reaches(&good, 1, 2, 3));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double bad[] = {target[r / 3] / 1.153, NOT_A_NUMBER, INFINITE};
        for (unsigned i = 0; i < 3; i++) {
            invcal_quality q = good;
            q.sigma[r] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(0, invcal_reaches(&q, 1, 2, 3));
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real none[3] = {i == 0 ? (invcal_real)NAN : 1, i == 1 ? (invcal_real)NAN : 2,
                                     i == 2 ? (invcal_real)NAN : 3};
        TEST_ASSERT_EQUAL_INT(0, invcal_reaches(&good, none[0], none[1], none[2]));
    }
    for (unsigned verdict = 1; verdict < 256; verdict++) {
        invcal_quality q = good;
        q.verdict = (invcal_verdict)verdict;
        TEST_ASSERT_EQUAL_INT(0, invcal_reaches(&q, 1, 2, 3));
    }
    good.sigma_dof = 65535;
    TEST_ASSERT_EQUAL_INT(
        1, invcal_reaches(&good, INVCAL_REAL(0.87), INVCAL_REAL(1.74), INVCAL_REAL(2.61)));
}

static void coverage_is_students_quantile(void)
{
    for (unsigned i = 0; i < EXPECTED_STUDENT_COUNT; i++) {
        const double expected = expected_student_t[i];
        TEST_ASSERT_DOUBLE_WITHIN(2e-3 * expected, expected,
                                  (double)invcal_coverage((unsigned)expected_student_dof[i]));
    }
    TEST_ASSERT_TRUE(invcal_coverage(0) == invcal_coverage(1));
    TEST_ASSERT_DOUBLE_WITHIN(0.004, 1.96, (double)invcal_coverage(65535u));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(sigma_over_noise_of_the_papers_program_is_the_papers);
    RUN_TEST(residuals_are_calibrated_lengths_minus_one);
    RUN_TEST(what_was_not_looked_for_is_unchecked);
    RUN_TEST(a_noise_that_is_not_stated_is_the_one_observed);
    RUN_TEST(a_noise_that_is_stated_counts_as_four_residuals);
    RUN_TEST(a_stated_noise_is_weighed_against_residuals_of_other_equations);
    RUN_TEST(residuals_that_chi_squared_excludes_overrule_the_noise_stated);
    RUN_TEST(one_residual_is_enough_to_tell_what_is_weak);
    RUN_TEST(noise_of_a_tenth_of_the_information_is_weak);
    RUN_TEST(nine_positions_of_absurd_noise_are_weak);
    RUN_TEST(nine_positions_have_no_redundancy);
    RUN_TEST(positions_close_to_the_axes_are_weak_and_name_the_angles);
    RUN_SLOW_TEST(sigma_is_the_cramer_rao_bound_for_errors_of_any_size);
    RUN_TEST(sigma_is_the_cramer_rao_bound_beside_large_cross_terms);
    RUN_TEST(a_wrong_scale_of_nominal_scales_what_is_over_field_only);
    RUN_TEST(accuracy_is_the_error_of_lengths);
    RUN_TEST(what_is_held_counts_as_stated);
    RUN_TEST(a_target_is_reached_when_every_sigma_is_within_it);
    RUN_TEST(coverage_is_students_quantile);
    return UNITY_END() != 0;
}
