/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "expected.h"
#include "plan/plan_axes.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST = INVCAL_PLAN_PER_GROUP_MAX };
#if LDBL_MANT_DIG > DBL_MANT_DIG
#define SINE(x) sinl(x)
#define COSINE(x) cosl(x)
#else /* some libraries then have no functions of long double */
#define SINE(x) sin((double)(x))
#define COSINE(x) cos((double)(x))
#endif
static const long double RADIAN = 0.017453292519943295769236907684886L;
/* The bound of plan.h for a component; the oracle rounds, too, if long double is no longer than
 * double. */
static const double component = FLOAT_OR_DOUBLE(5e-7, 1e-15) + 8 * (double)LDBL_EPSILON;
/* One unit in the last place of an angle up to 180 degrees. */
static const double degrees = 132 * (double)INVCAL_EPSILON + 720 * (double)LDBL_EPSILON;

static const double axis[INVCAL_AXES][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};

static invcal_plan plan_of(unsigned per_group, double first, double second, double third)
{
    const invcal_plan plan = {per_group,
                              {(invcal_real)first, (invcal_real)second, (invcal_real)third}};
    return plan;
}

static invcal_plan random_plan(random_source *random, unsigned per_group)
{
    invcal_plan plan = plan_of(per_group, 0, 0, 0);

    for (int g = 0; g < 3; g++) {
        plan.start_deg[g] = (invcal_real)random_uniform(random, -360, 360);
    }
    return plan;
}

static invcal_plan_position position_at(const invcal_plan *plan, unsigned i)
{
    invcal_plan_position position;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_get(plan, i, &position));
    return position;
}

/* Table 1, not wrapped: the angles of position l = 1 ... N of a group. */
static void table_1(const invcal_plan *plan, unsigned group, unsigned l, long double *alpha,
                    long double *beta)
{
    const long double turned =
        (long double)plan->start_deg[group - 1] + 360.0L * (l - 1) / plan->per_group;

    *alpha = group == 2 ? -90.0L : turned;
    *beta = group == 1 ? 0.0L : group == 2 ? turned : 90.0L;
}

/* eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta). */
static void eta_of(long double alpha, long double beta, double eta[3])
{
    eta[0] = (double)(SINE(alpha * RADIAN) * SINE(beta * RADIAN));
    eta[1] = (double)COSINE(alpha * RADIAN);
    eta[2] = (double)(SINE(alpha * RADIAN) * COSINE(beta * RADIAN));
}

/* An angle without whole turns: -180 ... 180. */
static long double without_turns(long double angle)
{
    return angle - 360 * (long double)(long)(angle / 360 + (angle < 0 ? -0.5L : 0.5L));
}

/* Above -180, at most 180, and the expected angle except for whole turns. */
static void assert_wrapped(long double expected, invcal_real actual)
{
    TEST_ASSERT_TRUE(actual > -180 && actual <= 180);
    TEST_ASSERT_DOUBLE_WITHIN(degrees, 0, (double)without_turns((long double)actual - expected));
}

static void assert_follows_table_1(const invcal_plan *plan)
{
    unsigned i = 0;

    for (unsigned group = 1; group <= 3; group++) {
        for (unsigned l = 1; l <= plan->per_group; l++) {
            const invcal_plan_position p = position_at(plan, i++);
            long double alpha;
            long double beta;
            double eta[3];
            TEST_ASSERT_EQUAL_UINT(group, p.group);
            TEST_ASSERT_EQUAL_UINT(l, p.index);
            table_1(plan, group, l, &alpha, &beta);
            assert_wrapped(alpha, p.alpha_deg);
            assert_wrapped(beta, p.beta_deg);
            TEST_ASSERT_TRUE(group != 2 || p.alpha_deg == -90);
            TEST_ASSERT_TRUE(group == 2 || p.beta_deg == (group == 1 ? 0 : 90));
            eta_of(alpha, beta, eta);
            for (int k = 0; k < 3; k++) {
                TEST_ASSERT_DOUBLE_WITHIN(component, eta[k], (double)p.up[k]);
            }
        }
    }
    TEST_ASSERT_EQUAL_UINT(3 * plan->per_group, i);
}

static void positions_follow_table_1_and_eta_from_any_starts(void)
{
    random_source random = random_start(1);

    for (unsigned n = 5; n <= 64; n++) {
        for (int draw = 0; draw < SOME(30); draw++) {
            const invcal_plan plan = random_plan(&random, n);
            assert_follows_table_1(&plan);
        }
    }
    const invcal_plan largest = random_plan(&random, MOST);
    assert_follows_table_1(&largest);
}

static void starts_at_the_seams_of_the_turn_are_wrapped(void)
{
    static const double seams[] = {-360, -359.999, -270.001, -180.001, -180, -179.999, -1e-30, 0,
                                   360,  359.999,  270.001,  180.001,  180,  179.999,  1e-30,  90};
    enum { SEAMS = sizeof seams / sizeof seams[0] };

    for (unsigned n = 5; n <= 64; n++) {
        for (unsigned i = 0; i < SEAMS; i++) {
            const invcal_plan plan =
                plan_of(n, seams[i], seams[(i + 5) % SEAMS], seams[(i + 11) % SEAMS]);
            assert_follows_table_1(&plan);
        }
    }
    /* A position that lies on the seam, from either side. */
    for (unsigned n = 5; n <= 64; n++) {
        for (unsigned k = 0; k < n; k++) {
            const double start = (double)without_turns(180 - 360.0L * k / n);
            const invcal_plan plan = plan_of(n, start, start, start);
            const invcal_plan below =
                plan_of(n, start * (1 - 4 * (double)INVCAL_EPSILON), start, start);
            assert_follows_table_1(&plan);
            assert_follows_table_1(&below);
        }
    }
}

static void starts_a_whole_turn_apart_are_the_same_program(void)
{
    static const double pairs[][2] = {{-360, 0},  {360, 0},    {-180, 180},
                                      {270, -90}, {-225, 135}, {315.5, -44.5}};

    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        for (unsigned n = 5; n <= 24; n++) {
            const invcal_plan a = plan_of(n, pairs[i][0], pairs[i][0], pairs[i][0]);
            const invcal_plan b = plan_of(n, pairs[i][1], pairs[i][1], pairs[i][1]);
            for (unsigned k = 0; k < 3 * n; k++) {
                const invcal_plan_position p = position_at(&a, k);
                const invcal_plan_position q = position_at(&b, k);
                TEST_ASSERT_TRUE(p.alpha_deg == q.alpha_deg && p.beta_deg == q.beta_deg);
                for (int c = 0; c < 3; c++) {
                    TEST_ASSERT_TRUE(p.up[c] == q.up[c]);
                }
            }
        }
    }
}

/* The paper's Table 2, its angles brought to -180 ... 180. */
static void the_papers_table_2_is_the_program_of_18(void)
{
    static const double angles[18][2] = {{30, 0},    {90, 0},    {150, 0},  {-150, 0},  {-90, 0},
                                         {-30, 0},   {-90, 30},  {-90, 90}, {-90, 150}, {-90, -150},
                                         {-90, -90}, {-90, -30}, {120, 90}, {180, 90},  {-120, 90},
                                         {-60, 90},  {0, 90},    {60, 90}};
    const invcal_plan plan = plan_of(6, 30, 30, 120);

    for (unsigned i = 0; i < 18; i++) {
        const invcal_plan_position p = position_at(&plan, i);
        TEST_ASSERT_TRUE((double)p.alpha_deg == angles[i][0]);
        TEST_ASSERT_TRUE((double)p.beta_deg == angles[i][1]);
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-7, 6e-16), expected_plan18[i][k],
                                      (double)p.up[k]);
        }
    }
}

/* Cosine of a multiple of 90 degrees. */
static int quarter_cosine(int angle)
{
    static const int value[4] = {1, 0, -1, 0};
    return value[((angle / 90) % 4 + 4) % 4];
}

/* Programs whose angles are whole degrees: where both are multiples of 90, eta is exact. */
static void multiples_of_90_degrees_give_exactly_0_and_1(void)
{
    static const unsigned per_group[] = {5, 6, 8, 9, 10, 12, 15, 18, 20, 24, 36, 40, 60, 72, 360};
    unsigned seen = 0;

    for (unsigned i = 0; i < sizeof per_group / sizeof per_group[0]; i++) {
        const int n = (int)per_group[i];
        for (int start = -360; start <= 360; start++) {
            const invcal_plan plan = plan_of((unsigned)n, start, start, start);
            for (int k = 0; k < n; k++) {
                const int turned = start + 360 / n * k;
                if (turned % 90 != 0) {
                    continue;
                }
                for (int group = 1; group <= 3; group++) {
                    const int alpha = group == 2 ? -90 : turned;
                    const int beta = group == 1 ? 0 : group == 2 ? turned : 90;
                    const double sine = quarter_cosine(alpha - 90);
                    const double exact[3] = {sine * quarter_cosine(beta - 90),
                                             quarter_cosine(alpha), sine * quarter_cosine(beta)};
                    const invcal_plan_position p =
                        position_at(&plan, (unsigned)((group - 1) * n + k));
                    for (int c = 0; c < 3; c++) {
                        TEST_ASSERT_TRUE((double)p.up[c] == exact[c]);
                    }
                    seen++;
                }
            }
        }
    }
    TEST_ASSERT_TRUE(seen > 10000);
}

/* Quarters and halves of a turn are exact although the steps are not. */
static void quarter_turns_are_exact_whatever_the_step(void)
{
    for (unsigned n = 6; n <= MOST; n += 2) {
        const unsigned parts = n % 4 ? 2 : 4;
        for (int start = -360; start <= 360; start += 90) {
            const invcal_plan plan = plan_of(n, start, start, start);
            for (unsigned part = 0; part < parts; part++) {
                const int turned = start + 360 / (int)parts * (int)part;
                const double c = quarter_cosine(turned);
                const double s = quarter_cosine(turned - 90);
                const double exact[3][3] = {{0, c, s}, {-s, 0, -c}, {s, c, 0}};
                for (unsigned g = 0; g < 3; g++) {
                    const invcal_plan_position p = position_at(&plan, g * n + n / parts * part);
                    for (int k = 0; k < 3; k++) {
                        TEST_ASSERT_TRUE((double)p.up[k] == exact[g][k]);
                    }
                }
            }
        }
    }
}

static void every_vertical_is_a_unit_vector(void)
{
    random_source random = random_start(2);

    for (unsigned n = 5; n <= MOST; n += n < 64 ? 1 : 39) {
        const invcal_plan plan = random_plan(&random, n);
        for (unsigned i = 0; i < 3 * n; i++) {
            const invcal_plan_position p = position_at(&plan, i);
            const double v[3] = {(double)p.up[0], (double)p.up[1], (double)p.up[2]};
            /* the length is rounded, too, which shows if double is float */
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1.5e-7 + DBL_EPSILON, 5e-16), 1, length3(v));
        }
    }
}

/* A call of each function that takes a plan; none may touch its output. */
static void assert_refused(invcal_status expected, const invcal_plan *plan, unsigned i)
{
    invcal_plan_position position;
    invcal_plan_position before;

    memset(&position, 7, sizeof position);
    before = position;
    TEST_ASSERT_EQUAL_INT(expected, invcal_plan_get(plan, i, &position));
    TEST_ASSERT_EQUAL_MEMORY(&before, &position, sizeof before);
}

static void a_position_beyond_the_program_is_refused(void)
{
    static const unsigned per_group[] = {5, 6, 64, MOST};

    for (unsigned k = 0; k < 4; k++) {
        const unsigned n = per_group[k];
        const invcal_plan plan = plan_of(n, 1, 2, 3);
        TEST_ASSERT_EQUAL_UINT(n, position_at(&plan, 3 * n - 1).index);
        assert_refused(INVCAL_BAD_COUNT, &plan, 3 * n);
        assert_refused(INVCAL_BAD_COUNT, &plan, 3 * n + 1);
        assert_refused(INVCAL_BAD_COUNT, &plan, UINT_MAX);
    }
}

static void absurd_numbers_of_positions_are_refused_with_a_reason(void)
{
    static const unsigned numbers[] = {0,
                                       1,
                                       2,
                                       3,
                                       4,
                                       MOST + 1,
                                       INT_MAX,
                                       UINT_MAX / 3 + 1,
                                       UINT_MAX,
                                       UINT_MAX - 1,
                                       UINT_MAX / 2 + 1,
                                       UINT_MAX / 3};

    for (unsigned k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        const unsigned n = numbers[k];
        const invcal_status expected = n < 5 ? INVCAL_TOO_FEW : INVCAL_BAD_COUNT;
        const invcal_plan plan = plan_of(n, 0, 0, 0);
        invcal_plan made = plan_of(6, 7, 8, 9);
        TEST_ASSERT_EQUAL_INT(expected, invcali_plan_check(&plan));
        assert_refused(expected, &plan, 0);
        TEST_ASSERT_EQUAL_INT(expected, invcal_plan_init(&made, n));
        TEST_ASSERT_TRUE(made.per_group == 6 && made.start_deg[0] == 7 && made.start_deg[1] == 8 &&
                         made.start_deg[2] == 9);
    }
    for (unsigned n = 5; n <= MOST; n++) {
        const invcal_plan plan = plan_of(n, 360, -360, 0);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_plan_check(&plan));
    }
}

static void starts_that_are_not_angles_are_refused(void)
{
    const double beyond = 360 * (1 + (double)INVCAL_EPSILON);
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 361, -361, beyond, -beyond, 1e30};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned group = 0; group < 3; group++) {
            invcal_plan plan = plan_of(6, 30, 30, 120);
            plan.start_deg[group] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, invcali_plan_check(&plan));
            for (unsigned k = 0; k < 18; k++) {
                assert_refused(INVCAL_BAD_ANGLE, &plan, k);
            }
        }
    }
}

/* The axes within so many degrees of a vertical, by the chord between them. */
static unsigned axes_within(double angle, const invcal_real vertical[3])
{
    unsigned axes = 0;

    for (unsigned a = 0; a < INVCAL_AXES; a++) {
        const double off[3] = {(double)vertical[0] - axis[a][0], (double)vertical[1] - axis[a][1],
                               (double)vertical[2] - axis[a][2]};
        axes |= (unsigned)(length3(off) < angle * (double)RADIAN) << a;
    }
    return axes;
}

/* The axes of some positions of a plan, 0.1 degrees being blurred by 5 %. */
static unsigned axes_of(const invcal_plan *plan, unsigned first, unsigned last)
{
    unsigned axes = 0;

    for (unsigned i = first; i < last; i++) {
        const invcal_plan_position p = position_at(plan, i);
        const unsigned up = invcali_axis_up(p.up);
        TEST_ASSERT_EQUAL_HEX8(axes_within(0.095, p.up), up & axes_within(0.095, p.up));
        TEST_ASSERT_EQUAL_HEX8(up, up & axes_within(0.105, p.up));
        axes |= up;
    }
    return axes;
}

static void assert_starts_point(unsigned per_group, unsigned expected)
{
    invcal_plan plan = plan_of(0, NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_init(&plan, per_group));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_plan_check(&plan));
    TEST_ASSERT_EQUAL_UINT(per_group, plan.per_group);
    TEST_ASSERT_EQUAL_HEX8(expected, axes_of(&plan, 0, 3 * per_group));
}

static void the_starts_for_an_even_number_point_every_axis_up_and_down(void)
{
    for (unsigned n = 6; n <= MOST; n += 2) {
        assert_starts_point(n, 0x3F);
    }
}

static void each_group_of_an_even_program_holds_its_own_axis_both_ways(void)
{
    static const unsigned own[3] = {1u << INVCAL_AXIS_PLUS_Z | 1u << INVCAL_AXIS_MINUS_Z,
                                    1u << INVCAL_AXIS_PLUS_X | 1u << INVCAL_AXIS_MINUS_X,
                                    1u << INVCAL_AXIS_PLUS_Y | 1u << INVCAL_AXIS_MINUS_Y};

    for (unsigned n = 6; n <= 64; n += 2) {
        invcal_plan plan;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_init(&plan, n));
        for (unsigned g = 0; g < 3; g++) {
            TEST_ASSERT_EQUAL_HEX8(own[g], axes_of(&plan, g * n, (g + 1) * n) & own[g]);
        }
    }
}

static void the_starts_for_an_odd_number_give_plus_z_minus_x_minus_y(void)
{
    const unsigned expected =
        1u << INVCAL_AXIS_PLUS_Z | 1u << INVCAL_AXIS_MINUS_X | 1u << INVCAL_AXIS_MINUS_Y;

    /* From 901 on a quarter of a step, by which the others are missed, is less than 0.1 degrees. */
    for (unsigned n = 5; n <= 899; n += 2) {
        assert_starts_point(n, expected);
    }
}

static void the_starts_for_six_are_the_papers(void)
{
    invcal_plan plan;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_init(&plan, 6));
    TEST_ASSERT_TRUE(plan.start_deg[0] == 30 && plan.start_deg[1] == 30 &&
                     plan.start_deg[2] == 120);
}

/* How many axes a group can point to at best: its starts repeat after a step, and are tried four
 * times as close as the 0.1 degrees that count as along an axis. */
static unsigned most_axes(unsigned per_group, unsigned group)
{
    const double step = 360.0 / per_group;
    const unsigned tries = (unsigned)(step / 0.025) + 1;
    unsigned most = 0;

    for (unsigned t = 0; t < tries; t++) {
        const double start = step * t / tries;
        const invcal_plan plan = plan_of(per_group, start, start, start);
        const unsigned axes = axes_of(&plan, group * per_group, (group + 1) * per_group);
        unsigned count = 0;
        for (unsigned a = 0; a < INVCAL_AXES; a++) {
            count += axes >> a & 1u;
        }
        most = count > most ? count : most;
    }
    return most;
}

static void no_starts_of_an_odd_program_point_to_more_than_three_axes(void)
{
    for (unsigned n = 5; n <= 15; n++) {
        for (unsigned group = 0; group < 3; group++) {
            /* Opposite axes are N/2 steps apart, neighbours N/4. */
            const unsigned expected = n % 2 ? 1 : n % 4 ? 2 : 4;
            TEST_ASSERT_EQUAL_UINT(expected, most_axes(n, group));
        }
    }
}

static void an_axis_is_up_within_a_tenth_of_a_degree(void)
{
    static const double tilts[] = {0, 0.01, 0.05, 0.095, 0.105, 0.2, 1, 30, 54, 90};

    for (unsigned a = 0; a < INVCAL_AXES; a++) {
        const unsigned i = a / 2;
        for (unsigned t = 0; t < sizeof tilts / sizeof tilts[0]; t++) {
            for (int azimuth = 7; azimuth < 360; azimuth += 12) {
                const double tilt = tilts[t] * (double)RADIAN;
                const double turn = azimuth * (double)RADIAN;
                invcal_real v[3];
                v[i] = (invcal_real)(axis[a][i] * cos(tilt));
                v[(i + 1) % 3] = (invcal_real)(sin(tilt) * cos(turn));
                v[(i + 2) % 3] = (invcal_real)(sin(tilt) * sin(turn));
                TEST_ASSERT_EQUAL_HEX8(tilts[t] < 0.1 ? 1u << a : 0, invcali_axis_up(v));
            }
        }
    }
}

static void what_is_not_a_direction_is_along_one_axis_at_most(void)
{
    const double values[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 0, 1, -1, 1e30};
    enum { VALUES = sizeof values / sizeof values[0] };
    const invcal_real zero[3] = {0, 0, 0};
    const invcal_real nan[3] = {(invcal_real)NAN, (invcal_real)NAN, (invcal_real)NAN};

    TEST_ASSERT_EQUAL_HEX8(0, invcali_axis_up(zero));
    TEST_ASSERT_EQUAL_HEX8(0, invcali_axis_up(nan));
    for (unsigned i = 0; i < VALUES * VALUES * VALUES; i++) {
        const invcal_real v[3] = {(invcal_real)values[i % VALUES],
                                  (invcal_real)values[i / VALUES % VALUES],
                                  (invcal_real)values[i / VALUES / VALUES]};
        const unsigned axes = invcali_axis_up(v);
        TEST_ASSERT_TRUE(axes < 1u << INVCAL_AXES && (axes & (axes - 1u)) == 0);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(positions_follow_table_1_and_eta_from_any_starts);
    RUN_LONG_TEST(starts_at_the_seams_of_the_turn_are_wrapped);
    RUN_TEST(starts_a_whole_turn_apart_are_the_same_program);
    RUN_TEST(the_papers_table_2_is_the_program_of_18);
    RUN_SLOW_TEST(multiples_of_90_degrees_give_exactly_0_and_1);
    RUN_SLOW_TEST(quarter_turns_are_exact_whatever_the_step);
    RUN_SLOW_TEST(every_vertical_is_a_unit_vector);
    RUN_TEST(a_position_beyond_the_program_is_refused);
    RUN_TEST(absurd_numbers_of_positions_are_refused_with_a_reason);
    RUN_TEST(starts_that_are_not_angles_are_refused);
    RUN_LONG_TEST(the_starts_for_an_even_number_point_every_axis_up_and_down);
    RUN_TEST(each_group_of_an_even_program_holds_its_own_axis_both_ways);
    RUN_LONG_TEST(the_starts_for_an_odd_number_give_plus_z_minus_x_minus_y);
    RUN_TEST(the_starts_for_six_are_the_papers);
    RUN_LONG_TEST(no_starts_of_an_odd_program_point_to_more_than_three_axes);
    RUN_TEST(an_axis_is_up_within_a_tenth_of_a_degree);
    RUN_TEST(what_is_not_a_direction_is_along_one_axis_at_most);
    return UNITY_END() != 0;
}
