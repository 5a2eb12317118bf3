/* SPDX-License-Identifier: MIT
 *
 * Known directions: the paper's vertical composition J1, and its scalar one, J2.
 */
#include <math.h>
#include <string.h>

#include "stand/directions.h"
#include "expected.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

typedef invcal_status (*adder)(invcal_directions *linear, const invcal_calibration *nominal,
                               const invcal_real raw[3], const invcal_real eta[3]);

static void to_real(const double v[3], invcal_real out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = (invcal_real)v[i];
    }
}

static invcal_status add_reading(adder add, invcal_directions *linear, const triad_truth *truth,
                                 const double eta[3])
{
    const invcal_calibration nominal = unit_nominal();
    double u[3];
    invcal_real reading[3];
    invcal_real up[3];

    triad_read(truth, eta, u);
    to_real(u, reading);
    to_real(eta, up);
    return add(linear, &nominal, reading, up);
}

/* The paper's program with its directions known. */
static invcal_directions with_known_directions(const triad_truth *truth, adder add)
{
    invcal_directions linear;

    invcal_directions_init(&linear);
    for (int i = 0; i < 18; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add_reading(add, &linear, truth, expected_plan18[i]));
    }
    return linear;
}

/* J + h(eta) p = 0 with p = -X: J'J of one row is (h X)^2, h written out from the paper. */
static void the_vertical_row_is_linear_for_errors_of_any_size(void)
{
    random_source random = random_start(2);

    for (int i = 0; i < SOME(500); i++) {
        const triad_truth truth = triad_random(&random, 0.5);
        const double *x = truth.x;
        double e[3];
        double u[3];
        invcal_directions linear;
        random_direction(&random, e);
        triad_read(&truth, e, u);
        invcal_directions_init(&linear);
        const invcal_status status = add_reading(invcal_directions_add, &linear, &truth, e);
        if (length3(u) > 0.1) {
            const double hx = e[0] * x[0] + e[1] * x[1] + e[2] * x[2] + e[0] * e[0] * x[3] +
                              e[1] * e[1] * x[4] + e[2] * e[2] * x[5] + e[0] * e[1] * x[6] +
                              e[0] * e[2] * x[7] + e[1] * e[2] * x[8];
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, status);
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(4e-6, 1e-14), hx * hx,
                                      element(&linear.sums, 9, 9));
        }
    }
}

static void known_directions_give_the_triad_exactly_for_errors_of_any_size(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(3);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.2);
        invcal_directions linear = with_known_directions(&truth, invcal_directions_add);
        invcal_calibration calibration;
        invcal_real x[INVCAL_PARAMETERS];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_directions_solve(&linear, &nominal, &calibration, x));
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            const double bound = FLOAT_OR_DOUBLE(2e-6, 1e-13);
            TEST_ASSERT_DOUBLE_WITHIN(bound, truth.x[r], (double)x[r]);
            TEST_ASSERT_DOUBLE_WITHIN(bound, truth.x[r], parameter(&calibration, r));
        }
    }
}

/* As many as there are parameters. */
static void nine_positions_are_enough(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(5);
    const triad_truth truth = triad_random(&random, 0.1);
    invcal_directions linear;
    invcal_calibration calibration;
    invcal_real x[INVCAL_PARAMETERS];

    invcal_directions_init(&linear);
    for (int i = 0; i < 9; i++) { /* three of each group */
        const double *eta = expected_plan18[2 * i];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add_reading(invcal_directions_add, &linear, &truth, eta));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_directions_solve(&linear, &nominal, &calibration, x));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-12), truth.x[r], (double)x[r]);
    }
}

/* The reason for the exact row: the error that the paper's first-order row leaves, by the
 * reference. */
static double first_order_error(double size, double *rms)
{
    static const double sign[9] = {1, -1, 1, 1, -1, 1, -1, 1, -1};
    const invcal_calibration nominal = unit_nominal();
    triad_truth truth;
    invcal_calibration calibration;
    invcal_real x[INVCAL_PARAMETERS];
    double worst = 0;
    double squares = 0;

    for (int r = 0; r < 9; r++) {
        truth.x[r] = size * sign[r];
    }
    invcal_directions linear = with_known_directions(&truth, invcali_directions_add_scalar);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_directions_solve(&linear, &nominal, &calibration, x));
    for (unsigned r = 0; r < 9; r++) {
        worst = larger(worst, fabs((double)x[r] - truth.x[r]));
    }
    for (int i = 0; i < 18; i++) {
        const double error = calibrated_length(&calibration, &truth, expected_plan18[i]) - 1;
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

/* Raw counts, turned and skewed. */
static void any_regular_matrix_may_be_nominal(void)
{
    static const double t[3][3] = {{80, 30, -20}, {-35, 60, 50}, {20, -40, 120}};
    random_source random = random_start(4);
    const triad_truth truth = triad_random(&random, 0.1);
    double inverse[3][3];
    invcal_calibration nominal;
    invcal_calibration calibration;
    invcal_directions linear;
    invcal_real x[INVCAL_PARAMETERS];

    inverse3(t, inverse);
    invcal_directions_init(&linear);
    for (int k = 0; k < 3; k++) {
        nominal.offset[k] = (invcal_real)(100 * k);
        to_real(inverse[k], nominal.matrix[k]);
    }
    for (int i = 0; i < 18; i++) {
        double u[3];
        invcal_real raw[3];
        invcal_real up[3];
        triad_read(&truth, expected_plan18[i], u);
        for (int k = 0; k < 3; k++) {
            raw[k] = (invcal_real)(100 * k + t[k][0] * u[0] + t[k][1] * u[1] + t[k][2] * u[2]);
        }
        to_real(expected_plan18[i], up);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_directions_add(&linear, &nominal, raw, up));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_directions_solve(&linear, &nominal, &calibration, x));
    const triad_truth found = truth_of(&calibration, &nominal);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(4e-6, 1e-13), truth.x[r], (double)x[r]);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(4e-6, 1e-13), truth.x[r], found.x[r]);
    }
}

static void assert_row_refused(const double reading[3], const double direction[3],
                               invcal_status expected)
{
    static const adder adders[2] = {invcal_directions_add, invcali_directions_add_scalar};
    const invcal_calibration nominal = unit_nominal();
    invcal_directions linear;
    invcal_directions before;
    invcal_real u[3];
    invcal_real up[3];

    to_real(reading, u);
    to_real(direction, up);
    memset(&linear, 7, sizeof linear);
    before = linear;
    for (int i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL_INT(expected, adders[i](&linear, &nominal, u, up));
    }
    TEST_ASSERT_EQUAL_MEMORY(&before, &linear, sizeof before);
}

static void readings_that_cannot_be_of_this_field_are_refused(void)
{
    static const double bad[][3] = {{0, 0, 0},          {1e-3, 0, 0},   {1e-40, 1e-40, 0},
                                    {0.09, 0.01, 0.01}, {10.1, 0, 0},   {1e30, 0, 0},
                                    {0, -1e30, 1},      {0, 7.2, -7.2}, {1e19, 1e19, 1e19}};
    static const double up[3] = {0, 0, 1};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_row_refused(bad[i], up, INVCAL_OUT_OF_RANGE);
    }
}

static void readings_that_are_not_numbers_are_refused(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    static const double up[3] = {0, 0, 1};

    for (unsigned i = 0; i < 9; i++) {
        double u[3] = {0.6, 0.6, 0.5};
        u[i % 3] = bad[i / 3];
        assert_row_refused(u, up, INVCAL_NOT_FINITE);
    }
}

static void directions_that_are_not_unit_vectors_are_refused(void)
{
    static const double bad[][3] = {{0, 0, 1.0002},       {0, 0, 0.9998},   {0, 0, 0},
                                    {NOT_A_NUMBER, 0, 1}, {INFINITE, 0, 0}, {1, 1, 1}};
    static const double u[3] = {0, 0, 1};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_row_refused(u, bad[i], INVCAL_BAD_DIRECTION);
    }
}

/* A semi-axis of 0.1 to 10 of nominal is a triad's, and an offset of up to 10 fields. Readings are
 * kept between 0.1 and 10, too. */
static void semi_axes_and_offsets_beyond_their_limits_are_not_triads(void)
{
    static const struct {
        int r;
        double error;
        invcal_status status;
    } limits[] = {{INVCAL_DK_X, 0.13 - 1, INVCAL_OK},
                  {INVCAL_DK_X, 0.07 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DK_X, 9.5 - 1, INVCAL_OK},
                  {INVCAL_DK_X, 10.5 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_GAMMA_XZ, 1.7, INVCAL_OK}, /* semi-axes 1 + 0.85, 1, 1 - 0.85 */
                  {INVCAL_GAMMA_XZ, 1.9, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DELTA_X, 9.8, INVCAL_OK},
                  {INVCAL_DELTA_Y, -10.2, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DELTA_Z, 10.2, INVCAL_NOT_ELLIPSOID}};
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(15);

    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        triad_truth truth = {{0}};
        invcal_directions linear;
        invcal_calibration calibration;
        invcal_real x[INVCAL_PARAMETERS] = {7};
        truth.x[limits[i].r] = limits[i].error;
        invcal_directions_init(&linear);
        while (linear.sums.count < 40) {
            double eta[3];
            random_direction(&random, eta);
            (void)add_reading(invcal_directions_add, &linear, &truth, eta);
        }
        TEST_ASSERT_EQUAL_INT(limits[i].status,
                              invcal_directions_solve(&linear, &nominal, &calibration, x));
        TEST_ASSERT_TRUE(limits[i].status == INVCAL_OK || (x[0] == 7 && x[1] == 0));
    }
}

static void what_cannot_be_solved_is_refused_and_the_outputs_left_alone(void)
{
    const invcal_calibration singular = {{0, 0, 0}, {{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}};
    static const invcal_status expected[3] = {INVCAL_TOO_FEW, INVCAL_UNDETERMINED,
                                              INVCAL_BAD_NOMINAL};
    const triad_truth none = {{0}};

    for (int i = 0; i < 3; i++) {
        const invcal_calibration nominal = i == 2 ? singular : unit_nominal();
        invcal_directions linear;
        invcal_calibration calibration;
        invcal_calibration before;
        invcal_real x[INVCAL_PARAMETERS] = {7};
        memset(&calibration, 7, sizeof calibration);
        before = calibration;
        invcal_directions_init(&linear);
        for (int k = 0; k < (i == 0 ? 8 : 18); k++) { /* of the second, one direction only */
            const double *eta = expected_plan18[i == 1 ? 0 : k];
            (void)add_reading(invcal_directions_add, &linear, &none, eta);
        }
        TEST_ASSERT_EQUAL_INT(expected[i],
                              invcal_directions_solve(&linear, &nominal, &calibration, x));
        TEST_ASSERT_EQUAL_MEMORY(&before, &calibration, sizeof before);
        TEST_ASSERT_TRUE(x[0] == 7 && x[8] == 0);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_vertical_row_is_linear_for_errors_of_any_size);
    RUN_TEST(known_directions_give_the_triad_exactly_for_errors_of_any_size);
    RUN_TEST(nine_positions_are_enough);
    RUN_TEST(the_first_order_row_leaves_the_error_that_the_design_states);
    RUN_TEST(any_regular_matrix_may_be_nominal);
    RUN_TEST(readings_that_cannot_be_of_this_field_are_refused);
    RUN_TEST(readings_that_are_not_numbers_are_refused);
    RUN_TEST(directions_that_are_not_unit_vectors_are_refused);
    RUN_TEST(semi_axes_and_offsets_beyond_their_limits_are_not_triads);
    RUN_TEST(what_cannot_be_solved_is_refused_and_the_outputs_left_alone);
    return UNITY_END() != 0;
}
