/* SPDX-License-Identifier: MIT
 *
 * Both sensors in one solution: against closed form, and against a simulated hand. The equations are those of
 * mathematics_imu.md.
 */
#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "imu/turns.h"
#include "core/solve.h"
#include "turns_design.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static world w;
static world_solution imu;

static double rms(double squares, int count)
{
    return sqrt(squares / count);
}

/* ---- closed form -------------------------------------------------------------------------------- */

static const invcal_real none[3] = {0, 0, 0};
static const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const double upright[3] = {0, 0, 1};
static const double slanted[3] = {0.48, 0.6, 0.64}; /* up along no axis, nor across one */

static void replay(const double m[3][3], const invcal_private_segment *segments, unsigned count,
                   const invcal_real bias[3], invcali_replay *out)
{
    static const invcal_real up[2][3] = {{0, 0, 1}, {0, 0, 1}};
    invcali_imu_work work;

    memset(&work, 0, sizeof work);
    work.imu = &w.imu;
    work.out = &imu.result;
    for (int i = 0; i < 9; i++) {
        work.parameter[i] = (invcal_real)m[i / 3][i % 3];
    }
    invcali_replay_move(&work, segments, count, bias, up, out);
}

/* exp and its left Jacobian. The segment lasts a second, so a bias subtracts its own angle. */
static void assert_closed_form(const double m[3][3], const invcal_real bias[3])
{
    const invcal_private_segment segment = {{7000, -5000, 4000}, {0, 0, 0}, 200};
    const double within = FLOAT_OR_DOUBLE(3e-7, 1e-13);
    invcali_replay r;
    double v[3], th[3], c[3][3], jacobian[3][3];

    replay(m, &segment, 1, bias, &r);
    for (int i = 0; i < 3; i++) {
        v[i] = segment.v[i] / 32768.0 - (double)bias[i];
    }
    for (int i = 0; i < 3; i++) {
        th[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    const double x = th[0] * th[0] + th[1] * th[1] + th[2] * th[2];
    const double angle = sqrt(x);
    rotation_by(th, c);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double along = (angle - sin(angle)) / (x * angle);
            jacobian[i][j] = along * th[i] * th[j] + (i == j ? sin(angle) / angle : 0);
        }
        jacobian[i][(i + 1) % 3] -= (1 - cos(angle)) / x * th[(i + 2) % 3];
        jacobian[i][(i + 2) % 3] += (1 - cos(angle)) / x * th[(i + 1) % 3];
    }
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(within, c[i / 3][i % 3], (double)r.c[i / 3][i % 3]);
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(within, jacobian[i / 3][i % 3] * v[k],
                                      (double)r.s[i % 3][i / 3][k]);
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, (double)r.time);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, x, (double)r.angle);
}

static void a_segment_of_a_steady_axis_is_that_of_closed_form(void)
{
    static const double m[3][3] = {{1.02, 0.01, -0.03}, {0.005, 0.97, 0.02}, {-0.01, 0.015, 1.01}};
    static const invcal_real bias[3] = {INVCAL_REAL(0.03), INVCAL_REAL(-0.02), INVCAL_REAL(0.05)};

    world_begin(&w, 100, 1);
    assert_closed_form(m, none);
    assert_closed_form(m, bias);
}

/* S against central differences, for a move that wobbles. */
static void the_jacobian_is_that_of_differences(void)
{
    const double vector[3] = {1.2, 0.6, -0.4};
    const double step = FLOAT_OR_DOUBLE(1e-2, 1e-4);
    invcali_replay r, plus, minus;

    needs_53_bits();
    world_begin(&w, 400, 3);
    world_without_noise(&w);
    w.wobble = 0.25;
    world_rest(&w, 1.5);
    world_move(&w, vector, 1);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(2, w.imu.rests);
    const unsigned count = (unsigned)w.imu.own.rest[1].move;
    replay(unit, w.imu.own.segment, count, none, &r);
    for (int k = 0; k < 9; k++) {
        double m[3][3];
        world_unit(m);
        m[k / 3][k % 3] += step;
        replay((const double(*)[3])m, w.imu.own.segment, count, none, &plus);
        m[k / 3][k % 3] -= 2 * step;
        replay((const double(*)[3])m, w.imu.own.segment, count, none, &minus);
        for (int i = 0; i < 3; i++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            double d = 0; /* of (C+ - C-) C', its skew part */
            for (int j = 0; j < 3; j++) {
                d += ((double)plus.c[b][j] - (double)minus.c[b][j]) * (double)r.c[a][j] -
                     ((double)plus.c[a][j] - (double)minus.c[a][j]) * (double)r.c[b][j];
            }
            TEST_ASSERT_DOUBLE_WITHIN(3e-3, d / (4 * step), (double)r.s[k / 3][i][k % 3]);
        }
    }
}

/* ---- exact segments ----------------------------------------------------------------------------- */

/* A move of equal segments about a fixed axis, all whole numbers: its truth has no rounding. */
static void add_exact(const double m[3][3], const int v[3], int segments)
{
    double th[3], c[3][3], all[3][3], after[3];

    for (int i = 0; i < 3; i++) {
        th[i] = (m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2]) / 32768;
    }
    rotation_by(th, c);
    world_unit(all);
    for (int k = 0; k < segments; k++) {
        invcal_private_segment *s = &w.imu.own.segment[w.imu.own.first++];
        for (int i = 0; i < 3; i++) {
            s->v[i] = (int16_t)v[i];
            s->kappa[i] = 0;
        }
        s->time = 2 * 20;
        world_turn(all, (const double(*)[3])c);
    }
    world_up((const double(*)[3])all, w.up, after);
    w.imu.own.rest[w.count].move = (int8_t)segments;
    w.imu.own.rest[w.count].when = (uint16_t)(20 * w.count);
    memcpy(w.up, after, sizeof w.up);
    triad_read(&w.triad, w.up, w.mean[w.count]);
    w.count++;
    w.imu.rests = (uint8_t)w.count;
}

/* Where it begins. */
static void begin_exact(const double up[3])
{
    world_begin(&w, 100, 1);
    memcpy(w.up, up, sizeof w.up);
    memcpy(w.mean[0], up, sizeof w.up);
    w.count = w.imu.rests = 1;
}

/* Quarter turns, each of the twelve edges once: the axis and the sense. */
static void tour_exact(const double m[3][3], int v)
{
    static const char tour[] = "zxyZXyzXYZxYz";

    for (int k = 1; tour[k] != 0; k++) {
        const int was = tour[k - 1] < 'a' ? tour[k - 1] - 'X' : tour[k - 1] - 'x';
        const int to = tour[k] < 'a' ? tour[k] - 'X' : tour[k] - 'x';
        const int sign = (tour[k - 1] < 'a') == (tour[k] < 'a') ? 1 : -1;
        int turn[3] = {0, 0, 0};
        turn[3 - was - to] = (to + 1) % 3 == was ? sign * v : -sign * v;
        add_exact(m, turn, 5);
    }
}

static void settle_settings(world_settings *s, int is_held)
{
    static const world_settings usual = WORLD_USUAL;

    *s = usual;
    s->held = (uint8_t)is_held;
}

/* parameter against m, after the rotation R = A (I + S) by which the accelerometer that was found differs from
 * the true one: both sensors may turn by it together. */
static void expect_matrix(const double m[3][3], double within)
{
    const double *x = w.triad.x;
    const double s[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                            {x[6] / 2, 1 + x[4], x[8] / 2},
                            {x[7] / 2, x[8] / 2, 1 + x[5]}};
    double r[3][3];

    for (int i = 0; i < 9; i++) {
        const invcal_real *a = imu.result.accelerometer.matrix[i / 3];
        r[i / 3][i % 3] =
            (double)a[0] * s[0][i % 3] + (double)a[1] * s[1][i % 3] + (double)a[2] * s[2][i % 3];
        TEST_ASSERT_DOUBLE_WITHIN(3e-5, i % 4 == 0, r[i / 3][i % 3]);
    }
    for (int i = 0; i < 9; i++) {
        double found = 0;
        for (int k = 0; k < 3; k++) {
            found += r[k][i / 3] * (double)imu.parameter[3 * k + i % 3];
        }
        TEST_ASSERT_DOUBLE_WITHIN(within, m[i / 3][i % 3], found);
    }
}

/* Errors of the gyroscope, without noise; with errors of the accelerometer, or with it held. */
static void errors_of_ten_percent_come_back_exactly(void)
{
    static const double m[3][3] = {{1.1, 0.04, -0.03}, {-0.05, 0.92, 0.03}, {0.02, -0.06, 1.05}};
    world_settings settings;

    needs_53_bits();
    for (int held = 0; held < 2; held++) {
        settle_settings(&settings, held);
        begin_exact(upright);
        if (!held) {
            random_source random = random_start(5);
            w.triad = triad_random(&random, 0.03);
            triad_read(&w.triad, upright, w.mean[0]);
        }
        tour_exact(m, 10294);
        tour_exact(m, 10000);
        if (held) { /* then only the direction of a rest counts */
            for (int k = 0; k < 3 * w.count; k++) {
                w.mean[k / 3][k % 3] *= 1.25;
            }
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
            expect_matrix(m, FLOAT_OR_DOUBLE(1e-6, 1e-12));
            for (int k = 0; k < 3 * w.count; k++) {
                w.mean[k / 3][k % 3] /= 1.25;
            }
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
        expect_matrix(m, FLOAT_OR_DOUBLE(1e-6, 1e-12));
        TEST_ASSERT_EQUAL_INT(24, imu.result.moves);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-9), 0, (double)imu.result.move_rms);
        /* and what the accelerometer calibrates is of length 1 */
        for (int k = 0; k < w.count; k++) {
            invcal_real raw[3], up[3];
            for (int i = 0; i < 3; i++) {
                raw[i] = (invcal_real)w.mean[k][i];
            }
            invcal_apply(&imu.result.accelerometer, raw[0], raw[1], raw[2], up);
            TEST_ASSERT_DOUBLE_WITHIN(
                FLOAT_OR_DOUBLE(2e-6, 1e-9), 1,
                sqrt((double)(up[0] * up[0] + up[1] * up[1] + up[2] * up[2])));
        }
    }
}

/* Turns about one axis are linear in scale errors, as far as the angle is 3 sin / (2 + cos): for 9
 * degrees to 6e-7. So one pass determines them. */
static void one_pass_determines_scale_errors(void)
{
    static const double errors[3] = {0.1, -0.08, 0.05};
    world_settings settings;
    invcali_imu_work work;
    double m[3][3] = {{0}};
    int from = 2;

    needs_53_bits();
    settle_settings(&settings, 1);
    begin_exact(upright);
    for (int i = 0; i < 3; i++) {
        m[i][i] = 1 + errors[i];
    }
    /* z x y z ..., so that each turn leads from an axis to the next */
    for (int k = 0; k < 12; k++) {
        const int to = (from + 1) % 3, axis = (from + 2) % 3;
        int v[3] = {0, 0, 0};
        v[axis] = -(int)lround(90 * DEGREE / m[axis][axis] / 5 * 32768);
        add_exact((const double(*)[3])m, v, 5);
        from = to;
    }
    world_sum(&w, &settings, &work);
    for (unsigned i = 0; i < 9; i++) { /* half of the misalignments is not determined */
        work.pass.sum[INVCAL_PACKED(i, i)] += INVCAL_REAL(1e6) * (i % 4 != 0);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(work.pass.sum, 9, 10, INVCAL_FLOOR));
    invcali_back_substitute(work.pass.sum, 9);
    for (unsigned i = 0; i < 9; i++) {
        const double step = (double)work.pass.sum[INVCAL_PACKED(9, i)];
        TEST_ASSERT_DOUBLE_WITHIN(2e-6, i % 4 == 0 ? errors[i / 4] : 0, step);
    }
}

/* A segment of a hand that wobbles is wrong by the square of the sensor's errors: of 3 % by less than 3e-5
 * (mathematics_imu.md). */
static void a_wobbling_hand_costs_little(void)
{
    static const double sizes[2] = {0.03, 0.1};
    static const double bounds[2] = {3e-5, 1e-4};
    const int runs = SOME(5);

    for (int k = 0; k < 2; k++) {
        world_settings settings;
        double squares = 0;
        settle_settings(&settings, 1);
        for (int n = 0; n < runs; n++) {
            world_begin(&w, 400, 900u + (uint32_t)n);
            world_without_noise(&w);
            w.wobble = 0.25;
            world_draw(&w, sizes[k], 0);
            world_tour(&w);
            world_end(&w);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
            for (int i = 0; i < 9; i++) {
                squares += pow((double)imu.parameter[i] - w.m[i / 3][i % 3], 2);
            }
        }
        TEST_ASSERT_TRUE(rms(squares, 9 * runs) < bounds[k]);
    }
}

/* sqrt(K) of the tour in closed form, 1/pi and 1/2. */
static void the_tour_determines_the_gyroscope_as_closed_form_says(void)
{
    world_settings settings;

    settle_settings(&settings, 1);
    settings.rate_noise = settings.instability = 0;
    begin_exact(upright);
    tour_exact(unit, 10294);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, i % 4 == 0 ? 1 / 3.14159265358979 : 0.5,
                                  (double)(imu.sigma[i] / imu.result.move_noise));
        TEST_ASSERT_TRUE(imu.sigma[9 + i] == 0);
    }
}

/* Both, over the noise of a mean; moves have sqrt(2) times that. */
static void the_tour_determines_both(void)
{
    world_settings settings;
    invcali_imu_work work;

    settle_settings(&settings, 0);
    settings.rate_noise = settings.instability = 0;
    settings.noise = INVCAL_REAL(0.01);
    begin_exact(upright);
    tour_exact(unit, 10294);
    world_sum(&w, &settings, &work);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_factor(work.pass.sum, 18, 19, INVCAL_FLOOR));
    invcali_invert(work.pass.sum, 18);
    for (unsigned i = 0; i < 18; i++) {
        const double root = sqrt((double)invcali_variance(work.pass.sum, 18, i)) / 0.01;
        TEST_ASSERT_DOUBLE_WITHIN(3e-4, tour12_sigma[i], root);
    }
}

/* Turns about one axis determine three of nine. */
static void moves_about_one_axis_leave_six_open_and_about_two_three(void)
{
    const int x[3] = {9000, 0, 0};
    const int y[3] = {0, 9000, 0};
    const int z[3] = {0, 0, 9000};
    world_settings settings;

    settle_settings(&settings, 1);
    begin_exact(slanted);
    for (int i = 0; i < 5; i++) {
        add_exact(unit, x, 4 + i);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_HEX32(0x1B6, imu.open); /* all but gyro_xx, yx, zx */
    for (int i = 0; i < 5; i++) {
        add_exact(unit, y, 4 + i);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_HEX32(0x124, imu.open);
    for (int i = 0; i < 5; i++) {
        add_exact(unit, z, 4 + i);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
    settings.held = 0; /* and both, from all of these */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    begin_exact(upright);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, world_solve(&w, &settings, &imu));
    add_exact(unit, x, 5);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, world_solve(&w, &settings, &imu));
}

/* A prior determines what is open, and nothing else. */
static void a_prior_holds_what_moves_leave_open(void)
{
    static const double m[3][3] = {{1.02, 0.01, 0}, {0.01, 0.99, 0.02}, {0, 0.01, 1.01}};
    const int x[3] = {9000, 0, 0};
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    world_settings settings;

    settle_settings(&settings, 1);
    for (int i = 0; i < 18; i++) {
        prior[i] = INVCAL_REAL(0.05);
    }
    settings.prior = prior;
    begin_exact(slanted);
    for (int i = 0; i < 5; i++) {
        add_exact(m, x, 4 + i);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, imu.result.verdict);
    TEST_ASSERT_EQUAL_HEX32(0x1B6, imu.open);
    for (int i = 0; i < 9; i++) {
        if (i % 3 == 0) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-4, m[i / 3][0], (double)imu.parameter[i]);
            TEST_ASSERT_TRUE(imu.sigma[i] < INVCAL_REAL(1e-3));
        } else {
            TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.05, (double)imu.sigma[i]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-3, i % 4 == 0 ? 1 : 0, (double)imu.parameter[i]);
        }
    }
}

/* Almost one axis: the pivots see it, and sigma is honest about it. */
static void next_to_one_axis_nothing_is_determined(void)
{
    world_settings settings;

    settle_settings(&settings, 1);
    begin_exact(slanted);
    for (int i = 0; i < 8; i++) {
        const int v[3] = {2000, i % 3 - 1, i % 2 - (i % 4 == 0)};
        add_exact(unit, v, 4 + i % 3);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_HEX32(0x1B6, imu.open & 0x1B6u);
}

/* Up in one plane does not show how the bias depends on it. */
static void a_bias_that_rests_do_not_determine_is_left_alone(void)
{
    const int x[3] = {9000, 0, 0};
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    world_settings settings;

    settle_settings(&settings, 1);
    for (int i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        prior[i] = INVCAL_REAL(0.05);
    }
    settings.prior = prior;
    begin_exact(upright);
    for (int i = 0; i < 12; i++) {
        add_exact(unit, x, 1 + i % 2);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_TRUE(imu.result.slope_sigma[i][0] == 0 && imu.result.slope[i][1] == 0);
    }
}

/* Three moves and three priors are nine equations. */
static void without_redundancy_nothing_is_good(void)
{
    static const int turns[3][3] = {{9000, 0, 3000}, {0, 9000, 0}, {-3000, 0, 9000}};
    invcal_real prior[INVCAL_IMU_PARAMETERS] = {0};
    world_settings settings;

    settle_settings(&settings, 1);
    prior[0] = prior[2] = prior[4] = INVCAL_REAL(1e-4);
    settings.prior = prior;
    begin_exact(slanted);
    for (int i = 0; i < 3; i++) {
        add_exact(unit, turns[i], 12);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(0, imu.result.dof);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, imu.result.verdict);
}

/* ---- residuals, closed form --------------------------------------------------------------------- */

/* Turns about x, up across: what is off by[k] of turn k is seen in full. Priors of 1e-6 hold all parameters: these
 * are the residuals. */
static invcal_status solve_turns(const double *by, int turns, double prior_of_all,
                                 world_settings *settings)
{
    const int v[3] = {9000, 0, 0};
    const double nominal = 5 * 9000.0 / 32768;
    invcal_real prior[INVCAL_IMU_PARAMETERS];

    for (int i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        prior[i] = (invcal_real)prior_of_all;
    }
    settings->held = 1;
    settings->prior = prior;
    begin_exact(upright);
    for (int k = 0; k < turns; k++) {
        const double m[3][3] = {{1 + by[k] / nominal, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        add_exact(m, v, 5);
    }
    const invcal_status status = world_solve(&w, settings, &imu);
    settings->prior = NULL;
    return status;
}

/* Of 12 moves and 9 priors for 9 unknowns, 24 rows of 33 have 24^2 / 33 degrees of freedom; what is stated counts
 * as four. A turn of 1 s has 2 a^2 + N^2 + N^2 / 2 + (1.5 B)^2. */
static void the_noise_of_moves_is_that_of_residuals_and_statement(void)
{
    const double dof = 24.0 * 24 / 33;

    /* The variance of both, residuals and statement, is 1.96 or 2.04 times the stated one: rough begins at 2. */
    for (int k = 0; k < 4; k++) {
        const double ratio = k % 2 == 0 ? 1.96 : 2.04;
        const int is_noisy = k >= 2;
        world_settings settings = {0, INVCAL_REAL(0.003), INVCAL_REAL(0.002), INVCAL_REAL(0.001),
                                   0};
        double stated = 2 * 9e-6 + 4e-6 * 1.5 + 2.25 * 1e-6;
        double by[12];
        if (!is_noisy) {
            settings.rate_noise = settings.instability = 0;
            stated = 2 * 9e-6;
        }
        const double off = sqrt((ratio * (4 + dof) - 4) * stated / 12);
        for (int i = 0; i < 12; i++) {
            by[i] = i % 2 == 0 ? off : -off;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, solve_turns(by, 12, 1e-6, &settings));
        TEST_ASSERT_EQUAL_INT(k % 2 == 0 ? INVCAL_GOOD : INVCAL_ROUGH, imu.result.verdict);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * sqrt(ratio * stated), sqrt(ratio * stated),
                                  (double)imu.result.move_noise);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * off, off / sqrt(2), (double)imu.result.move_rms);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3 * off, off, (double)imu.result.move_max);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 0.003, (double)imu.result.noise);
        TEST_ASSERT_EQUAL_INT(24, imu.result.dof);
        TEST_ASSERT_EQUAL_INT(12, imu.result.moves);
        TEST_ASSERT_EQUAL_HEX32(0, imu.open | imu.result.left_out | imu.result.idle);
    }
}

/* A parameter that only its prior determines has that as sigma: weak above 2.5 times the noise of a
 * rest, which here is larger than that of a move; undetermined above 1000. */
static void weak_and_undetermined_begin_at_their_bounds(void)
{
    static const double by[12] = {0};
    static const double times[4] = {2.48, 2.52, 990, 1010};
    const double noise = 1e-4;

    for (int k = 0; k < FLOAT_OR_DOUBLE(2, 4); k++) { /* of 1000 times a float has lost the pivot */
        world_settings settings = {0, (invcal_real)noise, 0, 0, 0};
        const double sigma = times[k] * noise;
        const invcal_status status = solve_turns(by, 12, sigma, &settings);
        TEST_ASSERT_EQUAL_INT(k == 3 ? INVCAL_UNDETERMINED : INVCAL_OK, status);
        TEST_ASSERT_EQUAL_HEX32(k == 0 ? 0 : 0x1B6, imu.open);
        if (status == INVCAL_OK) {
            TEST_ASSERT_EQUAL_INT(k == 0 ? INVCAL_GOOD : INVCAL_WEAK, imu.result.verdict);
            TEST_ASSERT_DOUBLE_WITHIN(1e-3 * sigma, sigma, (double)imu.sigma[1]);
        }
    }
}

/* A move is apart if its square is 12.5 times the mean of the others', and they are six at least. */
static void a_move_is_apart_beyond_its_bound(void)
{
    for (int k = 0; k < 4; k++) {
        const int turns = k < 2 ? 7 : k == 2 ? 12 : 6;
        const double ratio = k % 2 == 0 ? (k == 0 ? 12.2 : 12.8) : 12.8;
        world_settings settings = {0, INVCAL_REAL(0.003), 0, 0, 0};
        double by[12];
        for (int i = 0; i < turns; i++) {
            by[i] = i % 2 == 0 ? 2e-3 : -2e-3;
        }
        by[3] = 2e-3 * sqrt(ratio);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, solve_turns(by, turns, 1e-6, &settings));
        TEST_ASSERT_EQUAL_HEX32(k == 1 || k == 2 ? 1u << 4 : 0, imu.result.left_out);
        TEST_ASSERT_EQUAL_INT(k == 1 || k == 2 ? turns - 1 : turns, imu.result.moves);
        if (k == 0 || k == 3) {
            TEST_ASSERT_EQUAL_INT(4, imu.result.worst);
        }
    }
}

/* The biases of 25 rests are G up + drift to a unit of 2^-18 rad/s; 12 rests determine them, 11 do
 * not. */
static void slopes_of_the_bias_are_those_of_closed_form(void)
{
    static const int g[3][4] = {{40, -80, 120, 960}, {200, 60, -20, 0}, {-90, 10, 30, -480}};
    static const int counts[3] = {25, 12, 11};
    world_settings settings;

    settle_settings(&settings, 1);
    begin_exact(upright);
    tour_exact(unit, 10294);
    tour_exact(unit, 10294);
    for (int k = 0; k < 25; k++) {
        for (int i = 0; i < 3; i++) {
            w.imu.own.rest[k].bias[i] =
                (int16_t)lround(g[i][0] * w.mean[k][0] + g[i][1] * w.mean[k][1] +
                                g[i][2] * w.mean[k][2] + g[i][3] * k / 24.0);
        }
    }
    for (int n = 0; n < 3; n++) {
        const double span = (counts[n] - 1) / 24.0; /* the drift is that from first to last */
        w.count = counts[n];
        w.imu.rests = (uint8_t)counts[n];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
        for (int i = 0; i < 12; i++) {
            const int of = g[i / 4][i % 4];
            const double expected = n == 2 ? 0 : i % 4 == 3 ? of * span : of;
            TEST_ASSERT_DOUBLE_WITHIN(n == 2 ? 0 : 1.5, expected,
                                      (double)imu.result.slope[i / 4][i % 4] * 262144);
            TEST_ASSERT_TRUE(n == 2 ? imu.result.slope_sigma[i / 4][i % 4] == 0
                                    : imu.result.slope_sigma[i / 4][i % 4] * 262144 < 2);
        }
        TEST_ASSERT_EQUAL_INT(n != 2, imu.result.g_is_used);
    }
}

/* Of 25 rests with one bias each, b: p by (H'H)^-1 H'b, sigma, and the bias of the last rest with its share of the
 * residual, by mathematics_imu.md, "The bias". */
static void expect_bias(double h[25][5], const double b[25], double p[5], double sigma[4],
                        double *last)
{
    double a[5][5] = {{0}}, y[5] = {0}, squares = 0, changes = 0, before = 0;

    for (int k = 0; k < 25; k++) {
        for (int i = 0; i < 5; i++) {
            y[i] += h[k][i] * b[k];
            for (int j = 0; j < 5; j++) {
                a[i][j] += h[k][i] * h[k][j];
            }
        }
    }
    invert(a[0], 5);
    for (int i = 0; i < 5; i++) {
        p[i] = 0;
        for (int j = 0; j < 5; j++) {
            p[i] += a[i][j] * y[j];
        }
    }
    for (int k = 0; k < 25; k++) {
        double r = -b[k];
        for (int i = 0; i < 5; i++) {
            r += h[k][i] * p[i];
        }
        squares += r * r;
        changes += (r - before) * (r - before);
        before = r;
    }
    const double square = squares / (25 - 5);
    const double noise = changes / (4 * 25);
    for (int i = 0; i < 4; i++) {
        sigma[i] = sqrt(square * a[i][i]);
    }
    *last = b[24] + (square > 2 * noise ? noise / (square - noise) : 1) * before;
}

/* Two biases that wander, and one that is all noise: steps of +-100 units of 2^-18 rad/s. */
static void a_bias_that_wanders_is_that_of_closed_form(void)
{
    static const char steps[3][26] = {"+++-++-+--+-----++-+--++++", "--+----+-+++++-+++--+-----",
                                      "-+-+-+-+-+-++-+-+-+-+-+-+"};
    world_settings settings;
    double h[25][5], b[3][25], p[3][5], sigma[3][4], last[3];
    int is_used = 0;

    settle_settings(&settings, 1);
    begin_exact(upright);
    tour_exact(unit, 10294);
    tour_exact(unit, 10294);
    for (int i = 0; i < 3; i++) {
        int bias = 0;
        for (int k = 0; k < 25; k++) {
            bias += steps[i][k] == '+' ? 100 : -100;
            b[i][k] = bias;
            w.imu.own.rest[k].bias[i] = (int16_t)bias;
            for (int j = 0; j < 5; j++) {
                h[k][j] = j < 3 ? w.mean[k][j] : j == 3 ? k / 24.0 : 1;
            }
        }
        expect_bias(h, b[i], p[i], sigma[i], &last[i]);
        for (int j = 0; j < 3; j++) {
            is_used |= fabs(p[i][j]) > 4 * sigma[i][j];
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(is_used, imu.result.g_is_used);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.1, p[i][j], (double)imu.result.slope[i][j] * 262144);
            TEST_ASSERT_DOUBLE_WITHIN(1e-3 * sigma[i][j], sigma[i][j],
                                      (double)imu.result.slope_sigma[i][j] * 262144);
        }
        for (int j = 0; j < 3; j++) { /* in counts */
            const double m = (double)imu.parameter[3 * i + j] * (double)w.imu.nominal.matrix[j][j];
            TEST_ASSERT_DOUBLE_WITHIN(1e-6 / COUNTS, m, (double)imu.result.gyro.matrix[i][j]);
        }
        const double g = is_used ? p[i][0] * h[24][0] + p[i][1] * h[24][1] + p[i][2] * h[24][2] : 0;
        const double offset = (double)imu.result.gyro.offset[i] - (double)w.imu.nominal.offset[i];
        TEST_ASSERT_DOUBLE_WITHIN(0.1, last[i] - g,
                                  offset * (double)w.imu.nominal.matrix[i][i] * 262144);
    }
}

/* Both are 9 where nothing is found. */
static invcal_status find_mounting(int8_t axes[3], invcal_real *scale)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real raw[WORLD_RESTS][3];

    const invcal_positions positions = world_positions(&w, raw, &nominal);
    axes[0] = axes[1] = axes[2] = 9;
    *scale = 9;
    return invcali_imu_mounting_of(&w.imu, &positions, axes, scale);
}

/* Moves about the space diagonal look the same after the axes are exchanged in a circle. */
static void moves_may_leave_the_mapping_of_axes_open(void)
{
    const int v[3] = {5000, 5000, 5000};
    int8_t axes[3];
    invcal_real scale;

    begin_exact(slanted);
    for (int i = 0; i < 4; i++) {
        add_exact(unit, v, 4 + i);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 9 && scale == 9);
    w.mean[2][1] = NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 9 && scale == 9);
}

/* ---- a hand ------------------------------------------------------------------------------------- */

/* The error of the accelerometer's calibration: A (I + S) - 1 and A (delta - zero), over sigma. */
static void compare_accelerometer(double squares[4], double *chi)
{
    const double *x = w.triad.x;
    const double s[3][3] = {{1 + x[3], x[6] / 2, x[7] / 2},
                            {x[6] / 2, 1 + x[4], x[8] / 2},
                            {x[7] / 2, x[8] / 2, 1 + x[5]}};
    static const int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    double off[9];

    for (int i = 0; i < 3; i++) {
        off[i] = off[3 + i] = 0;
        for (int j = 0; j < 3; j++) {
            off[i] += (double)imu.result.accelerometer.matrix[i][j] *
                      (x[j] - (double)imu.result.accelerometer.offset[j]);
            off[3 + i] += (double)imu.result.accelerometer.matrix[i][j] * s[j][i];
        }
        off[3 + i] -= 1;
    }
    for (int k = 0; k < 3; k++) {
        const int a = pair[k][0], b = pair[k][1];
        off[6 + k] = 0;
        for (int j = 0; j < 3; j++) {
            off[6 + k] += (double)imu.result.accelerometer.matrix[a][j] * s[j][b] +
                          (double)imu.result.accelerometer.matrix[b][j] * s[j][a];
        }
    }
    for (int i = 0; i < 9; i++) {
        squares[1 + i / 3] += off[i] * off[i];
        *chi += pow(off[i] / (double)imu.sigma[9 + i], 2);
    }
}

/* Two tours in a hand that wobbles. Errors are as large as sigma says; their bounds are the noise of a mean, 3e-4, times
 * sqrt(K) of tour24 by turns_design.py (rms 0.49 of the gyroscope, then 0.25, 0.35, 0.5), and for the accelerometer a third
 * more, for what the hand adds. */
static void errors_are_those_that_sigma_says(void)
{
    const int runs = SOME(40);
    double squares[4] = {0};
    double chi = 0, chi_accelerometer = 0;
    int inside = 0;

    for (int n = 0; n < runs; n++) {
        world_begin(&w, 100, (uint32_t)(100 + n));
        w.wobble = 0.25;
        world_draw(&w, 0.03, 0.03);
        for (int i = 0; i < 3; i++) {
            w.bias[i] = 0.03 * random_normal(&w.random);
        }
        world_tour(&w);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        TEST_ASSERT_EQUAL_INT(25, w.imu.rests);
        TEST_ASSERT_EQUAL_INT(24, imu.result.moves);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
        for (int i = 0; i < 9; i++) {
            const double off = (double)imu.parameter[i] - w.m[i / 3][i % 3];
            squares[0] += off * off;
            chi += pow(off / (double)imu.sigma[i], 2);
            inside += fabs(off) < 1.96 * (double)imu.sigma[i];
        }
        compare_accelerometer(squares, &chi_accelerometer);
    }
    if (runs < 40) {
        return;
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.15, 1, rms(chi, 9 * runs));
    TEST_ASSERT_DOUBLE_WITHIN(0.15, 1, rms(chi_accelerometer, 9 * runs));
    TEST_ASSERT_DOUBLE_WITHIN(2.5, 96.5, 100.0 * inside / (9 * runs));
    TEST_ASSERT_TRUE(rms(squares[0], 9 * runs) < 1.5e-4);
    TEST_ASSERT_TRUE(rms(squares[1], 3 * runs) < 1.0e-4);
    TEST_ASSERT_TRUE(rms(squares[2], 3 * runs) < 1.4e-4);
    TEST_ASSERT_TRUE(rms(squares[3], 3 * runs) < 2.0e-4);
}

/* A gyroscope ten times as unstable as stated, with rests three times as exact as usual: the moves
 * are given less weight, and the accelerometer is as exact as its lengths allow, and says so. */
static void noisy_moves_spoil_no_accelerometer(void)
{
    const int runs = SOME(20);
    double squares[4] = {0};
    double chi = 0, noise = 0;

    for (int n = 0; n < runs; n++) {
        world_begin(&w, 100, (uint32_t)(700 + n));
        w.mean_noise = 1e-4;
        w.instability = 600 * DEGREE / 3600;
        world_draw(&w, 0.03, 0.03);
        world_tour(&w);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        compare_accelerometer(squares, &chi);
        noise += (double)imu.result.noise / runs;
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.6e-4, 1e-4, noise);
    if (runs < 20) {
        return;
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.3e-4, 1e-4, noise);
    TEST_ASSERT_DOUBLE_WITHIN(0.25, 1, rms(chi, 9 * runs));
}

/* g-sensitivity of 0.1 degrees/s/g is found, and causes no error. */
static void g_sensitivity_is_found_and_taken_out(void)
{
    double squares = 0;
    double biases = 0;
    const int runs = SOME(12);

    for (int n = 0; n < runs; n++) {
        world_begin(&w, 100, (uint32_t)(300 + n));
        world_draw(&w, 0.02, 0.02);
        for (int i = 0; i < 9; i++) {
            w.g[i / 3][i % 3] = 0.1 * DEGREE * random_normal(&w.random);
        }
        world_tour(&w);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        TEST_ASSERT_EQUAL_INT(1, imu.result.g_is_used);
        for (int i = 0; i < 9; i++) {
            const double sigma = (double)imu.result.slope_sigma[i / 3][i % 3];
            squares += pow((double)imu.parameter[i] - w.m[i / 3][i % 3], 2);
            TEST_ASSERT_TRUE(sigma < 0.015 * DEGREE);
            TEST_ASSERT_DOUBLE_WITHIN(5 * sigma + 0.003 * DEGREE, w.g[i / 3][i % 3],
                                      (double)imu.result.slope[i / 3][i % 3]);
        }
        for (int i = 0; i < 3; i++) { /* the offset is free of it */
            biases += pow((double)imu.result.gyro.offset[i] / COUNTS - w.bias[i], 2);
        }
    }
    TEST_ASSERT_TRUE(rms(squares, 9 * runs) < 2.2e-4);
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * DEGREE, 0, rms(biases, 3 * runs));
}

/* Without enough rests there is only an upper bound. */
static void without_g_sensitivity_none_is_used(void)
{
    int used = 0;

    for (int n = 0; n < 5; n++) {
        world_begin(&w, 100, (uint32_t)(400 + n));
        world_tour(&w);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        used += imu.result.g_is_used;
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(5 * (double)imu.result.slope_sigma[i / 3][i % 3], 0,
                                      (double)imu.result.slope[i / 3][i % 3]);
        }
    }
    TEST_ASSERT_EQUAL_INT(0, used);
}

/* ---- what is wrong ------------------------------------------------------------------------------ */

static void exchanged_or_reversed_axes_are_named(void)
{
    static const int ways[][3] = {{1, 2, 3},  {2, 1, 3},   {1, -2, 3},
                                  {-2, 3, 1}, {-1, -2, 3}, {3, 2, -1}};
    int8_t axes[3];
    invcal_real scale;

    for (unsigned k = 0; k < sizeof ways / sizeof ways[0]; k++) {
        world_begin(&w, 100, 50 + k);
        world_draw(&w, 0.03, 0.02);
        memcpy(w.axes, ways[k], sizeof w.axes);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(k == 0 ? INVCAL_OK : INVCAL_MOUNTING, world_solve(&w, NULL, &imu));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
        TEST_ASSERT_TRUE(scale == 1);
        for (int i = 0; i < 3; i++) { /* the gyroscope's axis j reads axis |ways[j]| - 1 */
            const int of = ways[k][i] < 0 ? -ways[k][i] : ways[k][i];
            TEST_ASSERT_EQUAL_INT(ways[k][i] < 0 ? -(i + 1) : i + 1, axes[of - 1]);
        }
    }
}

/* Seven turns of the tour are one more than the unknowns need, but leave some nearly open. */
static void too_few_moves_are_not_called_a_wrong_mounting(void)
{
    for (unsigned seed = 7046; seed <= 7060; seed++) {
        world_begin(&w, 100, seed);
        world_draw(&w, 0.03, 0.03);
        world_rest(&w, 1.5);
        for (unsigned i = 0; i < 7; i++) {
            invcal_turn turn;
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_tour(i, &turn));
            world_to(&w,
                     (const double[3]){(double)turn.up[0], (double)turn.up[1], (double)turn.up[2]});
        }
        world_end(&w);
        const invcal_status status = world_solve(&w, NULL, &imu);
        TEST_ASSERT_TRUE(status == INVCAL_OK || status == INVCAL_UNDETERMINED);
    }
}

static void degrees_taken_for_radians_are_named(void)
{
    int8_t axes[3];
    invcal_real scale;

    for (int way = 0; way < 2; way++) {
        world_begin(&w, 100, 60);
        for (int i = 0; i < 3; i++) {
            w.m[i][i] = way == 0 ? 57.29578 : 1 / 57.29578;
        }
        world_tour(&w);
        world_end(&w);
        const invcal_status status = world_solve(&w, NULL, &imu);
        if (way == 0) {
            TEST_ASSERT_TRUE(status == INVCAL_MOUNTING || status == INVCAL_UNDETERMINED);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
            TEST_ASSERT_DOUBLE_WITHIN(1e-4, 57.29578, (double)scale);
            TEST_ASSERT_TRUE(axes[0] == 1 && axes[1] == 2 && axes[2] == 3);
        } else { /* no move is usable: more than seven turns each */
            TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, status);
            for (unsigned i = 1; i < w.imu.rests; i++) {
                TEST_ASSERT_TRUE(invcal_imu_move_reason(&w.imu, i) == INVCAL_MOUNTING ||
                                 invcal_imu_move_reason(&w.imu, i) == INVCAL_NO_SPACE);
            }
        }
    }
}

static void an_axis_that_is_stuck_is_named(void)
{
    int8_t axes[3];
    invcal_real scale;

    world_begin(&w, 100, 61);
    w.m[1][1] = 1e6; /* reads a millionth */
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
    TEST_ASSERT_EQUAL_INT(1, axes[0]);
    TEST_ASSERT_EQUAL_INT(0, axes[1]);
    TEST_ASSERT_EQUAL_INT(3, axes[2]);
}

/* An axis is stuck if its square is below 1e4 + 1e-4 of all squares: 101^2 is below 10201.42, and not below
 * 10200.82. One segment about each axis. */
static void stuck_is_less_than_a_hundredth(void)
{
    static const int others[2][2] = {{1001, 1001}, {1000, 999}};
    int8_t axes[3];
    invcal_real scale;

    for (int k = 0; k < 6; k++) {
        const int is_stuck = k < 3;
        const int of[3] = {101, others[!is_stuck][0], others[!is_stuck][1]};
        begin_exact(slanted);
        for (int i = 0; i < 3; i++) {
            int v[3] = {0, 0, 0};
            v[(k + i) % 3] = of[i];
            add_exact(unit, v, 1);
        }
        const invcal_status status = find_mounting(axes, &scale);
        if (is_stuck) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, status);
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_EQUAL_INT(i == k % 3 ? 0 : i + 1, axes[i]);
            }
            TEST_ASSERT_TRUE(scale == 1);
        } else {
            TEST_ASSERT_TRUE(axes[k % 3] != 0);
        }
    }
}

static void a_single_segment_shows_what_is_stuck(void)
{
    const int v[3] = {0, 9000, 0};
    int8_t axes[3];
    invcal_real scale;

    begin_exact(slanted);
    add_exact(unit, v, 1);
    w.imu.own.segment[1].v[0] = 9000; /* of a move that has not ended */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 0 && axes[1] == 2 && axes[2] == 0 && scale == 1);
}

/* All 48 mappings of axes, and in degrees: each is found. Axis i of the accelerometer turns as axis
 * `of[i]` of the gyroscope reads. */
static void every_mapping_of_axes_is_found(void)
{
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                     {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    int8_t axes[3];
    invcal_real scale;

    for (int k = 0; k < 96; k++) {
        const double size = k < 48 ? 1 : 57.29578;
        const int v[2][3] = {{6000, 1000, -3000}, {-2000, 7000, 2500}};
        double m[3][3] = {{0}};
        for (int i = 0; i < 3; i++) {
            m[i][orders[k / 8 % 6][i]] = (k >> i & 1) != 0 ? -size : size;
        }
        begin_exact(slanted);
        for (int n = 0; n < 4; n++) {
            int turn[3];
            for (int i = 0; i < 3; i++) {
                turn[i] = (int)lround(v[n % 2][i] / size);
            }
            add_exact((const double(*)[3])m, turn, 6 + n);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, size, (double)scale);
        for (int i = 0; i < 3; i++) {
            const int of = orders[k / 8 % 6][i] + 1;
            TEST_ASSERT_EQUAL_INT((k >> i & 1) != 0 ? -of : of, axes[i]);
        }
    }
}

/* A mapping of axes must be four times as good as the next. About z the device turns by 1 - 2 f of
 * what is read: with z as it is, f of twice that angle remains, with z reversed 1 - f. */
static void the_next_mapping_has_four_times_the_squares(void)
{
    static const double level[3] = {0.8, 0.6, 0};
    const int x[3] = {9000, 0, 0}, y[3] = {0, 9000, 0}, z[3] = {0, 0, 6554};
    int8_t axes[3];
    invcal_real scale;

    for (int k = 0; k < 4; k++) {
        const double f = 1 / (1 + sqrt(k % 2 == 0 ? 3.9 : 4.1));
        const double m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, k < 2 ? 1 - 2 * f : 2 * f - 1}};
        begin_exact(level);
        add_exact(m, z, 1);
        add_exact(m, x, 5);
        add_exact(m, y, 5);
        TEST_ASSERT_EQUAL_INT(k % 2 == 0 ? INVCAL_UNDETERMINED : INVCAL_OK,
                              find_mounting(axes, &scale));
        TEST_ASSERT_EQUAL_INT(k % 2 == 0 ? 9 : k < 2 ? 3 : -3, axes[2]);
    }
}

/* Two axes that turn little, and by 0.64 of what is read: no turn at all would be wrong by 0.64,
 * the right mapping is by 0.36, which is not four times as good in squares. But no turn is not a
 * mapping. */
static void an_axis_that_turns_turns_something(void)
{
    static const double m[3][3] = {{0.64, 0, 0}, {0, 1, 0}, {0, 0, 0.64}};
    static const double steep[3] = {0.28, 0.96, 0};
    const int x[3] = {6554, 0, 0}, y[3] = {0, 9000, 0}, z[3] = {0, 0, 6554};
    int8_t axes[3];
    invcal_real scale;

    begin_exact(steep);
    add_exact(m, x, 1);
    add_exact(m, z, 1);
    add_exact(m, y, 5);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 1 && axes[1] == 2 && axes[2] == 3 && scale == 1);
}

/* One move that turns about all axes does not determine the mapping, two do. */
static void a_single_move_determines_no_mounting(void)
{
    const int first[3] = {6000, 1000, -3000}, second[3] = {-2000, 7000, 2500};
    int8_t axes[3];
    invcal_real scale;

    begin_exact(slanted);
    for (int moves = 1; moves <= 2; moves++) {
        add_exact(unit, moves == 1 ? first : second, 6);
        TEST_ASSERT_EQUAL_INT(moves == 1 ? INVCAL_TOO_FEW : INVCAL_OK, find_mounting(axes, &scale));
        TEST_ASSERT_EQUAL_INT(moves == 1 ? 9 : 1, axes[0]);
    }
    TEST_ASSERT_TRUE(axes[1] == 2 && axes[2] == 3 && scale == 1);
}

/* A gyroscope that reads nothing at all. */
static void a_gyroscope_that_is_dead_is_named(void)
{
    int8_t axes[3];
    invcal_real scale;

    world_begin(&w, 100, 66);
    world_without_noise(&w);
    for (int i = 0; i < 3; i++) {
        w.m[i][i] = 1e6;
    }
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 0 && axes[1] == 0 && axes[2] == 0);
}

/* Only rests, on all six faces: every move is clipped. */
static void without_moves_nothing_is_solved(void)
{
    int8_t axes[3];
    invcal_real scale;

    world_begin(&w, 100, 67);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_set_limits(&w.imu, -50000, 50000)); /* 0.5 rad/s */
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(13, w.imu.rests);
    for (unsigned i = 1; i < w.imu.rests; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_REST_CLIPPED, invcal_imu_move_reason(&w.imu, i));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, find_mounting(axes, &scale));
    TEST_ASSERT_TRUE(axes[0] == 9 && scale == 9);
    w.count = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, world_solve(&w, NULL, &imu));
}

/* All about one axis, with a hand that wobbles: never good. */
static void moves_about_one_axis_are_never_good(void)
{
    const double vector[3] = {90 * DEGREE, 0, 0};

    for (uint32_t n = 0; n < 3; n++) {
        world_begin(&w, 100, 70 + n);
        world_draw(&w, 0.03, 0.02);
        w.wobble = 0.02 * n;
        world_rest(&w, 1.5);
        for (int k = 0; k < 20; k++) {
            world_move(&w, vector, 1);
        }
        world_end(&w);
        const invcal_status status = world_solve(&w, NULL, &imu);
        if (status == INVCAL_OK) {
            TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, imu.result.verdict);
        } else {
            TEST_ASSERT_TRUE(status == INVCAL_UNDETERMINED || status == INVCAL_MOUNTING);
        }
        if (status == INVCAL_UNDETERMINED) {
            TEST_ASSERT_TRUE(imu.open != 0);
        }
    }
}

/* Six faces, and a full turn about each axis while it is level. */
static void six_faces_and_full_turns_determine_both(void)
{
    static const double turns[3][3] = {
        {360 * DEGREE, 0, 0}, {0, 0, 360 * DEGREE}, {0, 360 * DEGREE, 0}};
    static const double faces[5][3] = {{0, 1, 0}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}};

    world_begin(&w, 100, 75);
    world_draw(&w, 0.03, 0.02);
    for (int round = 0; round < 2; round++) {
        if (round == 0) {
            world_rest(&w, 1.5);
        }
        world_move(&w, turns[0], 4);
        world_to(&w, faces[0]);
        world_to(&w, faces[1]);
        world_to(&w, faces[2]);
        world_move(&w, turns[1], 4);
        world_to(&w, faces[3]);
        world_to(&w, upright);
        world_to(&w, faces[4]);
        world_move(&w, turns[2], 4);
        world_to(&w, upright);
    }
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
    TEST_ASSERT_EQUAL_HEX32(0, imu.open);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
        TEST_ASSERT_TRUE(imu.sigma[i] < INVCAL_REAL(1e-3));
    }
}

/* 50 ms between the sensors. If the accelerometer is late nothing is lost, as a rest ends before
 * the motion was noticed; if the gyroscope is late, what it still reads of the move counts as bias,
 * here twice the error. */
static void samples_may_come_some_time_late(void)
{
    double squares[3] = {0, 0, 0};

    for (int k = 0; k < 3 * SOME(6); k++) {
        world_begin(&w, 100, 80u + (uint32_t)k / 3);
        world_draw(&w, 0.03, 0.02);
        w.late = 5 * (k % 3 - 1);
        world_tour(&w);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
        TEST_ASSERT_TRUE(imu.result.moves >= 22);
        for (int i = 0; i < 9; i++) {
            squares[k % 3] += pow((double)imu.parameter[i] - w.m[i / 3][i % 3], 2);
        }
    }
    TEST_ASSERT_TRUE(sqrt(squares[0] / squares[1]) < 1.1);
    TEST_ASSERT_TRUE(sqrt(squares[2] / squares[1]) < 3);
}

/* One move in which something slipped. */
static void a_move_that_contradicts_the_others_is_left_out(void)
{
    world_begin(&w, 100, 62);
    world_draw(&w, 0.03, 0.02);
    world_tour(&w);
    world_tour(&w);
    world_end(&w);
    w.imu.own.segment[w.imu.own.rest[1].move + 2].v[0] += 900; /* of the second move: 27 mrad */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_HEX32(1u << 2, imu.result.left_out);
    TEST_ASSERT_EQUAL_INT(23, imu.result.moves);
    TEST_ASSERT_TRUE(imu.result.move_max > imu.result.move_rms &&
                     imu.result.move_max < 5 * imu.result.move_rms);
    TEST_ASSERT_TRUE(imu.result.worst != 2);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
    }
}

/* Of many that slipped only three are left out; the residuals of the others show how good they
 * are. */
static void no_more_than_three_are_left_out(void)
{
    unsigned first = 0;

    world_begin(&w, 100, 62);
    world_draw(&w, 0.03, 0.02);
    world_tour(&w);
    world_tour(&w);
    world_end(&w);
    for (unsigned i = 1; i < w.imu.rests; i++) {
        if (i % 5 == 2) {
            w.imu.own.segment[first + 2].v[0] += (int16_t)(400 << (i / 5));
        }
        first += (unsigned)w.imu.own.rest[i].move;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(21, imu.result.moves);
    TEST_ASSERT_TRUE(imu.result.move_noise > INVCAL_REAL(1e-3));
}

/* Residuals far above the stated noise. */
static void residuals_beyond_what_was_stated_are_rough(void)
{
    world_settings settings;

    settle_settings(&settings, 0);
    settings.noise = INVCAL_REAL(3e-5);
    world_begin(&w, 100, 68);
    world_draw(&w, 0.03, 0.02);
    world_tour(&w);
    world_tour(&w);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_ROUGH, imu.result.verdict);
    settings.rate_noise = INVCAL_REAL(1e-3); /* then it is from the rests alone */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_ROUGH, imu.result.verdict);
    settings.noise = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, imu.result.verdict);
}

/* A move back to where it began, with little turning. */
static void a_move_without_a_turn_shows_nothing(void)
{
    const double little[3] = {0.02, 0, 0};

    world_begin(&w, 100, 63);
    w.wobble = 0;
    world_tour(&w);
    world_move(&w, little, 1);
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_HEX32(1u << 13, imu.result.idle);
    TEST_ASSERT_EQUAL_INT(12, imu.result.moves);
}

static void bad_noise_is_refused(void)
{
    static const float bad[][3] = {{-1, 0, 0}, {NAN, 0, 0}, {INFINITY, 0, 0}, {0, 2, 0},
                                   {0, -1, 0}, {0, NAN, 0}, {0, 0, -1},       {0, 0, NAN}};
    world_settings settings;

    begin_exact(upright);
    tour_exact(unit, 10294);
    settle_settings(&settings, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        settings.noise = (invcal_real)bad[i][0];
        settings.rate_noise = (invcal_real)bad[i][1];
        settings.instability = (invcal_real)bad[i][2];
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, world_solve(&w, &settings, &imu));
    }
}

static void a_bad_prior_is_refused(void)
{
    invcal_real prior[INVCAL_IMU_PARAMETERS] = {0};
    world_settings settings;

    begin_exact(upright);
    tour_exact(unit, 10294);
    settle_settings(&settings, 0);
    settings.prior = prior;
    prior[17] = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_PRIOR, world_solve(&w, &settings, &imu));
    prior[17] = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_PRIOR, world_solve(&w, &settings, &imu));
    prior[17] = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    const unsigned dof = imu.result.dof;
    for (int i = 0; i < INVCAL_IMU_PARAMETERS; i++) { /* unknown, too */
        prior[i] = i % 2 ? (invcal_real)INFINITY : INVCAL_REAL_MAX;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_UINT(dof, imu.result.dof);
    for (int i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        prior[i] = INVCAL_REAL(0.05);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
}

static void bad_readings_and_scales_are_refused(void)
{
    static const float bad[3] = {0, NAN, INFINITY};
    invcal_calibration nominal = unit_nominal();
    invcal_real raw[WORLD_RESTS][3];
    int8_t axes[3] = {9, 9, 9};
    invcal_real scale = 9;

    begin_exact(upright);
    tour_exact(unit, 10294);
    for (int i = 0; i < 3; i++) {
        nominal.matrix[1][1] = (invcal_real)bad[i];
        const invcal_positions positions = world_positions(&w, raw, &nominal);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, world_solve_of(&w, &positions, NULL, &imu));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL,
                              invcali_imu_mounting_of(&w.imu, &positions, axes, &scale));
    }
    TEST_ASSERT_TRUE(axes[0] == 9 && scale == 9);
    w.mean[3][1] = NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, world_solve(&w, NULL, &imu));
    w.mean[3][1] = INFINITE;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, world_solve(&w, NULL, &imu));
}

/* Of the accelerometer, whose length does not matter if it is held. */
static void readings_have_a_tenth_to_ten_times_the_field(void)
{
    static const double length[4] = {0.095, 0.105, 9.5, 10.5};
    world_settings settings;

    settle_settings(&settings, 1);
    for (int i = 0; i < 4; i++) {
        begin_exact(upright);
        tour_exact(unit, 10294);
        for (int k = 0; k < 3; k++) {
            w.mean[3][k] *= length[i];
        }
        TEST_ASSERT_EQUAL_INT(i == 1 || i == 2 ? INVCAL_OK : INVCAL_OUT_OF_RANGE,
                              world_solve(&w, &settings, &imu));
    }
}

/* More rests than means, or more means than rests: they are matched from the last on. */
static void the_last_rests_belong_together(void)
{
    enum { OLDER = 5 };
    world_solution all;

    world_begin(&w, 100, 65);
    world_draw(&w, 0.02, 0.02);
    world_tour(&w);
    world_tour(&w);
    world_end(&w);
    const int rests = w.count;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &all));
    TEST_ASSERT_EQUAL_INT(24, all.result.moves);
    memmove(w.mean[OLDER], w.mean[0], sizeof w.mean[0] * (unsigned)rests);
    memset(w.mean[0], 0, sizeof w.mean[0] * OLDER); /* of no rest */
    w.count = rests + OLDER;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_MEMORY(all.parameter, imu.parameter, sizeof imu.parameter);
    memmove(w.mean[0], w.mean[2 * OLDER], sizeof w.mean[0] * (unsigned)(rests - OLDER));
    w.count = rests - OLDER;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
    TEST_ASSERT_EQUAL_INT(24 - OLDER, imu.result.moves);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(5 * (double)imu.sigma[i], w.m[i / 3][i % 3],
                                  (double)imu.parameter[i]);
    }
}

static void every_parameter_has_a_name(void)
{
    TEST_ASSERT_EQUAL_STRING("gyro_xx", invcal_parameter_text(INVCAL_GYRO_XX));
    TEST_ASSERT_EQUAL_STRING("gyro_zy", invcal_parameter_text(INVCAL_GYRO_ZY));
    TEST_ASSERT_EQUAL_STRING("gyro_zz", invcal_parameter_text(17));
    TEST_ASSERT_EQUAL_STRING("delta_x", invcal_parameter_text(0));
    TEST_ASSERT_EQUAL_STRING("gamma_zy", invcal_parameter_text(8));
    TEST_ASSERT_EQUAL_STRING("?", invcal_parameter_text(18));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_segment_of_a_steady_axis_is_that_of_closed_form);
    RUN_TEST(the_jacobian_is_that_of_differences);
    RUN_TEST(errors_of_ten_percent_come_back_exactly);
    RUN_TEST(one_pass_determines_scale_errors);
    RUN_SLOW_TEST(a_wobbling_hand_costs_little);
    RUN_TEST(the_tour_determines_the_gyroscope_as_closed_form_says);
    RUN_TEST(the_tour_determines_both);
    RUN_TEST(moves_about_one_axis_leave_six_open_and_about_two_three);
    RUN_TEST(a_prior_holds_what_moves_leave_open);
    RUN_TEST(next_to_one_axis_nothing_is_determined);
    RUN_TEST(a_bias_that_rests_do_not_determine_is_left_alone);
    RUN_TEST(without_redundancy_nothing_is_good);
    RUN_TEST(the_noise_of_moves_is_that_of_residuals_and_statement);
    RUN_TEST(weak_and_undetermined_begin_at_their_bounds);
    RUN_TEST(a_move_is_apart_beyond_its_bound);
    RUN_TEST(slopes_of_the_bias_are_those_of_closed_form);
    RUN_TEST(a_bias_that_wanders_is_that_of_closed_form);
    RUN_TEST(moves_may_leave_the_mapping_of_axes_open);
    RUN_SLOW_TEST(errors_are_those_that_sigma_says);
    RUN_SLOW_TEST(noisy_moves_spoil_no_accelerometer);
    RUN_SLOW_TEST(g_sensitivity_is_found_and_taken_out);
    RUN_SLOW_TEST(without_g_sensitivity_none_is_used);
    RUN_SLOW_TEST(exchanged_or_reversed_axes_are_named);
    RUN_SLOW_TEST(too_few_moves_are_not_called_a_wrong_mounting);
    RUN_SLOW_TEST(degrees_taken_for_radians_are_named);
    RUN_SLOW_TEST(an_axis_that_is_stuck_is_named);
    RUN_TEST(stuck_is_less_than_a_hundredth);
    RUN_TEST(a_single_segment_shows_what_is_stuck);
    RUN_SLOW_TEST(every_mapping_of_axes_is_found);
    RUN_TEST(the_next_mapping_has_four_times_the_squares);
    RUN_TEST(an_axis_that_turns_turns_something);
    RUN_TEST(a_single_move_determines_no_mounting);
    RUN_SLOW_TEST(samples_may_come_some_time_late);
    RUN_SLOW_TEST(a_gyroscope_that_is_dead_is_named);
    RUN_SLOW_TEST(without_moves_nothing_is_solved);
    RUN_SLOW_TEST(moves_about_one_axis_are_never_good);
    RUN_SLOW_TEST(six_faces_and_full_turns_determine_both);
    RUN_SLOW_TEST(a_move_that_contradicts_the_others_is_left_out);
    RUN_SLOW_TEST(no_more_than_three_are_left_out);
    RUN_SLOW_TEST(residuals_beyond_what_was_stated_are_rough);
    RUN_SLOW_TEST(a_move_without_a_turn_shows_nothing);
    RUN_TEST(bad_noise_is_refused);
    RUN_TEST(a_bad_prior_is_refused);
    RUN_TEST(bad_readings_and_scales_are_refused);
    RUN_TEST(readings_have_a_tenth_to_ten_times_the_field);
    RUN_SLOW_TEST(the_last_rests_belong_together);
    RUN_TEST(every_parameter_has_a_name);
    return UNITY_END();
}
