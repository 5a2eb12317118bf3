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

/* Positions with errors of up to `size` on the paper's 18 directions, solved with exact rows. */
static void solve_plan18(const triad_truth *truth, const invcal_settings *settings,
                         invcal_solution *solution)
{
    random_source unused = random_start(0);
    reading_set set;

    read_positions(truth, expected_plan18, 18, 0, &unused, &set);
    const invcal_normal normal = normal_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, settings, solution));
}

/* Must reach: |calibrated| - 1 on 1000 unseen orientations, errors up to 10 %. */
static void unseen_orientations_come_out_with_unit_length(void)
{
    random_source random = random_start(1);
    const invcal_settings settings = unit_settings(0);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        invcal_solution solution;
        double squares = 0;
        double worst = 0;
        solve_plan18(&truth, &settings, &solution);
        for (int i = 0; i < 1000; i++) {
            double eta[3];
            random_direction(&random, eta);
            const double error = fabs(calibrated_length(&solution, &truth, eta, 1) - 1);
            worst = fmax(worst, error);
            squares += error * error;
        }
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(2e-7, sqrt(squares / 1000));
        if (INVCAL_DOUBLE) {
            TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1e-12, worst);
        }
    }
}

static void the_nine_parameters_are_those_of_the_triad(void)
{
    random_source random = random_start(2);
    const invcal_settings settings = unit_settings(0);

    for (int draw = 0; draw < SOME(100); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        invcal_solution solution;
        solve_plan18(&truth, &settings, &solution);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-13), truth.x[r],
                                      parameter(&solution, r));
        }
    }
}

typedef invcal_status (*known_row)(const invcal_real u[3], const invcal_real vertical[3],
                                   invcal_observation *out);

/* The paper's program with its directions known. */
static invcal_normal with_known_directions(const triad_truth *truth, known_row observe)
{
    invcal_normal normal;
    invcal_observation row;

    invcal_normal_init(&normal);
    for (int i = 0; i < 18; i++) {
        double u[3];
        invcal_real ur[3];
        invcal_real vertical[3];
        triad_read(truth, expected_plan18[i], u);
        for (int k = 0; k < 3; k++) {
            ur[k] = (invcal_real)u[k];
            vertical[k] = (invcal_real)expected_plan18[i][k];
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, observe(ur, vertical, &row));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&normal, &row, 1));
    }
    return normal;
}

/* The exact row's reason to be: what the paper's first-order row leaves, by the reference. */
static double first_order_error(double size, double *rms)
{
    static const double sign[9] = {1, -1, 1, 1, -1, 1, -1, 1, -1};
    const invcal_settings settings = unit_settings(0);
    triad_truth truth;
    invcal_solution solution;
    double worst = 0;
    double squares = 0;

    for (int r = 0; r < 9; r++) {
        truth.x[r] = size * sign[r];
    }
    const invcal_normal normal = with_known_directions(&truth, invcal_observation_first_order);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &settings, &solution));
    for (unsigned r = 0; r < 9; r++) {
        worst = fmax(worst, fabs(parameter(&solution, r) - truth.x[r]));
    }
    for (int i = 0; i < 18; i++) {
        const double error = calibrated_length(&solution, &truth, expected_plan18[i], 1) - 1;
        squares += error * error;
    }
    *rms = sqrt(squares / 18);
    return worst;
}

static void the_first_order_row_leaves_the_error_that_the_design_states(void)
{
    static const double size[2] = {0.01, 0.1};

    for (int i = 0; i < 2; i++) {
        double rms;
        const double worst = first_order_error(size[i], &rms);
        const double bound = FLOAT_OR_DOUBLE(1e-6, 1e-12);
        TEST_ASSERT_DOUBLE_WITHIN(bound, expected_first_order_worst[i], worst);
        TEST_ASSERT_DOUBLE_WITHIN(bound, expected_first_order_rms[i], rms);
    }
    TEST_ASSERT_DOUBLE_WITHIN(2e-4, 2.5e-4, expected_first_order_worst[0]); /* order 1e-4 */
    TEST_ASSERT_DOUBLE_WITHIN(2e-2, 2.5e-2, expected_first_order_worst[1]); /* order 1e-2 */
}

static void known_directions_give_the_triad_exactly_for_errors_of_any_size(void)
{
    random_source random = random_start(3);
    const invcal_settings settings = unit_settings(0);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.2);
        const invcal_normal normal = with_known_directions(&truth, invcal_observation_vertical);
        invcal_solution solution;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &settings, &solution));
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-13), truth.x[r],
                                      parameter(&solution, r));
        }
    }
}

/* M'M of the calibration. */
static void gram(const invcal_solution *solution, double out[3][3])
{
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            out[r][c] = 0;
            for (int k = 0; k < 3; k++) {
                out[r][c] += (double)solution->calibration.matrix[k][r] *
                             (double)solution->calibration.matrix[k][c];
            }
        }
    }
}

static void the_two_frames_differ_by_a_rotation_only(void)
{
    random_source random = random_start(4);

    for (int draw = 0; draw < SOME(50); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        invcal_settings settings = unit_settings(0);
        invcal_solution symmetric;
        invcal_solution triangular;
        double a[3][3];
        double b[3][3];
        solve_plan18(&truth, &settings, &symmetric);
        settings.frame = INVCAL_FRAME_TRIANGULAR;
        solve_plan18(&truth, &settings, &triangular);
        gram(&symmetric, a);
        gram(&triangular, b);
        for (int r = 0; r < 3; r++) {
            TEST_ASSERT_TRUE(triangular.calibration.matrix[r][r] > 0);
            for (int c = 0; c < 3; c++) {
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-14), a[r][c], b[r][c]);
                TEST_ASSERT_TRUE(c >= r || triangular.calibration.matrix[r][c] == 0);
                TEST_ASSERT_TRUE(symmetric.calibration.matrix[r][c] ==
                                 symmetric.calibration.matrix[c][r]);
            }
        }
        TEST_ASSERT_EQUAL_MEMORY(symmetric.delta, triangular.delta, sizeof symmetric.delta);
        TEST_ASSERT_EQUAL_MEMORY(symmetric.gamma, triangular.gamma, sizeof symmetric.gamma);
    }
}

/* New case axes: u' = R u. Noise makes the fit a compromise, which must be the same one. */
static void a_rotation_of_the_case_does_not_change_lengths(void)
{
    random_source random = random_start(5);
    const invcal_settings settings = unit_settings(0);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.1);
        reading_set set;
        reading_set turned;
        double rotation[3][3];
        invcal_solution solution[2];
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
        const invcal_normal a = normal_of(&set);
        const invcal_normal b = normal_of(&turned);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&a, &settings, &solution[0]));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&b, &settings, &solution[1]));
        for (unsigned i = 0; i < set.count; i++) {
            double length[2];
            for (int k = 0; k < 2; k++) {
                invcal_real v[3];
                invcal_apply(&solution[k].calibration, k ? turned.u[i] : set.u[i], v);
                const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
                length[k] = length3(d);
            }
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-12), length[0], length[1]);
        }
    }
}

static void order_merging_and_removal_give_the_same_calibration(void)
{
    random_source random = random_start(6);
    const invcal_settings settings = unit_settings(0);
    const triad_truth truth = triad_random(&random, 0.1);
    reading_set set;
    invcal_observation row[18];
    invcal_solution expected;
    invcal_solution actual;
    invcal_normal n[3];

    read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
    const invcal_normal all = normal_of(&set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&all, &settings, &expected));
    for (int k = 0; k < 3; k++) {
        invcal_normal_init(&n[k]);
    }
    for (int i = 18; i-- > 0;) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(set.u[i], &row[i]));
        invcal_normal_add(&n[0], &row[i], 1);                 /* backwards */
        invcal_normal_add(i % 2 ? &n[1] : &n[2], &row[i], 1); /* two halves */
    }
    invcal_observation stray = row[3];
    stray.j += (invcal_real)0.05;
    invcal_normal_add(&n[0], &stray, 1);
    invcal_normal_remove(&n[0], &stray, 1);
    invcal_normal_merge(&n[1], &n[2]);
    for (int k = 0; k < 2; k++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&n[k], &settings, &actual));
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-13), parameter(&expected, r),
                                      parameter(&actual, r));
        }
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
        invcal_real least = raw[0][k];
        invcal_real most = raw[0][k];
        for (int i = 1; i < MAGNETOMETER_POSITIONS; i++) {
            least = raw[i][k] < least ? raw[i][k] : least;
            most = raw[i][k] > most ? raw[i][k] : most;
        }
        middle[k] = (least + most) / 2;
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
        invcal_settings settings = unit_settings(0);
        invcal_solution solution;
        invcal_quality quality;
        settings.field = (invcal_real)magnetometer_field;
        for (int k = 0; k < 3; k++) {
            iron[k] = random_uniform(&random, -48, 48) / uT_per_count;
            truth.x[k] = 0;
            settings.nominal.matrix[k][k] = (invcal_real)uT_per_count;
        }
        for (int i = 0; i < MAGNETOMETER_POSITIONS; i++) {
            read_magnetometer(&truth, iron, expected_plan18[i], raw[i]);
        }
        guess_iron(raw, settings.nominal.offset);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibrate(&raw[0][0], MAGNETOMETER_POSITIONS,
                                                          &settings, &solution, &quality, NULL));
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
        for (int k = 0; k < 3; k++) { /* hard iron, counts */
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-3, 1e-10), iron[k],
                                      (double)solution.calibration.offset[k]);
        }
        for (int i = 0; i < 100; i++) {
            double eta[3];
            invcal_real v[3];
            random_direction(&random, eta);
            read_magnetometer(&truth, iron, eta, v);
            invcal_apply(&solution.calibration, v, v);
            const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-11), magnetometer_field, length3(d));
        }
    }
}

/* raw = T (field eta) + zero, T turned, skewed and scaled at will; nominal is its inverse with
 * errors of 3 %. Nothing about it is diagonal or symmetric. */
static void any_regular_matrix_may_be_nominal(void)
{
    random_source random = random_start(10);

    for (int draw = 0; draw < SOME(50); draw++) {
        static const double zero[3] = {500, -300, 200};
        double turn[3][3];
        double t[3][3];
        invcal_calibration forward = {{0, 0, 0}, {{0}}};
        invcal_settings settings = unit_settings(0);
        invcal_normal normal;
        invcal_observation row;
        invcal_solution solution;
        random_rotation(&random, turn);
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                t[r][c] = 100 * (turn[r][c] + random_uniform(&random, -0.2, 0.2));
                forward.matrix[r][c] = (invcal_real)(t[r][c] + random_uniform(&random, -3, 3));
            }
            settings.nominal.offset[r] = (invcal_real)(zero[r] + 20);
        }
        settings.field = 10;
        settings.frame = draw % 2 ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_calibration_inverse(&forward, settings.nominal.matrix));
        invcal_normal_init(&normal);
        for (int i = 0; i < 18 + 100; i++) {
            double eta[3];
            invcal_real raw[3];
            invcal_real u[3];
            random_direction(&random, eta);
            const double *e = i < 18 ? expected_plan18[i] : eta;
            for (int k = 0; k < 3; k++) {
                raw[k] = (invcal_real)(zero[k] +
                                       10 * (t[k][0] * e[0] + t[k][1] * e[1] + t[k][2] * e[2]));
            }
            if (i < 18) {
                invcal_observation_reading(&settings.nominal, settings.field, raw, u);
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(u, &row));
                invcal_normal_add(&normal, &row, 1);
                continue;
            }
            if (i == 18) {
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &settings, &solution));
                for (int k = 0; k < 3; k++) {
                    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-3, 1e-10), zero[k],
                                              (double)solution.calibration.offset[k]);
                }
            }
            invcal_apply(&solution.calibration, raw, u);
            const double v[3] = {(double)u[0], (double)u[1], (double)u[2]};
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-5, 1e-12), 10, length3(v));
        }
    }
}

/* What the positions leave open is weighed with rounding errors in mind, the rest is not. */
static void noise_is_raised_only_where_a_prior_has_to_hold_something(void)
{
    random_source random = random_start(11);
    const triad_truth truth = triad_random(&random, 0.03);
    invcal_settings settings = unit_settings(1e-5);
    reading_set set;
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    settings.prior[2] = 10;
    settings.prior[8] = (invcal_real)1e-3;
    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    invcal_normal normal = normal_of(&set);
    invcal_real noise = (invcal_real)1e-9;
    invcal_information(&normal, &settings, &noise, hth);
    TEST_ASSERT_TRUE(noise == (invcal_real)1e-9);
    set.count = 3;
    normal = normal_of(&set);
    invcal_information(&normal, &settings, &noise, hth);
    /* 10 sqrt(4 epsilon largest), the largest diagonal element of three positions being about 2 */
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-3, 3e-7), FLOAT_OR_DOUBLE(1e-2, 4e-7),
                              (double)noise);
}

static void a_prior_adds_the_square_of_noise_over_sigma_to_the_diagonal(void)
{
    random_source random = random_start(12);
    const triad_truth truth = triad_random(&random, 0.1);
    invcal_settings settings = unit_settings(1);
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real noise = 2;
    reading_set set;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = (invcal_real)(r % 4 / 2.0); /* 0: none */
    }
    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    const invcal_normal normal = normal_of(&set);
    invcal_information(&normal, &settings, &noise, hth);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double s = r % 4 / 2.0;
        for (unsigned c = 0; c <= r; c++) {
            const double added = (double)hth[INVCAL_PACKED(r, c)] - element(&normal, r, c);
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 4e-15),
                                      s > 0 && r == c ? 4 / (s * s) : 0, added);
        }
    }
    TEST_ASSERT_TRUE(noise == 2);
}

static void unusable_settings_are_refused_and_the_solution_left_alone(void)
{
    random_source random = random_start(8);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;
    invcal_solution solution;
    invcal_solution before;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    const invcal_normal normal = normal_of(&set);
    memset(&solution, 7, sizeof solution);
    before = solution;
    for (int i = 0; i < 17; i++) {
        invcal_settings s = unit_settings(0.001);
        switch (i) {
        case 0:
            s.field = 0;
            break;
        case 1:
            s.field = (invcal_real)NAN;
            break;
        case 2:
            s.field = -1;
            break;
        case 3:
            s.noise = -1;
            break;
        case 4:
            s.noise = (invcal_real)NAN;
            break;
        case 5:
            s.noise = (invcal_real)INFINITY;
            break;
        case 6:
            s.prior[4] = 1, s.noise = 0;
            break; /* a prior needs the noise */
        case 7:
            s.prior[4] = 1, s.prior[5] = -1;
            break;
        case 8:
            s.prior[4] = 1, s.prior[5] = (invcal_real)NAN;
            break;
        case 9:
            s.nominal.matrix[1][1] = 0;
            break;
        case 10:
            s.frame = (invcal_frame)2;
            break;
        case 11:
            s.noise = (invcal_real)1.01; /* more than the field */
            break;
        case 12:
            s.prior[8] = (invcal_real)NAN; /* the only one */
            break;
        case 13:
            s.prior[0] = -1;
            break;
        default:
            s.nominal.offset[i - 14] = (invcal_real)INFINITY;
            break;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_solve(&normal, &s, &solution));
        TEST_ASSERT_EQUAL_MEMORY(&before, &solution, sizeof solution);
    }
    for (int frame = 0; frame < 2; frame++) { /* and these are usable */
        invcal_settings s = unit_settings(frame ? 0.001 : 0);
        s.frame = frame ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &s, &solution));
    }
}

/* Matrix, field in raw units, offset: up to 1e-6 of the largest number, what comes of them is one. */
static void numbers_too_large_for_their_result_are_refused(void)
{
    static const double beyond[] = {1.1, 0.9};
    random_source random = random_start(8);
    const triad_truth truth = triad_random(&random, 0.1);
    reading_set set;
    invcal_solution solution;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    const invcal_normal normal = normal_of(&set);
    for (unsigned i = 0; i < 6; i++) {
        const invcal_real large = INVCAL_REAL_MAX * (invcal_real)1e-6 * (invcal_real)beyond[i % 2];
        invcal_settings s = unit_settings(0);
        if (i < 2) {
            s.nominal.matrix[2][2] = large;
        } else if (i < 4) {
            s.field = large;
        } else {
            s.nominal.offset[1] = -large;
        }
        TEST_ASSERT_EQUAL_INT(i % 2 ? INVCAL_OK : INVCAL_BAD_SETTING, invcal_settings_check(&s));
        if (i % 2) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&normal, &s, &solution));
            for (unsigned k = 0; k < 3; k++) {
                TEST_ASSERT_TRUE(solution.calibration.offset[k] - solution.calibration.offset[k] ==
                                 0);
                TEST_ASSERT_TRUE(solution.calibration.matrix[k][2] * 0 == 0);
            }
        }
    }
}

static void unreal_sums_are_refused(void)
{
    random_source random = random_start(9);
    const triad_truth truth = triad_random(&random, 0.01);
    const invcal_settings settings = unit_settings(0);
    reading_set set;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    for (unsigned i = 0; i < INVCAL_MOMENTS + 9; i++) {
        invcal_normal n = normal_of(&set);
        invcal_solution solution;
        invcal_solution before;
        memset(&solution, 7, sizeof solution);
        before = solution;
        invcal_real *number = i < INVCAL_MOMENTS ? &n.moment[i] : &n.htj[i - INVCAL_MOMENTS];
        *number = (invcal_real)NAN;
        TEST_ASSERT_TRUE(invcal_solve(&n, &settings, &solution) != INVCAL_OK);
        TEST_ASSERT_EQUAL_MEMORY(&before, &solution, sizeof solution);
    }
}

static void the_deviation_is_put_together_from_dk_and_gamma(void)
{
    const invcal_solution s = {{{0, 0, 0}, {{0}}}, {0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
    static const double expected[6] = {1, 1, 2, 2, 3, 3};
    invcal_real deviation[6];

    invcal_solution_deviation(&s, deviation);
    for (int k = 0; k < 6; k++) {
        TEST_ASSERT_EQUAL_DOUBLE(expected[k], (double)deviation[k]);
    }
}

/* A semi-axis of 0.1 to 10 of nominal is a triad's, and an offset of up to 10 fields. Readings are
 * kept between 0.1 and 10, too. */
static void semi_axes_and_offsets_beyond_their_limits_are_no_triads(void)
{
    static const struct {
        int r;
        double error;
        invcal_status status;
    } limits[] = {{INVCAL_DK_X, 0.13 - 1, INVCAL_OK},
                  {INVCAL_DK_X, 0.07 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DK_X, 9.5 - 1, INVCAL_OK},
                  {INVCAL_DK_X, 10.5 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DELTA_X, 9.8, INVCAL_OK},
                  {INVCAL_DELTA_Y, -10.2, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DELTA_Z, 10.2, INVCAL_NOT_ELLIPSOID}};
    const invcal_settings settings = unit_settings(0);
    random_source random = random_start(15);

    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        triad_truth truth = {{0}};
        invcal_normal normal;
        invcal_solution solution;
        truth.x[limits[i].r] = limits[i].error;
        invcal_normal_init(&normal);
        while (normal.count < 40) {
            double eta[3];
            double u[3];
            invcal_observation row;
            random_direction(&random, eta);
            triad_read(&truth, eta, u);
            const invcal_real up[3] = {(invcal_real)eta[0], (invcal_real)eta[1],
                                       (invcal_real)eta[2]};
            const invcal_real reading[3] = {(invcal_real)u[0], (invcal_real)u[1],
                                            (invcal_real)u[2]};
            if (invcal_observation_vertical(reading, up, &row) == INVCAL_OK) {
                (void)invcal_normal_add(&normal, &row, 1);
            }
        }
        TEST_ASSERT_EQUAL_INT(limits[i].status, invcal_solve(&normal, &settings, &solution));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(unseen_orientations_come_out_with_unit_length);
    RUN_TEST(the_nine_parameters_are_those_of_the_triad);
    RUN_TEST(the_first_order_row_leaves_the_error_that_the_design_states);
    RUN_TEST(known_directions_give_the_triad_exactly_for_errors_of_any_size);
    RUN_TEST(the_two_frames_differ_by_a_rotation_only);
    RUN_TEST(a_rotation_of_the_case_does_not_change_lengths);
    RUN_TEST(order_merging_and_removal_give_the_same_calibration);
    RUN_TEST(a_magnetometer_is_calibrated_like_an_accelerometer);
    RUN_TEST(any_regular_matrix_may_be_nominal);
    RUN_TEST(noise_is_raised_only_where_a_prior_has_to_hold_something);
    RUN_TEST(a_prior_adds_the_square_of_noise_over_sigma_to_the_diagonal);
    RUN_TEST(unusable_settings_are_refused_and_the_solution_left_alone);
    RUN_TEST(numbers_too_large_for_their_result_are_refused);
    RUN_TEST(unreal_sums_are_refused);
    RUN_TEST(the_deviation_is_put_together_from_dk_and_gamma);
    RUN_TEST(semi_axes_and_offsets_beyond_their_limits_are_no_triads);
    return UNITY_END() != 0;
}
