/* SPDX-License-Identifier: MIT
 *
 * Known directions: the full vector, and the rotation that lengths cannot show.
 */
#include "stand/full_vector.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "expected.h"
#include "stand/full_vector.h"
#include "support.h"
#include "core/system.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void turned(const double r[3][3], const double eta[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = r[i][0] * eta[0] + r[i][1] * eta[1] + r[i][2] * eta[2];
    }
}

static void to_real(const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = v[i];
    }
}

static invcal_status add(full_vector *full, const double u[3], const double eta[3])
{
    const invcal_calibration nominal = unit_nominal();
    double raw[3];
    double up[3];

    to_real(u, raw);
    to_real(eta, up);
    return full_vector_add(full, &nominal, raw, up);
}

/* The first `count` positions of the paper's program, for a unit with the mounting R. */
static full_vector mounted(const triad_truth *truth, const double r[3][3], int count)
{
    full_vector full;

    full_vector_init(&full);
    for (int k = 0; k < count; k++) {
        double up[3];
        double u[3];
        turned(r, expected_plan18[k], up);
        triad_read(truth, up, u);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&full, u, expected_plan18[k]));
    }
    return full;
}

static void parameters_and_mounting_come_out_for_errors_of_any_size(void)
{
    random_source random = random_start(1);

    for (int i = 0; i < SOME(200); i++) {
        const triad_truth truth = triad_random(&random, 0.2);
        const invcal_calibration nominal = unit_nominal();
        const double tolerance = 1e-14;
        double r[3][3];
        double x[9];
        double found[3][3];
        invcal_calibration c;
        random_rotation(&random, r);
        full_vector full = mounted(&truth, (const double(*)[3])r, 18);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, full_vector_solve(&full, &nominal, &c, x, found));
        for (int p = 0; p < 9; p++) {
            TEST_ASSERT_DOUBLE_WITHIN(tolerance, truth.x[p], x[p]);
            TEST_ASSERT_DOUBLE_WITHIN(tolerance, r[p / 3][p % 3], found[p / 3][p % 3]);
        }
    }
}

static void calibrated_readings_are_directions_of_the_stand(void)
{
    random_source random = random_start(2);
    const triad_truth truth = triad_random(&random, 0.1);
    const invcal_calibration nominal = unit_nominal();
    double r[3][3];
    double e[3];
    double up[3];
    double u[3];
    double x[9];
    double found[3][3];
    double out[3];
    invcal_calibration c;

    random_rotation(&random, r);
    full_vector full = mounted(&truth, (const double(*)[3])r, 18);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, full_vector_solve(&full, &nominal, &c, x, found));
    for (int i = 0; i < SOME(50); i++) {
        random_direction(&random, e);
        turned((const double(*)[3])r, e, up);
        triad_read(&truth, up, u);
        const double raw[3] = {u[0], u[1], u[2]};
        invcal_apply(&c, raw[0], raw[1], raw[2], out);
        for (int a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-13, e[a], out[a]);
        }
    }
}

/* Raw counts, turned and skewed; and the new calibration replaces the previous one. */
static void any_regular_matrix_may_be_nominal_and_be_replaced(void)
{
    static const double t[3][3] = {{80, 30, -20}, {-35, 60, 50}, {20, -40, 120}};
    random_source random = random_start(4);
    const triad_truth truth = triad_random(&random, 0.1);
    const double tolerance = 1e-13;
    double inverse[3][3];
    double r[3][3];
    invcal_calibration c;
    full_vector full;
    double raw[18][3];
    double x[9];
    double found[3][3];
    double up[3];

    inverse3(t, inverse);
    random_rotation(&random, r);
    full_vector_init(&full);
    for (int k = 0; k < 3; k++) {
        c.offset[k] = (100 * k);
        to_real(inverse[k], c.matrix[k]);
    }
    for (int i = 0; i < 18; i++) {
        double turn[3];
        double u[3];
        turned((const double(*)[3])r, expected_plan18[i], turn);
        triad_read(&truth, turn, u);
        for (int k = 0; k < 3; k++) {
            raw[i][k] = (100 * k + t[k][0] * u[0] + t[k][1] * u[1] + t[k][2] * u[2]);
        }
        to_real(expected_plan18[i], up);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, full_vector_add(&full, &c, raw[i], up));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, full_vector_solve(&full, &c, &c, x, found));
    for (int p = 0; p < 9; p++) {
        TEST_ASSERT_DOUBLE_WITHIN(tolerance, truth.x[p], x[p]);
        TEST_ASSERT_DOUBLE_WITHIN(tolerance, r[p / 3][p % 3], found[p / 3][p % 3]);
    }
    for (int i = 0; i < 18; i++) {
        invcal_apply(&c, raw[i][0], raw[i][1], raw[i][2], up);
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(tolerance, expected_plan18[i][k], up[k]);
        }
    }
}

/* The three angles, if reading `moved` of 54 is wrong by `error`. */
static void angles_of_mounting(int moved, double error, double angle[3])
{
    const invcal_calibration nominal = unit_nominal();
    full_vector full;
    invcal_calibration c;
    double x[9];
    double r[3][3];

    full_vector_init(&full);
    for (int k = 0; k < 18; k++) {
        double u[3] = {expected_plan18[k][0], expected_plan18[k][1], expected_plan18[k][2]};
        if (moved / 3 == k) {
            u[moved % 3] += error;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&full, u, expected_plan18[k]));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, full_vector_solve(&full, &nominal, &c, x, r));
    for (int i = 0; i < 3; i++) {
        angle[i] = (r[i][(i + 1) % 3] - r[(i + 1) % 3][i]) / 2;
    }
}

/* The squares of the change by each reading add up to 1/(2 N), N = 6 on each great circle. */
static void the_angles_of_the_mounting_have_the_sigma_that_the_header_states(void)
{
    const double error = 0.01;
    double sum[3] = {0};
    double angle[3];

    for (int moved = 0; moved < 54; moved++) {
        angles_of_mounting(moved, error, angle);
        for (int i = 0; i < 3; i++) {
            sum[i] += angle[i] * angle[i] / (error * error);
        }
    }
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-4, 1.0 / 12, sum[i]);
    }
}

static void assert_solved(invcal_status status, full_vector full, const invcal_calibration *nominal)
{
    invcal_calibration c = {{7, 7, 7}, {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
    const invcal_calibration was = c;
    double x[9] = {7, 7, 7, 7, 7, 7, 7, 7, 7};
    double r[4][3] = {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}, {7, 7, 7}}; /* and a row after it */

    TEST_ASSERT_EQUAL_INT(status, full_vector_solve(&full, nominal, &c, x, r));
    TEST_ASSERT_EQUAL_INT(status != INVCAL_OK, memcmp(&was, &c, sizeof c) == 0);
    for (int p = 0; p < 9; p++) {
        TEST_ASSERT_EQUAL_INT(status != INVCAL_OK, x[p] == 7);
        TEST_ASSERT_EQUAL_INT(status != INVCAL_OK, r[p / 3][p % 3] == 7);
    }
    TEST_ASSERT_TRUE(r[3][0] == 7);
}

static const double straight[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static void too_few_flat_and_mirrored_directions_are_refused(void)
{
    const triad_truth truth = {{0.01, 0, 0, 0.02, 0, 0, 0, 0.01, 0}};
    const double mirror[3][3] = {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; /* beta reversed */
    const invcal_calibration nominal = unit_nominal();
    const double s = sqrt(1.0 / 3);
    const double corner[4][3] = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
    full_vector four;

    assert_solved(INVCAL_TOO_FEW, mounted(&truth, straight, 3), &nominal);
    assert_solved(INVCAL_UNDETERMINED, mounted(&truth, straight, 6), &nominal); /* group 1 */
    assert_solved(INVCAL_NOT_ELLIPSOID, mounted(&truth, mirror, 18), &nominal);
    full_vector_init(&four);
    for (int i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&four, corner[i], corner[i]));
    }
    assert_solved(INVCAL_OK, four, &nominal);
}

static void a_nominal_without_an_inverse_is_refused(void)
{
    const invcal_calibration singular = {{0, 0, 0}, {{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}};
    const triad_truth none = {{0}};

    assert_solved(INVCAL_BAD_NOMINAL, mounted(&none, straight, 18), &singular);
}

/* Readings are kept between 0.1 and 10, and so are semi-axes, about; offsets within 10. */
static void semi_axes_and_offsets_beyond_their_limits_are_not_triads(void)
{
    static const struct {
        int r;
        double error;
        invcal_status status;
    } limits[] = {{INVCAL_DK_X, 0.13 - 1, INVCAL_OK},
                  {INVCAL_DK_X, 0.07 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DK_Y, 9.5 - 1, INVCAL_OK},
                  {INVCAL_DK_Y, 10.5 - 1, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_GAMMA_XZ, 1.7, INVCAL_OK}, /* semi-axes 1 + 0.85, 1, 1 - 0.85 */
                  {INVCAL_GAMMA_XZ, 1.9, INVCAL_NOT_ELLIPSOID},
                  {INVCAL_DELTA_X, 9.8, INVCAL_OK},
                  {INVCAL_DELTA_Y, -10.2, INVCAL_NOT_ELLIPSOID}};
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(15);
    double rotation[3][3];

    random_rotation(&random, rotation);
    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        triad_truth truth = {{0}};
        full_vector full;
        truth.x[limits[i].r] = limits[i].error;
        full_vector_init(&full);
        while (full.count < 40) {
            double eta[3];
            double up[3];
            double u[3];
            random_direction(&random, eta);
            turned((const double(*)[3])rotation, eta, up);
            triad_read(&truth, up, u);
            (void)add(&full, u, eta);
        }
        assert_solved(limits[i].status, full, &nominal);
    }
}

/* Every element of the system and of its first right-hand side, for a set that can be solved. */
static void sums_that_are_not_numbers_are_refused(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    const triad_truth none = {{0}};
    const invcal_calibration nominal = unit_nominal();

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned k = 0; k < INVCAL_PACKED(4, 4); k++) {
            full_vector full = mounted(&none, straight, 18);
            invcal_calibration c = nominal;
            double x[9];
            double r[3][3];
            full.sum[k] = bad[i];
            TEST_ASSERT_TRUE(full_vector_solve(&full, &nominal, &c, x, r) != INVCAL_OK);
            TEST_ASSERT_EQUAL_MEMORY(&nominal, &c, sizeof c);
        }
    }
}

static void assert_not_added(const double u[3], const double eta[3], invcal_status expected)
{
    full_vector full;
    full_vector before;

    memset(&full, 7, sizeof full);
    before = full;
    TEST_ASSERT_EQUAL_INT(expected, add(&full, u, eta));
    TEST_ASSERT_EQUAL_MEMORY(&before, &full, sizeof before);
}

static void what_is_not_a_reading_or_a_direction_is_not_added(void)
{
    const double z[3] = {0, 0, 1};
    const double nan[3] = {0, NOT_A_NUMBER, 1};
    const double infinite[3] = {INFINITE, 0, 0};
    const double none[3] = {0, 0, 0.01};
    const double longer[3] = {0, 0, 1.0002};
    const double shorter[3] = {0, 0, 0.9998};

    assert_not_added(nan, z, INVCAL_NOT_FINITE);
    assert_not_added(infinite, z, INVCAL_NOT_FINITE);
    assert_not_added(none, z, INVCAL_OUT_OF_RANGE);
    assert_not_added(z, longer, INVCAL_BAD_DIRECTION);
    assert_not_added(z, shorter, INVCAL_BAD_DIRECTION);
    assert_not_added(z, nan, INVCAL_BAD_DIRECTION);
    assert_not_added(z, infinite, INVCAL_BAD_DIRECTION);
}

static void the_count_ends_at_the_largest_number(void)
{
    const double z[3] = {0, 0, 1};
    full_vector full;

    full_vector_init(&full);
    full.count = UINT_MAX - 1;
    for (int i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&full, z, z));
        TEST_ASSERT_EQUAL_UINT(UINT_MAX, full.count);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(parameters_and_mounting_come_out_for_errors_of_any_size);
    RUN_TEST(calibrated_readings_are_directions_of_the_stand);
    RUN_TEST(any_regular_matrix_may_be_nominal_and_be_replaced);
    RUN_TEST(the_angles_of_the_mounting_have_the_sigma_that_the_header_states);
    RUN_TEST(too_few_flat_and_mirrored_directions_are_refused);
    RUN_TEST(a_nominal_without_an_inverse_is_refused);
    RUN_TEST(semi_axes_and_offsets_beyond_their_limits_are_not_triads);
    RUN_TEST(sums_that_are_not_numbers_are_refused);
    RUN_TEST(what_is_not_a_reading_or_a_direction_is_not_added);
    RUN_TEST(the_count_ends_at_the_largest_number);
    return UNITY_END() != 0;
}
