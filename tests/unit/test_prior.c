/* SPDX-License-Identifier: MIT
 *
 * Priors. How often their intervals hold the truth is in test_statistics.c.
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

typedef struct {
    invcal_calibration calibration;
    invcal_quality quality;
} outcome;

static invcal_status calibrate(const reading_set *set, double noise, const double prior[9],
                               outcome *out)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real sigma[INVCAL_PARAMETERS];

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        sigma[r] = (invcal_real)prior[r];
    }
    return invcal_calibrate_prior(POSITIONS_OF(set->u[0], set->count, &nominal, (invcal_real)noise),
                                  sigma, &out->calibration, &out->quality);
}

static const double equal[9] = {0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01};
static const double of_angles[9] = {0, 0, 0, 0, 0, 0, 0.01, 0.01, 0.01};
static const double faces[6][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                   {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

/* With a prior for only some parameters, there must be as many positions as others. */
static void a_partial_prior_needs_as_many_positions_as_it_leaves_open(void)
{
    random_source random = random_start(1);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;
    outcome o;

    read_positions(&truth, faces, 6, 1e-4, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-4, of_angles, &o));
    TEST_ASSERT_EQUAL_HEX16(0x1C0, o.quality.held);
    TEST_ASSERT_EQUAL_UINT(6, o.quality.positions);
    set.count = 5;
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, calibrate(&set, 1e-4, of_angles, &o));
    set.count = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, calibrate(&set, 1e-4, equal, &o));
}

/* Readings so exact that the prior is 2000 times their noise: a parameter held only by the prior
 * has a K that would be singular without it. */
static void what_a_prior_holds_is_never_hopeless(void)
{
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;
    outcome o;

    read_positions(&truth, faces, 6, 5e-6, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 5e-6, of_angles, &o));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, o.quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, o.quality.held);
    for (unsigned r = INVCAL_GAMMA_XY; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, 0.01, (double)o.quality.sigma[r]);
    }
}

/* Six faces of an ideal sensor give H'H = diag(2 2 2 2 2 2 0 0 0), and noise of a tenth of the prior adds 0.01 for
 * each angle. The traces are 12.03 and, of the inverse, 303. */
static void the_condition_counts_the_rows_of_the_prior(void)
{
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    reading_set set;
    outcome o;

    read_positions(&none, faces, 6, 0, &unused, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-3, of_angles, &o));
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 12.03 * 303, (double)o.quality.condition);
}

/* A prior of many fields says nothing, and the noise that it would be resolved beside is no noise of a
 * reading: what it alone holds is weak, however often it is solved. */
static void an_absurdly_wide_prior_is_weak(void)
{
    static const double wide[9] = {0, 0, 0, 0, 0, 0, 1e8, 1e8, 1e8};
    random_source random = random_start(6);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;
    outcome o;

    if (INVCAL_DOUBLE) {
        TEST_IGNORE_MESSAGE("double tells so wide a prior from nothing known, and refuses");
    }
    read_positions(&truth, faces, 6, 1e-4, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-4, wide, &o));
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, o.quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(0x1C0, o.quality.held & 0x1C0);
    TEST_ASSERT_TRUE((double)o.quality.noise >= 1);
}

/* A parameter that neither the prior nor the positions determine is refused as always. */
static void what_no_prior_holds_may_be_hopeless(void)
{
    static const double of_offsets[9] = {0.01, 0.01, 0.01, 0, 0, 0, 0, 0, 0};
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    reading_set set;
    outcome o;

    read_positions(&none, faces, 6, 0, &unused, &set);
    for (unsigned i = 6; i < 12; i++) {
        memcpy(set.u[i], set.u[i - 6], sizeof set.u[i]);
    }
    set.count = 12;
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, calibrate(&set, 1e-4, of_offsets, &o));
}

/* Six faces and edges that show gamma_xy by `tilt` only, which no prior holds: at some tilt it is no
 * more than rounding, once in the first pass, once in the second. Either is a refusal. */
static void what_hardly_shows_is_solved_or_refused_as_open(void)
{
    static const double of_offsets[9] = {0.01, 0.01, 0.01, 0, 0, 0, 0, 0, 0};
    double directions[12][3];
    const triad_truth truth = {{0.001, 0, 0, 0.002, 0, 0, 0, 0, 0.003}};
    random_source unused = random_start(0);
    unsigned solved = 0;
    reading_set set;
    outcome o;
    outcome before;

    for (unsigned step = 0; step < SOME(4000); step++) {
        const double tilt = pow(10, -5 + 4 * (double)step / SOME(4000));
        memcpy(directions, faces, sizeof faces);
        for (unsigned i = 6; i < 12; i++) {
            const double a = i % 2 ? 1 : -1;
            const double edge[3][3] = {{a, 0, 1}, {0, a, 1}, {1, a * tilt, 0}};
            const double length = length3(edge[i % 3]);
            for (unsigned k = 0; k < 3; k++) {
                directions[i][k] = edge[i % 3][k] / length;
            }
        }
        read_positions(&truth, (const double(*)[3])directions, 12, 0, &unused, &set);
        memset(&o, 7, sizeof o);
        before = o;
        const invcal_status status = calibrate(&set, 1e-7, of_offsets, &o);
        if (status == INVCAL_OK) {
            solved++;
        } else {
            TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, status);
            TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
        }
    }
    TEST_ASSERT_TRUE(solved > SOME(4000) / 4 && solved < SOME(4000));
}

/* Residuals larger than the stated noise give the prior more weight. */
static void a_prior_is_weighed_against_the_noise_that_is_there(void)
{
    random_source random = random_start(2);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;
    outcome o;

    read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-5, equal, &o));
    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 1e-3, (double)o.quality.noise);
    /* sigma is that of the two together: 1/s^2 = 1/prior^2 + 1/data^2 */
    const double data = (double)o.quality.noise * expected_plan18_root_k[0];
    const double both = 1 / sqrt(1 / (0.01 * 0.01) + 1 / (data * data));
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * both, both, (double)o.quality.sigma[0]);
    TEST_ASSERT_EQUAL_HEX16(0, o.quality.held);
}

/* Stated at a ten thousandth it would leave the prior nothing to say, and the angles where the
 * readings put them; as it is, it takes half of them away. */
static void observed_noise_shrinks_like_stated_noise(void)
{
    static const triad_truth truth = {{0, 0, 0, 0, 0, 0, 0.03, -0.03, 0.03}};
    random_source random = random_start(6);

    for (int draw = 0; draw < 5; draw++) {
        static const double stated[2] = {1e-6, 1e-2};
        reading_set set;
        outcome o[2];
        read_positions(&truth, expected_plan18, 18, 1e-2, &random, &set);
        for (int i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, stated[i], equal, &o[i]));
        }
        for (unsigned r = 0; r < 9; r++) {
            TEST_ASSERT_DOUBLE_WITHIN((double)o[1].quality.sigma[r],
                                      parameter(&o[1].calibration, r),
                                      parameter(&o[0].calibration, r));
        }
    }
}

/* The share of a parameter from the prior, the posterior over the prior variance, is not from the
 * data. */
static double dof_of(const outcome *o, const double prior[9])
{
    double dof = o->quality.positions;

    for (unsigned r = 0; r < 9; r++) {
        const double ratio = (double)o->quality.sigma[r] / prior[r];
        dof -= 1 - ratio * ratio;
    }
    return dof;
}

/* The stated noise counts as four residuals, in addition to them. */
static void what_a_prior_determines_leaves_degrees_of_freedom(void)
{
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.001);
    double prior[9];
    reading_set set;
    outcome o;

    for (unsigned r = 0; r < 9; r++) {
        prior[r] = 5e-4 * (r + 1);
    }
    read_positions(&truth, expected_plan18, 18, 1e-4, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 2e-3, prior, &o));
    const double dof = dof_of(&o, prior);
    TEST_ASSERT_TRUE(dof > 9.5 && dof < 17.5);
    TEST_ASSERT_EQUAL_UINT((unsigned)dof, o.quality.dof);
    TEST_ASSERT_EQUAL_UINT((unsigned)(dof + 4), o.quality.sigma_dof);
    const double rms = (double)o.quality.rms;
    const double noise = sqrt((4 * 4e-6 + 18 * rms * rms) / (4 + dof));
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * noise, noise, (double)o.quality.noise);
}

/* Readings as noisy as the field have no information: each parameter keeps its own prior. */
static void sigma_of_what_is_not_determined_is_the_prior_of_each(void)
{
    random_source random = random_start(6);
    const triad_truth truth = triad_random(&random, 0.001);
    double prior[9];
    reading_set set;
    outcome o;

    for (unsigned r = 0; r < 9; r++) {
        prior[r] = 1e-3 * (r + 1);
    }
    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 0.99, prior, &o));
    TEST_ASSERT_EQUAL_HEX16(0x1FF, o.quality.held);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(3e-3 * prior[r], prior[r], (double)o.quality.sigma[r]);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE((double)(invcal_real)prior[r], (double)o.quality.sigma[r]);
    }
}

/* What the positions leave open is weighed with rounding errors in mind, the rest is not: 10 being
 * the widest prior, and about 2 the largest sum of three positions, to 10 sqrt(8 epsilon). */
static void noise_is_raised_only_where_a_prior_has_to_hold_something(void)
{
    static const double prior[9] = {1, 1, 10, 1, 1, 1, 1, 1, 1e-3};
    random_source random = random_start(11);
    const triad_truth truth = triad_random(&random, 0.03);
    reading_set set;
    outcome o;

    read_positions(&truth, expected_plan18, 18, 0, &random, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-5, prior, &o));
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0, (double)o.quality.noise); /* 0.03 against a prior of 1e-3 */
    set.count = 3;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-9, prior, &o));
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-3, 3e-7), FLOAT_OR_DOUBLE(1e-2, 4e-7),
                              (double)o.quality.noise);
}

/* Six faces, tilted by less than rounding: what the sums seem to show of the angles is rounding. */
static void what_rounding_seems_to_show_is_held_by_the_prior(void)
{
    random_source random = random_start(12);
    const double root = sqrt(FLOAT_OR_DOUBLE(1.2e-7, 2.2e-16));

    for (int i = 0; i < 20; i++) {
        const triad_truth truth = triad_random(&random, 0.01);
        const double t = root * pow(10, 0.1 * i - 1.5);
        double tilted[6][3];
        reading_set set;
        outcome o;
        for (int k = 0; k < 6; k++) {
            for (int a = 0; a < 3; a++) {
                tilted[k][a] = faces[k][a] + t * (faces[k][(a + 1) % 3] - faces[k][(a + 2) % 3]);
            }
        }
        read_positions(&truth, (const double(*)[3])tilted, 6, 0, &random, &set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, root * root, equal, &o));
        for (unsigned r = INVCAL_GAMMA_XY; r <= INVCAL_GAMMA_ZY; r++) {
            TEST_ASSERT_GREATER_THAN_DOUBLE(0.5 * equal[r], (double)o.quality.sigma[r]);
        }
    }
}

/* Without errors of the triad, a prior changes only sigma. */
static void a_prior_that_is_true_leaves_the_solution_alone(void)
{
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    reading_set set;
    outcome o;

    read_positions(&none, expected_plan18, 18, 0, &unused, &set);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-3, equal, &o));
    const double noise = 1e-3 * sqrt(4 / (4 + dof_of(&o, equal)));
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-14), 0, parameter(&o.calibration, r));
        /* 1/s^2 = 1/prior^2 + 1/data^2 where no two parameters depend on each other */
        const double data = noise * expected_plan18_root_k[r];
        const double both = 1 / sqrt(1 / (0.01 * 0.01) + 1 / (data * data));
        const double bound = r >= INVCAL_DK_X && r <= INVCAL_DK_Z ? 0.01 : 1e-4;
        TEST_ASSERT_DOUBLE_WITHIN(bound * both, both, (double)o.quality.sigma[r]);
    }
}

/* The same readings and priors, once over field and once in counts: tilts by 10 degrees, which leave
 * much to the prior. */
static void a_prior_weighs_the_same_in_any_unit(void)
{
    const invcal_calibration counts = {
        {0, 0, 0},
        {{INVCAL_REAL(0.0025), 0, 0}, {0, INVCAL_REAL(0.0025), 0}, {0, 0, INVCAL_REAL(0.0025)}}};
    random_source random = random_start(3);
    const triad_truth truth = triad_random(&random, 0.01);
    invcal_real prior[9];
    double v[12][3];
    reading_set set;
    reading_set raw;
    outcome o[2];

    for (int i = 0; i < 12; i++) {
        v[i][0] = random_uniform(&random, -0.17, 0.17);
        v[i][1] = random_uniform(&random, -0.17, 0.17);
        v[i][2] = sqrt(1 - v[i][0] * v[i][0] - v[i][1] * v[i][1]);
    }
    read_positions(&truth, (const double(*)[3])v, 12, 1e-4, &random, &set);
    raw.count = set.count;
    for (int i = 0; i < 12 * 3; i++) {
        raw.u[i / 3][i % 3] = 400 * set.u[i / 3][i % 3];
    }
    for (int r = 0; r < 9; r++) {
        prior[r] = (invcal_real)0.01;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate(&set, 1e-3, equal, &o[0]));
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_calibrate_prior(POSITIONS_OF(raw.u[0], 12, &counts, (invcal_real)1e-3),
                                          prior, &o[1].calibration, &o[1].quality));
    const triad_truth found = truth_of(&o[1].calibration, &counts);
    for (unsigned r = 0; r < 9; r++) {
        const double sigma = (double)o[0].quality.sigma[r];
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-2, 1e-9) * sigma,
                                  parameter(&o[0].calibration, r), found.x[r]);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-2, 1e-9) * sigma, sigma,
                                  (double)o[1].quality.sigma[r]);
    }
    TEST_ASSERT_EQUAL_HEX16(o[0].quality.held, o[1].quality.held);
    TEST_ASSERT_TRUE(o[0].quality.held != 0);
}

static void assert_refused(const reading_set *set, double noise, const double prior[9],
                           invcal_status expected)
{
    outcome o;
    outcome before;

    memset(&o, 7, sizeof o);
    before = o;
    TEST_ASSERT_EQUAL_INT(expected, calibrate(set, noise, prior, &o));
    TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
}

static void unusable_arguments_are_refused_and_the_outputs_left_alone(void)
{
    static const double no_prior[] = {-1e-3, NOT_A_NUMBER, INFINITE};
    static const double no_noise[] = {0, -1e-3, 1, NOT_A_NUMBER, INFINITE};
    static const double none[9] = {0};
    random_source random = random_start(9);
    const triad_truth truth = triad_random(&random, 0.01);
    reading_set set;

    read_positions(&truth, expected_plan18, 18, 1e-3, &random, &set);
    for (unsigned i = 0; i < sizeof no_noise / sizeof no_noise[0]; i++) {
        assert_refused(&set, no_noise[i], equal, INVCAL_BAD_NOISE);
    }
    for (unsigned i = 0; i < 3 * 9; i++) {
        double prior[9];
        memcpy(prior, equal, sizeof prior);
        prior[i % 9] = no_prior[i / 9];
        assert_refused(&set, 1e-3, prior, INVCAL_BAD_PRIOR);
    }
    assert_refused(&set, 1e-3, none, INVCAL_BAD_PRIOR);
    set.u[3][1] = (invcal_real)NAN;
    assert_refused(&set, 1e-3, equal, INVCAL_NOT_FINITE);
    set.u[3][1] = 100;
    assert_refused(&set, 1e-3, equal, INVCAL_OUT_OF_RANGE);
}

/* Nor does a prior make a triad out of anything else. */
static void readings_on_no_ellipsoid_are_refused(void)
{
    random_source random = random_start(10);
    reading_set set = {.count = 40};

    for (unsigned i = 0; i < set.count; i++) {
        double d[3];
        random_direction(&random, d);
        const double radius = random_uniform(&random, 0.3, 1.7);
        for (int k = 0; k < 3; k++) {
            set.u[i][k] = (invcal_real)(radius * d[k]);
        }
    }
    assert_refused(&set, 1e-3, equal, INVCAL_NOT_ELLIPSOID);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_partial_prior_needs_as_many_positions_as_it_leaves_open);
    RUN_TEST(what_a_prior_holds_is_never_hopeless);
    RUN_TEST(the_condition_counts_the_rows_of_the_prior);
    RUN_TEST(an_absurdly_wide_prior_is_weak);
    RUN_TEST(what_no_prior_holds_may_be_hopeless);
    RUN_TEST(what_hardly_shows_is_solved_or_refused_as_open);
    RUN_TEST(a_prior_is_weighed_against_the_noise_that_is_there);
    RUN_TEST(observed_noise_shrinks_like_stated_noise);
    RUN_TEST(what_a_prior_determines_leaves_degrees_of_freedom);
    RUN_TEST(sigma_of_what_is_not_determined_is_the_prior_of_each);
    RUN_TEST(noise_is_raised_only_where_a_prior_has_to_hold_something);
    RUN_TEST(what_rounding_seems_to_show_is_held_by_the_prior);
    RUN_TEST(a_prior_that_is_true_leaves_the_solution_alone);
    RUN_TEST(a_prior_weighs_the_same_in_any_unit);
    RUN_TEST(unusable_arguments_are_refused_and_the_outputs_left_alone);
    RUN_TEST(readings_on_no_ellipsoid_are_refused);
    return UNITY_END() != 0;
}
