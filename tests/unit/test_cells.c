/* SPDX-License-Identifier: MIT
 *
 * The cells of a magnetometer in motion: they are as large as each other, and what they hold is exact.
 */
#include <math.h>
#include <string.h>

#include "cells.h"
#include "sums.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static unsigned cell_along(const double d[3])
{
    invcal_real h[INVCAL_PARAMETERS];

    for (int i = 0; i < 3; i++) {
        h[i] = (invcal_real)d[i];
    }
    invcal_row_of(h);
    return invcal_cell_of(h);
}

static void each_cell_holds_its_own_direction(void)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        invcal_real d[3];
        invcal_cell_direction(k, d);
        const double direction[3] = {(double)d[0], (double)d[1], (double)d[2]};
        TEST_ASSERT_EQUAL_UINT(k, cell_along(direction));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, length3(direction));
    }
}

/* Each an eighteenth of the sphere: within 5 standard deviations of a binomial. */
static void cells_are_as_large_as_each_other(void)
{
    const int draws = 18 * SOME(10000);
    random_source random = random_start(1);
    int count[INVCAL_CELLS] = {0};

    for (int i = 0; i < draws; i++) {
        double d[3];
        random_direction(&random, d);
        const unsigned k = cell_along(d);
        TEST_ASSERT_TRUE(k < INVCAL_CELLS);
        count[k]++;
    }
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        TEST_ASSERT_DOUBLE_WITHIN(5 * sqrt(draws / 18.0), draws / 18.0, count[k]);
    }
}

static void fill(invcal_cells *cells, double shift, double scale)
{
    random_source random = random_start(2);

    memset(cells, 0, sizeof *cells);
    for (int i = 0; i < 500; i++) {
        invcal_real h[INVCAL_PARAMETERS];
        double d[3];
        random_direction(&random, d);
        for (int a = 0; a < 3; a++) {
            h[a] = (invcal_real)((d[a] - shift * (a + 1)) / scale);
        }
        invcal_row_of(h);
        invcal_cells_add(cells, 3, h); /* wherever they point */
    }
}

/* The rows of moved readings, of all of a cell's samples together: closed form. */
static void moved_rows_are_those_of_moved_readings(void)
{
    static const invcal_real shift[3] = {INVCAL_REAL(0.3), INVCAL_REAL(0.6), INVCAL_REAL(0.9)};
    invcal_cells moved;
    invcal_cells expected;
    unsigned count = 0;

    fill(&moved, 0, 1);
    fill(&expected, 0.3, 0.5);
    invcal_cells_move(&moved, shift, INVCAL_REAL(0.5));
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        if (moved.count[k] > 0) {
            count++;
            TEST_ASSERT_EQUAL_UINT(500, moved.count[k]);
            for (int i = 0; i < INVCAL_PARAMETERS; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-2, 1e-10), (double)expected.sum[3][i],
                                          (double)moved.sum[k][i]);
            }
            const double direction[3] = {-1, -2, -3}; /* less the centre of a sphere around 0 */
            TEST_ASSERT_EQUAL_UINT(cell_along(direction), k);
        }
    }
    TEST_ASSERT_EQUAL_UINT(1, count);
}

static void a_full_cell_keeps_its_mean(void)
{
    static invcal_cells cells;
    static invcal_cells other;
    const invcal_real h[INVCAL_PARAMETERS] = {1, 0, 0, 1, 0, 0, 0, 0, 0};

    memset(&cells, 0, sizeof cells);
    memset(&other, 0, sizeof other);
    for (long i = 0; i < 40000; i++) {
        invcal_cells_add(&cells, 0, h);
        invcal_cells_add(&other, 0, h);
        TEST_ASSERT_TRUE(cells.count[0] < 16384 && cells.sum[0][0] == (invcal_real)cells.count[0]);
    }
    invcal_cells_merge(&cells, &other);
    TEST_ASSERT_TRUE(cells.count[0] < 16384 && cells.sum[0][3] == (invcal_real)cells.count[0]);
    TEST_ASSERT_TRUE(cells.count[0] >= 8192 && other.count[0] == 0 && other.sum[0][0] == 0);
}

/* Between two faces, and between a face and an edge; none; and all but one covered. */
static void a_gap_is_that_of_the_farthest_cell(void)
{
    invcal_cells cells;
    const invcal_cell_tables tables = {&cells, &cells};
    const invcal_real h[INVCAL_PARAMETERS] = {0};
    unsigned worst = 99;

    memset(&cells, 0, sizeof cells);
    TEST_ASSERT_TRUE(invcal_cells_gap(&tables, &worst) == -1);
    invcal_cells_add(&cells, 0, h); /* +x: opposite -x */
    TEST_ASSERT_TRUE(invcal_cells_gap(&tables, &worst) == -1);
    TEST_ASSERT_EQUAL_UINT(1, worst);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        if (k != 4) {
            invcal_cells_add(&cells, k, h);
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, sqrt(0.5), (double)invcal_cells_gap(&tables, &worst));
    TEST_ASSERT_EQUAL_UINT(4, worst);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        invcal_cells_add(&cells, k, h);
    }
    TEST_ASSERT_TRUE(invcal_cells_gap(&tables, &worst) == 1);
    TEST_ASSERT_EQUAL_UINT(4, worst); /* has the fewest */
}

/* Nine cells leave nothing over, and cells that agree to the last bit tell no scatter: sigma stays as it was. */
static void what_shows_no_scatter_is_not_weighed(void)
{
    static invcal_cells cells;
    invcal_cell_fit fit = {.tables = {&cells, &cells}};
    random_source random = random_start(4);

    memset(&cells, 0, sizeof cells);
    for (int i = 0; i < 2000; i++) {
        invcal_real h[INVCAL_PARAMETERS];
        double d[3];
        random_direction(&random, d);
        for (int a = 0; a < 3; a++) {
            h[a] = (invcal_real)(1.01 * d[a] + 0.01 * random_normal(&random));
        }
        invcal_row_of(h);
        invcal_cells_add(&cells, invcal_cell_of(h), h);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_cells_calibrate(&fit));
    const invcal_cell_fit found = fit;
    invcal_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_TRUE(fit.quality.sigma_dof > found.quality.sigma_dof);
    fit = found;
    fit.quality.noise = 0;
    invcal_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_EQUAL_UINT(found.quality.sigma_dof, fit.quality.sigma_dof);
    fit = found;
    fit.quality.dof = 0;
    invcal_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_EQUAL_UINT(found.quality.sigma_dof, fit.quality.sigma_dof);
}

static void add_along(invcal_cells *cells, const double d[3], double shift, int samples)
{
    invcal_real h[INVCAL_PARAMETERS] = {(invcal_real)(d[0] + shift), (invcal_real)d[1],
                                        (invcal_real)d[2]};

    invcal_row_of(h);
    for (int i = 0; i < samples; i++) {
        invcal_cells_add(cells, invcal_cell_of(h), h);
    }
}

/* An offset and a length are four unknowns: four cells tell them, wherever these are, three do not. Closed form: lengths
 * of +x and -x change by the shift of 0.1, those across by 0.005; 100 samples before and after weigh 50. */
static void four_cells_tell_a_step(void)
{
    static const double direction[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const unsigned sets[4][4] = {{0, 1, 2, 4}, {0, 1, 3, 5}, {5, 3, 0, 1}, {1, 0, 2, 5}};
    static const invcal_calibration same = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    static invcal_cells early;
    static invcal_cells late;

    for (unsigned n = 0; n < 4; n++) {
        for (unsigned cells = 3; cells <= 4; cells++) {
            const invcal_cell_fit fit = {.tables = {&early, &late}, .triad = same};
            memset(&early, 0, sizeof early);
            memset(&late, 0, sizeof late);
            for (unsigned i = 0; i < cells; i++) {
                add_along(&early, direction[sets[n][i]], 0, 100);
                add_along(&late, direction[sets[n][i]], 0.1, 100);
            }
            /* 50 (0.105^2 + 0.095^2 + 2 0.005^2) = 1.005 is told: more than 28 times 0.035, less than of 0.037 */
            TEST_ASSERT_EQUAL_INT(cells == 4, invcal_cells_step(&fit, INVCAL_REAL(0.035)));
            TEST_ASSERT_EQUAL_INT(0, invcal_cells_step(&fit, INVCAL_REAL(0.037)));
            TEST_ASSERT_EQUAL_INT(0, invcal_cells_step(&fit, 0));
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_cell_holds_its_own_direction);
    RUN_TEST(cells_are_as_large_as_each_other);
    RUN_TEST(moved_rows_are_those_of_moved_readings);
    RUN_SLOW_TEST(a_full_cell_keeps_its_mean);
    RUN_TEST(what_shows_no_scatter_is_not_weighed);
    RUN_TEST(four_cells_tell_a_step);
    RUN_TEST(a_gap_is_that_of_the_farthest_cell);
    return UNITY_END();
}
