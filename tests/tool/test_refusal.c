/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "fit/nominal.h"
#include "result/refusal.h"
#include "support.h"
#include "unity.h"

enum { MOST = 40 };

static calibrate_result result;
static positions data;
static position_origin origin[MOST];
static double mean[3 * MOST];
static refusal_direction more[REFUSAL_DIRECTIONS];

void setUp(void)
{
    memset(&result, 0, sizeof result);
    data = (positions){.name = "log", .mean = mean, .origin = origin};
    result.data = &data;
    result.refused = (refusal){.word = "too few", .wants_positions = 1};
}

void tearDown(void)
{
}

/* A reading of a sensor with an offset on all axes. */
static void add_reading(double x, double y, double z, double scale, double offset)
{
    const double length = sqrt(x * x + y * y + z * z);
    double *v = &mean[3 * (size_t)data.count++];

    v[0] = offset + scale * x / length;
    v[1] = offset + scale * y / length;
    v[2] = offset + scale * z / length;
}

/* As settle.h does where nothing is stated. */
static void take_nominal_from_range(void)
{
    double zero[3];
    double lsb[3];

    result.nominal.zero = result.nominal.lsb = NOMINAL_RANGE;
    TEST_ASSERT_TRUE(nominal_from_range(&data, 1, zero, lsb));
    TEST_ASSERT_TRUE(nominal_make(zero, lsb, 1, &result.nominal.calibration));
    result.settings.nominal = result.nominal.calibration;
}

static void assert_up(double within, double x, double y, double z, unsigned position)
{
    const double length = sqrt(x * x + y * y + z * z);
    invcal_calibration view;
    double up[3];

    TEST_ASSERT_NOT_EQUAL(REFUSAL_NO_VIEW, refusal_find_view(&result, &view));
    TEST_ASSERT_TRUE(refusal_up(&result, &view, position, up));
    TEST_ASSERT_DOUBLE_WITHIN(within, x / length, up[0]);
    TEST_ASSERT_DOUBLE_WITHIN(within, y / length, up[1]);
    TEST_ASSERT_DOUBLE_WITHIN(within, z / length, up[2]);
}

/* The range of a cap tells no zero: by the middle of it positions would lie all around. */
static void a_cap_is_seen_as_its_readings_are(void)
{
    invcal_calibration view;

    add_reading(0, 0, 1, 16384, 0);
    add_reading(0.3, 0, 1, 16384, 0);
    add_reading(0, 0.3, 1, 16384, 0);
    add_reading(-0.3, -0.3, 1, 16384, 0);
    take_nominal_from_range();
    TEST_ASSERT_EQUAL_INT(REFUSAL_BY_ZERO, refusal_find_view(&result, &view));
    assert_up(1e-12, 0.3, 0, 1, 1);
    assert_up(1e-12, -0.3, -0.3, 1, 3);
}

/* Readings that are never negative: zero lies in the middle. */
static void faces_of_unsigned_counts_are_seen_from_the_middle_of_the_range(void)
{
    invcal_calibration view;

    for (unsigned n = 0; n < 6; n++) {
        const double sign = n % 2 ? -1 : 1;
        add_reading(sign * (n / 2 == 0), sign * (n / 2 == 1), sign * (n / 2 == 2), 4000, 32768);
    }
    take_nominal_from_range();
    TEST_ASSERT_EQUAL_INT(REFUSAL_BY_RANGE, refusal_find_view(&result, &view));
    assert_up(1e-12, 1, 0, 0, 0);
    assert_up(1e-12, 0, -1, 0, 3);
}

static void a_nominal_that_is_stated_is_taken(void)
{
    const double zero[3] = {100, 100, 100};
    const double lsb[3] = {0.001, 0.001, 0.001};
    invcal_calibration view;

    add_reading(1, 2, -2, 1000, 100);
    result.nominal.zero = result.nominal.lsb = NOMINAL_GIVEN;
    TEST_ASSERT_TRUE(nominal_make(zero, lsb, 1, &result.settings.nominal));
    TEST_ASSERT_EQUAL_INT(REFUSAL_BY_NOMINAL, refusal_find_view(&result, &view));
    assert_up(1e-12, 1, 2, -2, 0);
}

static void what_has_no_length_is_not_seen(void)
{
    invcal_calibration view;

    TEST_ASSERT_EQUAL_INT(REFUSAL_NO_VIEW, refusal_find_view(&result, &view)); /* none at all */
    memset(mean, 0, sizeof mean);
    data.count = 3;
    TEST_ASSERT_EQUAL_INT(REFUSAL_NO_VIEW, refusal_find_view(&result, &view));
    mean[0] = 1e300;
    mean[3] = 1e300;
    mean[6] = -1e300;
    TEST_ASSERT_EQUAL_INT(REFUSAL_NO_VIEW, refusal_find_view(&result, &view));
}

/* Unit vectors, none within 26 degrees of another or of what is there. */
static void assert_apart(unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const double *u = more[i].up;
        double other[3];
        invcal_calibration view;
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1, sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
        TEST_ASSERT_TRUE(strlen(more[i].words) > 0);
        for (unsigned k = 0; k < i; k++) {
            const double *v = more[k].up;
            TEST_ASSERT_TRUE(u[0] * v[0] + u[1] * v[1] + u[2] * v[2] < 0.9);
        }
        (void)refusal_find_view(&result, &view);
        for (unsigned n = 0; n < data.count; n++) {
            TEST_ASSERT_TRUE(refusal_up(&result, &view, n, other));
            TEST_ASSERT_TRUE(u[0] * other[0] + u[1] * other[1] + u[2] * other[2] < 0.9);
        }
    }
}

static void twelve_are_asked_for_in_all(void)
{
    TEST_ASSERT_EQUAL_UINT(12, refusal_additions(&result, more));
    assert_apart(12);
    faces_of_unsigned_counts_are_seen_from_the_middle_of_the_range();
    TEST_ASSERT_EQUAL_UINT(6, refusal_additions(&result, more));
    assert_apart(6);
    result.refused.is_of_position = 1; /* the first is wrong: it is to be taken again */
    TEST_ASSERT_EQUAL_UINT(7, refusal_additions(&result, more));
    result.refused.wants_positions = 0;
    TEST_ASSERT_EQUAL_UINT(0, refusal_additions(&result, more));
}

/* A circle of twenty, however many, says nothing of its axis. */
static void a_circle_wants_positions_across(void)
{
    const unsigned planes = 20;
    double highest = 0;

    for (unsigned n = 0; n < planes; n++) {
        const double angle = 6.283185307179586 * n / planes;
        add_reading(cos(angle), sin(angle), 0, 16384, 0);
    }
    take_nominal_from_range();
    const unsigned count = refusal_additions(&result, more);
    TEST_ASSERT_TRUE(count >= 3 && count <= 6);
    for (unsigned i = 0; i < count; i++) {
        highest = fmax(highest, fabs(more[i].up[2]));
        TEST_ASSERT_TRUE(fabs(more[i].up[2]) > 0.5);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1, highest);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_cap_is_seen_as_its_readings_are);
    RUN_TEST(faces_of_unsigned_counts_are_seen_from_the_middle_of_the_range);
    RUN_TEST(a_nominal_that_is_stated_is_taken);
    RUN_TEST(what_has_no_length_is_not_seen);
    RUN_TEST(twelve_are_asked_for_in_all);
    RUN_TEST(a_circle_wants_positions_across);
    return UNITY_END();
}
