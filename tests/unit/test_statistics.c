/* SPDX-License-Identifier: MIT
 *
 * The library's claims about its own errors, tested with thousands of noisy draws.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expected.h"
#include "invcal/result.h"
#include "support.h"
#include "unity.h"

/* Slow machines may use fewer; the bounds below are for these numbers. */
#ifndef SPREAD_DRAWS
#define SPREAD_DRAWS 8000
#endif
#ifndef DRAWS
#define DRAWS 2000
#endif

void setUp(void)
{
}

void tearDown(void)
{
}

static const double sizes[3] = {0.001, 0.03, 0.1};

/* The truth for which the reference gives the Cramer-Rao bound. */
static triad_truth reference_truth(double size)
{
    static const double sign[9] = {1, -1, 1, 1, -1, 1, -1, 1, -1};
    triad_truth truth;

    for (int r = 0; r < 9; r++) {
        truth.x[r] = size * sign[r];
    }
    return truth;
}

typedef struct {
    double spread[9]; /* root mean square error of each parameter */
    double sigma[9];  /* root mean square of its reported sigma */
    double good;      /* share of the draws */
} spread_result;

static spread_result measure_spread(const triad_truth *truth, double sigma, double stated)
{
    random_source random = random_start(1);
    spread_result result = {{0}, {0}, 0};

    for (int draw = 0; draw < SPREAD_DRAWS; draw++) {
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        read_positions(truth, expected_plan18, 18, sigma, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, stated, &calibration, &quality));
        result.good += quality.verdict == INVCAL_GOOD ? 1.0 / SPREAD_DRAWS : 0;
        for (unsigned r = 0; r < 9; r++) {
            const double error = parameter(&calibration, r) - truth->x[r];
            const double s = (double)quality.sigma[r];
            result.spread[r] += error * error;
            result.sigma[r] += s * s;
        }
    }
    for (unsigned r = 0; r < 9; r++) {
        result.spread[r] = sqrt(result.spread[r] / SPREAD_DRAWS);
        result.sigma[r] = sqrt(result.sigma[r] / SPREAD_DRAWS);
    }
    return result;
}

static void the_spread_is_the_cramer_rao_bound_and_sigma_says_so(void)
{
    for (int i = 0; i < 6; i++) {
        const double sigma = i % 2 ? 1e-3 : 1e-4;
        const triad_truth truth = reference_truth(sizes[i / 2]);
        const spread_result s = measure_spread(&truth, sigma, 0);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1, s.good);
        for (unsigned r = 0; r < 9; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, s.spread[r] / (sigma * expected_crb[i / 2][r]));
            TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, s.sigma[r] / s.spread[r]);
        }
    }
}

/* A noise that is stated, and true, counts as four residuals beside nine, but in the one draw of 20
 * whose chi^2 exceeds 16.9: that makes E sigma^2 1 + (4/117) E (chi^2 - 9; chi^2 > 16.9) = 1.0186.
 * In three draws of a thousand it exceeds what noise can be. */
static void a_stated_noise_that_is_true_leaves_sigma_right(void)
{
    const triad_truth truth = reference_truth(0.1);
    const spread_result s = measure_spread(&truth, 1e-3, 1e-3);

    TEST_ASSERT_DOUBLE_WITHIN(0.002, 0.997, s.good);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.03, 1.009, s.sigma[r] / s.spread[r]);
    }
}

typedef struct {
    unsigned refused;
    unsigned good;
    unsigned beyond5; /* good draws with an error of more than 5 sigma in any parameter */
    unsigned covered; /* parameters of good draws within their 95 % interval */
} tally;

static tally try_random_sets(unsigned positions, double stated, unsigned draws)
{
    random_source random = random_start(positions);
    tally t = {0, 0, 0, 0};

    for (unsigned draw = 0; draw < draws; draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[18][3];
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        for (unsigned i = 0; i < positions; i++) {
            random_direction(&random, v[i]);
        }
        read_positions(&truth, (const double(*)[3])v, positions, 1e-3, &random, &set);
        if (calibrate_set(&set, stated, &calibration, &quality) != INVCAL_OK) {
            t.refused++;
            continue;
        }
        if (quality.verdict != INVCAL_GOOD) {
            continue;
        }
        t.good++;
        double worst = 0;
        for (unsigned r = 0; r < 9; r++) {
            const double error = fabs(parameter(&calibration, r) - truth.x[r]);
            const double ratio = error / (double)quality.sigma[r];
            worst = larger(worst, ratio);
            t.covered += ratio <= (double)invcal_coverage(quality.sigma_dof);
        }
        t.beyond5 += !(worst <= 5);
    }
    return t;
}

static void random_sets_are_good_only_when_they_are(void)
{
    static const unsigned positions[] = {9, 10, 12, 18};
    static const double refused[] = {0.12, 0.015, 0.002, 0};

    for (int i = 0; i < 4; i++) {
        const tally t = try_random_sets(positions[i], 1e-3, DRAWS);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(refused[i], (double)t.refused / DRAWS);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.002, (double)t.beyond5 / (t.good + 1e-9));
        /* Nine positions are never good: nothing checks them. */
        TEST_ASSERT_TRUE(positions[i] == 9 ? t.good == 0 : t.good > DRAWS / 20);
    }
}

static void without_stated_noise_intervals_follow_student(void)
{
    static const unsigned positions[] = {10, 12, 18};

    for (int i = 0; i < 3; i++) {
        const tally t = try_random_sets(positions[i], 0, 4 * DRAWS);
        TEST_ASSERT_DOUBLE_WITHIN(0.015, 0.95, t.covered / (9.0 * t.good));
    }
}

/* The cases of the comparison in port/manual/evidence.md: 200 draws, noise 1e-4, errors of 3 %. */
typedef struct {
    unsigned refused, weak, good;
    double error; /* median over delivered draws of that of the worst parameter */
    double sigma; /* median of the largest sigma */
} outcome;

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

static double median(double *x, unsigned count)
{
    qsort(x, count, sizeof *x, by_size);
    return count ? x[count / 2] : 0;
}

typedef void (*position_maker)(random_source *random, double v[][3], unsigned *count);

static outcome try_case(position_maker make, double outlier, double bad)
{
    random_source random = random_start(1);
    outcome result = {0, 0, 0, 0, 0};
    double error[200];
    double sigma[200];
    unsigned delivered = 0;

    for (int draw = 0; draw < 200; draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[18][3];
        double direction[3];
        unsigned count;
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        make(&random, v, &count);
        read_positions(&truth, (const double(*)[3])v, count, 1e-4, &random, &set);
        random_direction(&random, direction);
        for (int k = 0; k < 3; k++) {
            set.u[draw % (int)count][k] += (invcal_real)(outlier * direction[k] + bad);
        }
        if (calibrate_set(&set, 0, &calibration, &quality) != INVCAL_OK) {
            result.refused++;
            continue;
        }
        result.weak += quality.verdict == INVCAL_WEAK;
        result.good += quality.verdict == INVCAL_GOOD;
        error[delivered] = 0;
        sigma[delivered] = 0;
        for (unsigned r = 0; r < 9; r++) {
            const double e = fabs(parameter(&calibration, r) - truth.x[r]);
            error[delivered] = larger(error[delivered], e);
            sigma[delivered] = larger(sigma[delivered], (double)quality.sigma[r]);
        }
        delivered++;
    }
    result.error = median(error, delivered);
    result.sigma = median(sigma, delivered);
    return result;
}

static void eight_positions(random_source *random, double v[][3], unsigned *count)
{
    *count = 8;
    for (int i = 0; i < 8; i++) {
        random_direction(random, v[i]);
    }
}

static void six_faces(random_source *random, double v[][3], unsigned *count)
{
    (void)random;
    *count = 6;
    memset(v, 0, 6 * sizeof v[0]);
    for (int i = 0; i < 6; i++) {
        v[i][i % 3] = i < 3 ? 1 : -1;
    }
}

/* Positions spread over circles at the heights given, from a random side. */
static void circles(random_source *random, const double *height, int heights, int count,
                    double v[][3])
{
    double side[3][3];

    random_rotation(random, side);
    for (int i = 0; i < count; i++) {
        const double z = height[i % heights];
        const double angle = random_uniform(random, 0, 6.283185307179586);
        for (int k = 0; k < 3; k++) {
            v[i][k] = z * side[2][k] +
                      sqrt(1 - z * z) * (cos(angle) * side[0][k] + sin(angle) * side[1][k]);
        }
    }
}

static void one_plane(random_source *random, double v[][3], unsigned *count)
{
    const double height = 0;

    *count = 18;
    circles(random, &height, 1, 18, v);
}

static void two_circles(random_source *random, double v[][3], unsigned *count)
{
    const double height[2] = {random_uniform(random, -0.9, 0), random_uniform(random, 0, 0.9)};

    *count = 12;
    circles(random, height, 2, 12, v);
}

static void program_of_18(random_source *random, double v[][3], unsigned *count)
{
    (void)random;
    *count = 18;
    memcpy(v, expected_plan18, sizeof expected_plan18);
}

static void the_comparison_in_the_readme_is_true(void)
{
    TEST_ASSERT_EQUAL_UINT(200, try_case(eight_positions, 0, 0).refused);
    TEST_ASSERT_EQUAL_UINT(200, try_case(six_faces, 0, 0).refused);
    TEST_ASSERT_EQUAL_UINT(200, try_case(one_plane, 0, 0).refused);
    const outcome circle = try_case(two_circles, 0, 0);
    TEST_ASSERT_EQUAL_UINT(200, circle.refused + circle.weak);
    TEST_ASSERT_TRUE(circle.refused >= 190);
    TEST_ASSERT_EQUAL_UINT(200, try_case(program_of_18, 0, NOT_A_NUMBER).refused);
    const outcome wrong = try_case(program_of_18, 0.05, 0);
    TEST_ASSERT_EQUAL_UINT(200, wrong.good);
    TEST_ASSERT_DOUBLE_WITHIN(0.5e-3, 9.5e-3, wrong.error);
    TEST_ASSERT_DOUBLE_WITHIN(0.5e-3, 7.2e-3, wrong.sigma);
}

static invcal_status calibrate_with_prior(const reading_set *set, double noise,
                                          const double prior[9], invcal_calibration *calibration,
                                          invcal_quality *quality)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real sigma[INVCAL_PARAMETERS];

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        sigma[r] = (invcal_real)prior[r];
    }
    return invcal_calibrate_prior(POSITIONS_OF(set->u[0], set->count, &nominal, (invcal_real)noise),
                                  sigma, calibration, quality);
}

/* A device that can only be tilted by 10 degrees, with factory tolerances as prior. */
static void tilts_alone_with_a_prior(double noise, double stated, double *covered, unsigned *held)
{
    static const double sigma[9] = {0.02, 0.02, 0.02, 0.01, 0.01, 0.01, 0.03, 0.03, 0.03};
    random_source random = random_start(1);
    unsigned within = 0;

    *held = 0;
    for (int draw = 0; draw < DRAWS; draw++) {
        triad_truth truth;
        double v[12][3];
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        for (int r = 0; r < 9; r++) {
            truth.x[r] = sigma[r] * random_normal(&random);
        }
        for (int i = 0; i < 12; i++) {
            const double tilt = random_uniform(&random, 0, 10) / 57.29577951308232;
            const double azimuth = random_uniform(&random, 0, 6.283185307179586);
            v[i][0] = sin(tilt) * cos(azimuth);
            v[i][1] = sin(tilt) * sin(azimuth);
            v[i][2] = cos(tilt);
        }
        read_positions(&truth, (const double(*)[3])v, 12, noise, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              calibrate_with_prior(&set, stated, sigma, &calibration, &quality));
        for (unsigned r = 0; r < 9; r++) {
            const double s = (double)quality.sigma[r];
            TEST_ASSERT_LESS_OR_EQUAL_DOUBLE((double)(invcal_real)sigma[r], s);
            within += fabs(parameter(&calibration, r) - truth.x[r]) <= 3 * s;
        }
        *held |= quality.held;
        TEST_ASSERT_TRUE(quality.held != 0x1FF); /* the data determined something */
    }
    *covered = within / (9.0 * DRAWS);
}

static void a_prior_holds_what_tilts_alone_cannot_determine(void)
{
    static const double noise[] = {1e-4, 1e-3};

    for (int i = 0; i < 2; i++) {
        double covered;
        unsigned held;
        tilts_alone_with_a_prior(noise[i], noise[i], &covered, &held);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.99, covered);
        TEST_ASSERT_TRUE(held != 0);
    }
}

/* The residuals show ten times the stated noise: the prior gets more weight. */
static void a_prior_is_not_overruled_by_understated_noise(void)
{
    double covered;
    unsigned held;

    tilts_alone_with_a_prior(1e-3, 1e-4, &covered, &held);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.985, covered);
}

/* Priors so wide that they hardly matter, and a stated noise that is far too small: the residuals
 * show the noise, and that it is rough, so intervals are Student's anyway. */
static void intervals_follow_student_with_a_prior_too(void)
{
    static const unsigned positions[] = {10, 12, 18};
    random_source random = random_start(1);

    for (int i = 0; i < 3; i++) {
        unsigned covered = 0;
        unsigned solved = 0;
        unsigned rough = 0;
        for (int draw = 0; draw < 2 * DRAWS; draw++) {
            static const double prior[9] = {0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3};
            const triad_truth truth = triad_random(&random, 0.03);
            double v[18][3];
            reading_set set;
            invcal_calibration calibration;
            invcal_quality quality;
            for (unsigned k = 0; k < positions[i]; k++) {
                random_direction(&random, v[k]);
            }
            read_positions(&truth, (const double(*)[3])v, positions[i], 1e-3, &random, &set);
            if (calibrate_with_prior(&set, 1e-5, prior, &calibration, &quality) != INVCAL_OK ||
                quality.weak != 0 || quality.dof == 0) {
                continue;
            }
            solved++;
            rough += quality.verdict == INVCAL_ROUGH;
            const double coverage = (double)invcal_coverage(quality.sigma_dof);
            for (unsigned r = 0; r < 9; r++) {
                const double error = fabs(parameter(&calibration, r) - truth.x[r]);
                covered += error <= coverage * (double)quality.sigma[r];
            }
        }
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.935, covered / (9.0 * solved));
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.95, (double)rough / solved);
    }
}

/* One wide prior must not make the narrow ones win against good data. */
static void a_wide_prior_does_not_hurt_the_others(void)
{
    random_source random = random_start(1);
    double squares = 0;
    int draws = 500;

    for (int draw = 0; draw < draws; draw++) {
        static const double prior[9] = {10, 10, 10, 10, 10, 10, 1e-3, 1e-3, 1e-3};
        triad_truth truth = triad_random(&random, 0.03);
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        for (unsigned r = 6; r < 9; r++) {
            truth.x[r] = 1e-3 * random_normal(&random);
        }
        read_positions(&truth, expected_plan18, 18, 1e-4, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              calibrate_with_prior(&set, 1e-4, prior, &calibration, &quality));
        for (unsigned r = 6; r < 9; r++) {
            const double error = parameter(&calibration, r) - truth.x[r];
            squares += error * error;
        }
    }
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.3e-4, sqrt(squares / (3 * draws)));
}

/* Offsets in counts, behind a nominal matrix that is turned and skewed. */
static void offsets_spread_as_reported_whatever_the_nominal(void)
{
    static const double t[3][3] = {{80, 30, -20}, {-35, 60, 50}, {20, -40, 120}};
    random_source random = random_start(1);
    const triad_truth truth = triad_random(&random, 0.03);
    invcal_calibration nominal = unit_nominal();
    double inverse[3][3];
    double spread[3] = {0};
    double sigma[3] = {0};

    inverse3(t, inverse);
    for (int i = 0; i < 9; i++) {
        nominal.matrix[i / 3][i % 3] = (invcal_real)inverse[i / 3][i % 3];
    }
    for (int draw = 0; draw < SPREAD_DRAWS; draw++) {
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        invcal_real s[3];
        read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
        for (unsigned i = 0; i < 18; i++) { /* u to counts */
            const double u[3] = {(double)set.u[i][0], (double)set.u[i][1], (double)set.u[i][2]};
            for (int k = 0; k < 3; k++) {
                set.u[i][k] = (invcal_real)(t[k][0] * u[0] + t[k][1] * u[1] + t[k][2] * u[2]);
            }
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_calibrate_plain(POSITIONS_OF(set.u[0], 18, &nominal, 0),
                                                     &calibration, &quality));
        invcal_sigma_offset(&quality, &nominal, s);
        for (int k = 0; k < 3; k++) {
            const double *d = truth.x;
            const double offset = t[k][0] * d[0] + t[k][1] * d[1] + t[k][2] * d[2];
            const double error = (double)calibration.offset[k] - offset;
            spread[k] += error * error;
            sigma[k] += (double)(s[k] * s[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, sqrt(sigma[k] / spread[k]));
    }
}

/* An earlier calibration as nominal; three positions; only the offsets have changed, by 5 mg. */
static void three_positions_renew_the_offsets_of_an_earlier_calibration(void)
{
    static const double known[9] = {0.02, 0.02, 0.02, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4};
    invcal_real prior[9];
    random_source random = random_start(1);
    unsigned within = 0;

    for (int r = 0; r < 9; r++) {
        prior[r] = (invcal_real)known[r];
    }
    for (int draw = 0; draw < DRAWS; draw++) {
        const triad_truth truth = triad_random(&random, 0.05);
        triad_truth moved = truth;
        reading_set set;
        invcal_calibration earlier;
        invcal_calibration calibration;
        invcal_quality quality;
        double shift[3];
        read_positions(&truth, expected_plan18, 18, 0, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_set(&set, 1e-4, &earlier, &quality));
        for (int k = 0; k < 3; k++) {
            shift[k] = 5e-3 * random_normal(&random);
            moved.x[k] += shift[k];
        }
        double v[3][3];
        random_rotation(&random, v); /* any three directions at right angles */
        read_positions(&moved, (const double(*)[3])v, 3, 1e-4, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibrate_prior(
                                             POSITIONS_OF(set.u[0], 3, &earlier, (invcal_real)1e-4),
                                             prior, &calibration, &quality));
        TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, quality.verdict);
        TEST_ASSERT_EQUAL_HEX16(0x1F8, quality.held); /* scale and angles: not new */
        const triad_truth found = truth_of(&calibration, &earlier);
        invcal_real sigma[3];
        invcal_sigma_offset(&quality, &earlier, sigma);
        for (int k = 0; k < 3; k++) {
            const double error =
                (double)calibration.offset[k] - (double)earlier.offset[k] - shift[k];
            within += fabs(error) <= 3 * (double)sigma[k];
            TEST_ASSERT_DOUBLE_WITHIN(5e-4, 0, found.x[3 + k]);
            TEST_ASSERT_DOUBLE_WITHIN(5e-4, 0, found.x[6 + k]);
            TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(4e-4, (double)sigma[k]);
        }
    }
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.99, within / (3.0 * DRAWS));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_LONG_TEST(the_spread_is_the_cramer_rao_bound_and_sigma_says_so);
    RUN_LONG_TEST(a_stated_noise_that_is_true_leaves_sigma_right);
    RUN_LONG_TEST(random_sets_are_good_only_when_they_are);
    RUN_LONG_TEST(without_stated_noise_intervals_follow_student);
    RUN_SLOW_TEST(the_comparison_in_the_readme_is_true);
    RUN_LONG_TEST(a_prior_holds_what_tilts_alone_cannot_determine);
    RUN_LONG_TEST(a_prior_is_not_overruled_by_understated_noise);
    RUN_LONG_TEST(intervals_follow_student_with_a_prior_too);
    RUN_LONG_TEST(a_wide_prior_does_not_hurt_the_others);
    RUN_LONG_TEST(offsets_spread_as_reported_whatever_the_nominal);
    RUN_LONG_TEST(three_positions_renew_the_offsets_of_an_earlier_calibration);
    return UNITY_END() != 0;
}
