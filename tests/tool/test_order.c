/* SPDX-License-Identifier: MIT */
#include "design/order.h"

#include <math.h>
#include <string.h>

#include "expected.h"
#include "design/optimal.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static double way_of(const double (*v)[3], unsigned count)
{
    double path = 0;

    for (unsigned k = 1; k < count; k++) {
        const double dot = v[k][0] * v[k - 1][0] + v[k][1] * v[k - 1][1] + v[k][2] * v[k - 1][2];
        path += acos(fmax(-1, fmin(1, dot)));
    }
    return path / (count - 1);
}

/* Six directions and their opposites, then all again: 24. In the second half of a round trip each is met
 * as long after the middle as before it, so nothing that is odd in time is made of the nine columns,
 * which are the same both times. */
static void a_round_trip_shows_a_drift_as_well_as_possible(void)
{
    double v[24][3];

    for (unsigned i = 0; i < 12; i++) {
        memcpy(v[i], expected_plan18[i + 3], sizeof v[i]);
        memcpy(v[23 - i], v[i], sizeof v[i]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1, order_drift_factor((const double(*)[3])v, NULL, 24));
}

/* Nine equations have a solution in nine parameters, whatever drifts. */
static void nine_positions_hide_a_drift(void)
{
    double v[9][3];

    optimal_directions(9, 0, v);
    TEST_ASSERT_TRUE(isinf(order_drift_factor((const double(*)[3])v, NULL, 9)));
}

/* The figure for the program as the paper prints it: 1.39. */
static void the_program_of_the_paper_shows_it_to_1_39(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.005, 1.39, order_drift_factor(expected_plan18, NULL, 18));
}

static void order_as(const double (*given)[3], unsigned count, double most)
{
    double v[OPTIMAL_MAX][3];
    unsigned seen = 0;

    memcpy(v, given, count * sizeof *v);
    order_directions(v, count);
    for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < count; k++) {
            if (memcmp(v[i], given[k], sizeof v[i]) == 0) {
                seen++;
                break;
            }
        }
    }
    TEST_ASSERT_EQUAL_UINT(count, seen);
    TEST_ASSERT_EQUAL_MEMORY(given[0], v[0], sizeof v[0]);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(most, order_drift_factor((const double(*)[3])v, NULL, count));
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.2, way_of((const double(*)[3])v, count)); /* 69 degrees */
}

static void an_order_is_found_that_shows_it_with_short_turns(void)
{
    static const unsigned counts[] = {18, 24, 36};
    double v[OPTIMAL_MAX][3];

    order_as(expected_plan18, 18, 1.15);
    order_as(expected_faces_and_edges, 18, 1.15);
    for (unsigned i = 0; i < 3; i++) {
        optimal_directions(counts[i], 0, v);
        order_as((const double(*)[3])v, counts[i], 1.15);
    }
}

static void one_and_two_positions_stay_as_they_are(void)
{
    double v[2][3] = {{1, 0, 0}, {0, 1, 0}};

    order_directions(v, 1);
    order_directions(v, 2);
    TEST_ASSERT_TRUE(v[0][0] > 0 && v[1][1] > 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_round_trip_shows_a_drift_as_well_as_possible);
    RUN_TEST(nine_positions_hide_a_drift);
    RUN_TEST(the_program_of_the_paper_shows_it_to_1_39);
    RUN_TEST(an_order_is_found_that_shows_it_with_short_turns);
    RUN_TEST(one_and_two_positions_stay_as_they_are);
    return UNITY_END();
}
