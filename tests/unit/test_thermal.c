/* SPDX-License-Identifier: MIT
 *
 * For every INVCAL_THERMAL_DEGREE: what a degree cannot do, its tests pass over.
 */
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

enum { DEGREE = INVCAL_THERMAL_DEGREE, PLAN = 18, STATIONS = 3, MOST = STATIONS * PLAN };

/* The sensor of tests/reference: X(T) = c_0 + c_1 t + c_2 t^2, t = (T - 25 C) / 45 K. */
typedef struct {
    const double *constant, *slope, *bent; /* the last two may be null */
} sensor;

static sensor straight(int set)
{
    return (sensor){expected_thermal_constant, expected_thermal_slope[set], NULL};
}

static triad_truth triad_at(const sensor *s, double temperature)
{
    const double t = (temperature - 25) / 45;
    triad_truth truth;

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        truth.x[r] =
            s->constant[r] + (s->slope ? s->slope[r] * t : 0) + (s->bent ? s->bent[r] * t * t : 0);
    }
    return truth;
}

/* Position means with their temperatures. Static: small machines have little stack. */
static struct {
    unsigned count;
    invcal_real raw[3 * MOST];
    invcal_real temperature[MOST];
} all;

static void take(const sensor *s, double temperature, unsigned positions, double sigma,
                 random_source *random)
{
    const triad_truth truth = triad_at(s, temperature);

    for (unsigned i = 0; i < positions; i++, all.count++) {
        reading_set one;
        TEST_ASSERT_TRUE(all.count < MOST);
        read_positions(&truth, &expected_plan18[i], 1, sigma, random, &one);
        memcpy(&all.raw[3 * all.count], one.u[0], sizeof one.u[0]);
        all.temperature[all.count] = (invcal_real)temperature;
    }
}

/* The program of 18 at -20, 25 and 70 C. */
static void take_three(const sensor *s, double sigma, random_source *random)
{
    all.count = 0;
    for (int station = 0; station < STATIONS; station++) {
        take(s, -20 + 45 * station, PLAN, sigma, random);
    }
}

static const invcal_thermal_settings nothing_known;

/* What came of the positions. */
static invcal_thermal_calibration found;
static invcal_quality quality;

static void calibrate_all(const invcal_settings *settings, const invcal_thermal_settings *thermal)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_calibrate(all.raw, all.temperature, all.count, settings,
                                                   thermal, &found, &quality, NULL));
}

static invcal_thermal_sums sums; /* of all positions, on what was found */

static void gather(void)
{
    invcal_thermal_init(&sums);
    for (unsigned i = 0; i < all.count; i++) {
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_add(&sums, &found, &all.raw[3 * i], all.temperature[i]));
    }
}

static invcal_solution solution_at(double temperature)
{
    invcal_solution solution;
    invcal_thermal_place place;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_at(&found, (invcal_real)temperature, &solution, &place));
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_WITHIN, place);
    return solution;
}

/* The mean square of |calibrated| - 1 over all directions: an icosahedron has it exactly. */
static double square_error(const invcal_solution *solution, const triad_truth *truth)
{
    double squares = 0;

    for (int i = 0; i < 12; i++) {
        const double e = calibrated_length(solution, truth, expected_icosahedron[i], 1) - 1;
        squares += e * e / 12;
    }
    return squares;
}

/* Over a range in nine steps: from -20 to 70 C those of the reference, -15, -5 ... 65 C. */
static double square_error_of_range(const sensor *s, double low, double high,
                                    const invcal_solution *nine)
{
    double squares = 0;

    for (int k = 0; k < 9; k++) {
        const double temperature = low + (high - low) * (k + 0.5) / 9;
        const triad_truth truth = triad_at(s, temperature);
        const invcal_solution solution = nine ? *nine : solution_at(temperature);
        squares += square_error(&solution, &truth) / 9;
    }
    return squares;
}

/* ---- how good it is ----------------------------------------------------------------------- */

static void slopes_of_a_sensor_without_noise_come_out(void)
{
    random_source unused = random_start(0);
    const invcal_settings settings = unit_settings(1e-4);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    for (int set = 0; set < SOME(EXPECTED_THERMAL_COUNT); set++) {
        const sensor s = straight(set);
        take_three(&s, 0, &unused);
        calibrate_all(&settings, &nothing_known);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.degree);
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.fitted);
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(3e-6, s.constant[r], (double)found.x[0][r]);
            TEST_ASSERT_DOUBLE_WITHIN(3e-6, s.slope[r], (double)found.x[DEGREE > 0][r]);
        }
        /* the first has slopes of 1 mg/K and 500 ppm/K throughout; what float loses is 5e-8 */
        TEST_ASSERT_DOUBLE_WITHIN(set == 0 ? 1e-6 : 2e-7, 0,
                                  sqrt(square_error_of_range(&s, -20, 70, NULL)));
    }
}

/* Wherever in the span the temperatures lie; with nominal errors of 18 % too. */
static void a_part_of_the_span_and_a_bad_nominal_are_as_good(void)
{
    static const double stations[][STATIONS] = {{25, 47, 70}, {-20, -5, 40}, {10, 45, 70}};
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    random_source unused = random_start(0);
    double constant[INVCAL_PARAMETERS];

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        constant[r] = 6 * expected_thermal_constant[r];
    }
    const sensor s = {constant, expected_thermal_slope[0],
                      DEGREE == 2 ? expected_thermal_bent : NULL};
    for (int i = 0; i < SOME(3); i++) {
        all.count = 0;
        for (int station = 0; station < STATIONS; station++) {
            take(&s, stations[i][station], PLAN, 0, &unused);
        }
        calibrate_all(&settings, &thermal);
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.fitted);
        TEST_ASSERT_DOUBLE_WITHIN(
            1e-6, 0, sqrt(square_error_of_range(&s, stations[i][0], stations[i][2], NULL)));
    }
}

/* Seeded draws of each sensor of the reference; the rms error over its Cramer-Rao bound. */
static double over_bound(const sensor *s, double bound, double *nine)
{
    const int draws = 300;
    const double sigma = 1e-4;
    const invcal_settings settings = unit_settings(sigma);
    random_source random = random_start(7);
    double squares = 0;
    double squares_of_nine = 0;

    for (int draw = 0; draw < draws; draw++) {
        invcal_solution solution;
        invcal_quality q;
        take_three(s, sigma, &random);
        calibrate_all(&settings, &nothing_known);
        squares += square_error_of_range(s, -20, 70, NULL) / draws;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_calibrate(all.raw, all.count, &settings, &solution, &q, NULL));
        squares_of_nine += square_error_of_range(s, -20, 70, &solution) / draws;
    }
    *nine = sqrt(squares_of_nine) / (bound * sigma);
    return sqrt(squares) / (bound * sigma);
}

static void the_error_is_the_cramer_rao_bound_and_that_of_nine_parameters_hundreds_of_it(void)
{
    double nine;

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("the bound of 18 parameters is for degree 1");
    }
    for (int set = 0; set < EXPECTED_THERMAL_COUNT; set++) {
        const sensor s = straight(set);
        const double ratio = over_bound(&s, expected_thermal_bound[set], &nine);
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, ratio); /* wanted: 1.1; 300 draws: 0.01 */
        TEST_ASSERT_TRUE(nine > 250 * ratio);
    }
}

static void a_bent_sensor_comes_to_the_bound_of_27_parameters(void)
{
    double nine;

    if (DEGREE != 2) {
        TEST_IGNORE_MESSAGE("needs degree 2");
    }
    for (int set = 0; set < EXPECTED_THERMAL_COUNT; set++) {
        sensor s = straight(set);
        s.bent = expected_thermal_bent;
        const double ratio = over_bound(&s, expected_thermal_bound2[set], &nine);
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, ratio);
        TEST_ASSERT_TRUE(nine > 200 * ratio);
    }
}

/* Solves `passes` times from the nominal; the error then. */
static double error_after(const sensor *s, int passes)
{
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
    for (int pass = 0; pass < passes; pass++) {
        gather();
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_thermal_solve(&sums, &found, &settings, &thermal, &found));
    }
    return sqrt(square_error_of_range(s, -20, 70, NULL));
}

/* As the header says. */
static void one_solve_leaves_the_square_of_the_slopes_and_two_nothing_that_matters(void)
{
    random_source unused = random_start(0);
    double gentle[INVCAL_PARAMETERS];

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    const sensor steep = straight(0);
    take_three(&steep, 0, &unused);
    TEST_ASSERT_DOUBLE_WITHIN(0.1e-3, 1.33e-3, error_after(&steep, 1));
    TEST_ASSERT_DOUBLE_WITHIN(0.1e-6, 0.93e-6, error_after(&steep, 2));
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        gentle[r] = steep.slope[r] / 10;
    }
    const sensor tenth = {steep.constant, gentle, NULL};
    take_three(&tenth, 0, &unused);
    TEST_ASSERT_DOUBLE_WITHIN(0.15e-5, 1.3e-5, error_after(&tenth, 1));
}

/* ---- what the temperatures do not tell ---------------------------------------------------- */

/* The same as without temperature, and no slopes. */
static void assert_like_nine_parameters(const invcal_settings *settings, invcal_verdict verdict)
{
    invcal_solution plain;
    invcal_quality q;
    const invcal_solution solution = solution_at((double)all.temperature[0]);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_calibrate(all.raw, all.count, settings, &plain, &q, NULL));
    TEST_ASSERT_EQUAL_UINT(0, found.degree);
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* rows are weighted with the noise that they have, which the plain ones are not */
        const double sigma = sigma_of_parameter(&q, r);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * sigma, parameter(&plain, r), parameter(&solution, r));
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * sigma, sigma, sigma_of_parameter(&quality, r));
        for (int k = 1; k <= DEGREE; k++) {
            TEST_ASSERT_TRUE(found.x[k][r] == 0);
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, (double)q.dof, (double)quality.dof);
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * (double)q.noise, (double)q.noise, (double)quality.noise);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)q.residual_rms, (double)quality.residual_rms);
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * (double)q.condition, (double)q.condition,
                              (double)quality.condition);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
    TEST_ASSERT_EQUAL_INT(verdict, quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(verdict == INVCAL_GOOD ? 0 : 0x1FF, quality.undetermined);
}

static invcal_thermal_fallback narrow(void)
{
    return DEGREE > 0 ? INVCAL_THERMAL_NARROW : INVCAL_THERMAL_AS_ASKED;
}

static void at_one_temperature_there_are_no_slopes_and_it_says_so(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(0);
    random_source random = random_start(3);

    all.count = 0;
    take(&s, 31.5, PLAN, 1e-4, &random);
    take(&s, 31.5, PLAN, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(&settings, INVCAL_GOOD);
}

static void two_temperatures_half_a_kelvin_apart_tell_no_slopes_and_it_says_so(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(0);
    const invcal_thermal_settings of_use = {.reference = 25, .span = 45};
    random_source random = random_start(4);

    all.count = 0;
    take(&s, 25, PLAN, 1e-4, &random);
    take(&s, 25.5, PLAN, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(&settings, INVCAL_GOOD);
    calibrate_all(&settings, &of_use);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(&settings, INVCAL_GOOD);
}

static void too_few_positions_for_slopes_are_enough_for_fewer(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(1);
    random_source random = random_start(5);

    all.count = 0;
    take(&s, -20, 17, 1e-4, &random);
    all.temperature[16] = 70;
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_INT(DEGREE > 0 ? INVCAL_THERMAL_FEW : INVCAL_THERMAL_AS_ASKED,
                          found.fallback);
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    if (DEGREE == 2) {
        all.count = 0;
        take(&s, -20, 13, 1e-4, &random);
        take(&s, 70, 13, 1e-4, &random);
        calibrate_all(&settings, &nothing_known);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_FEW, found.fallback);
        TEST_ASSERT_EQUAL_UINT(1, found.fitted);
    }
}

/* Three orientations at the other temperature; a parabola through two. */
static void what_the_positions_leave_open_is_left_out_and_named(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(6);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    all.count = 0;
    take(&still, -20, PLAN, 1e-4, &random);
    take(&still, 70, 3, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_OPEN, found.fallback);
    assert_like_nine_parameters(&settings, INVCAL_WEAK);
    all.count = 0;
    take(&still, -20, PLAN, 1e-4, &random);
    take(&still, 70, PLAN, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_UINT(1, found.fitted);
    TEST_ASSERT_EQUAL_INT(DEGREE > 1 ? INVCAL_THERMAL_OPEN : INVCAL_THERMAL_AS_ASKED,
                          found.fallback);
}

/* Eighteen positions in the cold, four each at room temperature and in the heat: nine parameters
 * go wrong by 20 times what they leave as residuals, in some draws. */
static void slopes_that_pass_for_other_errors_are_not_called_good(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    random_source random = random_start(21);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    for (int set = 0; set < EXPECTED_THERMAL_COUNT; set++) {
        const sensor s = straight(set);
        all.count = 0;
        take(&s, -20, PLAN, 1e-4, &random);
        take(&s, 25, 4, 1e-4, &random);
        take(&s, 70, 4, 1e-4, &random);
        calibrate_all(&settings, &nothing_known);
        TEST_ASSERT_EQUAL_UINT(0, found.fitted);
        TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
        TEST_ASSERT_EQUAL_HEX16(0x1FF, quality.undetermined);
    }
}

/* sqrt(K) of a slope of gamma: 0.816 over the part of the span, for 18 positions at either end. */
static void slopes_of_a_small_part_of_the_span_are_open(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(8);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    for (int i = 0; i < 2; i++) {
        const invcal_thermal_settings thermal = {.reference = 20, .span = i ? 70 : 55};
        all.count = 0;
        take(&still, 15, PLAN, 1e-4, &random);
        take(&still, 25, PLAN, 1e-4, &random);
        calibrate_all(&settings, &thermal);
        TEST_ASSERT_EQUAL_INT(i ? INVCAL_THERMAL_OPEN : INVCAL_THERMAL_AS_ASKED, found.fallback);
    }
}

/* ---- at a temperature --------------------------------------------------------------------- */

static void outside_the_range_seen_the_edge_is_held_and_said(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(0);
    random_source random = random_start(9);
    const double outside[] = {-100, -20.001, 70.001, 150, 1e30};

    take_three(&s, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    for (int i = 0; i < 5; i++) {
        const invcal_solution edge = solution_at(outside[i] < 0 ? -20 : 70);
        invcal_solution solution;
        invcal_thermal_place place;
        memset(&solution, 0, sizeof solution);
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_at(&found, (invcal_real)outside[i], &solution, &place));
        TEST_ASSERT_EQUAL_INT(outside[i] < 0 ? INVCAL_THERMAL_BELOW : INVCAL_THERMAL_ABOVE, place);
        TEST_ASSERT_EQUAL_MEMORY(&edge, &solution, sizeof edge);
    }
}

static void what_is_no_temperature_is_refused_and_nothing_written(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(2);
    random_source random = random_start(10);
    invcal_solution solution;
    invcal_solution before;
    invcal_thermal_place place = INVCAL_THERMAL_ABOVE;
    invcal_reason reason = {0, 0};
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};

    take_three(&s, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    const invcal_thermal_calibration kept = found;
    memset(&solution, 0x5A, sizeof solution);
    before = solution;
    for (int i = 0; i < 3; i++) {
        const invcal_quality q = quality;
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE,
                              invcal_thermal_at(&found, (invcal_real)bad[i], &solution, &place));
        TEST_ASSERT_EQUAL_MEMORY(&before, &solution, sizeof solution);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_ABOVE, place);
        all.temperature[20] = (invcal_real)bad[i];
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_thermal_calibrate(
                                                     all.raw, all.temperature, all.count, &settings,
                                                     &nothing_known, &found, &quality, &reason));
        TEST_ASSERT_EQUAL_UINT(20, reason.position);
        TEST_ASSERT_EQUAL_MEMORY(&kept, &found, sizeof kept);
        TEST_ASSERT_EQUAL_MEMORY(&q, &quality, sizeof q);
    }
}

static void a_damaged_calibration_is_refused_at_any_temperature(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(2);
    random_source random = random_start(19);
    const invcal_real nan = (invcal_real)NAN;

    take_three(&s, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    for (int i = 0; i < 9; i++) {
        invcal_thermal_calibration bad = found;
        invcal_solution solution;
        invcal_thermal_place place;
        *(i == 0   ? &bad.x[DEGREE][4]
          : i == 1 ? &bad.x[0][0]
          : i == 2 ? &bad.nominal.offset[1]
          : i == 3 ? &bad.nominal.matrix[2][1]
          : i == 4 ? &bad.field
          : i == 5 ? &bad.reference
          : i == 6 ? &bad.span
          : i == 7 ? &bad.least
                   : &bad.greatest) = nan;
        if (DEGREE == 0 && i > 4) {
            break; /* nothing depends on temperature */
        }
        const invcal_status status = invcal_thermal_at(&bad, 30, &solution, &place);
        TEST_ASSERT_EQUAL_INT(i >= 2 && i <= 4 ? INVCAL_BAD_SETTING : INVCAL_NOT_ELLIPSOID, status);
    }
}

/* A sensor of 16 bits, 1/4096 g, its axes turned against the case, in m/s^2. */
static void raw_counts_and_both_frames_give_the_right_lengths_at_every_temperature(void)
{
    const sensor s = straight(DEGREE > 0 ? 1 : 0);
    random_source unused = random_start(0);
    invcal_settings settings = unit_settings(0);

    settings.field = (invcal_real)9.80665;
    for (int k = 0; k < 3; k++) {
        settings.nominal.offset[k] = (invcal_real)(100 * k);
        settings.nominal.matrix[k][k] = (invcal_real)(9.80665 / 4096);
    }
    take_three(&s, 0, &unused);
    if (DEGREE == 0) {
        all.count = PLAN;
    }
    for (unsigned i = 0; i < 3 * all.count; i++) {
        all.raw[i] = 4096 * all.raw[i] + (invcal_real)(100 * (i % 3));
    }
    for (int frame = 0; frame < 2; frame++) {
        settings.frame = frame ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
        calibrate_all(&settings, &nothing_known);
        for (unsigned i = 0; i < all.count; i++) {
            const invcal_solution solution = solution_at((double)all.temperature[i]);
            invcal_real v[3];
            invcal_apply(&solution.calibration, &all.raw[3 * i], v);
            const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
            TEST_ASSERT_DOUBLE_WITHIN(3e-5, 9.80665, length3(d));
            TEST_ASSERT_TRUE((solution.calibration.matrix[1][0] == 0) == (frame == 1));
            TEST_ASSERT_TRUE((solution.calibration.matrix[2][1] == 0) == (frame == 1));
        }
    }
}

/* ---- judgement ---------------------------------------------------------------------------- */

static void sigma_at_every_temperature_is_that_of_the_error(void)
{
    enum { DRAWS = 60, AT = 4 };
    const double at[AT] = {-20, 2, 25, 70};
    const invcal_settings settings = unit_settings(0);
    const sensor s = straight(DEGREE > 0 ? 0 : 1);
    random_source random = random_start(11);
    double squares[AT] = {0};

    for (int draw = 0; draw < DRAWS; draw++) {
        if (DEGREE > 0) {
            take_three(&s, 1e-4, &random);
        } else {
            all.count = 0;
            take(&s, 25, PLAN, 1e-4, &random);
        }
        calibrate_all(&settings, &nothing_known);
        gather();
        for (int i = 0; i < AT; i++) {
            const double temperature = DEGREE > 0 ? at[i] : 25;
            const invcal_solution solution = solution_at(temperature);
            const triad_truth truth = triad_at(&s, temperature);
            invcal_quality q;
            TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                                  invcal_thermal_assess(&sums, &found, &settings, &nothing_known,
                                                        (invcal_real)temperature, &q));
            TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
            for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
                const double z = (parameter(&solution, r) - truth.x[r]) / sigma_of_parameter(&q, r);
                squares[i] += z * z / (INVCAL_PARAMETERS * DRAWS);
            }
        }
    }
    /* the variance of Student's t, as the noise is estimated too */
    const double dof = DEGREE > 0 ? MOST - 9 * (DEGREE + 1) : PLAN - 9;
    for (int i = 0; i < AT; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.1, 1, sqrt(squares[i] * (dof - 2) / dof));
    }
}

/* Two programs at -20 C and one at 70 C: in units of the half span the rows (1, s) of each parameter
 * sum up to 3, -1, 3, and their inverse makes K (3 + 2 s + 3 s^2) / 8 of the K of one program. */
static void sigma_of_a_line_has_its_closed_form(void)
{
    static const double of_program[3] = {4.0 / 8, 3.0 / 8, 8.0 / 8}; /* at -20, 25, 70 C */
    static const double zero[INVCAL_PARAMETERS] = {0};
    const sensor s = {zero, NULL, NULL};
    const invcal_settings settings = unit_settings(1e-4);
    random_source unused = random_start(0);

    if (DEGREE == 0) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    all.count = 0;
    take(&s, -20, PLAN, 0, &unused);
    take(&s, -20, PLAN, 0, &unused);
    take(&s, 70, PLAN, 0, &unused);
    calibrate_all(&settings, &nothing_known);
    gather();
    for (int i = 0; i < 3; i++) {
        invcal_quality q;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_thermal_assess(&sums, &found, &settings, &nothing_known,
                                                    (invcal_real)(-20 + 45 * i), &q));
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double sigma = 1e-4 * expected_plan18_root_k[r] * sqrt(of_program[i]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-5 * sigma, sigma, sigma_of_parameter(&q, r));
        }
    }
}

static void the_judgement_counts_coefficients_and_names_the_worst_position(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_settings quieter = unit_settings(1e-6);
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(12);

    take_three(&still, 1e-4, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, MOST - 9 * (DEGREE + 1), (double)quality.dof);
    TEST_ASSERT_DOUBLE_WITHIN(0.3e-4, 1e-4, (double)quality.noise);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
    all.raw[3 * 40 + 2] += (invcal_real)0.01; /* which points along z */
    calibrate_all(&quieter, &nothing_known);
    TEST_ASSERT_EQUAL_UINT(40, quality.worst);
    TEST_ASSERT_TRUE(quality.residual_max > (invcal_real)0.003);
    TEST_ASSERT_TRUE(quality.noise > (invcal_real)5e-4);
    gather();
    TEST_ASSERT_EQUAL_UINT(40, sums.worst);
    /* no more positions than coefficients: nothing checks them */
    all.count = 0;
    for (int k = 0; k <= DEGREE; k++) {
        take(&still, 20 * k, PLAN, 1e-4, &random);
        all.count -= 9;
        for (unsigned i = 0; i < 9; i++) { /* every second one */
            memcpy(&all.raw[3 * (all.count - 9 + i)], &all.raw[3 * (all.count - 9 + 2 * i)],
                   3 * sizeof(invcal_real));
        }
    }
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_TRUE(quality.dof == 0);
    TEST_ASSERT_TRUE(quality.verdict != INVCAL_GOOD);
}

/* ---- priors ------------------------------------------------------------------------------- */

/* Positions at t = 1/2 only tell x0 + x1/2. The prior shares it out by its variances. */
static void a_prior_on_slopes_holds_what_one_temperature_leaves_open(void)
{
    const double sigma0 = 0.02;
    const double sigma1 = 0.03; /* over the span */
    const sensor still = {expected_thermal_constant, NULL, NULL};
    invcal_settings settings = unit_settings(1e-4);
    invcal_thermal_settings thermal = {.reference = 20, .span = 40};
    random_source random = random_start(13);

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = (invcal_real)sigma0;
        thermal.slope[r] = (invcal_real)(sigma1 / 40);
        thermal.curvature[r] = (invcal_real)1e-6;
    }
    all.count = 0;
    take(&still, 40, PLAN, 1e-4, &random);
    calibrate_all(&settings, &thermal);
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
    TEST_ASSERT_EQUAL_UINT(DEGREE, found.fitted);
    const double share = sigma0 * sigma0 / (sigma0 * sigma0 + sigma1 * sigma1 / 4);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        const double whole = still.constant[r];
        const double constant = DEGREE > 0 ? share * whole : whole;
        TEST_ASSERT_DOUBLE_WITHIN(0.002, constant, (double)found.x[0][r]);
        if (DEGREE > 0) {
            TEST_ASSERT_DOUBLE_WITHIN(0.004, 2 * (1 - share) * whole,
                                      (double)found.x[DEGREE > 0][r]);
        }
    }
    const triad_truth truth = triad_at(&still, 40);
    const invcal_solution solution = solution_at(40);
    TEST_ASSERT_DOUBLE_WITHIN(3e-4, 0, sqrt(square_error(&solution, &truth)));
    TEST_ASSERT_TRUE(quality.sigma_delta[0] < (invcal_real)3e-4);
}

/* In float the noise is raised to what is resolved beside a wide prior, as invcal_information. */
static void a_slope_prior_alone_is_enough_at_a_constant_temperature(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    const invcal_settings settings = unit_settings(1e-4);
    const triad_truth truth = triad_at(&still, 25);
    invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    random_source random = random_start(14);

    all.count = 0;
    take(&still, 25, PLAN, 1e-4, &random);
    for (int wide = 0; wide < 2; wide++) {
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            thermal.slope[r] = (invcal_real)(wide ? 5e-3 : r < 3 ? 1e-3 : r < 6 ? 5e-4 : 1e-4);
            thermal.curvature[r] = (invcal_real)(wide ? 1e-5 : 1e-6);
        }
        calibrate_all(&settings, &thermal);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.fitted);
        for (int r = 0; r < INVCAL_PARAMETERS && DEGREE > 0; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-5, 0, (double)found.x[DEGREE > 0][r]);
        }
        const invcal_solution solution = solution_at(25);
        TEST_ASSERT_DOUBLE_WITHIN(3e-4, 0, sqrt(square_error(&solution, &truth)));
        if (wide && DEGREE > 0) { /* the largest sums are those of delta, 18 / 3 */
            const double raised = 5e-3 * 45 * sqrt(4 * (double)INVCAL_EPSILON * 6);
            const double noise = raised > 1e-4 ? raised : 1e-4;
            TEST_ASSERT_DOUBLE_WITHIN(0.05 * noise, noise, (double)quality.noise);
        }
    }
}

/* The delta of 3 x 18 positions without noise: H'H is 18 for its constant, 12 for its slope, and
 * nothing beside. A prior of ratio R = (noise / sigma)^2 shrinks either to H'H / (H'H + R), and
 * that is the share of it that the data told. */
static void a_prior_shrinks_and_counts_by_the_closed_form(void)
{
    const double noise = 1e-3;
    const double ratio = 24;
    const double x = 1e-3; /* small: the closed form is of first order */
    const double constant[INVCAL_PARAMETERS] = {x, x, -x};
    const double slope[INVCAL_PARAMETERS] = {x, -x, x};
    const sensor s = {constant, slope, NULL};
    invcal_settings settings = unit_settings(noise);
    invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    random_source unused = random_start(0);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    for (int r = 0; r < 3; r++) {
        settings.prior[r] = (invcal_real)(noise / sqrt(ratio));
        thermal.slope[r] = (invcal_real)(noise / sqrt(ratio) / 45);
    }
    take_three(&s, 0, &unused);
    calibrate_all(&settings, &thermal);
    const double told = 18 / (18 + ratio);
    const double told_slope = 12 / (12 + ratio);
    for (int r = 0; r < 3; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * x, told * constant[r], (double)found.x[0][r]);
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * x, told_slope * slope[r], (double)found.x[DEGREE > 0][r]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.05, MOST - 12 - 3 * told - 3 * told_slope, (double)quality.dof);
    TEST_ASSERT_EQUAL_HEX16(7, quality.from_prior); /* at all temperatures, and delta only */
    gather();
    for (int k = 0; k < 3; k++) {
        const double t = k - 1;
        const double sigma = noise * sqrt(1 / (18 + ratio) + t * t / (12 + ratio));
        invcal_quality q;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_assess(&sums, &found, &settings, &thermal,
                                                               (invcal_real)(25 + 45 * t), &q));
        TEST_ASSERT_EQUAL_HEX16(7, q.from_prior);
        for (unsigned r = 0; r < 3; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.01 * sigma, sigma, sigma_of_parameter(&q, r));
        }
    }
}

/* gamma at noise 0.05: K count noise^2 is 0.06 in the middle and 0.15 at the ends, 0.1 the limit. */
static void what_is_weak_anywhere_is_weak(void)
{
    const invcal_settings settings = unit_settings(0.05);
    const double none[INVCAL_PARAMETERS] = {0};
    const sensor perfect = {none, NULL, NULL};
    random_source unused = random_start(0);
    invcal_quality middle;

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    take_three(&perfect, 0, &unused);
    calibrate_all(&settings, &nothing_known);
    gather();
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_thermal_assess(&sums, &found, &settings, &nothing_known, 25, &middle));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, middle.verdict);
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, quality.undetermined);
}

/* Noise stated at a thousandth: what comes out is as if it had been stated as it is. */
static void a_prior_counts_for_more_where_the_data_are_noisier_than_stated(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    invcal_settings settings = unit_settings(1e-6);
    random_source random = random_start(20);

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = (invcal_real)0.01;
    }
    all.count = 0;
    take(&still, 25, PLAN, 1e-2, &random);
    take(&still, 25, PLAN, 1e-2, &random);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_DOUBLE_WITHIN(4e-3, 1e-2, (double)quality.noise);
    TEST_ASSERT_TRUE(quality.coverage > 2);
    const invcal_thermal_calibration first = found;
    settings.noise = (invcal_real)1e-2;
    calibrate_all(&settings, &nothing_known);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        const double sigma = sigma_of_parameter(&quality, (unsigned)r);
        TEST_ASSERT_DOUBLE_WITHIN(0.5 * sigma, (double)found.x[0][r], (double)first.x[0][r]);
    }
}

/* Readings that tell nothing: sigma is that of the prior, and X its centre. */
static void noise_as_large_as_the_field_leaves_everything_to_the_prior(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    invcal_settings settings = unit_settings(1);
    random_source unused = random_start(0);

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = (invcal_real)0.01;
    }
    all.count = 0;
    take(&still, 25, PLAN, 0, &unused);
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_HEX16(0x1FF, quality.from_prior);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* H'H is 6 at most, beside (1 / 0.01)^2 */
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, 0.01, sigma_of_parameter(&quality, r));
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0, (double)found.x[0][r]);
    }
}

/* An earlier calibration is the base: a few positions at one temperature renew its constant. */
static void renewing_at_one_temperature_keeps_the_slopes(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(1);
    double moved[INVCAL_PARAMETERS];
    random_source random = random_start(15);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    take_three(&s, 1e-5, &random);
    calibrate_all(&settings, &thermal);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        moved[r] = s.constant[r] + (r < 3 ? 0.02 : 0);
    }
    const sensor aged = {moved, s.slope, NULL};
    all.count = 0;
    take(&aged, 34, PLAN, 1e-5, &random);
    gather();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_solve(&sums, &found, &settings, &thermal, &found));
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    TEST_ASSERT_EQUAL_UINT(DEGREE, found.degree);
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_NARROW, found.fallback);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, moved[r], (double)found.x[0][r]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, s.slope[r], (double)found.x[DEGREE > 0][r]);
    }
}

/* ---- sums and settings -------------------------------------------------------------------- */

static void positions_taken_out_leave_what_was_without_them(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(3);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    random_source random = random_start(16);
    static invcal_thermal_sums empty;
    static invcal_thermal_sums few;
    const invcal_real other[3] = {(invcal_real)0.6, (invcal_real)-0.8, (invcal_real)0.1};

    take_three(&s, 1e-4, &random);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
    gather();
    few = sums;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_add(&few, &found, other, 60));
    TEST_ASSERT_EQUAL_UINT(MOST + 1, few.sum[0].count);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_remove(&few, &found, other, 60));
    for (int k = 0; k < INVCAL_THERMAL_SUMS; k++) {
        for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-13), (double)sums.sum[k].moment[i],
                                      (double)few.sum[k].moment[i]);
        }
    }
    TEST_ASSERT_EQUAL_UINT(MOST, few.sum[0].count);
    for (unsigned i = 0; i < all.count; i++) {
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_remove(&few, &found, &all.raw[3 * i], all.temperature[i]));
    }
    TEST_ASSERT_EQUAL_MEMORY(&empty, &few, sizeof few);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_thermal_remove(&few, &found, other, 60));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          invcal_thermal_solve(&few, &found, &settings, &thermal, &found));
}

static void readings_and_temperatures_that_are_none_leave_the_sums_alone(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    static invcal_thermal_sums empty;
    const invcal_real good[3] = {1, 0, 0};
    const invcal_real far[3] = {11, 0, 0};
    const invcal_real bad[3] = {1, 0, (invcal_real)NAN};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
    invcal_thermal_init(&sums);
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_thermal_add(&sums, &found, bad, 25));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_thermal_add(&sums, &found, far, 25));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE,
                          invcal_thermal_add(&sums, &found, good, (invcal_real)NAN));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_thermal_add(&sums, &found, good, 116));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_thermal_add(&sums, &found, good, -66));
    TEST_ASSERT_EQUAL_MEMORY(&empty, &sums, sizeof sums);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_add(&sums, &found, good, 115));
    const invcal_thermal_sums one = sums;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_thermal_remove(&sums, &found, bad, 115));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_thermal_remove(&sums, &found, far, 115));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_thermal_remove(&sums, &found, good, 116));
    TEST_ASSERT_EQUAL_MEMORY(&one, &sums, sizeof sums);
}

/* All of them below zero, or above. */
static void the_range_is_that_of_the_temperatures_in_any_order(void)
{
    static const int order[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 0, .span = 45};
    const invcal_real raw[3] = {1, 0, 0};

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
    for (int k = 0; k < 12; k++) {
        const int from = k < 6 ? -40 : 20;
        invcal_thermal_init(&sums);
        for (int i = 0; i < 3; i++) {
            const invcal_real t = (invcal_real)(from + 10 * order[k % 6][i]);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_add(&sums, &found, raw, t));
        }
        TEST_ASSERT_TRUE(sums.least == (invcal_real)from);
        TEST_ASSERT_TRUE(sums.greatest == (invcal_real)(from + 20));
    }
}

static void unusable_settings_are_refused(void)
{
    const double bad[] = {-1, NOT_A_NUMBER, INFINITE};
    const sensor s = straight(0);
    random_source random = random_start(17);

    const invcal_settings good = unit_settings(1e-4);
    const invcal_thermal_settings usual = {.reference = 25, .span = 45};
    take_three(&s, 1e-4, &random);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&good, &usual, &found));
    gather();
    for (int i = 0; i < 3 * 4 + 4; i++) {
        invcal_settings settings = unit_settings(i == 12 ? 0 : 1e-4);
        invcal_thermal_settings thermal = {.reference = 25, .span = 45};
        const invcal_real value = (invcal_real)bad[i % 3];
        if (i < 3) {
            thermal.slope[i] = value;
        } else if (i < 6) {
            thermal.curvature[2 + i] = value;
        } else if (i < 9) {
            thermal.span = value;
        } else if (i < 12) {
            thermal.reference = i == 9 ? (invcal_real)-INFINITE : value;
        } else if (i == 12) {
            thermal.slope[0] = 1; /* but no noise */
        } else if (i == 13) {
            settings.field = 0;
        } else if (i == 14) {
            settings.nominal.matrix[0][0] = 0;
        } else {
            settings.frame = (invcal_frame)7;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                              invcal_thermal_start(&settings, &thermal, &found));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_thermal_calibrate(
                                                      all.raw, all.temperature, all.count,
                                                      &settings, &thermal, &found, &quality, NULL));
        if (i < 6 || i >= 12) { /* what the sums were made with is in the base */
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                                  invcal_thermal_solve(&sums, &found, &settings, &thermal, &found));
        }
    }
}

static void eight_positions_and_a_plane_are_refused_as_without_temperature(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(18);
    invcal_reason reason;

    all.count = 0;
    take(&still, 20, 8, 1e-4, &random);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          invcal_thermal_calibrate(all.raw, all.temperature, all.count, &settings,
                                                   &nothing_known, &found, &quality, &reason));
    TEST_ASSERT_EQUAL_UINT(8, reason.position);
    for (int k = 0; k < 3; k++) { /* the first group, which lies in a plane */
        take(&still, 20 + 20 * k, 6, 1e-4, &random);
    }
    memmove(all.raw, all.raw + 24, 54 * sizeof *all.raw);
    memmove(all.temperature, all.temperature + 8, 18 * sizeof *all.temperature);
    all.count = 18;
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                          invcal_thermal_calibrate(all.raw, all.temperature, all.count, &settings,
                                                   &nothing_known, &found, &quality, &reason));
    TEST_ASSERT_TRUE(reason.undetermined != 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          invcal_thermal_calibrate(NULL, NULL, 0, &settings, &nothing_known, &found,
                                                   &quality, &reason));
}

static void the_order_of_the_temperatures_does_not_matter(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(1);
    random_source random = random_start(28);

    take_three(&s, 1e-5, &random);
    calibrate_all(&settings, &nothing_known);
    const invcal_thermal_calibration rising = found;
    for (unsigned i = 0; i < all.count / 2; i++) {
        const unsigned other = all.count - 1 - i;
        for (unsigned k = 0; k < 3; k++) {
            const invcal_real raw = all.raw[3 * i + k];
            all.raw[3 * i + k] = all.raw[3 * other + k];
            all.raw[3 * other + k] = raw;
        }
        const invcal_real temperature = all.temperature[i];
        all.temperature[i] = all.temperature[other];
        all.temperature[other] = temperature;
    }
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_TRUE(found.least == rising.least && found.greatest == rising.greatest);
    TEST_ASSERT_TRUE(found.reference == rising.reference && found.span == rising.span);
    for (int a = 0; a <= DEGREE; a++) {
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-12), (double)rising.x[a][r],
                                      (double)found.x[a][r]);
        }
    }
}

/* ---- what is refused ---------------------------------------------------------------------- */

/* Nothing of a refused calibration is written; returns why, and which position stands in reason. */
static invcal_status refusal(const invcal_settings *settings,
                             const invcal_thermal_settings *thermal, unsigned *position)
{
    invcal_thermal_calibration calibration;
    invcal_thermal_calibration before;
    invcal_quality q;
    invcal_quality q_before;
    invcal_reason reason = {0, 0};

    memset(&calibration, 0x5A, sizeof calibration);
    memset(&q, 0x5A, sizeof q);
    before = calibration;
    q_before = q;
    const invcal_status status = invcal_thermal_calibrate(
        all.raw, all.temperature, all.count, settings, thermal, &calibration, &q, &reason);
    if (status != INVCAL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
        TEST_ASSERT_EQUAL_MEMORY(&q_before, &q, sizeof q_before);
    }
    *position = reason.position;
    return status;
}

static void a_reading_that_is_none_is_named(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, 11};
    const invcal_settings settings = unit_settings(1e-4);
    const sensor s = straight(0);
    random_source random = random_start(22);
    unsigned position;

    for (int i = 0; i < 3; i++) {
        take_three(&s, 1e-4, &random);
        all.raw[3 * 31 + 1] = (invcal_real)bad[i];
        TEST_ASSERT_EQUAL_INT(i < 2 ? INVCAL_NOT_FINITE : INVCAL_OUT_OF_RANGE,
                              refusal(&settings, &nothing_known, &position));
        TEST_ASSERT_EQUAL_UINT(31, position);
    }
}

/* Readings on a sphere about (0.5, 0, 0), and one near its centre: of nearly the length of the
 * field at first, and of none once the centre is known. */
static void a_reading_that_is_absurd_once_it_is_calibrated_is_named(void)
{
    const double offset[INVCAL_PARAMETERS] = {0.5};
    const sensor s = {offset, NULL, NULL};
    const invcal_settings settings = unit_settings(1e-4);
    random_source random = random_start(23);
    unsigned position;

    all.count = 0;
    for (int i = 0; i < STATIONS; i++) {
        take(&s, 25, PLAN, 1e-4, &random);
    }
    all.raw[3 * 7] = (invcal_real)0.5;
    all.raw[3 * 7 + 1] = (invcal_real)0.02;
    all.raw[3 * 7 + 2] = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID, refusal(&settings, &nothing_known, &position));
    TEST_ASSERT_EQUAL_UINT(7, position);
}

/* Readings at a temperature on x^2 + y^2 + c z^2 = 1: no ellipsoid unless c is positive. */
static void take_quadric(double c, double temperature, random_source *random)
{
    for (unsigned i = 0; i < PLAN;) {
        double d[3];
        random_direction(random, d);
        const double square = d[0] * d[0] + d[1] * d[1] + c * d[2] * d[2];
        if (square > 0.06) { /* within 4 times the field */
            for (int k = 0; k < 3; k++) {
                all.raw[3 * all.count + (unsigned)k] = (invcal_real)(d[k] / sqrt(square));
            }
            all.temperature[all.count++] = (invcal_real)temperature;
            i++;
        }
    }
}

/* c is a line or, in the last row, a parabola of temperature; p follows it exactly. A prior, on
 * everything, does not bend the readings. */
static void what_is_no_ellipsoid_at_some_temperature_is_refused(void)
{
    const double form[][STATIONS] = {
        {-0.5, -0.5, -0.5}, {-0.5, 0.25, 1}, {1, 0.25, -0.5}, {1, -0.5, 1}};
    random_source random = random_start(24);
    unsigned position;

    for (int i = 0; i < (DEGREE == 0 ? 1 : DEGREE == 1 ? 3 : 4); i++) {
        invcal_settings settings = unit_settings(1e-4);
        all.count = 0;
        for (int station = 0; station < STATIONS; station++) {
            take_quadric(form[i][station], -20 + 45 * station, &random);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID, refusal(&settings, &nothing_known, &position));
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            settings.prior[r] = 1;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID, refusal(&settings, &nothing_known, &position));
    }
}

/* The same with a sensor in a plane, and noise: what is left open may take any shape, and is no
 * fault of the readings. */
static void a_plane_with_noise_is_undetermined_rather_than_no_ellipsoid(void)
{
    const invcal_settings settings = unit_settings(0);
    random_source random = random_start(25);
    unsigned position;

    for (int draw = 0; draw < SOME(20); draw++) {
        all.count = 0;
        for (unsigned i = 0; i < PLAN; i++, all.count++) {
            const double angle = random_uniform(&random, 0, 6.283185307179586);
            all.raw[3 * i] = (invcal_real)cos(angle);
            all.raw[3 * i + 1] = (invcal_real)sin(angle);
            all.raw[3 * i + 2] = (invcal_real)(0.02 * random_normal(&random));
            all.temperature[i] = 25;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, refusal(&settings, &nothing_known, &position));
    }
}

/* Six faces and twelve edges, but those between x and y all at +x and only `tilt` off it. The pivot
 * of gamma_xy is 4 tilt^2, the largest diagonal element 8, the largest eigenvalue 11.5: between the
 * two no pivot shows it, the condition does. */
static void an_angle_that_hardly_shows_is_refused_unless_a_prior_holds_it(void)
{
    const double tilt = FLOAT_OR_DOUBLE(2.14e-3, 1.55e-4);
    invcal_settings settings = unit_settings(1e-6);
    unsigned position;

    all.count = 0;
    for (unsigned i = 0; i < PLAN; i++, all.count++) {
        const double a = i & 1 ? 1 : -1;
        const double b = i & 2 ? 1 : -1;
        const double edge[3][3] = {{a, 0, b}, {0, a, b}, {1, a * tilt, 0}};
        double v[3] = {0, 0, 0};
        v[i % 3] = i < 15 ? 1 : -1;
        if (i < 12) {
            memcpy(v, edge[i / 4], sizeof v);
        }
        const double length = length3(v);
        for (unsigned k = 0; k < 3; k++) {
            all.raw[3 * i + k] = (invcal_real)(v[k] / length);
        }
        all.temperature[i] = 25;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, refusal(&settings, &nothing_known, &position));
    settings.prior[INVCAL_GAMMA_XY] = (invcal_real)1e-4;
    calibrate_all(&settings, &nothing_known);
    TEST_ASSERT_EQUAL_HEX16(1u << INVCAL_GAMMA_XY, quality.from_prior);
    const double data = 1e-6 / (2 * tilt);
    const double both = 1 / sqrt(1 / 1e-8 + 1 / (data * data));
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * both, both, (double)quality.sigma_gamma[0]);
}

/* A sensor of a fifth of the scale, and a prior that knows better by 800 sigma. The residuals say
 * how noisy the readings are; weighed again it takes more away than is there. */
static void a_prior_that_nothing_can_be_reconciled_with_is_refused(void)
{
    const double scale[INVCAL_PARAMETERS] = {0, 0, 0, -0.8, -0.8, -0.8};
    const sensor s = {scale, NULL, NULL};
    invcal_settings settings = unit_settings(1e-5);
    random_source random = random_start(26);
    unsigned position;

    all.count = 0;
    take(&s, 25, PLAN, 6e-3, &random);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, refusal(&settings, &nothing_known, &position));
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = (invcal_real)1e-3;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID, refusal(&settings, &nothing_known, &position));
}

/* A base whose x axis is 5 times the nominal one, and readings that are 3 times as long still. */
static void semi_axes_beyond_their_limits_are_refused_together(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    invcal_thermal_calibration out;
    random_source unused = random_start(0);

    for (int i = 0; i < 2; i++) {
        const double dk = (i ? 3 : 1.8) * 5 - 1; /* 15 or 9, 10 the limit */
        const double longer[INVCAL_PARAMETERS] = {0, 0, 0, dk};
        const sensor s = {longer, NULL, NULL};
        all.count = 0;
        take(&s, 25, PLAN, 0, &unused);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
        found.x[0][INVCAL_DK_X] = 4;
        gather();
        memset(&out, 0x5A, sizeof out);
        const invcal_thermal_calibration before = out;
        TEST_ASSERT_EQUAL_INT(i ? INVCAL_NOT_ELLIPSOID : INVCAL_OK,
                              invcal_thermal_solve(&sums, &found, &settings, &thermal, &out));
        if (i) {
            TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
        } else {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-11), dk,
                                      (double)out.x[0][INVCAL_DK_X]);
        }
    }
}

static void assert_not_judged(invcal_status expected, const invcal_settings *settings,
                              const invcal_thermal_settings *thermal, double temperature)
{
    invcal_quality q;
    invcal_quality before;

    memset(&q, 0x5A, sizeof q);
    before = q;
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_assess(&sums, &found, settings, thermal,
                                                          (invcal_real)temperature, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

static void what_cannot_be_judged_is_refused_and_the_quality_left_alone(void)
{
    const invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = {.reference = 25, .span = 45};
    const double scale[INVCAL_PARAMETERS] = {0, 0, 0, 0.2, 0.2, 0.2};
    const sensor s = {scale, NULL, NULL};
    invcal_settings bad = settings;
    invcal_thermal_settings worse = thermal;
    random_source random = random_start(27);

    take_three(&s, 1e-4, &random);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_start(&settings, &thermal, &found));
    gather(); /* as they are read: a fifth too long */
    assert_not_judged(INVCAL_NOT_ELLIPSOID, &settings, &thermal, 25);
    calibrate_all(&settings, &thermal);
    gather();
    assert_not_judged(INVCAL_NOT_FINITE, &settings, &thermal, NOT_A_NUMBER);
    assert_not_judged(INVCAL_NOT_FINITE, &settings, &thermal, INFINITE);
    bad.field = 0;
    assert_not_judged(INVCAL_BAD_SETTING, &bad, &thermal, 25);
    worse.less = DEGREE + 1;
    assert_not_judged(INVCAL_BAD_SETTING, &settings, &worse, 25);
    bad = settings;
    sums.sum[0].moment[3] = (invcal_real)NAN;
    assert_not_judged(INVCAL_UNDETERMINED, &settings, &thermal, 25);
    bad.prior[INVCAL_DK_X] = (invcal_real)0.01; /* holds no NaN */
    assert_not_judged(INVCAL_UNDETERMINED, &bad, &thermal, 25);
    invcal_thermal_init(&sums);
    assert_not_judged(INVCAL_BAD_SETTING, &settings, &thermal, 25);
}

/* ---- a lower degree than the build has ---------------------------------------------------- */

static void a_lower_degree_is_fitted_where_it_is_wanted(void)
{
    const sensor s = {expected_thermal_constant, expected_thermal_slope[0], NULL};
    const invcal_settings settings = unit_settings(0);
    invcal_thermal_settings thermal = nothing_known;
    random_source random = random_start(11);

    take_three(&s, 1e-4, &random);
    for (unsigned less = 0; less <= (unsigned)DEGREE; less++) {
        thermal.less = (uint8_t)less;
        calibrate_all(&settings, &thermal);
        TEST_ASSERT_EQUAL_UINT(DEGREE - less, found.fitted);
        TEST_ASSERT_EQUAL_UINT(DEGREE - less, found.degree);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
    }
    thermal.less = DEGREE + 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING,
                          invcal_thermal_calibrate(all.raw, all.temperature, all.count, &settings,
                                                   &thermal, &found, &quality, NULL));
}

/* ---- drift in a rest ---------------------------------------------------------------------- */

static void the_drift_limit_is_where_a_lag_makes_the_noise_of_a_position(void)
{
    invcal_settings settings = unit_settings(0);
    invcal_thermal_settings thermal = nothing_known;

    TEST_ASSERT_DOUBLE_WITHIN(1e-7, 0.2, (double)invcal_thermal_drift_limit(&settings, &thermal));
    settings.field = (invcal_real)9.8;
    settings.noise = (invcal_real)(9.8 * 5e-4);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, (double)invcal_thermal_drift_limit(&settings, &thermal));
    thermal.slope[1] = (invcal_real)2e-4;
    thermal.slope[4] = (invcal_real)1e-4;
    const double limit = (double)invcal_thermal_drift_limit(&settings, &thermal);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 5, limit);
    /* The sensor warms evenly by the limit; the thermometer still tells where it began. */
    double error = 0;
    for (int i = 0; i < 1000; i++) {
        error += 2e-4 * limit * (i + 0.5) / 1000 / 1000;
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 5e-4, error);
}

static void no_drift_is_allowed_where_the_limit_is_no_number(void)
{
    invcal_settings settings = unit_settings(1e-4);
    const invcal_thermal_settings thermal = nothing_known;

    settings.field = 0;
    TEST_ASSERT_TRUE(invcal_thermal_drift_limit(&settings, &thermal) == 0);
    settings.field = -1;
    TEST_ASSERT_TRUE(invcal_thermal_drift_limit(&settings, &thermal) == 0);
    settings.field = (invcal_real)NAN;
    TEST_ASSERT_TRUE(invcal_thermal_drift_limit(&settings, &thermal) == 0);
    settings.field = 1;
    settings.noise = (invcal_real)INFINITY;
    TEST_ASSERT_TRUE(invcal_thermal_drift_limit(&settings, &thermal) == 0);
}

static void every_fallback_has_its_words(void)
{
    TEST_ASSERT_EQUAL_STRING("as asked", invcal_thermal_fallback_text(INVCAL_THERMAL_AS_ASKED));
    TEST_ASSERT_EQUAL_STRING("too few positions for slopes",
                             invcal_thermal_fallback_text(INVCAL_THERMAL_FEW));
    TEST_ASSERT_EQUAL_STRING("too narrow a range of temperatures for slopes",
                             invcal_thermal_fallback_text(INVCAL_THERMAL_NARROW));
    TEST_ASSERT_EQUAL_STRING("positions and temperatures leave slopes open",
                             invcal_thermal_fallback_text(INVCAL_THERMAL_OPEN));
    TEST_ASSERT_EQUAL_STRING("unknown reason",
                             invcal_thermal_fallback_text((invcal_thermal_fallback)9));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(slopes_of_a_sensor_without_noise_come_out);
    RUN_TEST(a_part_of_the_span_and_a_bad_nominal_are_as_good);
    RUN_LONG_TEST(the_error_is_the_cramer_rao_bound_and_that_of_nine_parameters_hundreds_of_it);
    RUN_LONG_TEST(a_bent_sensor_comes_to_the_bound_of_27_parameters);
    RUN_SLOW_TEST(one_solve_leaves_the_square_of_the_slopes_and_two_nothing_that_matters);
    RUN_TEST(at_one_temperature_there_are_no_slopes_and_it_says_so);
    RUN_TEST(two_temperatures_half_a_kelvin_apart_tell_no_slopes_and_it_says_so);
    RUN_TEST(too_few_positions_for_slopes_are_enough_for_fewer);
    RUN_TEST(what_the_positions_leave_open_is_left_out_and_named);
    RUN_TEST(slopes_that_pass_for_other_errors_are_not_called_good);
    RUN_TEST(slopes_of_a_small_part_of_the_span_are_open);
    RUN_TEST(outside_the_range_seen_the_edge_is_held_and_said);
    RUN_TEST(what_is_no_temperature_is_refused_and_nothing_written);
    RUN_TEST(a_damaged_calibration_is_refused_at_any_temperature);
    RUN_TEST(raw_counts_and_both_frames_give_the_right_lengths_at_every_temperature);
    RUN_LONG_TEST(sigma_at_every_temperature_is_that_of_the_error);
    RUN_TEST(sigma_of_a_line_has_its_closed_form);
    RUN_TEST(the_judgement_counts_coefficients_and_names_the_worst_position);
    RUN_TEST(a_prior_on_slopes_holds_what_one_temperature_leaves_open);
    RUN_TEST(a_slope_prior_alone_is_enough_at_a_constant_temperature);
    RUN_TEST(a_prior_shrinks_and_counts_by_the_closed_form);
    RUN_TEST(what_is_weak_anywhere_is_weak);
    RUN_TEST(a_prior_counts_for_more_where_the_data_are_noisier_than_stated);
    RUN_TEST(noise_as_large_as_the_field_leaves_everything_to_the_prior);
    RUN_TEST(renewing_at_one_temperature_keeps_the_slopes);
    RUN_TEST(positions_taken_out_leave_what_was_without_them);
    RUN_TEST(the_order_of_the_temperatures_does_not_matter);
    RUN_TEST(readings_and_temperatures_that_are_none_leave_the_sums_alone);
    RUN_TEST(the_range_is_that_of_the_temperatures_in_any_order);
    RUN_TEST(unusable_settings_are_refused);
    RUN_TEST(eight_positions_and_a_plane_are_refused_as_without_temperature);
    RUN_TEST(a_reading_that_is_none_is_named);
    RUN_TEST(a_reading_that_is_absurd_once_it_is_calibrated_is_named);
    RUN_TEST(what_is_no_ellipsoid_at_some_temperature_is_refused);
    RUN_TEST(a_plane_with_noise_is_undetermined_rather_than_no_ellipsoid);
    RUN_TEST(an_angle_that_hardly_shows_is_refused_unless_a_prior_holds_it);
    RUN_TEST(a_prior_that_nothing_can_be_reconciled_with_is_refused);
    RUN_TEST(semi_axes_beyond_their_limits_are_refused_together);
    RUN_TEST(what_cannot_be_judged_is_refused_and_the_quality_left_alone);
    RUN_TEST(the_drift_limit_is_where_a_lag_makes_the_noise_of_a_position);
    RUN_TEST(no_drift_is_allowed_where_the_limit_is_no_number);
    RUN_TEST(a_lower_degree_is_fitted_where_it_is_wanted);
    RUN_TEST(every_fallback_has_its_words);
    return UNITY_END() != 0;
}
