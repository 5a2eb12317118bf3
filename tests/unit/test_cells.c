/* SPDX-License-Identifier: MIT
 *
 * The cells of a magnetometer in motion: they have equal size, and their contents are exact.
 */
#include <math.h>
#include <string.h>

#include "magnetometer/cells.h"
#include "core/sums.h"
#include "support.h"
#include "unity.h"

/* Early, late, and the memory after them, which nothing may read. */
static invcal_private_cells table[3];
static const invcali_cell_tables both = {&table[0], &table[1]};

void setUp(void)
{
    memset(table, 0, sizeof table);
    memset(&table[2], 1, sizeof table[2]);
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
    invcali_row_of(h);
    return invcali_cell_of(h);
}

static void each_cell_holds_its_own_direction(void)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        invcal_real d[3];
        invcali_cell_direction(k, d);
        const double direction[3] = {(double)d[0], (double)d[1], (double)d[2]};
        TEST_ASSERT_EQUAL_UINT(k, cell_along(direction));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, length3(direction));
    }
}

/* Each an eighteenth of the sphere: within 5 standard deviations of a binomial. */
static void cells_have_equal_size(void)
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

static void fill(invcal_private_cells *cells, double shift, double scale)
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
        invcali_row_of(h);
        invcali_cells_add(cells, 3, h); /* in any direction */
    }
}

/* The rows of moved readings, of all of a cell's samples together: closed form. */
static void moved_rows_are_those_of_moved_readings(void)
{
    static const invcal_real shift[3] = {INVCAL_REAL(0.3), INVCAL_REAL(0.6), INVCAL_REAL(0.9)};
    invcal_private_cells moved;
    invcal_private_cells expected;
    unsigned count = 0;

    fill(&moved, 0, 1);
    fill(&expected, 0.3, 0.5);
    invcali_cells_move(&moved, shift, INVCAL_REAL(0.5));
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
    invcal_private_cells *const cells = &table[0];
    invcal_private_cells *const other = &table[1];
    const invcal_real h[INVCAL_PARAMETERS] = {1, 0, 0, 1, 0, 0, 0, 0, 0};

    for (long i = 0; i < 40000; i++) {
        invcali_cells_add(cells, 0, h);
        invcali_cells_add(other, 0, h);
        TEST_ASSERT_TRUE(cells->count[0] < 16384 &&
                         cells->sum[0][0] == (invcal_real)cells->count[0]);
    }
    invcali_cells_merge(cells, other);
    TEST_ASSERT_TRUE(cells->count[0] < 16384 && cells->sum[0][3] == (invcal_real)cells->count[0]);
    TEST_ASSERT_TRUE(cells->count[0] >= 8192 && other->count[0] == 0 && other->sum[0][0] == 0);
}

/* 8192 and 8192 fill a cell. */
static void a_cell_that_a_merge_fills_is_halved(void)
{
    for (unsigned n = 0; n < 2; n++) {
        table[n].count[2] = 8192;
        table[n].sum[2][1] = n == 0 ? 1000 : 3000;
    }
    invcali_cells_merge(&table[0], &table[1]);
    TEST_ASSERT_EQUAL_UINT(8192, table[0].count[2]);
    TEST_ASSERT_TRUE(table[0].sum[2][1] == 2000);
    TEST_ASSERT_EQUAL_UINT(0, table[1].count[2]);
}

static void expect_gap(double cosine, unsigned cell)
{
    unsigned worst = 99;
    const invcal_real gap = invcali_cells_gap(&both, &worst);

    TEST_ASSERT_DOUBLE_WITHIN(1e-6, cosine, (double)gap);
    TEST_ASSERT_TRUE(cosine < 1 || gap == 1);
    TEST_ASSERT_EQUAL_UINT(cell, worst);
}

/* Of equally bad cells, the first. A single sample covers a cell. */
static void a_gap_is_that_of_the_farthest_cell(void)
{
    expect_gap(-1, 0);
    table[0].count[0] = 1; /* +x: opposite -x */
    expect_gap(-1, 1);
    table[1].count[1] = 1; /* both: all others are within 90 degrees */
    expect_gap(0, 2);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        table[0].count[k] = k != 4;
    }
    expect_gap(sqrt(0.5), 4);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        table[1].count[k] = 1;
    }
    expect_gap(1, 4); /* has the fewest */
    memset(&table[0], 0, sizeof table[0]);
    expect_gap(1, 0);
    table[0].count[0] = 1;
    expect_gap(1, 1);
    table[0].count[0] = table[1].count[0] = 0;
    expect_gap(sqrt(0.5), 0);
}

/* ---- positions ---------------------------------------------------------------------------------- */

static const triad_truth truth = {{0.1, -0.05, 0.08, 0.04, -0.03, 0.02, 0.06, -0.05, 0.04}};

/* One exact sample of an ellipsoid in cell k, along its centre. */
static void add_exact(unsigned k)
{
    invcal_real h[INVCAL_PARAMETERS];
    invcal_real centre[3];
    double u[3];

    invcali_cell_direction(k, centre);
    const double eta[3] = {(double)centre[0], (double)centre[1], (double)centre[2]};
    triad_read(&truth, eta, u);
    for (int i = 0; i < 3; i++) {
        h[i] = (invcal_real)u[i];
    }
    invcali_row_of(h);
    invcali_cells_add(&table[k % 2], k, h);
}

static void expect_truth(const invcal_calibration *found)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-6, 1e-13), truth.x[r], parameter(found, r));
    }
}

/* Nine unknowns: the faces and an edge of each plane determine them, eight cells do not. */
static void nine_cells_are_enough(void)
{
    static const unsigned of_nine[] = {1, 2, 3, 4, 5, 6, 10, 14, 0};
    invcali_cell_fit fit = {.tables = {&table[0], &table[1]}};

    for (unsigned i = 0; i < 8; i++) {
        add_exact(of_nine[i]);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcali_cells_solve(&fit));
    add_exact(of_nine[8]);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_cells_solve(&fit));
    expect_truth(&fit.triad);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_cells_calibrate(&fit));
    TEST_ASSERT_EQUAL_UINT(9, fit.quality.positions);
    expect_truth(&fit.triad);
}

/* It lies along the mean of its samples, and has the root mean square of their calibrated
 * lengths. */
static void a_cell_is_a_position_with_the_length_of_its_samples(void)
{
    static const struct {
        invcal_calibration triad;
        invcal_real behind[4]; /* nothing may read it */
    } with = {{{INVCAL_REAL(0.25), INVCAL_REAL(-0.5), INVCAL_REAL(0.125)},
               {{1, INVCAL_REAL(0.5), INVCAL_REAL(0.25)},
                {INVCAL_REAL(-0.25), 2, INVCAL_REAL(0.5)},
                {INVCAL_REAL(0.75), INVCAL_REAL(-0.5), 1}}},
              {9, 9, 9, 9}};
    static const double sample[2][3] = {{1, 0.5, -0.25}, {0.5, 1.5, 0.75}};
    static const double mean[3] = {0.75, 1, 0.25};
    invcal_real point[3] = {7, 8, 9};
    double eta[3][3]; /* of the mean, and of both */

    TEST_ASSERT_EQUAL_UINT(0, invcali_cells_point(&both, &with.triad, 3, point));
    TEST_ASSERT_TRUE(point[0] == 7 && point[1] == 8 && point[2] == 9);
    for (unsigned n = 0; n < 3; n++) {
        for (unsigned i = 0; i < 3; i++) {
            eta[n][i] = 0;
            for (unsigned j = 0; j < 3; j++) {
                eta[n][i] += (double)with.triad.matrix[i][j] *
                             ((n == 0 ? mean[j] : sample[n - 1][j]) - (double)with.triad.offset[j]);
            }
        }
    }
    for (unsigned n = 1; n <= 2; n++) {
        invcal_real h[INVCAL_PARAMETERS] = {(invcal_real)sample[n - 1][0],
                                            (invcal_real)sample[n - 1][1],
                                            (invcal_real)sample[n - 1][2]};
        invcali_row_of(h);
        invcali_cells_add(&table[n - 1], 3, h);
        TEST_ASSERT_EQUAL_UINT(n, invcali_cells_point(&both, &with.triad, 3, point));
        const double square = n == 1 ? pow(length3(eta[1]), 2)
                                     : (pow(length3(eta[1]), 2) + pow(length3(eta[2]), 2)) / 2;
        const double ratio = sqrt(square) / length3(eta[n == 1 ? 1 : 0]);
        for (unsigned i = 0; i < 3; i++) {
            const double along = n == 1 ? sample[0][i] : mean[i];
            const double offset = (double)with.triad.offset[i];
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-6, 1e-14),
                                      offset + ratio * (along - offset), (double)point[i]);
        }
    }
}

/* ---- judgement ---------------------------------------------------------------------------------- */

/* The variance of a cell's mean, averaged over the cells, counts as 24 degrees of freedom: closed form. */
static void the_power_counts_as_24(void)
{
    const double power = 6e-4;
    const double expected = power * (1 + 1 / 50.0 + 1 / 4.0) / 3;
    const double seen = 2 * expected;
    const double noise = sqrt((seen + 24 * expected) / 25);
    invcali_cell_fit fit = {.tables = {&table[0], &table[1]},
                            .triad = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

    table[0].count[0] = 1;
    table[0].count[5] = 50;
    table[0].count[17] = 3;
    table[1].count[17] = 1;
    fit.quality.positions = 3;
    fit.quality.dof = 1;
    fit.quality.noise = (invcal_real)sqrt(seen);
    fit.quality.verdict = INVCAL_WEAK;
    fit.quality.weak = 1;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        fit.quality.sigma[r] = (invcal_real)(sqrt(seen) * (1 + r));
    }
    invcali_cells_weigh(&fit, (invcal_real)power);
    TEST_ASSERT_DOUBLE_WITHIN(3e-6 * noise, noise, (double)fit.quality.noise);
    TEST_ASSERT_EQUAL_UINT(25, fit.quality.sigma_dof);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-5 * noise, noise * (1 + r), (double)fit.quality.sigma[r]);
    }
    TEST_ASSERT_EQUAL_UINT(0, fit.quality.weak);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, fit.quality.verdict);
}

/* Two single samples whose mean has the variance 3/16: at 9/16 and above the scatter of the cells counts alone. */
static void cells_that_scatter_much_more_count_alone(void)
{
    static const struct {
        invcal_real noise;
        unsigned sigma_dof;
    } of[] = {{INVCAL_REAL(0.74), 26}, {INVCAL_REAL(0.75), 2}, {INVCAL_REAL(0.76), 2}};

    table[0].count[0] = 1;
    table[0].count[9] = 1;
    for (unsigned i = 0; i < 3; i++) {
        invcali_cell_fit fit = {.tables = {&table[0], &table[1]},
                                .quality = {.positions = 2, .dof = 2, .sigma_dof = 2}};
        fit.quality.noise = of[i].noise;
        invcali_cells_weigh(&fit, INVCAL_REAL(0.1875));
        TEST_ASSERT_EQUAL_UINT(of[i].sigma_dof, fit.quality.sigma_dof);
        TEST_ASSERT_TRUE((fit.quality.noise == of[i].noise) == (i > 0));
    }
}

/* Nine cells leave no redundancy, and cells that agree to the last bit show no scatter: sigma stays
 * as it was. */
static void what_shows_no_scatter_is_not_weighted(void)
{
    static invcal_private_cells cells;
    invcali_cell_fit fit = {.tables = {&cells, &cells}};
    random_source random = random_start(4);

    memset(&cells, 0, sizeof cells);
    for (int i = 0; i < 2000; i++) {
        invcal_real h[INVCAL_PARAMETERS];
        double d[3];
        random_direction(&random, d);
        for (int a = 0; a < 3; a++) {
            h[a] = (invcal_real)(1.01 * d[a] + 0.01 * random_normal(&random));
        }
        invcali_row_of(h);
        invcali_cells_add(&cells, invcali_cell_of(h), h);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_cells_calibrate(&fit));
    const invcali_cell_fit found = fit;
    invcali_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_TRUE(fit.quality.sigma_dof > found.quality.sigma_dof);
    fit = found;
    fit.quality.noise = 0;
    invcali_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_EQUAL_UINT(found.quality.sigma_dof, fit.quality.sigma_dof);
    fit = found;
    fit.quality.dof = 0;
    invcali_cells_weigh(&fit, INVCAL_REAL(1e-4));
    TEST_ASSERT_EQUAL_UINT(found.quality.sigma_dof, fit.quality.sigma_dof);
}

static void add_along(invcal_private_cells *cells, const double d[3], double shift, int samples)
{
    invcal_real h[INVCAL_PARAMETERS] = {(invcal_real)(d[0] + shift), (invcal_real)d[1],
                                        (invcal_real)d[2]};

    invcali_row_of(h);
    for (int i = 0; i < samples; i++) {
        invcali_cells_add(cells, invcali_cell_of(h), h);
    }
}

static const invcali_cell_fit as_they_are = {
    .tables = {&table[0], &table[1]},
    .triad = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
};

/* An offset and a length are four unknowns: four cells determine them, wherever these are, three do
 * not. Closed form: lengths of +x and -x change by the shift of 0.1, those across by 0.005; 100
 * samples before and after weigh 50. */
static void four_cells_show_a_step(void)
{
    static const double direction[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const unsigned sets[4][4] = {{0, 1, 2, 4}, {0, 1, 3, 5}, {5, 3, 0, 1}, {1, 0, 2, 5}};

    for (unsigned n = 0; n < 4; n++) {
        for (unsigned cells = 3; cells <= 4; cells++) {
            setUp();
            for (unsigned i = 0; i < cells; i++) {
                add_along(&table[0], direction[sets[n][i]], 0, 100);
                add_along(&table[1], direction[sets[n][i]], 0.1, 100);
            }
            /* 50 (0.105^2 + 0.095^2 + 2 0.005^2) = 1.005: more than 28 times 0.035, less than of
             * 0.037 */
            TEST_ASSERT_EQUAL_INT(cells == 4, invcali_cells_step(&as_they_are, INVCAL_REAL(0.035)));
            TEST_ASSERT_EQUAL_INT(0, invcali_cells_step(&as_they_are, INVCAL_REAL(0.037)));
            TEST_ASSERT_EQUAL_INT(0, invcali_cells_step(&as_they_are, 0));
        }
    }
}

/* An early sample in a cell, and a late one whose squared length is larger by 2 excess. */
static void add_longer(unsigned k, double excess)
{
    for (unsigned n = 0; n < 2; n++) {
        invcal_real h[INVCAL_PARAMETERS];
        invcali_cell_direction(k, h);
        for (unsigned i = 0; i < 3; i++) {
            h[i] *= (invcal_real)sqrt(1.2 + 2 * excess * n);
        }
        invcali_row_of(h);
        invcali_cells_add(&table[n], k, h);
    }
}

/* Six faces are longer by b, four edges by b + e, b - e, b - e and b + e, which no offset or length
 * explains. Single samples weigh 1/2: 5 b^2 is explained and 2 e^2 remains, with 6 degrees of
 * freedom. F is above 40 if 6 5 b^2 > 160 2 e^2: b > 3.266 e. A power of 1 shows nothing, and cells
 * that were seen only before, or only after, do not count. */
static void ten_cells_show_a_step_by_themselves(void)
{
    static const unsigned edge[] = {14, 15, 16, 17};

    TEST_ASSERT_EQUAL_UINT(INVCAL_CELLS, edge[3] + 1);
    for (unsigned faces = 5; faces <= 6; faces++) {
        for (unsigned n = 0; n < 3; n++) {
            static const double b[] = {0.032, 0.0334, 0.3};
            setUp();
            for (unsigned k = 0; k < faces; k++) {
                add_longer(k, b[n]);
            }
            for (unsigned i = 0; i < 4; i++) {
                add_longer(edge[i], b[n] + (i == 0 || i == 3 ? 0.01 : -0.01));
            }
            table[0].count[8] = 1;
            table[1].count[9] = 1;
            TEST_ASSERT_EQUAL_INT(faces == 6 && n > 0, invcali_cells_step(&as_they_are, 1));
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_cell_holds_its_own_direction);
    RUN_TEST(cells_have_equal_size);
    RUN_TEST(moved_rows_are_those_of_moved_readings);
    RUN_SLOW_TEST(a_full_cell_keeps_its_mean);
    RUN_TEST(a_cell_that_a_merge_fills_is_halved);
    RUN_TEST(what_shows_no_scatter_is_not_weighted);
    RUN_TEST(nine_cells_are_enough);
    RUN_TEST(a_cell_is_a_position_with_the_length_of_its_samples);
    RUN_TEST(the_power_counts_as_24);
    RUN_TEST(cells_that_scatter_much_more_count_alone);
    RUN_TEST(four_cells_show_a_step);
    RUN_TEST(ten_cells_show_a_step_by_themselves);
    RUN_TEST(a_gap_is_that_of_the_farthest_cell);
    return UNITY_END();
}
