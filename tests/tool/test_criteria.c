/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <string.h>

#include "design/criteria.h"
#include "expected.h"
#include "invcal/plan.h"
#include "invcal/positions.h"
#include "plan/plan_axes.h"
#include "support.h"
#include "core/system.h"
#include "unity.h"

/* Slow machines may take fewer; the bounds follow. */
#ifndef PLAN_DRAWS
#define PLAN_DRAWS 20000
#endif

void setUp(void)
{
}

void tearDown(void)
{
}

enum { NINE = INVCAL_PARAMETERS };
enum { SCALES = 0x038, ANGLES = 0x1C0, ALL = 0x1FF }; /* parameters, as bits */
static const double TURN = 6.283185307179586;
static const double close = 1e-12; /* relative */
static const double close_condition = 1e-12;

/* ---- helpers ---- */

static invcal_sums design_of(const double v[][3], unsigned count)
{
    invcal_sums design;

    invcal_sums_init(&design);
    for (unsigned i = 0; i < count; i++) {
        criteria_add(&design, v[i]);
    }
    return design;
}

static criteria judge(const invcal_sums *design)
{
    criteria c;

    TEST_ASSERT_TRUE(criteria_evaluate(design, &c));
    return c;
}

static invcal_sums design_of_plan(const invcal_plan *plan)
{
    invcal_sums design;
    invcal_plan_position p;

    invcal_sums_init(&design);
    for (unsigned i = 0; i < 3 * plan->per_group; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_get(plan, i, &p));
        criteria_add(&design, p.up);
    }
    return design;
}

static invcal_plan random_plan(random_source *random, unsigned per_group)
{
    invcal_plan plan;

    plan.per_group = per_group;
    for (int g = 0; g < 3; g++) {
        plan.start_deg[g] = random_uniform(random, -360, 360);
    }
    return plan;
}

static void assert_near(double relative, double expected, double actual)
{
    TEST_ASSERT_DOUBLE_WITHIN(relative * fabs(expected), expected, actual);
}

/* The five figures, to the precision that is promised for the programs. */
static void assert_criteria(const double expected[5], const criteria *c)
{
    assert_near(close, expected[0], c->sigma_delta);
    assert_near(close, expected[1], c->sigma_dk);
    assert_near(close, expected[2], c->sigma_gamma);
    assert_near(close_condition, expected[3], c->condition);
    assert_near(close, expected[4], c->log_det);
}

/* A design that cannot be evaluated: nothing is touched. */
static void assert_undetermined(const invcal_sums *design)
{
    const invcal_sums design_before = *design;
    criteria c;
    criteria before;

    memset(&c, 7, sizeof c);
    before = c;
    TEST_ASSERT_FALSE(criteria_evaluate(design, &c));
    TEST_ASSERT_EQUAL_MEMORY(&before, &c, sizeof before);
    TEST_ASSERT_EQUAL_MEMORY(&design_before, design, sizeof design_before);
}

/* A set that cannot be evaluated, and the parameters that it leaves open. */
static unsigned open_in(const double v[][3], unsigned count)
{
    const invcal_sums design = design_of(v, count);
    const invcal_calibration unit = unit_nominal();
    const invcal_positions given = {
        .mean = (const invcal_vector *)v, .count = count, .nominal = &unit};

    assert_undetermined(&design);
    return invcal_undetermined(&given);
}

static void turn_all(random_source *random, double v[][3], unsigned count)
{
    double rotation[3][3];

    random_rotation(random, rotation);
    for (unsigned i = 0; i < count; i++) {
        const double a[3] = {v[i][0], v[i][1], v[i][2]};
        for (int k = 0; k < 3; k++) {
            v[i][k] = rotation[k][0] * a[0] + rotation[k][1] * a[1] + rotation[k][2] * a[2];
        }
    }
}

/* h(eta) in double. */
static void row_of(const double v[3], double h[NINE])
{
    const double row[NINE] = {v[0],        v[1],        v[2],        v[0] * v[0], v[1] * v[1],
                              v[2] * v[2], v[0] * v[1], v[0] * v[2], v[1] * v[2]};
    memcpy(h, row, sizeof row);
}

/* H'H and K = (H'H)^-1, by elimination of (H'H | I) without packing. */
static void covariance_of(const double v[][3], unsigned count, double hth[NINE][NINE],
                          double k[NINE][NINE])
{
    double a[NINE][2 * NINE] = {{0}};

    for (unsigned i = 0; i < count; i++) {
        double h[NINE];
        row_of(v[i], h);
        for (int r = 0; r < NINE; r++) {
            for (int c = 0; c < NINE; c++) {
                a[r][c] += h[r] * h[c];
            }
        }
    }
    for (int r = 0; r < NINE; r++) {
        memcpy(hth[r], a[r], sizeof hth[r]);
        a[r][NINE + r] = 1;
    }
    for (int p = 0; p < NINE; p++) { /* positive definite: no pivot search is needed */
        const double pivot = a[p][p];
        for (int c = 0; c < 2 * NINE; c++) {
            a[p][c] /= pivot;
        }
        for (int r = 0; r < NINE; r++) {
            const double factor = r == p ? 0 : a[r][p];
            for (int c = 0; c < 2 * NINE; c++) {
                a[r][c] -= factor * a[p][c];
            }
        }
    }
    for (int r = 0; r < NINE; r++) {
        memcpy(k[r], &a[r][NINE], sizeof k[r]);
    }
}

static double largest_root(double k[NINE][NINE], int first)
{
    return sqrt(fmax(k[first][first], fmax(k[first + 1][first + 1], k[first + 2][first + 2])));
}

/* ---- the programs of the paper ---- */

/* Table 1 sums, over a full turn in N >= 5 equal steps, powers of sine and cosine up to the
 * fourth, so each sum is N times the mean over the circle:
 *
 *     sum x^2 = N/2 in two groups = N;  sum x^4 = 2 (3 N/8);  sum x^2 y^2 = N/8 in one group;
 *
 * all others vanish. H'H is therefore N I for the offsets, N/8 (5 I + 11') for the scale errors,
 * N/8 I for the non-orthogonality terms. Its eigenvalues are N (offsets, and 1 of the scale
 * errors), 5 N/8 (two), N/8 (three): the condition is 8, the determinant N^9 5^2 / 8^5, and K has
 * 1/N, 8/(5N) (1 - 1/8) = 7/(5N) and 8/N on its diagonal. */
static void closed_form(unsigned per_group, double out[5])
{
    const double n = per_group;

    out[0] = sqrt(1 / n);
    out[1] = sqrt(7 / (5 * n));
    out[2] = sqrt(8 / n);
    out[3] = 8;
    out[4] = 9 * log(n) + 2 * log(5) - 5 * log(8);
}

static void a_program_of_any_size_and_starts_has_its_closed_form(void)
{
    random_source random = random_start(1);

    for (unsigned n = 5; n <= 64; n++) {
        double expected[5];
        closed_form(n, expected);
        for (int draw = 0; draw < 60; draw++) {
            const invcal_plan plan = random_plan(&random, n);
            const invcal_sums design = design_of_plan(&plan);
            const criteria c = judge(&design);
            TEST_ASSERT_EQUAL_UINT(3 * n, c.positions);
            assert_criteria(expected, &c);
        }
    }
}

static void the_program_of_18_has_the_papers_figures(void)
{
    const invcal_plan plan = {6, {30, 30, 120}};
    const invcal_sums design = design_of_plan(&plan);
    const criteria c = judge(&design);

    TEST_ASSERT_EQUAL_UINT(18, c.positions);
    TEST_ASSERT_DOUBLE_WITHIN(6e-7, 0.408248, c.sigma_delta);
    TEST_ASSERT_DOUBLE_WITHIN(6e-7, 0.483046, c.sigma_dk);
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 1.154701, c.sigma_gamma);
    assert_near(close, expected_plan18_root_k[0], c.sigma_delta);
    assert_near(close, expected_plan18_root_k[3], c.sigma_dk);
    assert_near(close, expected_plan18_root_k[6], c.sigma_gamma);
}

/* The paper: a third more labour makes every sigma smaller by sqrt(4/3) = 1.154701. */
static void a_program_of_18_is_worse_than_one_of_24_by_1_154701(void)
{
    const invcal_plan six = {6, {30, 30, 120}};
    const invcal_plan eight = {8, {0, 0, 90}};
    const invcal_sums a = design_of_plan(&six);
    const invcal_sums b = design_of_plan(&eight);
    const criteria c = judge(&a);
    const criteria d = judge(&b);

    TEST_ASSERT_TRUE(3 * d.positions == 4 * c.positions);
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 1.154701, c.sigma_delta / d.sigma_delta);
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 1.154701, c.sigma_dk / d.sigma_dk);
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 1.154701, c.sigma_gamma / d.sigma_gamma);
    assert_near(2 * close, d.sigma_gamma * sqrt(4 / 3.0), c.sigma_gamma);
}

/* ---- other sets of directions ---- */

/* Reference figures hold to rounding times the condition, whatever the directions. */
static void other_sets_have_the_figures_of_the_reference(void)
{
    static const struct {
        const double (*directions)[3];
        unsigned count;
    } sets[5] = {{expected_icosahedron, 12},
                 {expected_faces_and_edges, 18},
                 {expected_scattered12, 12},
                 {expected_scattered20, 20},
                 {expected_tilted24, 24}};

    for (unsigned i = 0; i < 5; i++) {
        const double *expected = expected_set_criteria[i];
        const invcal_sums design = design_of(sets[i].directions, sets[i].count);
        const criteria c = judge(&design);
        const double tolerance = close + 4 * DBL_EPSILON * expected[3];
        TEST_ASSERT_EQUAL_UINT(sets[i].count, c.positions);
        assert_near(tolerance, expected[0], c.sigma_delta);
        assert_near(tolerance, expected[1], c.sigma_dk);
        assert_near(tolerance, expected[2], c.sigma_gamma);
        assert_near(tolerance, expected[3], c.condition);
        TEST_ASSERT_DOUBLE_WITHIN(tolerance * 10, expected[4], c.log_det);
    }
}

static void icosahedron_and_faces_with_edges_have_their_published_figures(void)
{
    const invcal_sums a = design_of(expected_icosahedron, 12);
    const invcal_sums b = design_of(expected_faces_and_edges, 18);
    const criteria c = judge(&a);
    const criteria d = judge(&b);

    /* A spherical 5-design: K has 3/n, 6/n and 15/n on its diagonal, the condition is 5. */
    const double of_icosahedron[5] = {0.5, sqrt(0.5), sqrt(1.25), 5,
                                      4 * log(4) + 2 * log(1.6) + 3 * log(0.8)};
    assert_criteria(of_icosahedron, &c);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.707107, c.sigma_dk);
    TEST_ASSERT_DOUBLE_WITHIN(2e-6, 1.118034, c.sigma_gamma);
    /* sum x^2 = 2 + 8/2 = 6, sum x^4 = 2 + 8/4 = 4, sum x^2 y^2 = 4/4 = 1: eigenvalues 6 (offsets),
     * of 3 I + 11' 3, 3, 6, and 1, 1, 1. */
    const double of_faces[5] = {sqrt(1 / 6.0), sqrt(5 / 18.0), 1, 6, 4 * log(6) + 2 * log(3)};
    assert_criteria(of_faces, &d);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.408248, d.sigma_delta);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.527046, d.sigma_dk);
}

/* With four to a group the fifth coefficient of each series stays open, but not always a
 * parameter: from starts of 45 degrees the positions are the twelve edges of a cube. Their sums
 * are sum x^2 = 4, sum x^4 = 2, sum x^2 y^2 = 1: I + 11' for the scale errors. */
static void twelve_edges_are_a_set_like_any_other(void)
{
    double v[12][3] = {{0}};
    const double expected[5] = {0.5, sqrt(0.75), 1, 4, 4 * log(4)};

    for (int i = 0; i < 12; i++) {
        v[i][i / 4] = i & 1 ? sqrt(0.5) : -sqrt(0.5);
        v[i][(i / 4 + 1) % 3] = i & 2 ? sqrt(0.5) : -sqrt(0.5);
    }
    const invcal_sums design = design_of((const double(*)[3])v, 12);
    const criteria c = judge(&design);
    assert_criteria(expected, &c);
}

/* The largest log det that n directions can have. A spherical 4-design averages over the sphere,
 * mean x^2 = 1/3, x^4 = 1/5, x^2 y^2 = 1/15: H'H is n/3 I, n/15 (2 I + 11'), n/15 I, with
 * eigenvalues n/3 (four), 2n/15 (two), n/15 (three). By concavity of log det, and because turning
 * all directions does not change it, no directions do better than this mean over all turns. */
static double bound_of_log_det(double n)
{
    return 4 * log(n / 3) + 2 * log(2 * n / 15) + 3 * log(n / 15);
}

static void an_icosahedron_reaches_the_bound_however_it_is_turned(void)
{
    random_source random = random_start(3);

    for (int draw = 0; draw < 200; draw++) {
        double v[12][3];
        memcpy(v, expected_icosahedron, sizeof v);
        turn_all(&random, v, 12);
        const invcal_sums design = design_of((const double(*)[3])v, 12);
        const criteria c = judge(&design);
        const double expected[5] = {0.5, sqrt(0.5), sqrt(1.25), 5, bound_of_log_det(12)};
        assert_criteria(expected, &c);
    }
}

static void no_random_set_passes_the_bound(void)
{
    random_source random = random_start(4);
    unsigned judged = 0;
    double nearest = 1e9;

    for (int draw = 0; draw < 1000; draw++) {
        const unsigned count = 9 + (unsigned)draw % 40;
        invcal_sums design;
        criteria c;
        invcal_sums_init(&design);
        for (unsigned i = 0; i < count; i++) {
            double v[3];
            random_direction(&random, v);
            criteria_add(&design, v);
        }
        if (criteria_evaluate(&design, &c)) { /* nine may be singular */
            const double margin = bound_of_log_det(count) - c.log_det;
            TEST_ASSERT_TRUE(margin > 0);
            nearest = fmin(nearest, margin);
            judged++;
        }
    }
    TEST_ASSERT_TRUE(judged >= 990);
    TEST_ASSERT_TRUE(nearest < 0.8); /* the bound is so near that a mistake would exceed it */
}

/* ---- what leaves parameters open ---- */

static void six_faces_leave_the_angles_open(void)
{
    double v[24][3] = {{0}};

    for (unsigned i = 0; i < 24; i++) {
        v[i][i % 3] = i / 3 % 2 ? 1 : -1;
    }
    for (unsigned count = 6; count <= 24; count += 6) {
        TEST_ASSERT_EQUAL_HEX16(ANGLES, open_in((const double(*)[3])v, count));
    }
}

/* Table 1 with four steps from a multiple of 90 degrees is the six faces, each twice. */
static void groups_of_four_along_the_axes_leave_the_angles_open(void)
{
    static const double axis[3][4][3] = {{{0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}},
                                         {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}},
                                         {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}}};

    TEST_ASSERT_EQUAL_HEX16(ANGLES, open_in(axis[0], 12));
}

/* The plane z = 0 shows nothing of z. */
static void one_plane_leaves_all_that_z_takes_part_in_open(void)
{
    static const unsigned z[3] = {
        1u << INVCAL_DELTA_X | 1u << INVCAL_DK_X | 1u << INVCAL_GAMMA_XY | 1u << INVCAL_GAMMA_XZ,
        1u << INVCAL_DELTA_Y | 1u << INVCAL_DK_Y | 1u << INVCAL_GAMMA_XY | 1u << INVCAL_GAMMA_ZY,
        1u << INVCAL_DELTA_Z | 1u << INVCAL_DK_Z | 1u << INVCAL_GAMMA_XZ | 1u << INVCAL_GAMMA_ZY};

    for (unsigned k = 0; k < 3; k++) {
        double v[36][3] = {{0}};
        for (unsigned i = 0; i < 36; i++) {
            v[i][(k + 1) % 3] = cos(0.3 + TURN * i / 36);
            v[i][(k + 2) % 3] = sin(0.3 + TURN * i / 36);
        }
        TEST_ASSERT_EQUAL_HEX16(z[k], open_in((const double(*)[3])v, 36));
    }
}

/* Positions at the heights z = +-c, starting from an angle. */
static void two_circles(double c, double from, double step, double v[24][3])
{
    for (unsigned i = 0; i < 24; i++) {
        v[i][0] = sqrt(1 - c * c) * cos(from + step * i);
        v[i][1] = sqrt(1 - c * c) * sin(from + step * i);
        v[i][2] = i % 2 ? c : -c;
    }
}

/* c^2 (x^2 + y^2) = (1 - c^2) z^2 mixes the scale errors. */
static void two_circles_leave_the_scale_errors_open(void)
{
    for (int draw = 0; draw < 20; draw++) {
        double v[24][3];
        two_circles(sqrt(0.4), 0.1 * draw, TURN / 24, v);
        TEST_ASSERT_EQUAL_HEX16(SCALES, open_in((const double(*)[3])v, 24));
    }
}

/* If they are turned, no pivot need be small: the condition shows it. */
static void turned_circles_are_refused_too(void)
{
    random_source random = random_start(5);

    for (int draw = 0; draw < 500; draw++) {
        double v[24][3];
        const double c = random_uniform(&random, 0.2, 0.9);
        const double from = random_uniform(&random, 0, TURN);
        two_circles(c, from, random_uniform(&random, 0.2, 1), v);
        turn_all(&random, v, 24);
        TEST_ASSERT_TRUE(open_in((const double(*)[3])v, 24) != 0);
    }
}

/* From any side: the open parameters are mixtures. */
static void turned_faces_are_refused_too(void)
{
    random_source random = random_start(6);

    for (int draw = 0; draw < 200; draw++) {
        double v[18][3] = {{0}};
        for (unsigned i = 0; i < 18; i++) {
            v[i][i % 3] = i / 3 % 2 ? 1 : -1;
        }
        turn_all(&random, v, 18);
        TEST_ASSERT_TRUE(open_in((const double(*)[3])v, 18) != 0);
    }
}

static void turned_planes_are_refused_too(void)
{
    random_source random = random_start(13);

    for (int draw = 0; draw < 200; draw++) {
        double v[18][3] = {{0}};
        for (unsigned i = 0; i < 18; i++) {
            const double angle = random_uniform(&random, 0, TURN);
            v[i][0] = cos(angle);
            v[i][1] = sin(angle);
        }
        turn_all(&random, v, 18);
        TEST_ASSERT_TRUE(open_in((const double(*)[3])v, 18) != 0);
    }
}

static void up_to_eight_positions_are_refused(void)
{
    random_source random = random_start(7);

    for (int draw = 0; draw < 200; draw++) {
        double v[8][3];
        TEST_ASSERT_EQUAL_HEX16(ALL, open_in((const double(*)[3])v, 0));
        for (unsigned i = 0; i < 8; i++) {
            random_direction(&random, v[i]);
            TEST_ASSERT_TRUE(open_in((const double(*)[3])v, i + 1) != 0);
        }
    }
}

static void sums_that_are_not_numbers_are_refused(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    const invcal_sums good = design_of(expected_icosahedron, 12);

    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS); i++) {
        for (unsigned k = 0; k < 3; k++) {
            invcal_sums design = good;
            design.sum[i] = bad[k];
            assert_undetermined(&design);
        }
    }
}

/* The largest eigenvalue of a positive definite matrix: Rayleigh's quotient of a power. */
static double largest_eigenvalue_of(double a[NINE][NINE])
{
    double v[NINE] = {1, 1.1, 0.9, 1.2, 0.8, 1.3, 0.7, 1.4, 0.6};
    double quotient = 0;

    for (int step = 0; step < 200; step++) {
        double next[NINE] = {0};
        double square = 0;
        quotient = 0;
        for (int r = 0; r < NINE; r++) {
            for (int c = 0; c < NINE; c++) {
                next[r] += a[r][c] * v[c];
            }
            quotient += v[r] * next[r];
            square += v[r] * v[r];
        }
        quotient /= square;
        for (int r = 0; r < NINE; r++) {
            v[r] = next[r] / quotient;
        }
    }
    return quotient;
}

/* A plane and a little more, from any side: accepted as soon as the condition is below its limit,
 * whatever the pivots are. */
static void a_flat_set_is_refused_by_its_condition(void)
{
    random_source random = random_start(8);
    const double limit = 1e8; /* 1 / INVCAL_PIVOT_FLOOR */
    const double blur = 1.02; /* float sees no condition so large exactly */
    unsigned refused = 0;
    unsigned accepted = 0;

    for (int draw = 0; draw < 1000; draw++) {
        const double height = pow(10, random_uniform(&random, -3, -0.5));
        double v[24][3];
        double a[NINE][NINE];
        double k[NINE][NINE];
        for (int i = 0; i < 24; i++) {
            const double angle = random_uniform(&random, 0, TURN);
            v[i][0] = cos(angle);
            v[i][1] = sin(angle);
            v[i][2] = height * random_normal(&random);
            const double length = length3(v[i]);
            for (int axis = 0; axis < 3; axis++) {
                v[i][axis] /= length;
            }
        }
        turn_all(&random, v, 24);
        const invcal_sums design = design_of((const double(*)[3])v, 24);
        covariance_of((const double(*)[3])v, 24, a, k);
        const double expected = largest_eigenvalue_of(a) * largest_eigenvalue_of(k);
        if (expected > blur * limit) {
            assert_undetermined(&design);
            refused++;
        } else if (expected < limit / blur) {
            const criteria c = judge(&design);
            assert_near(0.01 + 4 * DBL_EPSILON * expected, expected, c.condition);
            accepted++;
        }
    }
    TEST_ASSERT_TRUE(refused > 100 && accepted > 100);
}

/* ---- what the criteria must not depend on ---- */

static void assert_same(double tolerance, const criteria *a, const criteria *b)
{
    TEST_ASSERT_EQUAL_UINT(a->positions, b->positions);
    assert_near(tolerance, a->sigma_delta, b->sigma_delta);
    assert_near(tolerance, a->sigma_dk, b->sigma_dk);
    assert_near(tolerance, a->sigma_gamma, b->sigma_gamma);
    assert_near(tolerance, a->condition, b->condition);
    TEST_ASSERT_DOUBLE_WITHIN(10 * tolerance, a->log_det, b->log_det);
}

static void order_does_not_matter(void)
{
    double shuffled[20][3];

    for (unsigned step = 1; step < 20; step += 2) {
        if (step == 5 || step == 15) {
            continue; /* 20 and the step must have no common divisor */
        }
        for (unsigned i = 0; i < 20; i++) {
            memcpy(shuffled[i], expected_scattered20[(19 + step * i) % 20], sizeof shuffled[i]);
        }
        const invcal_sums a = design_of(expected_scattered20, 20);
        const invcal_sums b = design_of((const double(*)[3])shuffled, 20);
        const criteria c = judge(&a);
        const criteria d = judge(&b);
        assert_same(40 * 2 * DBL_EPSILON, &c, &d);
    }
}

static void directions_and_their_opposites_are_worth_the_same(void)
{
    double opposite[20][3];

    for (unsigned i = 0; i < 20; i++) {
        for (int k = 0; k < 3; k++) {
            opposite[i][k] = -expected_scattered20[i][k];
        }
    }
    const invcal_sums a = design_of(expected_scattered20, 20);
    const invcal_sums b = design_of((const double(*)[3])opposite, 20);
    const criteria c = judge(&a);
    const criteria d = judge(&b);
    assert_same(40 * 2 * DBL_EPSILON, &c, &d);
}

/* Turning all directions mixes offsets among themselves by a rotation, the six of second degree
 * by a matrix of determinant 1: log det stays, the sigmas follow K. */
static void a_turn_keeps_log_det_and_moves_the_sigmas_with_k(void)
{
    random_source random = random_start(9);
    const double *expected = expected_set_criteria[3]; /* scattered20 */
    const double tolerance = close + 4 * DBL_EPSILON * 39;
    double smallest = 1e9;
    double largest = 0;

    for (int draw = 0; draw < 10 + 290; draw++) {
        double v[20][3];
        double a[NINE][NINE];
        double k[NINE][NINE];
        memcpy(v, expected_scattered20, sizeof v);
        turn_all(&random, v, 20);
        const invcal_sums design = design_of((const double(*)[3])v, 20);
        const criteria c = judge(&design);
        covariance_of((const double(*)[3])v, 20, a, k);
        TEST_ASSERT_DOUBLE_WITHIN(10 * tolerance, expected[4], c.log_det);
        assert_near(tolerance, largest_root(k, INVCAL_DELTA_X), c.sigma_delta);
        assert_near(tolerance, largest_root(k, INVCAL_DK_X), c.sigma_dk);
        assert_near(tolerance, largest_root(k, INVCAL_GAMMA_XY), c.sigma_gamma);
        smallest = fmin(smallest, c.sigma_gamma);
        largest = fmax(largest, c.sigma_gamma);
    }
    TEST_ASSERT_TRUE(largest > 1.1 * smallest); /* they moved */
}

/* Each axis in turn is the worst: the largest of each three is found. */
static void the_worst_axis_decides_whichever_it_is(void)
{
    const double *expected = expected_set_criteria[4]; /* tilted24 */
    const double tolerance = close + 4 * DBL_EPSILON * expected[3];

    for (unsigned shift = 0; shift < 6; shift++) {
        double v[24][3];
        for (unsigned i = 0; i < 24; i++) {
            for (unsigned k = 0; k < 3; k++) {
                const unsigned from = shift < 3 ? k + shift : 3 + shift - k;
                v[i][k] = expected_tilted24[i][from % 3];
            }
        }
        const invcal_sums design = design_of((const double(*)[3])v, 24);
        const criteria c = judge(&design);
        for (int k = 0; k < 3; k++) {
            const double sigma[3] = {c.sigma_delta, c.sigma_dk, c.sigma_gamma};
            assert_near(tolerance, expected[k], sigma[k]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(10 * tolerance, expected[4], c.log_det);
    }
}

static void visiting_every_position_twice_divides_sigma_by_the_root_of_two(void)
{
    random_source random = random_start(10);

    for (unsigned n = 5; n <= 20; n++) {
        const invcal_plan plan = random_plan(&random, n);
        const invcal_sums once = design_of_plan(&plan);
        invcal_sums twice = once;
        for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS); i++) {
            twice.sum[i] *= 2;
        }
        twice.count *= 2;
        const criteria c = judge(&once);
        const criteria d = judge(&twice);
        TEST_ASSERT_EQUAL_UINT(2 * c.positions, d.positions);
        assert_near(close, c.sigma_delta / sqrt(2), d.sigma_delta);
        assert_near(close, c.sigma_dk / sqrt(2), d.sigma_dk);
        assert_near(close, c.sigma_gamma / sqrt(2), d.sigma_gamma);
        assert_near(close_condition, c.condition, d.condition);
        assert_near(close, c.log_det + 9 * log(2), d.log_det);
    }
}

/* Weights may be of any size: the logarithm must be as good far from 1. */
static void weighted_sums_keep_their_condition_and_shift_log_det(void)
{
    const invcal_plan plan = {7, {11, 22, 33}};
    const invcal_sums design = design_of_plan(&plan);
    double expected[5];

    closed_form(7, expected);
    for (int exponent = -24; exponent <= 24; exponent++) {
        const double weight = pow(10, exponent / 2.0);
        invcal_sums weighted = design;
        for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS); i++) {
            weighted.sum[i] *= weight;
        }
        const criteria c = judge(&weighted);
        assert_near(close, expected[0] / sqrt(weight), c.sigma_delta);
        assert_near(close, expected[1] / sqrt(weight), c.sigma_dk);
        assert_near(close, expected[2] / sqrt(weight), c.sigma_gamma);
        assert_near(close_condition, 8, c.condition);
        TEST_ASSERT_DOUBLE_WITHIN(close * (fabs(expected[4]) + 9 * fabs(log(weight))),
                                  expected[4] + 9 * log(weight), c.log_det);
    }
}

static void weights_whose_sigma_fits_no_number_are_refused(void)
{
    const invcal_plan plan = {7, {11, 22, 33}};
    invcal_sums design = design_of_plan(&plan);

    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS); i++) {
        design.sum[i] = design.sum[i] / DBL_MAX / 64; /* K(r,r) overflows */
    }
    assert_undetermined(&design);
}

/* The positions taken so far: exact rows of an ideal triad are those of their directions. */
static void exact_rows_are_judged_like_directions(void)
{
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    reading_set set;

    read_positions(&none, expected_scattered20, 20, 0, &unused, &set);
    const invcal_sums exact = sums_of(&set);
    const invcal_sums design = design_of(expected_scattered20, 20);
    const criteria c = judge(&exact);
    const criteria d = judge(&design);
    assert_same(2 * DBL_EPSILON, &c, &d);
}

static void judging_does_not_change_the_design(void)
{
    const invcal_sums design = design_of(expected_scattered12, 12);
    const invcal_sums before = design;

    (void)judge(&design);
    TEST_ASSERT_EQUAL_MEMORY(&before, &design, sizeof before);
}

/* ---- what a direction adds ---- */

/* A set of directions is a set of rows h(eta) without measurements. */
static void a_direction_adds_its_row_and_no_measurement(void)
{
    invcal_sums design;
    double h[NINE];

    invcal_sums_init(&design);
    for (unsigned i = 0; i < 20; i++) {
        double v[3];
        for (int k = 0; k < 3; k++) { /* longer and shorter than 1, within the tolerance */
            v[k] = expected_scattered20[i][k] * (1 + (i % 2 ? 9e-5 : -9e-5));
        }
        const invcal_sums before = design;
        criteria_add(&design, v);
        row_of(v, h);
        TEST_ASSERT_EQUAL_UINT(i + 1, design.count);
        for (unsigned r = 0; r < NINE; r++) {
            for (unsigned c = 0; c <= r; c++) {
                TEST_ASSERT_DOUBLE_WITHIN(4e-15, h[r] * h[c],
                                          element(&design, r, c) - element(&before, r, c));
            }
            TEST_ASSERT_TRUE(design.sum[INVCAL_PACKED(NINE, r)] == 0);
        }
        TEST_ASSERT_TRUE(design.sum[INVCAL_PACKED(NINE, NINE)] == 0);
    }
}

/* ---- is the promise kept? ---- */

/* Triads with errors of 1e-3, held in the positions of a design, each axis with noise of 1e-4,
 * calibrated without knowing a direction: the root mean square error of every parameter over the
 * noise is what the design promised. It is estimated from PLAN_DRAWS draws, each with a new
 * triad, and has itself a standard deviation of 1 / sqrt(2 PLAN_DRAWS). */
static void assert_promise_is_kept(const double v[][3], unsigned count, const double root_k[3])
{
    const double noise = 1e-4;
    const double bound = 4 / sqrt(2.0 * PLAN_DRAWS);
    const invcal_sums design = design_of(v, count);
    const criteria c = judge(&design);
    const double promised[3] = {c.sigma_delta, c.sigma_dk, c.sigma_gamma};
    const invcal_calibration unit = unit_nominal();
    random_source random = random_start(count);
    double squares[NINE] = {0};

    for (int draw = 0; draw < PLAN_DRAWS; draw++) {
        const triad_truth truth = triad_random(&random, 1e-3);
        reading_set set;
        invcal_calibration calibration;
        read_positions(&truth, v, count, noise, &random, &set);
        invcal_sums sums = sums_of(&set);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_solve(&sums, &unit, &calibration));
        for (unsigned r = 0; r < NINE; r++) {
            const double error = parameter(&calibration, r) - truth.x[r];
            squares[r] += error * error;
        }
    }
    for (unsigned block = 0; block < 3; block++) {
        double largest = 0;
        assert_near(close, root_k[block], promised[block]);
        for (unsigned r = 3 * block; r < 3 * block + 3; r++) {
            const double spread = sqrt(squares[r] / PLAN_DRAWS) / noise;
            TEST_ASSERT_DOUBLE_WITHIN(bound, 1, spread / root_k[block]);
            largest = fmax(largest, spread);
        }
        TEST_ASSERT_DOUBLE_WITHIN(bound, 1, largest / promised[block]);
    }
}

static void assert_promise_of_a_program_is_kept(unsigned per_group)
{
    const double n = per_group;
    const double root_k[3] = {sqrt(1 / n), sqrt(7 / (5 * n)), sqrt(8 / n)}; /* of each block */
    invcal_plan plan;
    double v[18][3];

    plan.per_group = per_group;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_init(&plan, per_group));
    for (unsigned i = 0; i < 3 * per_group; i++) {
        invcal_plan_position p;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_get(&plan, i, &p));
        for (int k = 0; k < 3; k++) {
            v[i][k] = p.up[k];
        }
    }
    assert_promise_is_kept((const double(*)[3])v, 3 * per_group, root_k);
}

static void the_sigma_promised_by_a_program_of_18_is_obtained(void)
{
    assert_promise_of_a_program_is_kept(6);
}

static void the_sigma_promised_by_a_program_of_15_is_obtained(void)
{
    assert_promise_of_a_program_is_kept(5);
}

static void the_sigma_promised_by_an_icosahedron_is_obtained(void)
{
    const double root_k[3] = {sqrt(3 / 12.0), sqrt(6 / 12.0), sqrt(15 / 12.0)};

    assert_promise_is_kept(expected_icosahedron, 12, root_k);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_program_of_any_size_and_starts_has_its_closed_form);
    RUN_TEST(the_program_of_18_has_the_papers_figures);
    RUN_TEST(a_program_of_18_is_worse_than_one_of_24_by_1_154701);
    RUN_TEST(other_sets_have_the_figures_of_the_reference);
    RUN_TEST(icosahedron_and_faces_with_edges_have_their_published_figures);
    RUN_TEST(twelve_edges_are_a_set_like_any_other);
    RUN_TEST(an_icosahedron_reaches_the_bound_however_it_is_turned);
    RUN_TEST(no_random_set_passes_the_bound);
    RUN_TEST(six_faces_leave_the_angles_open);
    RUN_TEST(groups_of_four_along_the_axes_leave_the_angles_open);
    RUN_TEST(one_plane_leaves_all_that_z_takes_part_in_open);
    RUN_TEST(two_circles_leave_the_scale_errors_open);
    RUN_TEST(turned_circles_are_refused_too);
    RUN_TEST(turned_faces_are_refused_too);
    RUN_TEST(turned_planes_are_refused_too);
    RUN_TEST(up_to_eight_positions_are_refused);
    RUN_TEST(sums_that_are_not_numbers_are_refused);
    RUN_TEST(a_flat_set_is_refused_by_its_condition);
    RUN_TEST(order_does_not_matter);
    RUN_TEST(directions_and_their_opposites_are_worth_the_same);
    RUN_TEST(a_turn_keeps_log_det_and_moves_the_sigmas_with_k);
    RUN_TEST(the_worst_axis_decides_whichever_it_is);
    RUN_TEST(visiting_every_position_twice_divides_sigma_by_the_root_of_two);
    RUN_TEST(weighted_sums_keep_their_condition_and_shift_log_det);
    RUN_TEST(weights_whose_sigma_fits_no_number_are_refused);
    RUN_TEST(exact_rows_are_judged_like_directions);
    RUN_TEST(judging_does_not_change_the_design);
    RUN_TEST(a_direction_adds_its_row_and_no_measurement);
    RUN_TEST(the_sigma_promised_by_a_program_of_18_is_obtained);
    RUN_TEST(the_sigma_promised_by_a_program_of_15_is_obtained);
    RUN_TEST(the_sigma_promised_by_an_icosahedron_is_obtained);
    return UNITY_END() != 0;
}
