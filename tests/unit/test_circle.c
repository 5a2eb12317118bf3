/* SPDX-License-Identifier: MIT
 *
 * Cosine and sine of an angle in degrees, against those of libm.
 */
#include <float.h>
#include <math.h>

#include "core/circle.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double RADIAN = 0.017453292519943295769;
/* The bound of circle.h; libm rounds, too, half a turn of radians to 2 DBL_EPSILON. */
static const double within = FLOAT_OR_DOUBLE(1.2e-7, 2.2e-16) + 2 * DBL_EPSILON;

static void assert_agrees_with_libm(double degrees)
{
    const invcal_real angle = (invcal_real)degrees;
    invcal_real c;
    invcal_real s;

    const double rest = fmod((double)angle, 360); /* exact, as what follows */
    const double half = rest > 180 ? rest - 360 : rest < -180 ? rest + 360 : rest;
    invcali_circle(angle, &c, &s);
    TEST_ASSERT_DOUBLE_WITHIN(within, cos(half * RADIAN), (double)c);
    TEST_ASSERT_DOUBLE_WITHIN(within, sin(half * RADIAN), (double)s);
}

static void cosine_and_sine_agree_with_libm_over_the_whole_turn(void)
{
    random_source random = random_start(1);

    for (int32_t i = -180000; i <= 180000; i += TEST_SHORT) {
        assert_agrees_with_libm(i / 1000.0);
    }
    for (int i = 0; i < SOME(20000); i++) {
        assert_agrees_with_libm(random_uniform(&random, -180, 180));
        assert_agrees_with_libm(random_uniform(&random, -720, 720));
        assert_agrees_with_libm(random_uniform(&random, -1e-3, 1e-3));
    }
}

/* At 45 and 135 degrees the series changes to another quarter. */
static void both_sides_of_a_seam_agree_with_libm(void)
{
    for (int seam = -720; seam <= 720; seam += 45) {
        for (int ulps = -3; ulps <= 3; ulps++) {
            const double angle = seam * (1 - ulps * (double)INVCAL_EPSILON);
            assert_agrees_with_libm(fmax(-720, fmin(720, angle)));
        }
    }
}

static void quarter_turns_are_exact(void)
{
    static const invcal_real cosine[4] = {1, 0, -1, 0};

    for (int quarter = -8; quarter <= 8; quarter++) {
        invcal_real c = 7;
        invcal_real s = 7;
        invcali_circle((invcal_real)(90 * quarter), &c, &s);
        TEST_ASSERT_TRUE(c == cosine[(quarter + 8) % 4]);
        TEST_ASSERT_TRUE(s == cosine[(quarter + 11) % 4]);
    }
}

/* To the last bit: beyond an eighth of a turn both angles are reduced, or neither. */
static void the_opposite_angle_has_the_same_cosine_and_the_opposite_sine(void)
{
    for (unsigned i = 0; i <= 720 * 16; i++) {
        const invcal_real angle = (invcal_real)i / 16;
        invcal_real c[2];
        invcal_real s[2];
        invcali_circle(angle, &c[0], &s[0]);
        invcali_circle(-angle, &c[1], &s[1]);
        TEST_ASSERT_TRUE(c[1] == c[0]);
        TEST_ASSERT_TRUE(s[1] == -s[0]);
    }
}

static void what_is_not_an_angle_has_no_sine(void)
{
    invcal_real c = 7;
    invcal_real s = 7;

    invcali_circle((invcal_real)NAN, &c, &s);
    TEST_ASSERT_TRUE(isnan(c) && isnan(s));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(cosine_and_sine_agree_with_libm_over_the_whole_turn);
    RUN_TEST(both_sides_of_a_seam_agree_with_libm);
    RUN_TEST(quarter_turns_are_exact);
    RUN_TEST(the_opposite_angle_has_the_same_cosine_and_the_opposite_sine);
    RUN_TEST(what_is_not_an_angle_has_no_sine);
    return UNITY_END();
}
