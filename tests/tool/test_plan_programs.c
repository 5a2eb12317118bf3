/* SPDX-License-Identifier: MIT
 *
 * Sets for a stand, shares of the dwell, bounds: against reference.py and closed forms.
 */
#include <math.h>
#include <string.h>

#include "design/bound.h"
#include "cli/command.h"
#include "design/covariance.h"
#include "design/design.h"
#include "expected.h"
#include "design/grid.h"
#include "support.h"
#include "unity.h"
#include "design/weights.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { NINE = INVCAL_PARAMETERS };

static design set;

static void make(const char *word)
{
    TEST_ASSERT_EQUAL_INT(EXIT_GOOD, design_make(&set, "plan", word));
}

/* ---- programs ---- */

static void programs_have_the_figures_of_the_reference(void)
{
    static const char *const words[] = {"per-group:5", "per-group:6", "stand-24",
                                        "edges",       "stand-12",    "icosahedron"};

    for (int k = 0; k < 6; k++) {
        const double *expected = expected_programs[k];
        double bound[NINE];
        make(words[k]);
        bound_find(&set, bound);
        const double found[9] = {set.count,
                                 set.criteria.sigma_delta,
                                 set.criteria.sigma_dk,
                                 set.criteria.sigma_gamma,
                                 set.criteria.condition,
                                 set.criteria.log_det,
                                 bound_largest(bound, 0),
                                 bound_largest(bound, 1),
                                 bound_largest(bound, 2)};
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-12 * fabs(expected[i]), expected[i], found[i]);
        }
    }
}

static void twenty_four_positions_are_eighteen_directions(void)
{
    make("stand-24");
    TEST_ASSERT_EQUAL_UINT(24, set.count);
    TEST_ASSERT_EQUAL_UINT(18, design_distinct(&set));
    make("per-group:6");
    TEST_ASSERT_EQUAL_UINT(18, design_distinct(&set));
}

static void no_position_of_stand_12_is_on_an_axis(void)
{
    make("stand-12");
    TEST_ASSERT_EQUAL_UINT(0, set.axes);
    for (unsigned i = 0; i < set.count; i++) {
        TEST_ASSERT_EQUAL_UINT(1 + i / 4, set.position[i].group);
    }
}

/* ---- bounds ---- */

/* The errors that attain a bound: in each position, E times the sign of its element of H+. Least
 * squares with them, by elimination, are wrong by the bound. */
static void a_bound_is_reached_by_the_errors_that_it_is_for(void)
{
    double bound[NINE];

    make("edges");
    bound_find(&set, bound);
    for (unsigned r = 0; r < NINE; r++) {
        double K[NINE][NINE];
        double right[NINE] = {0};
        double wrong = 0;
        (void)covariance_find(expected_faces_and_edges, NULL, 18, K);
        for (unsigned i = 0; i < 18; i++) {
            double h[NINE];
            double element = 0;
            covariance_row(expected_faces_and_edges[i], h);
            for (unsigned c = 0; c < NINE; c++) {
                element += K[r][c] * h[c];
            }
            for (unsigned c = 0; c < NINE; c++) {
                right[c] += h[c] * (element > 0 ? 1 : -1);
            }
        }
        for (unsigned c = 0; c < NINE; c++) {
            wrong += K[r][c] * right[c];
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-7, wrong, bound[r]);
    }
}

/* ---- shares ---- */

static void shares_of_faces_and_edges_are_a_thirtieth_and_a_fifteenth(void)
{
    make("edges");
    design_weigh(&set);
    for (unsigned i = 0; i < set.count; i++) {
        const int is_face = invcali_axis_up(set.position[i].vertical) != 0;
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, is_face ? 1.0 / 30 : 1.0 / 15, set.position[i].share / 18);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, expected_shared_log_det[0], set.criteria.log_det);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, weights_bound(18), set.criteria.log_det);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, expected_programs[3][5], set.equal_log_det);
}

static void the_axes_of_table_2_have_no_share(void)
{
    make("per-group:6");
    design_weigh(&set);
    for (unsigned i = 0; i < set.count; i++) {
        const int is_axis = invcali_axis_up(set.position[i].vertical) != 0;
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, is_axis ? 0 : 1.0 / 12, set.position[i].share / 18);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-8, expected_shared_log_det[1], set.criteria.log_det);
    TEST_ASSERT_EQUAL_UINT(0, set.axes);
}

static void shares_of_scattered_directions_are_those_of_another_algorithm(void)
{
    double share[20];

    weights_find(expected_scattered20, 20, share);
    for (unsigned i = 0; i < 20; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, expected_scattered20_share[i], share[i] / 20);
    }
}

static void positions_that_point_the_same_way_have_the_same_share(void)
{
    make("stand-24");
    design_weigh(&set);
    for (unsigned i = 0; i < set.count; i++) {
        const int is_axis = invcali_axis_up(set.position[i].vertical) != 0;
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, is_axis ? 1.0 / 60 : 1.0 / 15, set.position[i].share / 24);
    }
}

/* ---- stops ---- */

static void on_a_grid_exchanges_from_many_starts_find_no_more(void)
{
    for (int k = 0; k < 6; k++) {
        const double *expected = expected_on_grid[k];
        double direction[OPTIMAL_MAX][3];
        double K[NINE][NINE];
        const unsigned n = (unsigned)expected[1];
        grid_directions(n, (unsigned)expected[0], 0, direction);
        const double found = covariance_find((const double(*)[3])direction, NULL, n, K);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(expected[2] - 1e-9, found);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(weights_bound(n) + 1e-7, found);
    }
}

static void twelve_positions_on_stops_of_30_degrees_are_stand_12(void)
{
    make("grid:30:12");
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, expected_programs[4][5], set.criteria.log_det);
}

static void angles_on_a_grid_are_multiples_of_its_step(void)
{
    static const char *const words[] = {"grid:15:18", "grid:30:24:axes", "grid:45:40"};

    for (int k = 0; k < 3; k++) {
        const double step = 15 * (k + 1);
        make(words[k]);
        for (unsigned i = 0; i < set.count; i++) {
            const design_position *p = &set.position[i];
            TEST_ASSERT_FALSE(fabs(remainder(p->alpha, step)) > 0);
            TEST_ASSERT_FALSE(fabs(remainder(p->beta, step)) > 0);
            TEST_ASSERT_TRUE(p->alpha > -180 && p->beta > -180);
        }
    }
    make("grid:30:24:axes");
    TEST_ASSERT_EQUAL_UINT(0x3F, set.axes);
    make("grid:45:26");
    TEST_ASSERT_EQUAL_UINT(26, design_distinct(&set));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(programs_have_the_figures_of_the_reference);
    RUN_TEST(twenty_four_positions_are_eighteen_directions);
    RUN_TEST(no_position_of_stand_12_is_on_an_axis);
    RUN_TEST(a_bound_is_reached_by_the_errors_that_it_is_for);
    RUN_TEST(shares_of_faces_and_edges_are_a_thirtieth_and_a_fifteenth);
    RUN_TEST(the_axes_of_table_2_have_no_share);
    RUN_TEST(shares_of_scattered_directions_are_those_of_another_algorithm);
    RUN_TEST(positions_that_point_the_same_way_have_the_same_share);
    RUN_TEST(on_a_grid_exchanges_from_many_starts_find_no_more);
    RUN_TEST(twelve_positions_on_stops_of_30_degrees_are_stand_12);
    RUN_TEST(angles_on_a_grid_are_multiples_of_its_step);
    return UNITY_END();
}
