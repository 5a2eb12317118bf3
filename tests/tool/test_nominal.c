/* SPDX-License-Identifier: MIT
 *
 * Zero and scale from few positions.
 */
#include <math.h>

#include "fit/nominal.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double zero[3] = {120, -80, 30};
#define RADIUS 2000.0

static void read(const double (*up)[3], unsigned count, double *raw)
{
    for (unsigned n = 0; n < 3 * count; n++) {
        raw[n] = zero[n % 3] + RADIUS * up[n / 3][n % 3];
    }
}

/* The centre of their box is not the zero. */
static void four_positions_show_the_sphere(void)
{
    static const double up[4][3] = {{0, 0, 1}, {1, 0, 0}, {0.6, 0.8, 0}, {-0.48, 0.6, -0.64}};
    double raw[12];
    invcal_calibration c;

    read(up, 4, raw);
    TEST_ASSERT_EQUAL(1, nominal_from_sphere(raw, 4, &c));
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-9 * RADIUS, zero[i], c.offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-12, i == j ? 1 / RADIUS : 0, c.matrix[i][j]);
        }
    }
}

static void refuses(const double (*up)[3], unsigned count)
{
    double raw[21];
    invcal_calibration c = {.offset = {7}};

    read(up, count, raw);
    TEST_ASSERT_EQUAL(0, nominal_from_sphere(raw, count, &c));
    TEST_ASSERT_EQUAL_DOUBLE(7, c.offset[0]);
}

/* In the plane x + y + z = 1 all spheres through them have centres on a line. */
static void a_plane_shows_no_zero(void)
{
    static const double up[7][3] = {{1, 0, 0},
                                    {0, 1, 0},
                                    {0, 0, 1},
                                    {-1 / 3.0, 2 / 3.0, 2 / 3.0},
                                    {2 / 3.0, -1 / 3.0, 2 / 3.0},
                                    {2 / 3.0, 2 / 3.0, -1 / 3.0},
                                    {0.001, 0, 1}};
    for (unsigned n = 0; n <= 7; n++) {
        refuses(up, n);
    }
}

static void one_position_again_and_again_shows_none(void)
{
    static const double up[7][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1},
                                    {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    refuses(up, 7);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(four_positions_show_the_sphere);
    RUN_TEST(a_plane_shows_no_zero);
    RUN_TEST(one_position_again_and_again_shows_none);
    return UNITY_END();
}
