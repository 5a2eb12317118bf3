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

/* Solution and residuals of the paper's 18 positions with errors of `size`. */
typedef struct {
    reading_set set;
    invcal_settings settings;
    invcal_solution solution;
    invcal_residuals residuals;
} scene;

static scene plan18(uint32_t seed, double size, double sigma, double stated)
{
    random_source random = random_start(seed);
    const triad_truth truth = triad_random(&random, size);
    scene s;

    s.settings = unit_settings(stated);
    read_positions(&truth, expected_plan18, 18, sigma, &random, &s.set);
    const invcal_normal normal = normal_of(&s.set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &s.settings, &s.solution));
    invcal_residuals_init(&s.residuals, &s.solution);
    for (unsigned i = 0; i < s.set.count; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_residuals_add(&s.residuals, s.set.u[i], 1, NULL));
    }
    return s;
}

static void root_k_of_the_papers_program_is_the_papers(void)
{
    /* Without errors of the triad: they would weight the rows. */
    const scene s = plan18(1, 0, 0, 1e-3);
    invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_quality q;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_covariance(&s.residuals, &s.settings, q.noise, K));
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-12), expected_plan18_root_k[r],
                                  sqrt((double)K[INVCAL_PACKED(r, r)]));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-9, 1e-15), 1e-3 * expected_plan18_root_k[r],
                                  sigma_of_parameter(&q, r));
    }
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-11), 8, (double)q.condition);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
    TEST_ASSERT_EQUAL_HEX16(0, q.undetermined);
    TEST_ASSERT_EQUAL_HEX16(0, q.from_prior);
}

static void residuals_are_calibrated_lengths_minus_one(void)
{
    scene s = plan18(2, 0.1, 1e-3, 0);
    double squares = 0;
    double worst = 0;
    unsigned at = 0;

    for (unsigned i = 0; i < 18; i++) {
        invcal_real v[3];
        invcal_real residual;
        invcal_apply(&s.solution.calibration, s.set.u[i], v);
        const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
        const double expected = length3(d) - 1;
        invcal_residuals_add(&s.residuals, s.set.u[i], 1, &residual);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15), expected, (double)residual);
        squares += expected * expected;
        at = fabs(expected) > worst ? i : at;
        worst = fmax(worst, fabs(expected));
    }
    TEST_ASSERT_EQUAL_UINT(36, s.residuals.count);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3 * squares, 2 * squares, (double)s.residuals.squares);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15), worst, (double)s.residuals.max);
    TEST_ASSERT_EQUAL_UINT(at, s.residuals.worst);
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

/* The mean of |A eta|^2 over all directions is that over the axes. */
static void the_gain_is_the_root_mean_square_over_all_directions(void)
{
    static const double x[9] = {0, 0, 0, 0.1, -0.1, 0.2, 0.4, -0.2, 0.3};
    static const double axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    invcal_solution solution;
    invcal_residuals residuals;
    double squares = 0;

    memset(&solution, 0, sizeof solution);
    for (int i = 0; i < 3; i++) {
        solution.dk[i] = (invcal_real)x[3 + i];
        solution.gamma[i] = (invcal_real)x[6 + i];
        squares += pow(length_at(x, axis[i]), 2);
    }
    invcal_residuals_init(&residuals, &solution);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-14), sqrt(squares / 3),
                              (double)residuals.gain);
}

static void the_noise_is_the_larger_of_stated_and_observed(void)
{
    invcal_quality q;
    scene s = plan18(3, 0.01, 1e-3, 0);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    const double observed = sqrt((double)s.residuals.normal.jtj / 9);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * observed, observed, (double)q.noise);
    TEST_ASSERT_DOUBLE_WITHIN(0.003, 2.262157, (double)q.coverage); /* Student, 9 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 9, (double)q.dof);
    s.settings.noise = (invcal_real)(observed / 2);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * observed, observed, (double)q.noise);
    s.settings.noise = (invcal_real)(observed * 2);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    const double gain = (double)s.residuals.gain;
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * observed, 2 * observed * gain, (double)q.noise);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1.959964, (double)q.coverage);
}

/* One residual to spare tells the noise, however badly: a parameter is weak where the information
 * on it is no more than ten times what noise in ten readings makes of nothing. */
static void one_residual_is_enough_to_tell_what_is_weak(void)
{
    random_source random = random_start(12);
    const triad_truth truth = triad_random(&random, 0.01);
    unsigned count[2] = {0, 0};

    for (unsigned draw = 0; draw < 40; draw++) {
        scene s = {.settings = unit_settings(0)};
        invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
        invcal_quality q;
        unsigned weak = 0;
        read_positions(&truth, &expected_faces_and_edges[draw % 9], 10, 0.02, &random, &s.set);
        if (calibrate_set(&s.set, &s.settings, &s.solution, &q, NULL) != INVCAL_OK) {
            continue;
        }
        invcal_residuals_init(&s.residuals, &s.solution);
        for (unsigned i = 0; i < 10; i++) {
            (void)invcal_residuals_add(&s.residuals, s.set.u[i], 1, NULL);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_covariance(&s.residuals, &s.settings, q.noise, K));
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double k = (double)K[INVCAL_PACKED(r, r)];
            const int is_noisy = k * 10 * (double)q.noise * (double)q.noise > 0.1;
            weak |= (unsigned)(k > 100 || is_noisy) << r;
            count[is_noisy] += k <= 100;
        }
        TEST_ASSERT_TRUE((double)q.dof > 0.99 && (double)q.dof < 1.01);
        TEST_ASSERT_EQUAL_HEX16(weak, q.undetermined);
    }
    TEST_ASSERT_TRUE(count[0] > 0 && count[1] > 0);
}

/* What the prior tells of a parameter, K noise^2 / prior^2 with K of both, the data need not. */
static void what_a_prior_tells_leaves_degrees_of_freedom(void)
{
    scene s = plan18(5, 0.01, 1e-3, 1e-3);
    invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_quality q;
    double dof = 18;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        s.settings.prior[r] = (invcal_real)(5e-4 * (r + 1));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    const double stated = 1e-3 * (double)s.residuals.gain;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_covariance(&s.residuals, &s.settings, (invcal_real)stated, K));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double ratio = stated / (double)s.settings.prior[r];
        dof -= 1 - (double)K[INVCAL_PACKED(r, r)] * ratio * ratio;
    }
    TEST_ASSERT_TRUE(dof > 9.5 && dof < 17.5);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, dof, (double)q.dof);
}

/* Readings as noisy as the field tell nothing: what is left is the prior, of each its own. */
static void sigma_of_what_is_not_told_is_the_prior_of_each(void)
{
    scene s = plan18(6, 0.001, 0, 1);
    invcal_quality q;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        s.settings.prior[r] = (invcal_real)(1e-3 * (r + 1));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    TEST_ASSERT_EQUAL_HEX16(0x1FF, q.from_prior);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double prior = 1e-3 * (r + 1);
        TEST_ASSERT_DOUBLE_WITHIN(3e-3 * prior, prior, sigma_of_parameter(&q, r));
    }
}

static void stored_positions_share_the_parameters_out(void)
{
    scene s = plan18(4, 0.01, 1e-3, 0);
    invcal_quality q;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&s.residuals, 36, &s.settings, &s.solution, &q));
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 13.5, (double)q.dof); /* 18 (1 - 9/36) */
    /* They stand for twice as many: sigma is that of 36, for the noise now seen. */
    for (unsigned r = 0; r < 9; r++) {
        const double expected = (double)q.noise * expected_plan18_root_k[r] / sqrt(2);
        TEST_ASSERT_DOUBLE_WITHIN(0.03 * expected, expected, sigma_of_parameter(&q, r));
    }
}

static void nine_positions_of_absurd_noise_are_weak(void)
{
    static const double direction[9][3] = {{1, 0, 0},     {0, 1, 0},     {0, 0, 1},
                                           {-1, 0, 0},    {0, -1, 0},    {0, 0, -1},
                                           {0.6, 0.8, 0}, {0.6, 0, 0.8}, {0, 0.6, 0.8}};
    const triad_truth none = {{0}};
    const invcal_settings settings = unit_settings(0.2);
    random_source unused = random_start(0);
    reading_set set;
    invcal_solution solution;
    invcal_quality q;

    read_positions(&none, direction, 9, 0, &unused, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &settings, &solution, &q, NULL));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, q.verdict);
}

/* Every second position is 20 times as noisy, and weighted so. */
static void weighted_positions_are_judged_by_their_weights(void)
{
    random_source random = random_start(12);
    const invcal_settings settings = unit_settings(0);
    double squares = 0;
    int draws = 300;

    for (int draw = 0; draw < draws; draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        invcal_real u[36][3];
        invcal_normal normal;
        invcal_observation row;
        invcal_solution solution;
        invcal_residuals residuals;
        invcal_quality q;
        invcal_normal_init(&normal);
        for (unsigned i = 0; i < 36; i++) {
            reading_set one;
            read_positions(&truth, &expected_plan18[i / 2], 1, i % 2 ? 2e-3 : 1e-4, &random, &one);
            memcpy(u[i], one.u[0], sizeof u[i]);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(u[i], &row));
            invcal_normal_add(&normal, &row, i % 2 ? (invcal_real)(1 / 400.0) : 1);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &settings, &solution));
        invcal_residuals_init(&residuals, &solution);
        for (unsigned i = 0; i < 36; i++) {
            TEST_ASSERT_EQUAL_INT(
                INVCAL_OK,
                invcal_residuals_add(&residuals, u[i], i % 2 ? (invcal_real)(1 / 400.0) : 1, NULL));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_assess(&residuals, 36, &settings, &solution, &q));
        for (unsigned r = 0; r < 9; r++) {
            const double z = (parameter(&solution, r) - truth.x[r]) / sigma_of_parameter(&q, r);
            squares += z * z;
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 1, sqrt(squares / (9 * draws)));
}

static void nine_positions_have_no_redundancy(void)
{
    static const double direction[9][3] = {{1, 0, 0},     {0, 1, 0},     {0, 0, 1},
                                           {-1, 0, 0},    {0, -1, 0},    {0, 0, -1},
                                           {0.6, 0.8, 0}, {0.6, 0, 0.8}, {0, 0.6, 0.8}};
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.01);
    const invcal_settings known = unit_settings(1e-4);
    const invcal_settings unknown = unit_settings(0);
    reading_set set;
    invcal_solution solution;
    invcal_quality q;

    read_positions(&truth, direction, 9, 1e-4, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &known, &solution, &q, NULL));
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, q.verdict);
    TEST_ASSERT_TRUE(q.dof == 0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1e-4, (double)q.noise);
    /* Nobody knows the noise: sigma is finite, and absurd enough not to be believed. */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &unknown, &solution, &q, NULL));
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, q.verdict);
    TEST_ASSERT_TRUE(q.noise == 1);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_TRUE(sigma_of_parameter(&q, r) > 0.1 && sigma_of_parameter(&q, r) < 10);
    }
}

/* Every position within 18 degrees of an axis, as on the T265: angles are hardly seen. */
static void positions_near_the_axes_are_weak_and_name_the_angles(void)
{
    random_source random = random_start(6);
    const triad_truth truth = triad_random(&random, 0.01);
    const invcal_settings settings = unit_settings(0);
    double v[30][3];
    reading_set set;
    invcal_solution solution;
    invcal_quality q;

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
    read_positions(&truth, (const double(*)[3])v, 30, 1e-5, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &settings, &solution, &q, NULL));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, q.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, q.undetermined);
}

/* In any field unit: its squares alone would overflow a float, or vanish. */
static void the_offset_sigma_is_that_of_delta_in_raw_units(void)
{
    scene s = plan18(7, 0.001, 1e-3, 0);
    invcal_quality q;

    for (int exponent = -30; exponent <= 30; exponent += 10) {
        const double unit = pow(10, exponent);
        s.settings.field = (invcal_real)(10 * unit);
        for (int k = 0; k < 3; k++) {
            s.settings.nominal.matrix[k][k] = (invcal_real)(0.5 * unit); /* a count */
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-5 * 20 * (double)q.sigma_delta[k],
                                      20 * (double)q.sigma_delta[k], (double)q.sigma_offset[k]);
        }
    }
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

/* a <- a^-1, by Gauss and Jordan; positive definite, so that no pivot is small. */
static void invert(double a[9][9])
{
    for (int k = 0; k < 9; k++) {
        const double pivot = 1 / a[k][k];
        a[k][k] = 1;
        for (int c = 0; c < 9; c++) {
            a[k][c] *= pivot;
        }
        for (int r = 0; r < 9; r++) {
            if (r != k) {
                const double factor = a[r][k];
                a[r][k] = 0;
                for (int c = 0; c < 9; c++) {
                    a[r][c] -= factor * a[k][c];
                }
            }
        }
    }
}

static void sigma_is_the_cramer_rao_bound_beside_large_cross_terms(void)
{
    static const triad_truth truth = {{0.05, -0.1, 0.08, 0.1, -0.05, 0.15, 0.3, -0.2, 0.25}};
    const invcal_settings settings = unit_settings(1e-4);
    random_source unused = random_start(0);
    double information[9][9] = {{0}};
    reading_set set;
    invcal_solution solution;
    invcal_quality q;

    needs_53_bits();
    read_positions(&truth, expected_plan18, 18, 0, &unused, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, &settings, &solution, &q, NULL));
    for (int i = 0; i < 18; i++) {
        double u[3];
        triad_read(&truth, expected_plan18[i], u);
        inform(truth.x, u, 1e-4, information);
    }
    invert(information);
    for (unsigned r = 0; r < 9; r++) {
        const double sigma = sqrt(information[r][r]);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-8) * sigma, sigma,
                                  sigma_of_parameter(&q, r));
    }
}

static void absurd_residuals_are_refused(void)
{
    scene s = plan18(8, 0.01, 1e-3, 0);
    invcal_quality q;
    invcal_quality before;

    memset(&q, 7, sizeof q);
    before = q;
    s.residuals.squares = (invcal_real)(18 * 0.11 * 0.11);
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID,
                          invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    s.residuals.squares = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID,
                          invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

static void unusable_input_is_refused_and_the_quality_left_alone(void)
{
    const scene good = plan18(9, 0.01, 1e-3, 1e-3);
    invcal_quality q;
    invcal_quality before;

    memset(&q, 7, sizeof q);
    before = q;
    for (int i = 0; i < 11; i++) {
        scene s = good;
        unsigned used = 18;
        switch (i) {
        case 0:
            s.settings.field = 0;
            break;
        case 1:
            s.settings.field = (invcal_real)NAN;
            break;
        case 2:
            s.settings.noise = -1;
            break;
        case 3:
            s.settings.noise = (invcal_real)NAN;
            break;
        case 4:
            s.settings.nominal.matrix[0][0] = 0;
            break;
        case 5:
            s.settings.prior[0] = 1, s.settings.prior[1] = -1;
            break;
        case 6:
            used = 17;
            break;
        case 7:
            s.settings.prior[3] = (invcal_real)0.01, s.settings.noise = 0;
            break;
        case 8:
            s.settings.prior[3] = (invcal_real)NAN; /* the only one */
            break;
        case 9:
            s.settings.noise = 2; /* twice the field */
            break;
        default:
            s.residuals.count = 0;
            break;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_assess(&s.residuals, used, &s.settings, &s.solution, &q));
    }
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

static void unreal_residuals_are_refused(void)
{
    const scene good = plan18(10, 0.01, 1e-3, 0);
    invcal_quality q;
    invcal_quality before;

    memset(&q, 7, sizeof q);
    before = q;
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)] = {7};
        scene s = good;
        s.residuals.normal.moment[i] = (invcal_real)NAN;
        TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                              invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
        TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                              invcal_covariance(&s.residuals, &s.settings, 1, K));
        TEST_ASSERT_TRUE(K[0] == 7 && K[44] == 0);
        s.settings.noise = (invcal_real)1e-3; /* nor does a prior hold a NaN */
        s.settings.prior[4] = (invcal_real)0.01;
        TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                              invcal_assess(&s.residuals, 18, &s.settings, &s.solution, &q));
    }
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

static void a_covariance_needs_a_noise_and_settings_that_are_some(void)
{
    static const double bad[] = {0, -1e-3, NOT_A_NUMBER, INFINITE};
    scene s = plan18(12, 0.01, 1e-3, 0);
    invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)] = {7};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_covariance(&s.residuals, &s.settings, (invcal_real)bad[i], K));
    }
    s.settings.field = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                          invcal_covariance(&s.residuals, &s.settings, (invcal_real)1e-3, K));
    TEST_ASSERT_TRUE(K[0] == 7 && K[44] == 0);
    s.settings.field = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_covariance(&s.residuals, &s.settings, (invcal_real)1e-3, K));
    TEST_ASSERT_TRUE(K[44] > 0);
}

static void a_reading_absurd_after_calibration_is_refused_by_the_residuals(void)
{
    scene s = plan18(11, 0.01, 1e-3, 0);
    const invcal_residuals before = s.residuals;
    const invcal_real far[3] = {0, 0, 20};
    const invcal_real nan[3] = {0, 0, (invcal_real)NAN};
    invcal_real residual = 7;

    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE,
                          invcal_residuals_add(&s.residuals, far, 1, &residual));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_residuals_add(&s.residuals, nan, 1, &residual));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                          invcal_residuals_add(&s.residuals, s.set.u[0], 0, &residual));
    TEST_ASSERT_TRUE(residual == 7);
    TEST_ASSERT_EQUAL_MEMORY(&before, &s.residuals, sizeof before);
}

static void coverage_is_students_quantile(void)
{
    for (unsigned i = 0; i < EXPECTED_STUDENT_COUNT; i++) {
        const double expected = expected_student_t[i];
        TEST_ASSERT_DOUBLE_WITHIN(2e-3 * expected, expected,
                                  (double)invcal_coverage((invcal_real)expected_student_dof[i]));
    }
}

static void coverage_rounds_down_and_fails_closed(void)
{
    TEST_ASSERT_TRUE(invcal_coverage((invcal_real)4.9) == invcal_coverage(4));
    TEST_ASSERT_TRUE(invcal_coverage((invcal_real)1.9) == invcal_coverage(1));
    TEST_ASSERT_TRUE(invcal_coverage(0) == invcal_coverage(1));
    TEST_ASSERT_TRUE(invcal_coverage(-1) == invcal_coverage(1));
    TEST_ASSERT_TRUE(invcal_coverage((invcal_real)NAN) == invcal_coverage(1));
    TEST_ASSERT_DOUBLE_WITHIN(0.004, 1.96, (double)invcal_coverage((invcal_real)INFINITY));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(root_k_of_the_papers_program_is_the_papers);
    RUN_TEST(residuals_are_calibrated_lengths_minus_one);
    RUN_TEST(the_gain_is_the_root_mean_square_over_all_directions);
    RUN_TEST(the_noise_is_the_larger_of_stated_and_observed);
    RUN_TEST(one_residual_is_enough_to_tell_what_is_weak);
    RUN_TEST(what_a_prior_tells_leaves_degrees_of_freedom);
    RUN_TEST(sigma_of_what_is_not_told_is_the_prior_of_each);
    RUN_TEST(stored_positions_share_the_parameters_out);
    RUN_TEST(nine_positions_of_absurd_noise_are_weak);
    RUN_SLOW_TEST(weighted_positions_are_judged_by_their_weights);
    RUN_TEST(nine_positions_have_no_redundancy);
    RUN_TEST(positions_near_the_axes_are_weak_and_name_the_angles);
    RUN_TEST(the_offset_sigma_is_that_of_delta_in_raw_units);
    RUN_TEST(sigma_is_the_cramer_rao_bound_beside_large_cross_terms);
    RUN_TEST(absurd_residuals_are_refused);
    RUN_TEST(unusable_input_is_refused_and_the_quality_left_alone);
    RUN_TEST(unreal_residuals_are_refused);
    RUN_TEST(a_covariance_needs_a_noise_and_settings_that_are_some);
    RUN_TEST(a_reading_absurd_after_calibration_is_refused_by_the_residuals);
    RUN_TEST(coverage_is_students_quantile);
    RUN_TEST(coverage_rounds_down_and_fails_closed);
    return UNITY_END() != 0;
}
