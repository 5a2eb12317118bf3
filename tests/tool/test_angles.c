/* SPDX-License-Identifier: MIT */
#include "maths/angles.h"

#include <math.h>

#include "expected.h"
#include "support.h"
#include "unity.h"

#define RADIANS 0.017453292519943295

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- directions --------------------------------------------------------------------------------- */

static void directions_are_those_of_the_angles(void)
{
    for (int alpha = -360; alpha <= 360; alpha += 15) {
        for (int beta = -360; beta <= 360; beta += 15) {
            double up[3];
            angles_direction(alpha, beta, up);
            const double a = RADIANS * alpha;
            const double b = RADIANS * beta;
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, sin(a) * sin(b), up[0]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, cos(a), up[1]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, sin(a) * cos(b), up[2]);
        }
    }
}

static void directions_of_table_2_are_those_of_the_paper(void)
{
    for (int k = 0; k < 18; k++) {
        const int step = 60 * (k % 6);
        double up[3];
        angles_direction(k < 6    ? 30 + step
                         : k < 12 ? -90
                                  : 120 + step,
                         k < 6    ? 0
                         : k < 12 ? 30 + step
                                  : 90,
                         up);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, expected_plan18[k][i], up[i]);
        }
    }
}

static void quarters_of_a_turn_are_exact(void)
{
    for (int alpha = -360; alpha <= 360; alpha += 90) {
        for (int beta = -360; beta <= 360; beta += 90) {
            double up[3];
            double sum = 0;
            angles_direction(alpha, beta, up);
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_FALSE(signbit(up[i]) && !(up[i] < 0));
                sum += fabs(up[i]);
            }
            TEST_ASSERT_FALSE(sum < 1 || sum > 1);
        }
    }
}

/* A vector of the unit is turned as the direction requires: its component along up is its product
 * with eta, its length stays, x with beta = 0 stays in place, and the axes are not mirrored. */
static void the_unit_turns_as_its_directions_say(void)
{
    static const double axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    for (int k = 0; k < 50; k++) {
        const double alpha = 17.0 * k - 400;
        const double beta = 31.0 * k - 700;
        double eta[3];
        double to[3][3];
        angles_direction(alpha, beta, eta);
        for (int i = 0; i < 3; i++) {
            angles_vector(alpha, beta, axis[i], to[i]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, eta[i], to[i][1]);
            TEST_ASSERT_DOUBLE_WITHIN(
                1e-14, 1, to[i][0] * to[i][0] + to[i][1] * to[i][1] + to[i][2] * to[i][2]);
        }
        for (int i = 0; i < 3; i++) { /* z is x cross y */
            const int j = (i + 1) % 3;
            const int l = (i + 2) % 3;
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, to[0][j] * to[1][l] - to[0][l] * to[1][j], to[2][i]);
        }
        angles_vector(alpha, 0, axis[0], to[0]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, 1, to[0][0]);
    }
}

/* ---- angles ------------------------------------------------------------------------------------- */

static void angles_of_a_direction_lead_back_to_it(void)
{
    random_source random = random_start(19);

    for (int n = 0; n < 1000; n++) {
        double up[3];
        double back[3];
        random_direction(&random, up);
        const stand_angles a = angles_of(up);
        angles_direction(a.alpha, a.beta, back);
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, up[i], back[i]);
        }
        TEST_ASSERT_TRUE(a.alpha >= 0 && a.alpha <= 180 && a.beta > -180 && a.beta <= 180);
    }
}

static void the_length_of_a_direction_is_free(void)
{
    const double up[3] = {0, 0, -9.81};
    const double along[3] = {0, -9.81, 0};

    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 90, angles_of(up).alpha);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 180, angles_of(up).beta);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 180, angles_of(along).alpha);
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, angles_of(along).beta);
}

static void of_the_two_pairs_the_nearer_is_found(void)
{
    for (int alpha = -170; alpha <= 180; alpha += 10) {
        for (int beta = -170; beta <= 180; beta += 10) {
            const stand_angles near = {alpha + 7, beta - 5};
            double up[3];
            angles_direction(alpha, beta, up);
            const stand_angles a = angles_near(up, near);
            TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0, angles_turn(alpha, a.alpha));
            if (alpha % 180 != 0) { /* otherwise beta turns nothing */
                TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0, angles_turn(beta, a.beta));
            } else {
                TEST_ASSERT_DOUBLE_WITHIN(1e-9, near.beta, a.beta);
            }
        }
    }
}

static void a_turn_is_the_shorter_way_round(void)
{
    const double cases[][3] = {{0, 90, 90},      {170, -170, 20},  {-170, 170, -20}, {0, 180, 180},
                               {180, 0, 180},    {-90, 120, -150}, {350, 10, 20},    {45, 45, 0},
                               {-180, 180, 0},   {0, -180, 180},   {0, -360, 0},     {0, 360, 0},
                               {0, 270.5, -89.5}};

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double turn = angles_turn(cases[i][0], cases[i][1]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, cases[i][2], turn);
        TEST_ASSERT_FALSE(signbit(turn) && !(turn < 0));
    }
}

/* ---- in words ----------------------------------------------------------------------------------- */

static void angles_are_printed_without_needless_zeros(void)
{
    char text[ANGLES_TEXT_MAX];

    TEST_ASSERT_EQUAL_STRING("alpha -90, beta 37.5°", angles_text((stand_angles){-90, 37.5}, text));
    TEST_ASSERT_EQUAL_STRING("alpha 0, beta 0°", angles_text((stand_angles){-0.001, 0.004}, text));
    TEST_ASSERT_EQUAL_STRING(
        "turn alpha +10, beta -20°",
        angles_turn_text((stand_angles){175, 0}, (stand_angles){-175, -20}, text));
    TEST_ASSERT_EQUAL_STRING("turn beta +180°",
                             angles_turn_text((stand_angles){1, 0}, (stand_angles){1, 180}, text));
    TEST_ASSERT_EQUAL_STRING("",
                             angles_turn_text((stand_angles){1, 2}, (stand_angles){1, 362}, text));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(directions_are_those_of_the_angles);
    RUN_TEST(the_unit_turns_as_its_directions_say);
    RUN_TEST(directions_of_table_2_are_those_of_the_paper);
    RUN_TEST(quarters_of_a_turn_are_exact);
    RUN_TEST(angles_of_a_direction_lead_back_to_it);
    RUN_TEST(the_length_of_a_direction_is_free);
    RUN_TEST(of_the_two_pairs_the_nearer_is_found);
    RUN_TEST(a_turn_is_the_shorter_way_round);
    RUN_TEST(angles_are_printed_without_needless_zeros);
    return UNITY_END();
}
