/* SPDX-License-Identifier: MIT
 *
 * What angles that are held do to lengths, and to intervals.
 */
#include <math.h>
#include <string.h>

#include "result/faces.h"
#include "unity.h"

#define T4 2.7764 /* Student's t of four degrees of freedom, 95 % */
#define NORMAL 1.95996

void setUp(void)
{
}

void tearDown(void)
{
}

static const double corner[3] = {0.57735026918962576, 0.57735026918962576, -0.57735026918962576};

static calibrate_result of_held(uint16_t held, double sigma)
{
    calibrate_result r = {.data = NULL};

    r.settings.is_six_faces = 1;
    r.quality.from_prior = held;
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        r.quality.sigma[p] = sigma;
    }
    return r;
}

static void three_angles_cost_most_on_a_corner(void)
{
    const calibrate_result r = of_held(0x1C0, 0.01);
    const faces_error e = faces_error_of(&r);

    TEST_ASSERT_DOUBLE_WITHIN(1e-7, NORMAL * 0.01 / sqrt(5), e.rms);
    TEST_ASSERT_DOUBLE_WITHIN(2e-5, NORMAL * 0.01 / sqrt(3), e.max);
}

static void one_angle_costs_most_on_its_edge(void)
{
    const calibrate_result r = of_held(1u << INVCAL_GAMMA_XZ, 0.01);
    const faces_error e = faces_error_of(&r);

    TEST_ASSERT_DOUBLE_WITHIN(1e-7, NORMAL * 0.01 / sqrt(15), e.rms);
    TEST_ASSERT_DOUBLE_WITHIN(1e-7, NORMAL * 0.01 / 2, e.max);
}

/* On a corner an offset is seen by 1/sqrt(3), an angle by 1/3. */
static void an_interval_widens_what_is_estimated_only(void)
{
    const double offset = 3e-3;
    const double angle = 1e-2;
    uncertainty u = {.unit = 1000};

    for (unsigned p = 0; p < 3; p++) {
        u.covariance[INVCAL_PACKED(p, p)] = offset * offset;
        u.covariance[INVCAL_PACKED(p + 6, p + 6)] = angle * angle;
    }
    const double estimated = offset * offset;
    const double stated = angle * angle / 3;
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1000 * sqrt(estimated + stated), uncertainty_sigma(&u, corner));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1000 * sqrt(T4 * T4 * estimated + NORMAL * NORMAL * stated),
                              uncertainty_half_width(&u, corner, T4, 0x1C0));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1000 * T4 * sqrt(estimated + stated),
                              uncertainty_half_width(&u, corner, T4, 0));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1000 * NORMAL * sqrt(estimated + stated),
                              uncertainty_half_width(&u, corner, T4, 0x1FF));
}

/* Parameters that belong together take their covariance with them. */
static void what_is_held_together_counts_together(void)
{
    uncertainty u = {.unit = 1};

    u.covariance[INVCAL_PACKED(6, 6)] = 1e-4;
    u.covariance[INVCAL_PACKED(7, 7)] = 1e-4;
    u.covariance[INVCAL_PACKED(7, 6)] = -0.5e-4; /* xy of the corner is 1/3, xz -1/3 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, sqrt(3e-4) / 3, uncertainty_sigma(&u, corner));
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, NORMAL * sqrt(3e-4) / 3,
                              uncertainty_half_width(&u, corner, T4, 0x0C0));
}

static void of_each_parameter_its_own_interval(void)
{
    const fit_quality q = {.coverage = T4, .from_prior = 1u << INVCAL_GAMMA_XY | 1u << INVCAL_DK_Y};

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        const int is_stated = p == INVCAL_GAMMA_XY || p == INVCAL_DK_Y;
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, is_stated ? NORMAL : T4, fit_coverage(&q, p));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(three_angles_cost_most_on_a_corner);
    RUN_TEST(one_angle_costs_most_on_its_edge);
    RUN_TEST(an_interval_widens_what_is_estimated_only);
    RUN_TEST(what_is_held_together_counts_together);
    RUN_TEST(of_each_parameter_its_own_interval);
    return UNITY_END();
}
