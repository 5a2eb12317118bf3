/* SPDX-License-Identifier: MIT
 *
 * The rotation between magnetometer and accelerometer: a known one comes back, and sigma is its
 * scatter.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "invcal/magnetometer.h"
#include "core/vector.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* A rotation by an angle about a random axis. */
static void rotate_by(double angle, random_source *random, double r[3][3])
{
    double v[3];

    random_direction(random, v);
    for (int i = 0; i < 3; i++) {
        v[i] *= angle;
    }
    rotation_by(v, r);
}

/* Up, and a field that dips by `dip`, in any orientation; the field is read in axes turned by
 * R'. */
static void read_both(double dip, const double r[3][3], double noise, random_source *random,
                      invcal_real up[3], invcal_real field[3])
{
    double turn[3][3];
    double m[3];

    random_rotation(random, turn);
    for (int i = 0; i < 3; i++) {
        up[i] = (invcal_real)(9.8 * turn[i][2]);
        m[i] = cos(dip) * turn[i][0] - sin(dip) * turn[i][2] + noise * random_normal(random);
    }
    for (int j = 0; j < 3; j++) {
        field[j] = (invcal_real)(48 * (r[0][j] * m[0] + r[1][j] * m[1] + r[2][j] * m[2]));
    }
}

static void a_rotation_of_up_to_90_degrees_comes_back(void)
{
    random_source random = random_start(1);

    for (int n = 0; n < SOME(50); n++) {
        invcal_dip dip;
        invcal_dip_quality quality;
        invcal_rotation found;
        double r[3][3];
        const double angle = random_uniform(&random, 0, 1.57);
        const double down = random_uniform(&random, -1.2, 1.2);
        rotate_by(angle, &random, r);
        invcal_dip_init(&dip);
        for (int i = 0; i < 200; i++) {
            invcal_real up[3];
            invcal_real field[3];
            read_both(down, (const double(*)[3])r, 0, &random, up, field);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, up, field));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_solve(&dip, 1, &found, NULL));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_solve(&dip, 1, &found, &quality));
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-7), r[i / 3][i % 3],
                                      (double)found.r[i / 3][i % 3]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-7), -sin(down), (double)quality.sine);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-3, 1e-7), 0, (double)quality.scatter);
    }
}

/* The angles of many draws scatter by sigma; errors that are alike k times count once. The heading
 * error that remains is sigma / cos dip. */
static void sigma_is_the_scatter_of_the_angles(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int runs = 300;
    const int alike = 4;
    random_source random = random_start(2);
    double squares = 0;
    double sigma = 0;

    for (int n = 0; n < runs; n++) {
        invcal_dip dip;
        invcal_dip_quality quality;
        invcal_rotation found;
        invcal_dip_init(&dip);
        for (int i = 0; i < 100; i++) {
            invcal_real up[3];
            invcal_real field[3];
            read_both(1.1, same, 0.01, &random, up, field);
            for (int k = 0; k < alike; k++) {
                invcal_dip_add(&dip, up, field);
            }
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcal_dip_solve(&dip, (invcal_real)alike, &found, &quality));
        for (int i = 0; i < 3; i++) {
            const double angle = (double)found.r[(i + 2) % 3][(i + 1) % 3];
            squares += angle * angle / (3 * runs);
            sigma += (double)(quality.sigma[i] * quality.sigma[i]) / (3 * runs);
        }
        const double mean = sqrt((double)(quality.sigma[0] * quality.sigma[0] +
                                          quality.sigma[1] * quality.sigma[1] +
                                          quality.sigma[2] * quality.sigma[2]) /
                                 3);
        TEST_ASSERT_DOUBLE_WITHIN(0.05 * mean, mean / cos(1.1), (double)quality.heading);
        TEST_ASSERT_DOUBLE_WITHIN(0.004, 0.01, (double)quality.scatter / cos(1.1));
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 1, sqrt(sigma / squares));
}

/* The n-th of the 24 rotations of a cube: rows are axes in some order and with some signs. */
static void rotation_of_cube(unsigned n, double r[3][3])
{
    const unsigned first = n / 4 % 3;
    const unsigned second = (first + 1 + n / 12) % 3;
    const unsigned third = 3 - first - second;
    const int parity = n < 12 ? 1 : -1; /* of the order */

    memset(r, 0, 9 * sizeof r[0][0]);
    r[0][first] = n & 1 ? -1 : 1;
    r[1][second] = n & 2 ? -1 : 1;
    r[2][third] = parity * r[0][first] * r[1][second];
}

/* All orientations of a cube, each with a field that dips by d + e and one by d - e. By symmetry R is I; a m is -sin d cos e on
 * average, and off by cos d sin e; the mean of (m x a)(m x a)' is a third of (1 + cos 2d cos 2e) / 2 times I, and that
 * of m x a is 0, so that the variance of each angle is the inverse over n - 4, times how many err alike. */
static void the_quality_is_that_of_closed_form(void)
{
    static const struct {
        double stated;
        double counted;
    } alike[] = {{0, 1}, {1, 1}, {1.5, 1.5}, {4, 4}};
    const double d = 1;
    const double e = 0.1;
    const double third = (1 + cos(2 * d) * cos(2 * e)) / 6;
    invcal_dip dip;

    invcal_dip_init(&dip);
    for (unsigned n = 0; n < 48; n++) {
        double turn[3][3];
        invcal_real up[3];
        invcal_real field[3];
        const double down = n < 24 ? d + e : d - e;
        rotation_of_cube(n % 24, turn);
        for (int i = 0; i < 3; i++) {
            up[i] = (invcal_real)turn[i][2];
            field[i] = (invcal_real)(cos(down) * turn[i][0] - sin(down) * turn[i][2]);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, up, field));
    }
    for (unsigned k = 0; k < sizeof alike / sizeof alike[0]; k++) {
        invcal_dip_quality quality;
        invcal_rotation found;
        const double sigma = cos(d) * sin(e) * sqrt(alike[k].counted / third / (48 - 4));
        TEST_ASSERT_EQUAL_INT(
            INVCAL_OK, invcal_dip_solve(&dip, (invcal_real)alike[k].stated, &found, &quality));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, -sin(d) * cos(e), (double)quality.sine);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(5e-6, 1e-12), cos(d) * sin(e),
                                  (double)quality.scatter);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-4, 1e-9) * sigma, sigma,
                                      (double)quality.sigma[i]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-4, 1e-9) * sigma,
                                  sigma / sqrt(1 - pow(sin(d) * cos(e), 2)),
                                  (double)quality.heading);
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, i % 4 == 0, (double)found.r[i / 3][i % 3]);
        }
    }
}

/* Four unknowns need five instants. */
static void five_instants_are_enough(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    random_source random = random_start(5);
    invcal_rotation found;
    invcal_dip dip;

    invcal_dip_init(&dip);
    for (int n = 1; n <= 5; n++) {
        invcal_real up[3];
        invcal_real field[3];
        read_both(0.5, same, 0.01, &random, up, field);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, up, field));
        TEST_ASSERT_EQUAL_INT(n < 5 ? INVCAL_TOO_FEW : INVCAL_OK,
                              invcal_dip_solve(&dip, 1, &found, NULL));
    }
}

static void what_leaves_an_angle_open_is_refused(void)
{
    invcal_dip dip;
    invcal_rotation found = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};

    invcal_dip_init(&dip);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_dip_solve(&dip, 1, &found, NULL));
    for (int i = 0; i < 100; i++) { /* it lies flat, and turns about the vertical */
        const double t = i * 0.1;
        const invcal_real up[3] = {0, 0, 1};
        const invcal_real field[3] = {(invcal_real)cos(t), (invcal_real)sin(t), -1};
        invcal_dip_add(&dip, up, field);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_dip_solve(&dip, 1, &found, NULL));
    TEST_ASSERT_TRUE(found.r[0][0] == 7 && found.r[2][2] == 7);
}

/* Up and an unrelated field have no constant angle between them. */
static void what_is_not_of_one_instant_is_refused(void)
{
    random_source random = random_start(3);

    for (int n = 0; n < SOME(50); n++) {
        invcal_dip dip;
        invcal_rotation found = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
        invcal_dip_init(&dip);
        for (int i = 0; i < 200; i++) {
            double d[2][3];
            random_direction(&random, d[0]);
            random_direction(&random, d[1]);
            const invcal_real up[3] = {(invcal_real)d[0][0], (invcal_real)d[0][1],
                                       (invcal_real)d[0][2]};
            const invcal_real field[3] = {(invcal_real)d[1][0], (invcal_real)d[1][1],
                                          (invcal_real)d[1][2]};
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, up, field));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_dip_solve(&dip, 1, &found, NULL));
        TEST_ASSERT_TRUE(found.r[0][0] == 7 && found.r[2][2] == 7);
    }
}

static void bad_input_leaves_the_sums_as_they_were(void)
{
    const invcal_real good[3] = {1, 2, 3};
    const invcal_real nothing[3] = {0, 0, 0};
    const invcal_real bad[3] = {(invcal_real)NAN, 0, 0};
    const invcal_real huge[3] = {INVCAL_REAL_MAX, 0, 0};
    const invcal_real small = INVCAL_SQRT(1 / INVCAL_REAL_MAX) / 4;
    const invcal_real tiny[2][3] = {{0, 0, small},
                                    {small, 0, 0}}; /* 1 over their product is infinite */
    invcal_dip dip;
    invcal_dip before;

    invcal_dip_init(&dip);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, good, good));
    before = dip;
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_dip_add(&dip, bad, good));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, invcal_dip_add(&dip, good, bad));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_dip_add(&dip, nothing, good));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_dip_add(&dip, good, huge));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_dip_add(&dip, tiny[0], tiny[1]));
    TEST_ASSERT_EQUAL_MEMORY(&before, &dip, sizeof dip);
    dip.count = UINT_MAX;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_dip_add(&dip, good, good));
    TEST_ASSERT_TRUE(dip.count == UINT_MAX);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_rotation_of_up_to_90_degrees_comes_back);
    RUN_TEST(the_quality_is_that_of_closed_form);
    RUN_TEST(five_instants_are_enough);
    RUN_LONG_TEST(sigma_is_the_scatter_of_the_angles);
    RUN_TEST(what_leaves_an_angle_open_is_refused);
    RUN_TEST(what_is_not_of_one_instant_is_refused);
    RUN_TEST(bad_input_leaves_the_sums_as_they_were);
    return UNITY_END();
}
