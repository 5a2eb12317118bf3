/* SPDX-License-Identifier: MIT
 *
 * The arithmetic of comparing calibrations. Expected are closed forms, tables of Student's t, and the example
 * of Rosner's test in the NIST handbook (1.3.5.17.3).
 */
#include "compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "maths/matrix.h"
#include "support.h"
#include "invcal/result.h"
#include "core/solve.h"
#include "unity.h"

enum { TRIALS = 4000 };

static calibration_file file;
static compare_item before;
static compare_item now;

void setUp(void)
{
    file = (calibration_file){.gravity = 9.80665, .lsb = {1e-3, 1e-3, 1e-3}, .interval = 2.0};
    strcpy(file.frame, "symmetric");
    before = now = (compare_item){.dof = 9};
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        before.x[p] = now.x[p] = p < 6 ? 1000 : 0.01;
        before.sigma[p] = now.sigma[p] = 1;
    }
}

void tearDown(void)
{
}

/* ---- nine parameters --------------------------------------------------------------------------- */

/* Axes of these lengths, at 90 degrees less gamma: x along x, y in the plane of x and y. */
static void set_axes(const double length[3], const double gamma[3], double g[3][3])
{
    const double y[3] = {sin(gamma[0]), cos(gamma[0]), 0};
    const double zx = sin(gamma[1]);
    const double zy = (sin(gamma[2]) - zx * y[0]) / y[1];
    const double z[3] = {zx, zy, sqrt(1 - zx * zx - zy * zy)};

    for (unsigned j = 0; j < 3; j++) {
        g[0][j] = length[0] * (j == 0);
        g[1][j] = length[1] * y[j];
        g[2][j] = length[2] * z[j];
    }
}

/* The calibration of a sensor with these axes, its result turned about z by `angle`. */
static invcal_calibration calibration_of(double g[3][3], double angle)
{
    const double turn[3][3] = {
        {cos(angle), -sin(angle), 0}, {sin(angle), cos(angle), 0}, {0, 0, 1}};
    invcal_calibration axes = {.offset = {0}};
    invcal_calibration out = {.offset = {3, -4, 5}};
    double inverse[3][3];

    memcpy(axes.matrix, g, sizeof axes.matrix);
    TEST_ASSERT_TRUE(matrix_inverse(&axes, inverse));
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            for (unsigned k = 0; k < 3; k++) {
                out.matrix[i][j] += turn[i][k] * inverse[k][j];
            }
        }
    }
    return out;
}

static void expect_nine(const double length[3], const double gamma[3])
{
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12 * fabs(length[i]), length[i], before.x[INVCAL_DK_X + i]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-13, gamma[i], before.x[INVCAL_GAMMA_XY + i]);
    }
    TEST_ASSERT_EQUAL_DOUBLE(3, before.x[INVCAL_DELTA_X]);
    TEST_ASSERT_EQUAL_DOUBLE(-4, before.x[INVCAL_DELTA_Y]);
    TEST_ASSERT_EQUAL_DOUBLE(5, before.x[INVCAL_DELTA_Z]);
}

static void nine_are_lengths_and_angles_of_the_axes(void)
{
    const double length[3] = {1000, 1200, 900};
    const double gamma[3] = {0.01, -0.02, 0.03};
    double g[3][3];

    set_axes(length, gamma, g);
    for (int k = 0; k < 5; k++) { /* however the result is turned */
        const invcal_calibration c = calibration_of(g, 0.1 * k);
        compare_parameters(&file, &c, &before);
        expect_nine(length, gamma);
    }
}

static void the_frame_does_not_matter(void)
{
    static const double length[3] = {1000, 1200, 900};
    static const double gamma[3] = {0.01, -0.02, 0.03};
    const invcal_calibration nominal = {.matrix = {{1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1e-3}}};
    double g[3][3];

    set_axes(length, gamma, g);
    invcal_calibration c = calibration_of(g, 0.3);
    invcali_make_triangular(&c, &nominal);
    TEST_ASSERT_EQUAL_DOUBLE(0, c.matrix[1][0]);
    compare_parameters(&file, &c, &before);
    expect_nine(length, gamma);
}

static void an_axis_may_be_turned_round(void)
{
    static const double length[3] = {1000, -1200, 900};
    static const double gamma[3] = {0.01, -0.02, 0.03};
    const double seen[3] = {0.01, -0.02, 0.03};
    double g[3][3];

    set_axes(length, gamma, g);
    invcal_calibration c = calibration_of(g, 0);
    compare_parameters(&file, &c, &before);
    expect_nine(length, seen);
    strcpy(file.frame, "stand"); /* where its sign means nothing */
    compare_parameters(&file, &c, &before);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1200, before.x[INVCAL_DK_Y]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, -0.01, before.x[INVCAL_GAMMA_XY]);
}

/* Against the nominal: to first order the delta, dk, gamma of the library. */
static void drifts_are_deviations_from_the_older(void)
{
    static const double length[2][3] = {{1000, 1200, 900}, {1000.1, 1200.36, 899.82}};
    static const double gamma[2][3] = {{0, 0, 0}, {1e-4, -2e-4, 3e-4}};
    double g[3][3];
    double x[INVCAL_PARAMETERS];
    invcal_calibration c[2];

    for (unsigned k = 0; k < 2; k++) {
        set_axes(length[k], gamma[k], g);
        c[k] = calibration_of(g, 0);
        compare_parameters(&file, &c[k], k ? &now : &before);
    }
    c[1].offset[0] += 9.80665;
    now.x[INVCAL_DELTA_X] += 9.80665;
    const compare_drift d = compare_drift_of(&before, &now, 9.80665, 1);
    for (unsigned k = 0; k < 2; k++) {
        invcal_scale(&c[k], 1 / 9.80665);
    }
    invcal_deviation(&c[1], &c[0], x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1e-3, d.x[INVCAL_DELTA_X]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, 1e-4, d.x[INVCAL_DK_X]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, 3e-4, d.x[INVCAL_DK_Y]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, -2e-4, d.x[INVCAL_DK_Z]);
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-7, x[p], d.x[p]);
    }
}

static void sigma_are_those_of_the_parameters(void)
{
    static const double length[3] = {1250, 800, 1000}; /* against 1000: ratios 0.8, 1.25, 1 */
    static const double gamma[3] = {0, 0, 0};
    double g[3][3];

    for (unsigned i = 0; i < 3; i++) {
        file.sigma_offset[i] = 0.5;
        file.sigma_dk[i] = 1e-3;
        file.sigma_gamma[i] = 2e-3;
    }
    file.gravity_sigma = 1e-4 * file.gravity;
    file.interval = invcal_coverage(13);
    set_axes(length, gamma, g);
    const invcal_calibration c = calibration_of(g, 0);
    compare_parameters(&file, &c, &now);
    TEST_ASSERT_EQUAL_UINT(13, now.dof);
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_DOUBLE(0.5, now.sigma[INVCAL_DELTA_X + i]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1, now.sigma[INVCAL_DK_X + i]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.1, now.field_sigma[i]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 2e-3 * 1.025, now.sigma[INVCAL_GAMMA_XY]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 2e-3 * 0.9, now.sigma[INVCAL_GAMMA_XZ]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 2e-3 * 1.125, now.sigma[INVCAL_GAMMA_ZY]);
}

/* ---- drift ------------------------------------------------------------------------------------- */

/* Student's t, two-sided. */
static void chance_is_that_of_students_table(void)
{
    static const struct {
        double v1;
        unsigned n1;
        double v2;
        unsigned n2;
        double t;
        double chance;
    } row[] = {{1, 9, 1, 9, 2.100922, 0.05},  /* 18 */
               {1, 5, 1, 5, 4.586894, 0.001}, /* 10 */
               {1, 10, 4, 5, 2.364624, 0.05}, /* 25 / 3.3 is 7 */
               {1, 2, 1e-30, 9, 9.924843, 0.01}};

    for (unsigned k = 0; k < 4; k++) {
        before.dof = row[k].n1;
        now.dof = row[k].n2;
        before.sigma[INVCAL_GAMMA_XY] = sqrt(row[k].v1);
        now.sigma[INVCAL_GAMMA_XY] = sqrt(row[k].v2);
        now.x[INVCAL_GAMMA_XY] = before.x[INVCAL_GAMMA_XY] + row[k].t * sqrt(row[k].v1 + row[k].v2);
        const compare_drift d = compare_drift_of(&before, &now, 1, 1);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, row[k].t, d.in_sigma[INVCAL_GAMMA_XY]);
        TEST_ASSERT_DOUBLE_WITHIN(2e-6 * row[k].chance + 1e-8, row[k].chance,
                                  d.chance[INVCAL_GAMMA_XY]);
    }
}

/* An offset that differs by k sigma: a ninth of 5 % is 3.15 of them with 18 degrees of freedom. */
static void what_is_beyond_chance_has_changed(void)
{
    const double sigma = sqrt(2);

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        setUp();
        now.x[p] += 3.1 * sigma;
        TEST_ASSERT_EQUAL_UINT(0, compare_drift_of(&before, &now, 1, 1).changed);
        now.x[p] -= 6.3 * sigma;
        TEST_ASSERT_EQUAL_UINT(1u << p, compare_drift_of(&before, &now, 1, 1).changed);
    }
}

static void without_sigma_nothing_is_reported(void)
{
    now.sigma[INVCAL_DELTA_X] = (double)NAN;
    now.x[INVCAL_DELTA_X] += 1e6;
    before.sigma[INVCAL_DELTA_Y] = now.sigma[INVCAL_DELTA_Y] = 0;
    now.x[INVCAL_DELTA_Y] += 1e6;
    const compare_drift d = compare_drift_of(&before, &now, 1, 1);
    TEST_ASSERT_EQUAL_UINT(0, d.changed);
    TEST_ASSERT_TRUE(isnan(d.chance[INVCAL_DELTA_X]) && isnan(d.chance[INVCAL_DELTA_Y]));
}

enum { HISTORY = 5 };

static compare_item steps[HISTORY];
static compare_device one;
static compare_drift drifts[HISTORY];
static compare_result history;

/* Calibrations that do not differ, with sigma 1. */
static void make_history(unsigned count)
{
    one = (compare_device){.count = count};
    history = (compare_result){
        .item = steps, .count = count, .device = &one, .devices = 1, .drift = drifts, .field = 1};
    for (unsigned k = 0; k < count; k++) {
        steps[k] = before;
    }
}

/* Of a difference of 1.5 sigma each step is nothing unusual, and four are. */
static void a_slow_drift_shows_against_the_first(void)
{
    for (unsigned count = 2; count <= HISTORY; count += 3) {
        make_history(count);
        for (unsigned k = 0; k < count; k++) {
            steps[k].x[INVCAL_DK_Z] += 1.5 * sqrt(2) * k;
        }
        compare_drifts_find(&history);
        for (unsigned k = 1; k < count; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.5, drifts[k].in_sigma[INVCAL_DK_Z]);
            TEST_ASSERT_EQUAL_UINT(0, drifts[k].changed);
        }
        TEST_ASSERT_EQUAL_STRING(count > 2 ? "Drifting" : "Steady", compare_verdict_word(&history));
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 6, one.whole.in_sigma[INVCAL_DK_Z]);
    TEST_ASSERT_EQUAL_UINT(1u << INVCAL_DK_Z, one.whole.changed);
    steps[0].sigma[INVCAL_DELTA_X] = (double)NAN;
    steps[0].x[INVCAL_DK_Z] = steps[HISTORY - 1].x[INVCAL_DK_Z];
    compare_drifts_find(&history);
    TEST_ASSERT_EQUAL_STRING("Unknown", compare_verdict_word(&history));
}

/* With 18 degrees of freedom an eighteenth of 5 % is 3.4626 sigma, a ninth 3.1486. */
static void three_calibrations_share_the_false_alarms(void)
{
    for (unsigned count = 2; count <= 3; count++) {
        for (unsigned above = 0; above < 2; above++) {
            const double limit = (count > 2 ? 3.4626 : 3.1486) + (above ? 1e-3 : -1e-3);
            make_history(count);
            steps[count - 1].x[INVCAL_DELTA_Y] += limit * sqrt(2);
            compare_drifts_find(&history);
            TEST_ASSERT_EQUAL_UINT(above << INVCAL_DELTA_Y, drifts[count - 1].changed);
            TEST_ASSERT_EQUAL_UINT(count > 2 ? above << INVCAL_DELTA_Y : 0, one.whole.changed);
        }
    }
}

static double chi_square(random_source *random, unsigned dof)
{
    double sum = 0;

    for (unsigned i = 0; i < dof; i++) {
        const double x = random_normal(random);
        sum += x * x;
    }
    return sum;
}

/* Nine unchanged parameters, with sigma from residuals: 5 % of cases or slightly less. */
static void drift_is_seldom_reported_by_chance(void)
{
    random_source random = random_start(1);

    for (unsigned count = 2; count <= HISTORY; count += 3) {
        unsigned alarms = 0;
        make_history(count);
        for (unsigned k = 0; k < TRIALS; k++) {
            for (unsigned i = 0; i < count; i++) {
                const double sigma = sqrt(chi_square(&random, steps[i].dof) / steps[i].dof);
                for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
                    steps[i].x[p] = (p < 6 ? 1e6 : 0) + random_normal(&random);
                    steps[i].sigma[p] = sigma;
                }
            }
            compare_drifts_find(&history);
            alarms += compare_verdict(&history) == COMPARE_DIFFERENT;
        }
        /* 200 at most by Bonferroni, with a standard deviation of 14 */
        TEST_ASSERT_UINT_WITHIN(60, 180, alarms);
    }
}

/* ---- fleet ------------------------------------------------------------------------------------- */

/* Rosner's 54 figures; at 5 % three are outliers, though the first alone is not. */
static void rosners_example_has_three(void)
{
    static const double x[54] = {-0.25, 0.68, 0.94, 1.15, 1.20, 1.26, 1.26, 1.34, 1.38, 1.43, 1.49,
                                 1.49,  1.55, 1.56, 1.58, 1.65, 1.69, 1.70, 1.76, 1.77, 1.81, 1.91,
                                 1.94,  1.96, 1.99, 2.06, 2.09, 2.10, 2.14, 2.15, 2.23, 2.24, 2.26,
                                 2.35,  2.37, 2.40, 2.47, 2.54, 2.62, 2.64, 2.90, 2.92, 2.92, 2.93,
                                 3.21,  3.26, 3.30, 3.59, 3.68, 4.30, 4.64, 5.34, 5.42, 6.01};
    unsigned who[54];

    TEST_ASSERT_EQUAL_UINT(3, compare_outliers(x, 54, 0.05, who));
    TEST_ASSERT_EQUAL_UINT(53, who[0]);
    TEST_ASSERT_EQUAL_UINT(52, who[1]);
    TEST_ASSERT_EQUAL_UINT(51, who[2]);
    TEST_ASSERT_EQUAL_UINT(0, compare_outliers(x, 54, 0.01, who));
}

static void equal_values_have_no_outlier(void)
{
    double x[20] = {0};
    unsigned who[20];

    TEST_ASSERT_EQUAL_UINT(0, compare_outliers(x, 20, 0.05, who));
    x[7] = 1e-9;
    TEST_ASSERT_EQUAL_UINT(1, compare_outliers(x, 20, 0.05, who));
    TEST_ASSERT_EQUAL_UINT(7, who[0]);
    TEST_ASSERT_EQUAL_UINT(0, compare_outliers(x, 2, 0.05, who));
}

static void devices_are_seldom_outliers_by_chance(void)
{
    static const unsigned sizes[] = {3, 8, 12, 20, 60};
    random_source random = random_start(2);
    double x[60];
    unsigned who[60];

    for (unsigned k = 0; k < 5; k++) {
        unsigned alarms = 0;
        for (unsigned trial = 0; trial < TRIALS; trial++) {
            for (unsigned i = 0; i < sizes[k]; i++) {
                x[i] = 33000 + random_normal(&random);
            }
            alarms += compare_outliers(x, sizes[k], 0.05, who) > 0;
        }
        TEST_ASSERT_UINT_WITHIN(50, 200, alarms);
    }
}

enum { FLEET = 20 };

static compare_item item[FLEET];
static compare_device device[FLEET];
static compare_result fleet;

/* Devices whose parameters are 1 ... 20 and 1000, each in another order. */
static void make_fleet(void)
{
    fleet = (compare_result){
        .item = item, .count = FLEET, .device = device, .devices = FLEET, .field = 1};
    for (unsigned k = 0; k < FLEET; k++) {
        item[k] = (compare_item){.dof = 9};
        device[k] = (compare_device){.first = k, .count = 1};
        for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
            item[k].x[p] = 1001.0 + (7 * k + 3 * p) % FLEET;
            item[k].sigma[p] = 0.1;
        }
    }
}

static void median_and_spread_are_closed_forms(void)
{
    make_fleet();
    TEST_ASSERT_TRUE(compare_fleet_find(&fleet));
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1010.5, fleet.fleet.median[p]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.4826 * 5, fleet.fleet.spread[p]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, sqrt(35), fleet.fleet.deviation[p]);
    }
    for (unsigned k = 0; k < FLEET; k++) {
        TEST_ASSERT_EQUAL_UINT(0, fleet.fleet.outliers[k]);
    }
    free(fleet.fleet.outliers);
}

/* Nothing can be said about two devices; about their histories it can. */
static void two_devices_are_too_few(void)
{
    make_fleet();
    fleet.devices = fleet.count = 3;
    TEST_ASSERT_TRUE(compare_fleet_find(&fleet));
    TEST_ASSERT_EQUAL_STRING("Alike", compare_verdict_word(&fleet));
    fleet.devices = fleet.count = 2;
    TEST_ASSERT_EQUAL_STRING("Too few", compare_verdict_word(&fleet));
    TEST_ASSERT_EQUAL(COMPARE_UNKNOWN, compare_verdict(&fleet));
    fleet.drift = drifts;
    fleet.count = 3;
    device[1].count = 2;
    compare_drifts_find(&fleet);
    TEST_ASSERT_EQUAL_STRING("Changed",
                             compare_verdict_word(&fleet)); /* sigma of 0.1, steps of 1 */
    item[2] = item[1];
    compare_drifts_find(&fleet);
    TEST_ASSERT_EQUAL_STRING("Steady", compare_verdict_word(&fleet));
    free(fleet.fleet.outliers);
}

static void one_that_is_off_is_an_outlier(void)
{
    make_fleet();
    item[13].x[INVCAL_DK_Y] += 60;
    item[4].x[INVCAL_GAMMA_ZY] -= 60;
    item[9].x[INVCAL_DELTA_X] += 60; /* and is known so poorly that this means nothing */
    item[9].sigma[INVCAL_DELTA_X] = 40;
    TEST_ASSERT_TRUE(compare_fleet_find(&fleet));
    for (unsigned k = 0; k < FLEET; k++) {
        TEST_ASSERT_EQUAL_UINT(k == 13  ? 1u << INVCAL_DK_Y
                               : k == 4 ? 1u << INVCAL_GAMMA_ZY
                                        : 0,
                               fleet.fleet.outliers[k]);
    }
    TEST_ASSERT_EQUAL_UINT(13, fleet.fleet.farthest[INVCAL_DK_Y]);
    TEST_ASSERT_EQUAL_UINT(9, fleet.fleet.farthest[INVCAL_DELTA_X]);
    free(fleet.fleet.outliers);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(nine_are_lengths_and_angles_of_the_axes);
    RUN_TEST(the_frame_does_not_matter);
    RUN_TEST(an_axis_may_be_turned_round);
    RUN_TEST(drifts_are_deviations_from_the_older);
    RUN_TEST(sigma_are_those_of_the_parameters);
    RUN_TEST(chance_is_that_of_students_table);
    RUN_TEST(what_is_beyond_chance_has_changed);
    RUN_TEST(without_sigma_nothing_is_reported);
    RUN_TEST(a_slow_drift_shows_against_the_first);
    RUN_TEST(three_calibrations_share_the_false_alarms);
    RUN_TEST(drift_is_seldom_reported_by_chance);
    RUN_TEST(rosners_example_has_three);
    RUN_TEST(equal_values_have_no_outlier);
    RUN_TEST(devices_are_seldom_outliers_by_chance);
    RUN_TEST(median_and_spread_are_closed_forms);
    RUN_TEST(two_devices_are_too_few);
    RUN_TEST(one_that_is_off_is_an_outlier);
    return UNITY_END();
}
