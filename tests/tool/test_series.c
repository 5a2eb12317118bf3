/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "expected.h"
#include "design/series.h"
#include "core/sums.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { NINE = INVCAL_PARAMETERS, TERMS = SERIES_TERMS, MOST = 3 * 64 };
enum { PACKED = INVCAL_PACKED_SIZE(SERIES_TERMS) };
static const double TURN = 6.283185307179586;
static const double close = 1e-12;
static const double close_determinant = 1e-12;

typedef double coefficient_table[INVCAL_PLAN_GROUPS][SERIES_TERMS];

/* A program with the verticals of Table 1 in double, apart from plan.h. */
typedef struct {
    invcal_plan plan;
    unsigned count;
    double eta[MOST][3];
} program;

static program program_of(unsigned per_group, const double start[3])
{
    program p;

    p.plan.per_group = per_group;
    p.count = 3 * per_group;
    for (unsigned g = 0; g < 3; g++) {
        p.plan.start_deg[g] = start[g];
        for (unsigned k = 0; k < per_group; k++) {
            const double turned = (p.plan.start_deg[g] / 360 + (double)k / per_group) * TURN;
            const double alpha = g == 1 ? -TURN / 4 : turned;
            const double beta = g == 0 ? 0 : g == 1 ? turned : TURN / 4;
            double *eta = p.eta[g * per_group + k];
            eta[0] = sin(alpha) * sin(beta);
            eta[1] = cos(alpha);
            eta[2] = sin(alpha) * cos(beta);
        }
    }
    return p;
}

static program random_program(random_source *random, unsigned per_group)
{
    double start[3];

    for (int g = 0; g < 3; g++) {
        start[g] = random_uniform(random, -360, 360);
    }
    return program_of(per_group, start);
}

static series series_of(const invcal_plan *plan)
{
    series s;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_init(&s, plan));
    return s;
}

static void add(series *s, double j)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_add(s, j));
}

static void solve(const series *s, double x[NINE])
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_solve(s, x));
}

static void coefficients(const series *s, double c[3][TERMS])
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_coefficients(s, c));
}

/* The row of J1 or J2 for a position, u being read without noise. */
enum { J1 = 1, J2 = 2 };
static invcali_row row_of(int kind, const triad_truth *truth, const double eta[3])
{
    const double x = eta[0];
    const double y = eta[1];
    const double z = eta[2];
    double u[3];

    triad_read(truth, eta, u);
    const double vertical = u[0] * x + u[1] * y + u[2] * z - 1;
    const double scalar = (u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - 1) / 2;
    return (invcali_row){
        {x, y, z, x * x, y * y, z * z, x * y, x * z, y * z, kind == J1 ? vertical : scalar}};
}

/* ---- J to coefficients to parameters ---- */

static void the_vertical_composition_gives_the_parameters_exactly(void)
{
    random_source random = random_start(1);

    for (unsigned n = 5; n <= 64; n++) {
        for (int draw = 0; draw < 20; draw++) {
            const program p = random_program(&random, n);
            const triad_truth truth = triad_random(&random, 0.1);
            series s = series_of(&p.plan);
            double x[NINE];
            for (unsigned i = 0; i < p.count; i++) {
                const invcali_row row = row_of(J1, &truth, p.eta[i]);
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_add(&s, row.h[INVCAL_J]));
            }
            solve(&s, x);
            for (int r = 0; r < NINE; r++) {
                TEST_ASSERT_DOUBLE_WITHIN(close, truth.x[r], x[r]);
            }
        }
    }
}

/* What each parameter alone, of size 1, puts into the fifteen coefficients: J is then one element
 * of h(eta), so this is that element as a series. Group 1 has eta = (0, cos, sin), group 2
 * (-sin, 0, -cos), group 3 (sin, cos, 0); cos^2 = (1 + cos 2)/2, sin^2 = (1 - cos 2)/2,
 * sin cos = sin 2 / 2. */
static const double unit_coefficient[NINE][3][TERMS] = {
    /* delta_x: x */ {{0, 0, 0, 0, 0}, {0, 0, -1, 0, 0}, {0, 0, 1, 0, 0}},
    /* delta_y: y */ {{0, 1, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 1, 0, 0, 0}},
    /* delta_z: z */ {{0, 0, 1, 0, 0}, {0, -1, 0, 0, 0}, {0, 0, 0, 0, 0}},
    /* dk_x: x^2  */ {{0, 0, 0, 0, 0}, {0.5, 0, 0, -0.5, 0}, {0.5, 0, 0, -0.5, 0}},
    /* dk_y: y^2  */ {{0.5, 0, 0, 0.5, 0}, {0, 0, 0, 0, 0}, {0.5, 0, 0, 0.5, 0}},
    /* dk_z: z^2  */ {{0.5, 0, 0, -0.5, 0}, {0.5, 0, 0, 0.5, 0}, {0, 0, 0, 0, 0}},
    /* gamma_xy   */ {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0.5}},
    /* gamma_xz   */ {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0.5}, {0, 0, 0, 0, 0}},
    /* gamma_zy   */ {{0, 0, 0, 0, 0.5}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}},
};

static double h_of(const double eta[3], unsigned r)
{
    const double h[NINE] = {eta[0],          eta[1],          eta[2],
                            eta[0] * eta[0], eta[1] * eta[1], eta[2] * eta[2],
                            eta[0] * eta[1], eta[0] * eta[2], eta[1] * eta[2]};
    return h[r];
}

static void each_parameter_alone_shows_in_its_own_coefficients(void)
{
    random_source random = random_start(2);

    for (unsigned n = 5; n <= 64; n++) {
        const program p = random_program(&random, n);
        for (unsigned r = 0; r < NINE; r++) {
            series s = series_of(&p.plan);
            double c[3][TERMS];
            double x[NINE];
            for (unsigned i = 0; i < p.count; i++) {
                add(&s, h_of(p.eta[i], r));
            }
            coefficients(&s, c);
            for (unsigned g = 0; g < 3; g++) {
                for (unsigned i = 0; i < TERMS; i++) {
                    TEST_ASSERT_DOUBLE_WITHIN(close, unit_coefficient[r][g][i], c[g][i]);
                }
            }
            solve(&s, x);
            for (unsigned k = 0; k < NINE; k++) {
                TEST_ASSERT_DOUBLE_WITHIN(2 * close, k == r, x[k]);
            }
        }
    }
}

/* The paper prints (dk_x + dk_z)/2: the x sensor lies across gravity throughout the group. */
static void a0_of_group_1_is_that_of_dk_y_and_dk_z_not_dk_x(void)
{
    const double start[3] = {30, 30, 120};
    const program p = program_of(6, start);

    for (int k = 0; k < 3; k++) {
        triad_truth truth = {{0}};
        series s = series_of(&p.plan);
        double c[3][TERMS];
        truth.x[INVCAL_DK_X + k] = 0.1;
        for (unsigned i = 0; i < p.count; i++) {
            const invcali_row row = row_of(J1, &truth, p.eta[i]);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_add(&s, row.h[INVCAL_J]));
        }
        coefficients(&s, c);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * close, k == 0 ? 0 : 0.05, c[0][0]);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * close, k == 1 ? 0 : 0.05, c[1][0]);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * close, k == 2 ? 0 : 0.05, c[2][0]);
    }
}

static void assert_reference(unsigned n, const double start[3], const double *j,
                             const double expected[3][TERMS], const double expected_x[NINE])
{
    const program p = program_of(n, start);
    series s = series_of(&p.plan);
    double c[3][TERMS];
    double x[NINE];

    for (unsigned i = 0; i < p.count; i++) {
        add(&s, j[i]);
    }
    coefficients(&s, c);
    solve(&s, x);
    for (unsigned g = 0; g < 3; g++) {
        for (unsigned i = 0; i < TERMS; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.3 * close, expected[g][i], c[g][i]);
        }
    }
    for (unsigned r = 0; r < NINE; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.3 * close, expected_x[r], x[r]);
    }
}

static void noisy_j_give_the_least_squares_of_the_reference(void)
{
    assert_reference(5, expected_series5_start, expected_series5_j[0], expected_series5_coefficient,
                     expected_series5_x);
    assert_reference(8, expected_series8_start, expected_series8_j[0], expected_series8_coefficient,
                     expected_series8_x);
}

/* ---- the same least squares as the 9x9 solve ---- */

static void assert_equal_to_the_solve(int kind, double size, double noise, uint32_t seed)
{
    random_source random = random_start(seed);

    for (unsigned n = 5; n <= 64; n++) {
        for (int draw = 0; draw < 5; draw++) {
            const program p = random_program(&random, n);
            const triad_truth truth = triad_random(&random, size);
            series s = series_of(&p.plan);
            invcal_sums sums;
            double x[NINE];
            invcal_sums_init(&sums);
            for (unsigned i = 0; i < p.count; i++) {
                invcali_row row = row_of(kind, &truth, p.eta[i]);
                row.h[INVCAL_J] += noise > 0 ? noise * random_normal(&random) : 0;
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_add(&s, row.h[INVCAL_J]));
                invcali_sums_add_row(&sums, &row, 1);
            }
            TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                                  invcali_factor(sums.sum, NINE, NINE + 1, INVCAL_FLOOR));
            invcali_back_substitute(sums.sum, NINE);
            solve(&s, x);
            for (unsigned r = 0; r < NINE; r++) { /* J + h p = 0: p = -X */
                TEST_ASSERT_DOUBLE_WITHIN(close, -sums.sum[INVCAL_PACKED(NINE, r)], x[r]);
            }
        }
    }
}

static void vertical_compositions_are_solved_as_by_the_9x9(void)
{
    assert_equal_to_the_solve(J1, 0.1, 0, 3);
}

static void noisy_vertical_compositions_are_solved_as_by_the_9x9(void)
{
    assert_equal_to_the_solve(J1, 0.1, 0.02, 4);
}

static void scalar_compositions_are_solved_as_by_the_9x9(void)
{
    assert_equal_to_the_solve(J2, 0.1, 0, 5);
}

static void noisy_scalar_compositions_are_solved_as_by_the_9x9(void)
{
    assert_equal_to_the_solve(J2, 0.1, 0.02, 6);
}

/* J2 of the program of 18 has an error of O(X^2), of the size that the reference gives. */
static void the_scalar_composition_holds_to_the_first_order(void)
{
    static const double sign[NINE] = {1, -1, 1, 1, -1, 1, -1, 1, -1};
    const double start[3] = {30, 30, 120};
    const program p = program_of(6, start);

    for (int k = 0; k < 2; k++) {
        const double size = expected_first_order_size[k];
        triad_truth truth;
        series s = series_of(&p.plan);
        double x[NINE];
        double worst = 0;
        for (int r = 0; r < NINE; r++) {
            truth.x[r] = size * sign[r];
        }
        for (unsigned i = 0; i < p.count; i++) {
            const invcali_row row = row_of(J2, &truth, p.eta[i]);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_add(&s, row.h[INVCAL_J]));
        }
        solve(&s, x);
        for (int r = 0; r < NINE; r++) {
            worst = larger(worst, fabs(x[r] - truth.x[r]));
        }
        TEST_ASSERT_DOUBLE_WITHIN(close, expected_first_order_worst[k], worst);
    }
}

/* ---- information ---- */

/* H5'H5 of angles in radians, packed, and its determinant by elimination without packing. */
static double information_of(const double *angle, unsigned count, double packed[PACKED])
{
    double a[TERMS][TERMS] = {{0}};
    double determinant = 1;

    for (unsigned k = 0; k < count; k++) {
        const double t[TERMS] = {1, cos(angle[k]), sin(angle[k]), cos(2 * angle[k]),
                                 sin(2 * angle[k])};
        for (unsigned r = 0; r < TERMS; r++) {
            for (unsigned c = 0; c < TERMS; c++) {
                a[r][c] += t[r] * t[c];
            }
        }
    }
    for (unsigned r = 0; r < TERMS; r++) {
        for (unsigned c = 0; c <= r; c++) {
            packed[INVCAL_PACKED(r, c)] = a[r][c];
        }
    }
    for (unsigned p = 0; p < TERMS; p++) {
        determinant *= a[p][p];
        for (unsigned r = p + 1; r < TERMS; r++) {
            const double factor = a[r][p] / a[p][p];
            for (unsigned c = p; c < TERMS; c++) {
                a[r][c] -= factor * a[p][c];
            }
        }
    }
    return determinant;
}

static void equal_steps_make_the_five_functions_orthogonal(void)
{
    random_source random = random_start(7);

    for (unsigned n = 5; n <= 64; n++) {
        for (int draw = 0; draw < 10; draw++) {
            const program p = random_program(&random, n);
            for (unsigned group = 1; group <= 3; group++) {
                double a[PACKED];
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_information(&p.plan, group, a));
                for (unsigned r = 0; r < TERMS; r++) {
                    for (unsigned c = 0; c <= r; c++) {
                        const double expected = r != c ? 0 : r == 0 ? n : n / 2.0;
                        TEST_ASSERT_DOUBLE_WITHIN(close * n, expected, a[INVCAL_PACKED(r, c)]);
                    }
                }
                TEST_ASSERT_DOUBLE_WITHIN(close_determinant, 1, series_efficiency(a));
            }
        }
    }
}

static void other_angles_have_a_smaller_determinant(void)
{
    random_source random = random_start(8);
    double best = 0;

    for (int draw = 0; draw < 2000; draw++) {
        const unsigned n = 5 + (unsigned)draw % 20;
        double angle[24];
        double packed[PACKED];
        for (unsigned k = 0; k < n; k++) {
            angle[k] = random_uniform(&random, 0, TURN);
        }
        const double determinant = information_of(angle, n, packed);
        const double expected = determinant / (n * pow(n / 2.0, 4));
        const double efficiency = series_efficiency(packed);
        TEST_ASSERT_TRUE(efficiency < 1);
        /* Refused as singular below about the floor of a pivot, else right to some roundings. */
        TEST_ASSERT_TRUE(efficiency > 0 || expected < 1e-6);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12 + (efficiency > 0 ? 0 : 1e-6), expected, efficiency);
        best = fmax(best, efficiency);
    }
    TEST_ASSERT_TRUE(best > 0.3);
}

/* One of N positions moved from its place: the further, the worse. */
static void efficiency_falls_as_a_position_leaves_its_place(void)
{
    for (unsigned n = 5; n <= 12; n++) {
        double last = 1;
        for (int step = 1; step <= 8; step++) {
            double angle[12];
            double packed[PACKED];
            for (unsigned k = 0; k < n; k++) {
                angle[k] = 0.4 + TURN * k / n;
            }
            angle[2] += TURN / n * step / 10;
            const double expected = information_of(angle, n, packed) / (n * pow(n / 2.0, 4));
            const double efficiency = series_efficiency(packed);
            TEST_ASSERT_DOUBLE_WITHIN(1e-12, expected, efficiency);
            TEST_ASSERT_TRUE(efficiency < last);
            last = efficiency;
        }
    }
}

static void angles_that_leave_a_coefficient_open_have_no_efficiency(void)
{
    random_source random = random_start(9);

    for (unsigned distinct = 1; distinct <= 4; distinct++) {
        for (int draw = 0; draw < 50; draw++) {
            double angle[12];
            double packed[PACKED];
            for (unsigned k = 0; k < 12; k++) { /* in equal steps, each several times */
                angle[k] = 0.01 * draw + TURN * (k % distinct) / distinct;
                if (k < distinct && draw % 2) {
                    angle[k] = random_uniform(&random, 0, TURN);
                } else if (k >= distinct) {
                    angle[k] = angle[k - distinct];
                }
            }
            (void)information_of(angle, draw % 3 ? 12 : distinct, packed);
            TEST_ASSERT_TRUE(series_efficiency(packed) == 0);
        }
    }
}

static void no_information_has_no_efficiency(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    double nothing[PACKED] = {0};

    TEST_ASSERT_TRUE(series_efficiency(nothing) == 0);
    for (unsigned i = 0; i < PACKED; i++) {
        for (unsigned k = 0; k < 3; k++) {
            const invcal_plan plan = {6, {0, 0, 0}};
            double a[PACKED];
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_information(&plan, 1, a));
            a[i] = bad[k];
            TEST_ASSERT_TRUE(series_efficiency(a) == 0);
        }
    }
}

/* ---- what is refused ---- */

static void an_incomplete_program_is_refused_and_nothing_touched(void)
{
    random_source random = random_start(10);

    for (unsigned n = 5; n <= 12; n++) {
        const program p = random_program(&random, n);
        series s = series_of(&p.plan);
        for (unsigned i = 0; i < p.count; i++) {
            coefficient_table c;
            coefficient_table c_before;
            double x[NINE];
            double x_before[NINE];
            memset(c, 7, sizeof c);
            memcpy(c_before, c, sizeof c);
            memset(x, 7, sizeof x);
            memcpy(x_before, x, sizeof x);
            const series before = s;
            TEST_ASSERT_EQUAL_UINT(i, s.next);
            TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, series_coefficients(&s, c));
            TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, series_solve(&s, x));
            TEST_ASSERT_EQUAL_MEMORY(c_before, c, sizeof c);
            TEST_ASSERT_EQUAL_MEMORY(x_before, x, sizeof x);
            TEST_ASSERT_EQUAL_MEMORY(&before, &s, sizeof before);
            add(&s, 0.01);
        }
        double x[NINE];
        solve(&s, x); /* now it is complete: J = 0.01 everywhere is dk = 0.01 */
        for (unsigned r = 0; r < NINE; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(close, r / 3 == 1 ? 0.01 : 0, x[r]);
        }
    }
}

static void one_position_too_many_is_refused(void)
{
    random_source random = random_start(11);

    for (unsigned n = 5; n <= 12; n++) {
        const program p = random_program(&random, n);
        series s = series_of(&p.plan);
        for (unsigned i = 0; i < p.count; i++) {
            add(&s, random_normal(&random));
        }
        const series before = s;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT, series_add(&s, 0));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT, series_add(&s, 1));
        TEST_ASSERT_EQUAL_MEMORY(&before, &s, sizeof before);
        TEST_ASSERT_EQUAL_UINT(p.count, s.next);
    }
}

static void a_j_that_is_not_a_number_is_refused_and_may_be_given_again(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    random_source random = random_start(12);
    const program p = random_program(&random, 7);
    series s = series_of(&p.plan);
    series undisturbed = s;

    for (unsigned i = 0; i < p.count; i++) {
        const double j = random_normal(&random);
        for (unsigned k = 0; k < 3; k++) {
            TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, series_add(&s, bad[k]));
            TEST_ASSERT_EQUAL_MEMORY(&undisturbed, &s, sizeof s);
        }
        add(&s, j);
        add(&undisturbed, j);
    }
    TEST_ASSERT_EQUAL_MEMORY(&undisturbed, &s, sizeof s);
}

static void a_j_that_no_reading_can_give_is_refused(void)
{
    static const double bad[] = {100.1, -100.1, 1e30};
    random_source random = random_start(13);
    const program p = random_program(&random, 5);
    series s = series_of(&p.plan);
    const series before = s;

    for (unsigned k = 0; k < 3; k++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, series_add(&s, bad[k]));
        TEST_ASSERT_EQUAL_MEMORY(&before, &s, sizeof s);
    }
    add(&s, 99.9);
    add(&s, -99.9);
}

static void an_unusable_plan_is_refused_by_the_series(void)
{
    static const struct {
        unsigned per_group;
        double start;
        invcal_status expected;
    } bad[] = {{0, 0, INVCAL_TOO_FEW},
               {4, 0, INVCAL_TOO_FEW},
               {INVCAL_PLAN_PER_GROUP_MAX + 1, 0, INVCAL_BAD_COUNT},
               {UINT_MAX, 0, INVCAL_BAD_COUNT},
               {6, 361, INVCAL_BAD_ANGLE},
               {6, -361, INVCAL_BAD_ANGLE},
               {6, NOT_A_NUMBER, INVCAL_BAD_ANGLE},
               {6, INFINITE, INVCAL_BAD_ANGLE}};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned g = 0; g < 3; g++) {
            invcal_plan plan = {bad[i].per_group, {0, 0, 0}};
            series s;
            series series_before;
            double a[PACKED];
            double a_before[PACKED];
            plan.start_deg[g] = bad[i].start;
            memset(&s, 7, sizeof s);
            memset(a, 7, sizeof a);
            series_before = s;
            memcpy(a_before, a, sizeof a);
            TEST_ASSERT_EQUAL_INT(bad[i].expected, series_init(&s, &plan));
            TEST_ASSERT_EQUAL_INT(bad[i].expected, series_information(&plan, g + 1, a));
            TEST_ASSERT_EQUAL_MEMORY(&series_before, &s, sizeof s);
            TEST_ASSERT_EQUAL_MEMORY(a_before, a, sizeof a);
        }
    }
}

static void a_group_that_does_not_exist_is_refused(void)
{
    static const unsigned bad[] = {0, 4, 5, UINT_MAX, UINT_MAX - 2};
    const invcal_plan plan = {6, {30, 30, 120}};
    double a[PACKED];
    double before[PACKED];

    memset(a, 7, sizeof a);
    memcpy(before, a, sizeof a);
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, series_information(&plan, bad[i], a));
        TEST_ASSERT_EQUAL_MEMORY(before, a, sizeof a);
    }
}

/* When it begins again, a series is empty. */
static void a_series_may_be_begun_again(void)
{
    const double start[3] = {1, 2, 3};
    const program p = program_of(5, start);
    const series fresh = series_of(&p.plan);
    series s;

    memset(&s, 7, sizeof s);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_init(&s, &p.plan));
    for (unsigned i = 0; i < 7; i++) {
        add(&s, 1);
    }
    TEST_ASSERT_EQUAL_UINT(7, s.next);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, series_init(&s, &p.plan));
    TEST_ASSERT_EQUAL_UINT(0, s.next);
    for (unsigned g = 0; g < 3; g++) {
        for (unsigned i = 0; i < TERMS; i++) {
            TEST_ASSERT_TRUE(s.sum[g][i] == 0 && fresh.sum[g][i] == 0);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_vertical_composition_gives_the_parameters_exactly);
    RUN_TEST(each_parameter_alone_shows_in_its_own_coefficients);
    RUN_TEST(a0_of_group_1_is_that_of_dk_y_and_dk_z_not_dk_x);
    RUN_TEST(noisy_j_give_the_least_squares_of_the_reference);
    RUN_TEST(vertical_compositions_are_solved_as_by_the_9x9);
    RUN_TEST(noisy_vertical_compositions_are_solved_as_by_the_9x9);
    RUN_TEST(scalar_compositions_are_solved_as_by_the_9x9);
    RUN_TEST(noisy_scalar_compositions_are_solved_as_by_the_9x9);
    RUN_TEST(the_scalar_composition_holds_to_the_first_order);
    RUN_TEST(equal_steps_make_the_five_functions_orthogonal);
    RUN_TEST(other_angles_have_a_smaller_determinant);
    RUN_TEST(efficiency_falls_as_a_position_leaves_its_place);
    RUN_TEST(angles_that_leave_a_coefficient_open_have_no_efficiency);
    RUN_TEST(no_information_has_no_efficiency);
    RUN_TEST(an_incomplete_program_is_refused_and_nothing_touched);
    RUN_TEST(one_position_too_many_is_refused);
    RUN_TEST(a_j_that_is_not_a_number_is_refused_and_may_be_given_again);
    RUN_TEST(a_j_that_no_reading_can_give_is_refused);
    RUN_TEST(an_unusable_plan_is_refused_by_the_series);
    RUN_TEST(a_group_that_does_not_exist_is_refused);
    RUN_TEST(a_series_may_be_begun_again);
    return UNITY_END() != 0;
}
