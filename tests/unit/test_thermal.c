/* SPDX-License-Identifier: MIT
 *
 * For every INVCAL_THERMAL_DEGREE: tests skip what a degree cannot do.
 */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/result.h"
#include "invcal/thermal.h"
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

static const invcal_thermal_prior nothing_known;

/* The result from the positions. */
static invcal_thermal found;
static invcal_quality quality;

static const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

static invcal_positions positions(double noise)
{
    return *POSITIONS_AT(all.raw, all.temperature, all.count, &unit, (invcal_real)noise);
}

static void calibrate_all(double noise)
{
    const invcal_positions p = positions(noise);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_calibrate(&p, DEGREE, &found, &quality));
}

/* The unit at all temperatures. */
static invcal_thermal base_at(double reference, double span)
{
    invcal_thermal base;

    memset(&base, 0, sizeof base);
    base.nominal = unit;
    base.reference = (invcal_real)reference;
    base.span = (invcal_real)span;
    base.min = base.reference - base.span;
    base.max = base.reference + base.span;
    return base;
}

/* Reference and span stated. */
static void fit_all(double noise, double reference, double span, unsigned degree)
{
    const invcal_thermal base = base_at(reference, span);
    const invcal_positions p = positions(noise);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_fit(&p, NULL, &base, degree, &found, &quality));
}

/* Without a base: the unit at all temperatures. */
static void fit_with_prior(double noise, const invcal_thermal_prior *prior,
                           const invcal_thermal *base)
{
    const invcal_positions p = positions(noise);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_fit(&p, prior, base, DEGREE, &found, &quality));
}

static invcal_quality judge(double noise, double temperature)
{
    const invcal_positions p = positions(noise);
    invcal_quality q;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_judge(&p, NULL, &found, (invcal_real)temperature, &q));
    return q;
}

static invcal_calibration calibration_at(double temperature)
{
    invcal_calibration calibration;
    invcal_thermal_place place;

    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_thermal_at(&found, (invcal_real)temperature, &calibration, &place));
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_WITHIN, place);
    return calibration;
}

/* The mean square of |calibrated| - 1 over all directions: an icosahedron gives it exactly. */
static double square_error(const invcal_calibration *calibration, const triad_truth *truth)
{
    double squares = 0;

    for (int i = 0; i < 12; i++) {
        const double e = calibrated_length(calibration, truth, expected_icosahedron[i]) - 1;
        squares += e * e / 12;
    }
    return squares;
}

/* A stated noise counts as four residuals: what remains of it with exact readings. */
static double beside_none(double stated, double dof)
{
    return stated * sqrt(4 / (4 + dof));
}

/* Over a range in nine steps: from -20 to 70 C those of the reference, -15, -5 ... 65 C. */
static double square_error_of_range(const sensor *s, double low, double high,
                                    const invcal_calibration *nine)
{
    double squares = 0;

    for (int k = 0; k < 9; k++) {
        const double temperature = low + (high - low) * (k + 0.5) / 9;
        const triad_truth truth = triad_at(s, temperature);
        const invcal_calibration calibration = nine ? *nine : calibration_at(temperature);
        squares += square_error(&calibration, &truth) / 9;
    }
    return squares;
}

/* Nothing of a refused calibration is written. */
static void assert_refused(invcal_status expected, double noise)
{
    const invcal_positions p = positions(noise);
    invcal_thermal out;
    invcal_quality q;

    memset(&out, 0x5A, sizeof out);
    memset(&q, 0x5A, sizeof q);
    const invcal_thermal before = out;
    const invcal_quality q_before = q;
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_calibrate(&p, DEGREE, &out, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof before);
    TEST_ASSERT_EQUAL_MEMORY(&q_before, &q, sizeof q_before);
}

static void assert_refused_with_prior(invcal_status expected, double noise,
                                      const invcal_thermal_prior *prior)
{
    const invcal_positions p = positions(noise);
    invcal_thermal out;
    invcal_quality q;

    memset(&out, 0x5A, sizeof out);
    const invcal_thermal before = out;
    TEST_ASSERT_EQUAL_INT(expected, invcal_thermal_fit(&p, prior, NULL, DEGREE, &out, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof before);
}

/* ---- how good it is ----------------------------------------------------------------------- */

static void slopes_of_a_sensor_without_noise_come_out(void)
{
    random_source unused = random_start(0);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    for (int set = 0; set < SOME(EXPECTED_THERMAL_COUNT); set++) {
        const sensor s = straight(set);
        take_three(&s, 0, &unused);
        calibrate_all(1e-4);
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

/* As the header states. */
static void two_solves_leave_nothing_that_matters_of_steep_slopes(void)
{
    random_source unused = random_start(0);
    const sensor steep = straight(0);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    take_three(&steep, 0, &unused);
    fit_all(1e-4, 25, 45, DEGREE);
    TEST_ASSERT_DOUBLE_WITHIN(0.1e-6, 0.93e-6, sqrt(square_error_of_range(&steep, -20, 70, NULL)));
}

/* As the manual says: slopes of these sizes, with all signs. What float loses is 5e-8. */
static void two_solves_leave_as_little_of_steep_slopes_of_any_signs(void)
{
    random_source unused = random_start(0);
    double least = 1;
    double most = 0;

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    for (int signs = 0; signs < 512; signs++) {
        double slope[INVCAL_PARAMETERS];
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            slope[r] = fabs(expected_thermal_slope[0][r]) * (signs >> r & 1 ? 1 : -1);
        }
        const sensor s = {expected_thermal_constant, slope, NULL};
        take_three(&s, 0, &unused);
        fit_all(1e-4, 25, 45, DEGREE);
        const double error = sqrt(square_error_of_range(&s, -20, 70, NULL));
        least = fmin(least, error);
        most = fmax(most, error);
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.05e-6, 0.51e-6, least);
    TEST_ASSERT_DOUBLE_WITHIN(0.05e-6, 1.96e-6, most);
}

/* The middle of the temperatures, and half their range. */
static void no_base_is_the_nominal_calibration_at_all_temperatures(void)
{
    const sensor s = straight(0);
    random_source random = random_start(31);

    take_three(&s, 1e-4, &random);
    fit_all(1e-4, 25, 45, DEGREE);
    const invcal_thermal of_base = found;
    const invcal_quality q = quality;
    fit_with_prior(1e-4, NULL, NULL);
    TEST_ASSERT_TRUE(found.reference == 25 && found.span == 45);
    TEST_ASSERT_TRUE(found.min == -20 && found.max == 70);
    TEST_ASSERT_EQUAL_MEMORY(of_base.x, found.x, sizeof found.x);
    TEST_ASSERT_EQUAL_MEMORY(q.sigma, quality.sigma, sizeof q.sigma);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_MEMORY(of_base.x, found.x, sizeof found.x);
    TEST_ASSERT_EQUAL_MEMORY(q.sigma, quality.sigma, sizeof q.sigma);
    all.count = PLAN; /* at one temperature */
    calibrate_all(1e-4);
    TEST_ASSERT_TRUE(found.reference == -20 && found.span == 1);
}

/* Wherever in the span the temperatures are; with nominal errors of 18 %, too. */
static void a_part_of_the_span_and_a_bad_nominal_are_as_good(void)
{
    static const double stations[][STATIONS] = {{25, 47, 70}, {-20, -5, 40}, {10, 45, 70}};
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
        fit_all(1e-4, 25, 45, DEGREE);
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
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(7);
    double squares = 0;
    double squares_of_nine = 0;

    for (int draw = 0; draw < draws; draw++) {
        invcal_calibration calibration;
        invcal_quality q;
        take_three(s, sigma, &random);
        calibrate_all(sigma);
        squares += square_error_of_range(s, -20, 70, NULL) / draws;
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK,
            invcal_calibrate_plain(POSITIONS_OF(all.raw, all.count, &nominal, (invcal_real)sigma),
                                   &calibration, &q));
        squares_of_nine += square_error_of_range(s, -20, 70, &calibration) / draws;
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

/* ---- what the temperatures do not show ---------------------------------------------------- */

/* The same as without temperature, and no slopes. */
static void assert_like_nine_parameters(double noise, invcal_verdict verdict)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_calibration plain;
    invcal_quality q;
    const invcal_calibration calibration = calibration_at((double)all.temperature[0]);

    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_calibrate_plain(
                       POSITIONS_OF(all.raw, all.count, &nominal, (invcal_real)noise), &plain, &q));
    TEST_ASSERT_EQUAL_UINT(0, found.degree);
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* rows are weighted with the noise that they have, which the plain ones are not */
        const double sigma = (double)q.sigma[r];
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * sigma, parameter(&plain, r), parameter(&calibration, r));
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * sigma, sigma, (double)quality.sigma[r]);
        for (int k = 1; k <= DEGREE; k++) {
            TEST_ASSERT_TRUE(found.x[k][r] == 0);
        }
    }
    TEST_ASSERT_EQUAL_UINT(q.dof, quality.dof);
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * (double)q.noise, (double)q.noise, (double)quality.noise);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)q.rms, (double)quality.rms);
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * (double)q.condition, (double)q.condition,
                              (double)quality.condition);
    TEST_ASSERT_EQUAL_INT(verdict == INVCAL_WEAK ? INVCAL_GOOD : verdict, q.verdict);
    TEST_ASSERT_EQUAL_INT(verdict, quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(verdict == INVCAL_WEAK ? 0x1FF : 0, quality.weak);
}

static invcal_thermal_fallback narrow(void)
{
    return DEGREE > 0 ? INVCAL_THERMAL_NARROW : INVCAL_THERMAL_AS_ASKED;
}

static void at_one_temperature_there_are_no_slopes_and_it_says_so(void)
{
    const sensor s = straight(0);
    random_source random = random_start(3);

    all.count = 0;
    take(&s, 31.5, PLAN, 1e-4, &random);
    take(&s, 31.5, PLAN, 1e-4, &random);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(1e-4, INVCAL_GOOD);
}

/* But offsets move by 0.5 mg, five times the noise, and no nine parameters follow them: that is
 * rough. */
static void two_temperatures_half_a_kelvin_apart_give_no_slopes_and_it_says_so(void)
{
    const sensor s = straight(0);
    random_source random = random_start(4);

    all.count = 0;
    take(&s, 25, PLAN, 1e-4, &random);
    take(&s, 25.5, PLAN, 1e-4, &random);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(1e-4, INVCAL_ROUGH);
    fit_all(1e-4, 25, 45, DEGREE);
    TEST_ASSERT_EQUAL_INT(narrow(), found.fallback);
    assert_like_nine_parameters(1e-4, INVCAL_ROUGH);
}

static void too_few_positions_for_slopes_are_enough_for_fewer(void)
{
    const sensor s = straight(1);
    random_source random = random_start(5);

    all.count = 0;
    take(&s, -20, 17, 1e-4, &random);
    all.temperature[16] = 70;
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_INT(DEGREE > 0 ? INVCAL_THERMAL_FEW : INVCAL_THERMAL_AS_ASKED,
                          found.fallback);
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    if (DEGREE == 2) {
        all.count = 0;
        take(&s, -20, 13, 1e-4, &random);
        take(&s, 70, 13, 1e-4, &random);
        calibrate_all(1e-4);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_FEW, found.fallback);
        TEST_ASSERT_EQUAL_UINT(1, found.fitted);
    }
}

/* Three orientations at the other temperature; a parabola through two. */
static void what_the_positions_leave_open_is_left_out_and_named(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(6);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    all.count = 0;
    take(&still, -20, PLAN, 1e-4, &random);
    take(&still, 70, 3, 1e-4, &random);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_OPEN, found.fallback);
    assert_like_nine_parameters(1e-4, INVCAL_WEAK);
    all.count = 0;
    take(&still, -20, PLAN, 1e-4, &random);
    take(&still, 70, PLAN, 1e-4, &random);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_UINT(1, found.fitted);
    TEST_ASSERT_EQUAL_INT(DEGREE > 1 ? INVCAL_THERMAL_OPEN : INVCAL_THERMAL_AS_ASKED,
                          found.fallback);
}

/* Eighteen positions in the cold, four each at 25 C and in the heat: nine parameters go wrong by 20
 * times what they leave as residuals, in some draws. */
static void slopes_that_pass_for_other_errors_are_not_called_good(void)
{
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
        calibrate_all(1e-4);
        TEST_ASSERT_EQUAL_UINT(0, found.fitted);
        TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
        TEST_ASSERT_EQUAL_HEX16(0x1FF, quality.weak);
    }
}

/* sqrt(K) of a slope of gamma: 0.816 over the part of the span, for 18 positions at either end. */
static void slopes_of_a_small_part_of_the_span_are_open(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(8);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    for (int i = 0; i < 2; i++) {
        all.count = 0;
        take(&still, 15, PLAN, 1e-4, &random);
        take(&still, 25, PLAN, 1e-4, &random);
        fit_all(1e-4, 20, i ? 70 : 55, DEGREE);
        TEST_ASSERT_EQUAL_INT(i ? INVCAL_THERMAL_OPEN : INVCAL_THERMAL_AS_ASKED, found.fallback);
    }
}

static void a_lower_degree_is_fitted_where_it_is_wanted(void)
{
    const sensor s = straight(0);
    random_source random = random_start(11);

    take_three(&s, 1e-4, &random);
    for (unsigned degree = 0; degree <= (unsigned)DEGREE; degree++) {
        fit_all(0, 25, 45, degree);
        TEST_ASSERT_EQUAL_UINT(degree, found.fitted);
        TEST_ASSERT_EQUAL_UINT(degree, found.degree);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
    }
}

/* ---- at a temperature --------------------------------------------------------------------- */

static void outside_the_observed_range_the_edge_is_held_and_reported(void)
{
    const sensor s = straight(0);
    random_source random = random_start(9);
    const double outside[] = {-100, -20.001, 70.001, 150, 1e30};

    take_three(&s, 1e-4, &random);
    calibrate_all(1e-4);
    for (int i = 0; i < 5; i++) {
        const invcal_calibration edge = calibration_at(outside[i] < 0 ? -20 : 70);
        invcal_calibration calibration;
        invcal_thermal_place place;
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_at(&found, (invcal_real)outside[i], &calibration, &place));
        TEST_ASSERT_EQUAL_INT(outside[i] < 0 ? INVCAL_THERMAL_BELOW : INVCAL_THERMAL_ABOVE, place);
        TEST_ASSERT_EQUAL_MEMORY(&edge, &calibration, sizeof edge);
        memset(&calibration, 0x5A, sizeof calibration);
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_at(&found, (invcal_real)outside[i], &calibration, NULL));
        TEST_ASSERT_EQUAL_MEMORY(&edge, &calibration, sizeof edge);
    }
}

static void what_is_not_a_temperature_is_refused_and_nothing_written(void)
{
    const sensor s = straight(2);
    random_source random = random_start(10);
    invcal_calibration calibration;
    invcal_calibration before;
    invcal_thermal_place place = INVCAL_THERMAL_ABOVE;
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};

    take_three(&s, 1e-4, &random);
    calibrate_all(1e-4);
    memset(&calibration, 0x5A, sizeof calibration);
    before = calibration;
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_TEMPERATURE,
                              invcal_thermal_at(&found, (invcal_real)bad[i], &calibration, &place));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_TEMPERATURE,
                              invcal_thermal_at(&found, (invcal_real)bad[i], &calibration, NULL));
        TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_ABOVE, place);
        all.temperature[20] = (invcal_real)bad[i];
        assert_refused(INVCAL_BAD_TEMPERATURE, 1e-4);
    }
}

static void a_damaged_calibration_is_refused_at_any_temperature(void)
{
    const sensor s = straight(2);
    random_source random = random_start(19);
    const invcal_real nan = (invcal_real)NAN;

    take_three(&s, 1e-4, &random);
    calibrate_all(1e-4);
    for (int i = 0; i < (DEGREE == 0 ? 4 : 8); i++) { /* nothing else depends on temperature */
        invcal_thermal bad = found;
        invcal_calibration calibration;
        invcal_thermal_place place;
        *(i == 0   ? &bad.x[DEGREE][4]
          : i == 1 ? &bad.x[0][0]
          : i == 2 ? &bad.nominal.offset[1]
          : i == 3 ? &bad.nominal.matrix[2][1]
          : i == 4 ? &bad.reference
          : i == 5 ? &bad.span
          : i == 6 ? &bad.min
                   : &bad.max) = nan;
        const invcal_status status = invcal_thermal_at(&bad, 30, &calibration, &place);
        TEST_ASSERT_EQUAL_INT(i == 2 || i == 3 ? INVCAL_BAD_NOMINAL : INVCAL_NOT_ELLIPSOID, status);
    }
    memset(found.nominal.matrix[1], 0, sizeof found.nominal.matrix[1]);
    invcal_calibration calibration;
    invcal_thermal_place place;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, invcal_thermal_at(&found, 30, &calibration, &place));
}

/* Semi-axes of I + S: by its elements, its trace, or its determinant. */
static void what_is_not_a_triad_is_refused_at_any_temperature(void)
{
    static const double bad[][INVCAL_PARAMETERS] = {
        {0, 0, 0, 9.1},          {0, 0, 0, -0.91},
        {0, 0, 0, -2},           {0, 11},
        {0, 0, 0, 0, 0, 0, 2.1}, {0, 0, 0, 0, 0, 0, -4, -4, -4},
        {0, 0, 0, 0, -3, -3},    {0, 0, 0, 0, 0, 0, 1.9, 1.9, 0}};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        invcal_thermal thermal = base_at(20, 40);
        invcal_calibration calibration;
        invcal_thermal_place place;
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            thermal.x[0][r] = (invcal_real)bad[i][r];
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID,
                              invcal_thermal_at(&thermal, 20, &calibration, &place));
    }
}

/* A sensor of 16 bits, 1/4096 g, its axes not at zero; in m/s^2 at the end. */
static void raw_counts_give_the_right_lengths_at_every_temperature(void)
{
    const sensor s = straight(DEGREE > 0 ? 1 : 0);
    random_source unused = random_start(0);
    const invcal_real zero[3] = {0, 100, 200};
    const invcal_real counts[3] = {4096, 4096, 4096};
    invcal_calibration nominal;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(zero, counts, &nominal));
    take_three(&s, 0, &unused);
    if (DEGREE == 0) {
        all.count = PLAN;
    }
    for (unsigned i = 0; i < 3 * all.count; i++) {
        all.raw[i] = 4096 * all.raw[i] + zero[i % 3];
    }
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK,
        invcal_thermal_calibrate(POSITIONS_AT(all.raw, all.temperature, all.count, &nominal, 0),
                                 INVCAL_THERMAL_DEGREE, &found, &quality));
    for (unsigned i = 0; i < all.count; i++) {
        invcal_calibration calibration = calibration_at((double)all.temperature[i]);
        invcal_real v[3];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_scale(&calibration, (invcal_real)9.80665));
        invcal_apply(&calibration, all.raw[3 * i], all.raw[3 * i + 1], all.raw[3 * i + 2], v);
        const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
        TEST_ASSERT_DOUBLE_WITHIN(3e-5, 9.80665, length3(d));
    }
}

/* A program evaluates a calibration of any degree, such as one from a record, even if its library
 * can fit only lower ones. */
static void a_calibration_of_any_degree_holds_in_every_build(void)
{
    static const double none[INVCAL_PARAMETERS];
    random_source unused = random_start(1);

    TEST_ASSERT_EQUAL_size_t(3 * INVCAL_PARAMETERS * sizeof(invcal_real), sizeof found.x);
    for (uint8_t degree = 0; degree <= 2; degree++) {
        const sensor s = {expected_thermal_constant, degree > 0 ? expected_thermal_slope[1] : none,
                          degree > 1 ? expected_thermal_bent : none};
        found = base_at(25, 45);
        found.degree = degree;
        found.min = -20;
        found.max = 70;
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            found.x[0][r] = (invcal_real)s.constant[r];
            found.x[1][r] = (invcal_real)s.slope[r];
            found.x[2][r] = (invcal_real)s.bent[r];
        }
        take_three(&s, 0, &unused);
        for (unsigned i = 0; i < all.count; i++) {
            const invcal_calibration calibration = calibration_at((double)all.temperature[i]);
            const invcal_real *raw = &all.raw[3 * i];
            invcal_real v[3];
            invcal_apply(&calibration, raw[0], raw[1], raw[2], v);
            const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-7, 1e-7), 1, length3(d));
        }
    }
}

/* ---- judgement ---------------------------------------------------------------------------- */

static void sigma_at_every_temperature_is_that_of_the_error(void)
{
    enum { DRAWS = 60, AT = 4 };
    const double at[AT] = {-20, 2, 25, 70};
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
        calibrate_all(0);
        for (int i = 0; i < AT; i++) {
            const double temperature = DEGREE > 0 ? at[i] : 25;
            const invcal_calibration calibration = calibration_at(temperature);
            const triad_truth truth = triad_at(&s, temperature);
            const invcal_quality q = judge(0, temperature);
            TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
            for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
                const double z = (parameter(&calibration, r) - truth.x[r]) / (double)q.sigma[r];
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
    random_source unused = random_start(0);

    if (DEGREE == 0) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    all.count = 0;
    take(&s, -20, PLAN, 0, &unused);
    take(&s, -20, PLAN, 0, &unused);
    take(&s, 70, PLAN, 0, &unused);
    calibrate_all(1e-4);
    for (int i = 0; i < 3; i++) {
        const invcal_quality q = judge(1e-4, -20 + 45 * i);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double noise = beside_none(1e-4, MOST - 9 * 2);
            const double sigma = noise * expected_plan18_root_k[r] * sqrt(of_program[i]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-5 * sigma, sigma, (double)q.sigma[r]);
            if (i == 1) { /* the fit states it at its reference, 25 C */
                TEST_ASSERT_DOUBLE_WITHIN(1e-5 * sigma, sigma, (double)quality.sigma[r]);
            }
        }
    }
}

/* Outside the range, the value at its edge and its sigma are held. */
static void beyond_the_range_it_is_judged_at_its_edge(void)
{
    const sensor s = straight(0);
    random_source random = random_start(29);

    take_three(&s, 1e-4, &random);
    calibrate_all(1e-4);
    const invcal_quality edge = judge(1e-4, 70);
    const invcal_quality beyond = judge(1e-4, 1000);
    TEST_ASSERT_EQUAL_MEMORY(edge.sigma, beyond.sigma, sizeof edge.sigma);
}

static void the_judgement_counts_coefficients_and_names_the_worst_position(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(12);

    take_three(&still, 1e-4, &random);
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_UINT(MOST - 9 * (DEGREE + 1), quality.dof);
    TEST_ASSERT_EQUAL_UINT(MOST, quality.positions);
    TEST_ASSERT_DOUBLE_WITHIN(0.3e-4, 1e-4, (double)quality.noise);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
    all.raw[3 * 40 + 2] += (invcal_real)0.01; /* which points along z */
    calibrate_all(1e-6);
    TEST_ASSERT_EQUAL_UINT(40, quality.worst);
    TEST_ASSERT_TRUE(quality.max > (invcal_real)0.003);
    TEST_ASSERT_TRUE(quality.noise > (invcal_real)5e-4);
    TEST_ASSERT_EQUAL_UINT(40, judge(1e-6, 25).worst);
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
    calibrate_all(1e-4);
    TEST_ASSERT_EQUAL_UINT(0, quality.dof);
    TEST_ASSERT_TRUE(quality.verdict != INVCAL_GOOD);
}

/* gamma at noise 0.05, which is what is left of 0.158: K count noise^2 is 0.06 in the middle and
 * 0.15 at the ends, 0.1 the limit. */
static void what_is_weak_anywhere_is_weak(void)
{
    const double none[INVCAL_PARAMETERS] = {0};
    const sensor perfect = {none, NULL, NULL};
    random_source unused = random_start(0);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    take_three(&perfect, 0, &unused);
    calibrate_all(0.158);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 0.05, (double)quality.noise);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, judge(0.158, 25).verdict);
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, quality.weak);
}

/* ---- priors ------------------------------------------------------------------------------- */

/* Coefficients above the degree are not held. */
static void hold(invcal_thermal_prior *prior, int power, int r, double sigma)
{
    if (power <= DEGREE) {
        prior->sigma[power][r] = (invcal_real)sigma;
    }
}

/* For which parameters the prior contributes more than the positions, at the reference. */
static unsigned from_prior(const invcal_thermal_prior *prior)
{
    unsigned mask = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double known = (double)prior->sigma[0][r];
        mask |= (known > 0 && (double)quality.sigma[r] > sqrt(0.5) * known ? 1u : 0u) << r;
    }
    return mask;
}

/* Positions at t = 1/2 only determine x0 + x1/2. The prior divides it by its variances. */
static void a_prior_on_slopes_holds_what_one_temperature_leaves_open(void)
{
    const double sigma0 = 0.02;
    const double sigma1 = 0.03; /* over the span */
    const sensor still = {expected_thermal_constant, NULL, NULL};
    const invcal_thermal base = base_at(20, 40);
    invcal_thermal_prior prior;
    random_source random = random_start(13);

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        hold(&prior, 0, r, sigma0);
        hold(&prior, 1, r, sigma1 / 40);
        hold(&prior, 2, r, 1e-6);
    }
    all.count = 0;
    take(&still, 40, PLAN, 1e-4, &random);
    fit_with_prior(1e-4, &prior, &base);
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
    const invcal_calibration calibration = calibration_at(40);
    TEST_ASSERT_DOUBLE_WITHIN(3e-4, 0, sqrt(square_error(&calibration, &truth)));
    const invcal_positions p = positions(1e-4);
    invcal_quality q;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_judge(&p, &prior, &found, 40, &q));
    TEST_ASSERT_TRUE(q.sigma[0] < (invcal_real)3e-4);
}

/* In float the noise is raised to what is resolved beside a wide prior. */
static void a_slope_prior_alone_is_enough_at_a_constant_temperature(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    const triad_truth truth = triad_at(&still, 25);
    const invcal_thermal base = base_at(25, 45);
    invcal_thermal_prior prior = nothing_known;
    random_source random = random_start(14);

    all.count = 0;
    take(&still, 25, PLAN, 1e-4, &random);
    for (int wide = 0; wide < 2; wide++) {
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            hold(&prior, 1, r, wide ? 5e-3 : r < 3 ? 1e-3 : r < 6 ? 5e-4 : 1e-4);
            hold(&prior, 2, r, wide ? 1e-5 : 1e-6);
        }
        fit_with_prior(1e-4, &prior, &base);
        TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback);
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.fitted);
        for (int r = 0; r < INVCAL_PARAMETERS && DEGREE > 0; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-5, 0, (double)found.x[DEGREE > 0][r]);
        }
        const invcal_calibration calibration = calibration_at(25);
        TEST_ASSERT_DOUBLE_WITHIN(3e-4, 0, sqrt(square_error(&calibration, &truth)));
        if (wide && DEGREE > 0) { /* the largest sums are those of delta, 18 / 3 */
            const double raised = 5e-3 * 45 * sqrt(4 * (double)INVCAL_EPSILON * 6);
            const double noise = raised > 1e-4 ? raised : 1e-4;
            TEST_ASSERT_DOUBLE_WITHIN(0.05 * noise, noise, (double)quality.noise);
        }
    }
}

/* The delta of 3 x 18 positions without noise: H'H is 18 for its constant, 12 for its slope, and
 * nothing else. A prior of ratio R = (noise / sigma)^2 shrinks either to H'H / (H'H + R), which is
 * the share from the data. The missing part of delta, x in all six, stays in the residuals; these
 * and the stated noise give another noise, with which everything is computed again. */
typedef struct {
    double ratio, share, share_of_slope, dof, noise;
} shrunk;

static shrunk shrink_at(double weighed, double stated, double sigma, double x)
{
    shrunk s;

    s.ratio = weighed * weighed / (sigma * sigma);
    s.share = 18 / (18 + s.ratio);
    s.share_of_slope = 12 / (12 + s.ratio);
    s.dof = MOST - 12 - 3 * s.share - 3 * s.share_of_slope;
    const double squares =
        3 * x * x * (18 * pow(1 - s.share, 2) + 12 * pow(1 - s.share_of_slope, 2));
    s.noise = sqrt((4 * stated * stated + squares) / (4 + s.dof));
    return s;
}

static void a_prior_shrinks_and_counts_by_the_closed_form(void)
{
    const double stated = 3e-3;
    const double sigma0 = 2e-4;
    const double x = 1e-3; /* small: the closed form is of first order */
    const double constant[INVCAL_PARAMETERS] = {x, x, -x};
    const double slope[INVCAL_PARAMETERS] = {x, -x, x};
    const sensor s = {constant, slope, NULL};
    const invcal_thermal base = base_at(25, 45);
    invcal_thermal_prior prior = nothing_known;
    random_source unused = random_start(0);

    if (DEGREE != 1) {
        TEST_IGNORE_MESSAGE("stated for degree 1");
    }
    for (int r = 0; r < 3; r++) {
        hold(&prior, 0, r, sigma0);
        hold(&prior, 1, r, sigma0 / 45);
    }
    take_three(&s, 0, &unused);
    fit_with_prior(stated, &prior, &base);
    const shrunk first = shrink_at(stated, stated, sigma0, x);
    const shrunk second = shrink_at(first.noise, stated, sigma0, x);
    for (int r = 0; r < 3; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * x, second.share * constant[r], (double)found.x[0][r]);
        TEST_ASSERT_DOUBLE_WITHIN(0.01 * x, second.share_of_slope * slope[r],
                                  (double)found.x[DEGREE > 0][r]);
    }
    TEST_ASSERT_EQUAL_UINT((unsigned)second.dof, quality.dof);
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * second.noise, second.noise, (double)quality.noise);
    TEST_ASSERT_EQUAL_HEX16(7, from_prior(&prior)); /* delta only */
    for (int k = 0; k < 3; k++) {
        const double t = k - 1;
        const invcal_positions p = positions(stated);
        invcal_quality q;
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_thermal_judge(&p, &prior, &found, (invcal_real)(25 + 45 * t), &q));
        TEST_ASSERT_DOUBLE_WITHIN(0.05 * second.noise, second.noise, (double)q.noise);
        const double noise = (double)q.noise;
        const double ratio = shrink_at(noise, stated, sigma0, x).ratio;
        const double sigma = noise * sqrt(1 / (18 + ratio) + t * t / (12 + ratio));
        for (unsigned r = 0; r < 3; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.01 * sigma, sigma, (double)q.sigma[r]);
        }
    }
}

/* Ten positions and a prior on nine slopes leave at most one degree of freedom of 18 unknowns. Float resolves the
 * prior so badly beside these readings that its shares would add up to 27 (found by a fuzzer). */
static void rounding_gives_no_degree_of_freedom(void)
{
    static const double raw[][3] = {
        {303.508789, 20.5, 988.916626},         {-329.845856, 350.391693, 904.349976},
        {99.2431946, -593.900391, 819.783386},  {449.783997, 586.183044, 736.31665},
        {-745.780396, -117.320419, 813.414551}, {761.540344, -434.993317, 567.18335},
        {-217.121719, 887.196228, 483.716675},  {-401.063751, -809.90387, 399.149994},
        {952.572937, 351.98111, 314.583313},    {-897.293152, 397.142639, 231.116653}};
    invcal_thermal_prior prior = nothing_known;

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("there are no slopes");
    }
    all.count = 10;
    for (unsigned i = 0; i < all.count; i++) {
        for (unsigned a = 0; a < 3; a++) {
            all.raw[3 * i + a] = (invcal_real)raw[i][a];
        }
        all.temperature[i] = (invcal_real)(30 * (int)(i % 3) - 10);
    }
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        prior.sigma[DEGREE > 0][r] = (invcal_real)(r < 4 ? 0.001 : 0.00115820323);
    }
    const invcal_positions p = positions(1e-4);
    found = base_at(34.74609375, 46.328125); /* -11.6 ... 81.1 */
    for (int i = 0; i < 3; i++) {
        found.nominal.matrix[i][i] = INVCAL_REAL(0.001);
    }
    for (unsigned degree = 0; degree < 2; degree++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_thermal_fit(&p, &prior, &found, degree, &found, &quality));
    }
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1, quality.dof);
}

static invcal_thermal_prior equal_prior(double sigma)
{
    invcal_thermal_prior prior = nothing_known;

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        hold(&prior, 0, r, sigma);
    }
    return prior;
}

/* Noise stated as a thousandth: the result is as if the true one had been stated. */
static void a_prior_counts_for_more_where_the_data_are_noisier_than_stated(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    const invcal_thermal_prior prior = equal_prior(0.01);
    random_source random = random_start(20);

    all.count = 0;
    take(&still, 25, PLAN, 1e-2, &random);
    take(&still, 25, PLAN, 1e-2, &random);
    fit_with_prior(1e-6, &prior, NULL);
    TEST_ASSERT_DOUBLE_WITHIN(4e-3, 1e-2, (double)quality.noise);
    TEST_ASSERT_TRUE(invcal_coverage(quality.dof) > 2);
    const invcal_thermal first = found;
    fit_with_prior(1e-2, &prior, NULL);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        const double sigma = (double)quality.sigma[r];
        TEST_ASSERT_DOUBLE_WITHIN(0.5 * sigma, (double)found.x[0][r], (double)first.x[0][r]);
    }
}

/* Readings without information: sigma is that of the prior, and X its centre. */
static void noise_as_large_as_the_field_leaves_everything_to_the_prior(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    const invcal_thermal_prior prior = equal_prior(0.01);
    random_source unused = random_start(0);

    all.count = 0;
    take(&still, 25, PLAN, 0, &unused);
    fit_with_prior(0.999, &prior, NULL);
    TEST_ASSERT_EQUAL_HEX16(0x1FF, from_prior(&prior));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* H'H is 6 at most, beside (0.42 / 0.01)^2 */
        TEST_ASSERT_DOUBLE_WITHIN(2e-5, 0.01, (double)quality.sigma[r]);
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0, (double)found.x[0][r]);
    }
}

static void an_invalid_prior_or_one_without_noise_is_refused(void)
{
    const double bad[] = {-1, NOT_A_NUMBER, INFINITE, 1e-44};
    const sensor s = straight(0);
    const invcal_thermal base = base_at(25, 45);
    random_source random = random_start(17);

    take_three(&s, 1e-4, &random);
    for (int i = 0; i < (DEGREE == 2 ? 12 : 8); i++) {
        invcal_thermal_prior prior = nothing_known;
        const invcal_positions p = positions(1e-4);
        prior.sigma[i / 4 > DEGREE ? 0 : i / 4][i % 9] = (invcal_real)bad[i % 4];
        if (INVCAL_DOUBLE && i % 4 == 3) {
            continue; /* in double its inverse is a number */
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_PRIOR,
                              invcal_thermal_fit(&p, &prior, &base, DEGREE, &found, &quality));
    }
    const invcal_thermal_prior prior = equal_prior(0.01);
    const invcal_positions p = positions(0);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE,
                          invcal_thermal_fit(&p, &prior, &base, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_thermal_judge(&p, &prior, &base, 25, &quality));
}

/* ---- an earlier calibration --------------------------------------------------------------- */

/* It is the base: a few positions at one temperature renew its constant, and its slopes hold where
 * they held before. */
static void renewing_at_one_temperature_keeps_the_slopes_and_the_range(void)
{
    const sensor s = straight(1);
    double moved[INVCAL_PARAMETERS];
    random_source random = random_start(15);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    take_three(&s, 1e-5, &random);
    fit_all(1e-4, 25, 45, DEGREE);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        moved[r] = s.constant[r] + (r < 3 ? 0.02 : 0);
    }
    const sensor aged = {moved, s.slope, NULL};
    all.count = 0;
    take(&aged, 34, PLAN, 1e-5, &random);
    const invcal_positions p = positions(1e-4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_thermal_fit(&p, NULL, &found, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_UINT(0, found.fitted);
    TEST_ASSERT_EQUAL_UINT(DEGREE, found.degree);
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_NARROW, found.fallback);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
    TEST_ASSERT_TRUE(found.min == -20 && found.max == 70);
    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, moved[r], (double)found.x[0][r]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, s.slope[r], (double)found.x[DEGREE > 0][r]);
    }
    /* beside the small slopes of S, by which delta is turned: 1e-3 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0, sqrt(square_error_of_range(&aged, -20, 70, NULL)));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_fit(&p, NULL, &found, 0, &found, &quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_THERMAL_AS_ASKED, found.fallback); /* no slopes were wanted */
}

/* The range of the stored calibration grows with the positions. */
static void renewing_beyond_the_range_widens_it(void)
{
    static const double at[2] = {-40, 95};
    const sensor s = straight(1);
    random_source random = random_start(18);

    if (DEGREE < 1) {
        TEST_IGNORE_MESSAGE("needs degree 1");
    }
    take_three(&s, 1e-5, &random);
    fit_all(1e-4, 25, 45, DEGREE);
    for (int i = 0; i < 2; i++) {
        all.count = 0;
        take(&s, at[i], PLAN, 1e-5, &random);
        const invcal_positions p = positions(1e-4);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_thermal_fit(&p, NULL, &found, 0, &found, &quality));
        TEST_ASSERT_EQUAL_UINT(DEGREE, found.degree);
        TEST_ASSERT_TRUE((double)found.min == -40 && (double)found.max == (i == 0 ? 70 : 95));
    }
}

static void temperatures_beyond_two_spans_are_refused(void)
{
    const sensor s = straight(0);
    const invcal_thermal base = base_at(25, 45);
    random_source random = random_start(16);
    static const double at[] = {115, -65, 116, -66};

    for (int i = 0; i < 4; i++) {
        take_three(&s, 1e-4, &random);
        all.temperature[3] = (invcal_real)at[i];
        const invcal_positions p = positions(1e-4);
        TEST_ASSERT_EQUAL_INT(i < 2 ? INVCAL_OK : INVCAL_BAD_TEMPERATURE,
                              invcal_thermal_fit(&p, NULL, &base, DEGREE, &found, &quality));
    }
}

/* All of them below zero, or above. */
static void the_range_is_that_of_the_temperatures_in_any_order(void)
{
    static const int order[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const sensor s = straight(2);
    random_source random = random_start(30);

    for (int k = 0; k < 12; k++) {
        const int from = k < 6 ? -40 : 20;
        all.count = 0;
        for (int i = 0; i < 3; i++) {
            take(&s, from + 10 * order[k % 6][i], PLAN, 1e-4, &random);
        }
        calibrate_all(1e-4);
        TEST_ASSERT_TRUE(found.min == (invcal_real)from);
        TEST_ASSERT_TRUE(found.max == (invcal_real)(from + 20));
        TEST_ASSERT_TRUE(found.reference == (invcal_real)(from + 10));
        TEST_ASSERT_TRUE(found.span == 10);
    }
}

static void the_order_of_the_positions_does_not_matter(void)
{
    const sensor s = straight(1);
    random_source random = random_start(28);

    take_three(&s, 1e-5, &random);
    calibrate_all(1e-4);
    const invcal_thermal rising = found;
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
    calibrate_all(1e-4);
    TEST_ASSERT_TRUE(found.min == rising.min && found.max == rising.max);
    TEST_ASSERT_TRUE(found.reference == rising.reference && found.span == rising.span);
    for (int a = 0; a <= DEGREE; a++) {
        for (int r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-12), (double)rising.x[a][r],
                                      (double)found.x[a][r]);
        }
    }
}

/* ---- what is refused ---------------------------------------------------------------------- */

static void unusable_arguments_are_named(void)
{
    const double bad[] = {-1, NOT_A_NUMBER, INFINITE, 1};
    const sensor s = straight(0);
    random_source random = random_start(17);
    invcal_calibration nominal = unit;
    invcal_thermal out;

    take_three(&s, 1e-4, &random);
    for (int i = 0; i < 4; i++) {
        assert_refused(INVCAL_BAD_NOISE, bad[i]);
    }
    for (int i = 1; i < 3; i++) {
        const invcal_real there = all.temperature[3];
        all.temperature[3] = (invcal_real)bad[i];
        assert_refused(INVCAL_BAD_TEMPERATURE, 1e-4);
        all.temperature[3] = there;
    }
    const invcal_thermal base = base_at(25, 45);
    invcal_positions p = positions(1e-4);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT,
                          invcal_thermal_fit(&p, NULL, &base, DEGREE + 1, &found, &quality));
    for (uint8_t degree = 0; degree <= 4; degree++) { /* that of the base must be one to fit, too */
        invcal_thermal of = base;
        of.degree = degree;
        TEST_ASSERT_EQUAL_INT(degree <= DEGREE ? INVCAL_OK : INVCAL_BAD_COUNT,
                              invcal_thermal_fit(&p, NULL, &of, 0, &out, &quality));
    }
    p.count = UINT16_MAX; /* which are not checked */
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT,
                          invcal_thermal_fit(&p, NULL, &base, DEGREE, &found, &quality));
    p.count = all.count;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT,
                          invcal_thermal_calibrate(&p, DEGREE + 1, &found, &quality));
    nominal.matrix[0][0] = 0;
    p.nominal = &nominal;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL,
                          invcal_thermal_calibrate(&p, DEGREE, &found, &quality));
    all.count = 0;
    assert_refused(INVCAL_TOO_FEW, 1e-4);
}

/* Wherever they are needed. */
static void positions_without_temperatures_are_refused(void)
{
    const sensor s = straight(0);
    const invcal_thermal base = base_at(25, 45);
    random_source random = random_start(17);

    take_three(&s, 1e-4, &random);
    invcal_positions p = positions(1e-4);
    p.temperature = NULL;
    memset(&found, 0x5A, sizeof found);
    memset(&quality, 0x5A, sizeof quality);
    const invcal_thermal before = found;
    const invcal_quality q_before = quality;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_TEMPERATURE,
                          invcal_thermal_calibrate(&p, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_TEMPERATURE,
                          invcal_thermal_fit(&p, NULL, &base, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_TEMPERATURE,
                          invcal_thermal_judge(&p, NULL, &base, 25, &quality));
    p.count = 0; /* nor are they needed of none */
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_thermal_calibrate(&p, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          invcal_thermal_fit(&p, NULL, &base, DEGREE, &found, &quality));
    TEST_ASSERT_EQUAL_MEMORY(&before, &found, sizeof found);
    TEST_ASSERT_EQUAL_MEMORY(&q_before, &quality, sizeof quality);
}

static void eight_positions_and_a_plane_are_refused_as_without_temperature(void)
{
    const sensor still = {expected_thermal_constant, NULL, NULL};
    random_source random = random_start(18);

    all.count = 0;
    take(&still, 20, 8, 1e-4, &random);
    assert_refused(INVCAL_TOO_FEW, 1e-4);
    for (int k = 0; k < 3; k++) { /* the first group, which lies in a plane */
        take(&still, 20 + 20 * k, 6, 1e-4, &random);
    }
    memmove(all.raw, all.raw + 24, 54 * sizeof *all.raw);
    memmove(all.temperature, all.temperature + 8, 18 * sizeof *all.temperature);
    all.count = 18;
    assert_refused(INVCAL_UNDETERMINED, 1e-4);
    all.count = 0;
    assert_refused(INVCAL_TOO_FEW, 1e-4);
}

static void an_invalid_reading_is_refused(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, 11, 0.01};
    const sensor s = straight(0);
    random_source random = random_start(22);

    for (int i = 0; i < 4; i++) {
        take_three(&s, 1e-4, &random);
        for (int k = 0; k < 3; k++) {
            all.raw[3 * 31 + k] = (invcal_real)(k == 1 ? bad[i] : 0);
        }
        assert_refused(i < 2 ? INVCAL_NOT_FINITE : INVCAL_OUT_OF_RANGE, 1e-4);
    }
}

/* Readings on a sphere about (0.5, 0, 0), and one next to its centre: of about the length of the
 * field at first, and of none once the centre is known. */
static void a_reading_that_is_absurd_once_it_is_calibrated_is_refused(void)
{
    const double offset[INVCAL_PARAMETERS] = {0.5};
    const sensor s = {offset, NULL, NULL};
    random_source random = random_start(23);

    all.count = 0;
    for (int i = 0; i < STATIONS; i++) {
        take(&s, 25, PLAN, 1e-4, &random);
    }
    all.raw[3 * 7] = (invcal_real)0.5;
    all.raw[3 * 7 + 1] = (invcal_real)0.02;
    all.raw[3 * 7 + 2] = 0;
    assert_refused(INVCAL_NOT_ELLIPSOID, 1e-4);
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
static void what_is_not_an_ellipsoid_at_some_temperature_is_refused(void)
{
    const double form[][STATIONS] = {
        {-0.5, -0.5, -0.5}, {-0.5, 0.25, 1}, {1, 0.25, -0.5}, {1, -0.5, 1}};
    const invcal_thermal_prior prior = equal_prior(1);
    random_source random = random_start(24);

    for (int i = 0; i < (DEGREE == 0 ? 1 : DEGREE == 1 ? 3 : 4); i++) {
        all.count = 0;
        for (int station = 0; station < STATIONS; station++) {
            take_quadric(form[i][station], -20 + 45 * station, &random);
        }
        assert_refused(INVCAL_NOT_ELLIPSOID, 1e-4);
        assert_refused_with_prior(INVCAL_NOT_ELLIPSOID, 1e-4, &prior);
    }
}

/* The same with a sensor in a plane, and noise: what is left open may take any shape, and is no
 * fault of the readings. */
static void a_plane_with_noise_is_undetermined_rather_than_no_ellipsoid(void)
{
    random_source random = random_start(25);

    for (int draw = 0; draw < SOME(20); draw++) {
        all.count = 0;
        for (unsigned i = 0; i < PLAN; i++, all.count++) {
            const double angle = random_uniform(&random, 0, 6.283185307179586);
            all.raw[3 * i] = (invcal_real)cos(angle);
            all.raw[3 * i + 1] = (invcal_real)sin(angle);
            all.raw[3 * i + 2] = (invcal_real)(0.02 * random_normal(&random));
            all.temperature[i] = 25;
        }
        assert_refused(INVCAL_UNDETERMINED, 0);
    }
}

/* Six faces and twelve edges, but those between x and y are all at +x and only `tilt` off it. */
static void take_with_a_hidden_angle(double tilt)
{
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
}

/* The pivot of gamma_xy is 4 tilt^2, the largest diagonal element 8, the largest eigenvalue 11.5:
 * between the two no pivot shows it, the condition does. */
static void an_angle_that_hardly_shows_is_refused_unless_a_prior_holds_it(void)
{
    const double tilt = FLOAT_OR_DOUBLE(2.14e-3, 1.55e-4);
    invcal_thermal_prior prior = nothing_known;

    take_with_a_hidden_angle(tilt);
    assert_refused(INVCAL_UNDETERMINED, 1e-6);
    assert_refused_with_prior(INVCAL_UNDETERMINED, 1e-6, &prior); /* which has no information */
    hold(&prior, 0, INVCAL_GAMMA_XY, 1e-4);
    fit_with_prior(1e-6, &prior, NULL);
    TEST_ASSERT_EQUAL_HEX16(1u << INVCAL_GAMMA_XY, from_prior(&prior));
    const double share =
        (double)quality.sigma[INVCAL_GAMMA_XY] / 1e-4; /* that it left to the prior */
    const double data = beside_none(1e-6, 9 + share * share) / (2 * tilt);
    const double both = 1 / sqrt(1 / 1e-8 + 1 / (data * data));
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * both, both, (double)quality.sigma[INVCAL_GAMMA_XY]);
}

/* However much wider than the noise: the prior alone never makes the system singular. */
static void what_only_a_prior_determines_has_its_sigma(void)
{
    invcal_thermal_prior prior = nothing_known;

    take_with_a_hidden_angle(0);
    hold(&prior, 0, INVCAL_GAMMA_XY, 0.01);
    fit_with_prior(1e-6, &prior, NULL);
    TEST_ASSERT_EQUAL_HEX16(1u << INVCAL_GAMMA_XY, from_prior(&prior));
    TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0.01, (double)quality.sigma[INVCAL_GAMMA_XY]);
}

/* sqrt(K) of gamma_xy is 1 / (2 tilt) = 1700, 1000 the limit. */
static void a_prior_on_one_parameter_is_none_on_another(void)
{
    invcal_thermal_prior prior = nothing_known;

    take_with_a_hidden_angle(3e-4);
    hold(&prior, 0, INVCAL_DELTA_X, 0.1);
    assert_refused_with_prior(INVCAL_UNDETERMINED, 1e-6, &prior);
}

/* A sensor of a fifth of the scale, and a prior that knows better by 800 sigma. The residuals say
 * how noisy the readings are; weighed again it takes more away than is there. */
static void an_irreconcilable_prior_is_refused(void)
{
    const double scale[INVCAL_PARAMETERS] = {0, 0, 0, -0.8, -0.8, -0.8};
    const sensor s = {scale, NULL, NULL};
    const invcal_thermal_prior prior = equal_prior(1e-3);
    random_source random = random_start(26);

    all.count = 0;
    take(&s, 25, PLAN, 6e-3, &random);
    calibrate_all(1e-5);
    assert_refused_with_prior(INVCAL_NOT_ELLIPSOID, 1e-5, &prior);
}

/* Lengths of 0.7 and 1.3: a sphere fits between them, but no sensor reads like that. */
static void readings_of_two_fields_are_refused_though_a_prior_solves_them(void)
{
    const sensor s = straight(0);
    const invcal_thermal_prior prior = equal_prior(1e-3);
    random_source random = random_start(27);

    all.count = 0;
    take(&s, 25, PLAN, 0, &random);
    for (unsigned i = 0; i < 3 * all.count; i++) {
        all.raw[i] *= (i / 3) % 2 ? INVCAL_REAL(0.7) : INVCAL_REAL(1.3);
    }
    assert_refused_with_prior(INVCAL_NOT_ELLIPSOID, 0.5, &prior);
}

/* A base whose x axis is 5 times the nominal one, and readings that are 3 times as long still. */
static void semi_axes_beyond_their_limits_are_refused_together(void)
{
    random_source unused = random_start(0);
    invcal_thermal out;

    for (int i = 0; i < 2; i++) {
        const double dk = (i ? 3 : 1.8) * 5 - 1; /* 15 or 9, 10 the limit */
        const double longer[INVCAL_PARAMETERS] = {0, 0, 0, dk};
        const sensor s = {longer, NULL, NULL};
        invcal_thermal base = base_at(25, 45);
        all.count = 0;
        take(&s, 25, PLAN, 0, &unused);
        base.x[0][INVCAL_DK_X] = 4;
        memset(&out, 0x5A, sizeof out);
        const invcal_thermal before = out;
        const invcal_positions p = positions(1e-4);
        TEST_ASSERT_EQUAL_INT(i ? INVCAL_NOT_ELLIPSOID : INVCAL_OK,
                              invcal_thermal_fit(&p, NULL, &base, DEGREE, &out, &quality));
        if (i) {
            TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
        } else {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-11), dk,
                                      (double)out.x[0][INVCAL_DK_X]);
        }
    }
}

static void assert_not_judged(invcal_status expected, const invcal_positions *p, double temperature)
{
    invcal_quality q;
    invcal_quality before;

    memset(&q, 0x5A, sizeof q);
    before = q;
    TEST_ASSERT_EQUAL_INT(expected,
                          invcal_thermal_judge(p, NULL, &found, (invcal_real)temperature, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

static void what_cannot_be_judged_is_refused_and_the_quality_left_alone(void)
{
    const double scale[INVCAL_PARAMETERS] = {0, 0, 0, 0.2, 0.2, 0.2};
    const sensor s = {scale, NULL, NULL};
    random_source random = random_start(27);

    take_three(&s, 1e-4, &random);
    invcal_positions p = positions(1e-4);
    found = base_at(25, 45);
    assert_not_judged(INVCAL_NOT_ELLIPSOID, &p, 25); /* as they are read: a fifth too long */
    fit_all(1e-4, 25, 45, DEGREE);
    assert_not_judged(INVCAL_BAD_TEMPERATURE, &p, NOT_A_NUMBER);
    assert_not_judged(INVCAL_BAD_TEMPERATURE, &p, INFINITE);
    p.noise = -1;
    assert_not_judged(INVCAL_BAD_NOISE, &p, 25);
    p.noise = 0;
    p.count = 0;
    assert_not_judged(INVCAL_TOO_FEW, &p, 25);
    p.count = all.count;
    all.raw[7] = (invcal_real)NAN;
    assert_not_judged(INVCAL_NOT_FINITE, &p, 25);
    all.raw[7] = 1;
    found.fitted = DEGREE + 1; /* damaged */
    assert_not_judged(INVCAL_BAD_COUNT, &p, 25);
}

/* ---- words ------------------------------------------------------------------------------------- */

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
                             invcal_thermal_fallback_text(INVCAL_THERMAL_OPEN + 1));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(slopes_of_a_sensor_without_noise_come_out);
    RUN_SLOW_TEST(two_solves_leave_nothing_that_matters_of_steep_slopes);
    RUN_LONG_TEST(two_solves_leave_as_little_of_steep_slopes_of_any_signs);
    RUN_TEST(no_base_is_the_nominal_calibration_at_all_temperatures);
    RUN_TEST(a_part_of_the_span_and_a_bad_nominal_are_as_good);
    RUN_LONG_TEST(the_error_is_the_cramer_rao_bound_and_that_of_nine_parameters_hundreds_of_it);
    RUN_LONG_TEST(a_bent_sensor_comes_to_the_bound_of_27_parameters);
    RUN_TEST(at_one_temperature_there_are_no_slopes_and_it_says_so);
    RUN_TEST(two_temperatures_half_a_kelvin_apart_give_no_slopes_and_it_says_so);
    RUN_TEST(too_few_positions_for_slopes_are_enough_for_fewer);
    RUN_TEST(what_the_positions_leave_open_is_left_out_and_named);
    RUN_TEST(slopes_that_pass_for_other_errors_are_not_called_good);
    RUN_TEST(slopes_of_a_small_part_of_the_span_are_open);
    RUN_TEST(a_lower_degree_is_fitted_where_it_is_wanted);
    RUN_TEST(outside_the_observed_range_the_edge_is_held_and_reported);
    RUN_TEST(what_is_not_a_temperature_is_refused_and_nothing_written);
    RUN_TEST(a_damaged_calibration_is_refused_at_any_temperature);
    RUN_TEST(what_is_not_a_triad_is_refused_at_any_temperature);
    RUN_TEST(raw_counts_give_the_right_lengths_at_every_temperature);
    RUN_TEST(a_calibration_of_any_degree_holds_in_every_build);
    RUN_LONG_TEST(sigma_at_every_temperature_is_that_of_the_error);
    RUN_TEST(sigma_of_a_line_has_its_closed_form);
    RUN_TEST(beyond_the_range_it_is_judged_at_its_edge);
    RUN_TEST(the_judgement_counts_coefficients_and_names_the_worst_position);
    RUN_TEST(what_is_weak_anywhere_is_weak);
    RUN_TEST(a_prior_on_slopes_holds_what_one_temperature_leaves_open);
    RUN_TEST(a_slope_prior_alone_is_enough_at_a_constant_temperature);
    RUN_TEST(a_prior_shrinks_and_counts_by_the_closed_form);
    RUN_TEST(rounding_gives_no_degree_of_freedom);
    RUN_TEST(a_prior_counts_for_more_where_the_data_are_noisier_than_stated);
    RUN_TEST(noise_as_large_as_the_field_leaves_everything_to_the_prior);
    RUN_TEST(an_invalid_prior_or_one_without_noise_is_refused);
    RUN_TEST(renewing_at_one_temperature_keeps_the_slopes_and_the_range);
    RUN_TEST(renewing_beyond_the_range_widens_it);
    RUN_TEST(temperatures_beyond_two_spans_are_refused);
    RUN_TEST(the_range_is_that_of_the_temperatures_in_any_order);
    RUN_TEST(the_order_of_the_positions_does_not_matter);
    RUN_TEST(unusable_arguments_are_named);
    RUN_TEST(positions_without_temperatures_are_refused);
    RUN_TEST(eight_positions_and_a_plane_are_refused_as_without_temperature);
    RUN_TEST(an_invalid_reading_is_refused);
    RUN_TEST(a_reading_that_is_absurd_once_it_is_calibrated_is_refused);
    RUN_TEST(what_is_not_an_ellipsoid_at_some_temperature_is_refused);
    RUN_TEST(a_plane_with_noise_is_undetermined_rather_than_no_ellipsoid);
    RUN_TEST(what_only_a_prior_determines_has_its_sigma);
    RUN_TEST(an_angle_that_hardly_shows_is_refused_unless_a_prior_holds_it);
    RUN_TEST(a_prior_on_one_parameter_is_none_on_another);
    RUN_TEST(readings_of_two_fields_are_refused_though_a_prior_solves_them);
    RUN_TEST(an_irreconcilable_prior_is_refused);
    RUN_TEST(semi_axes_beyond_their_limits_are_refused_together);
    RUN_TEST(what_cannot_be_judged_is_refused_and_the_quality_left_alone);
    RUN_TEST(every_fallback_has_its_words);
    return UNITY_END() != 0;
}
