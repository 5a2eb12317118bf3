/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plan/guidance.h"
#include "invcal/expert.h"
#include "invcal/plan.h"
#include "core/vector.h"
#include "support.h"
#include "unity.h"

#ifndef HANDS
#define HANDS 500 /* sessions with hand errors */
#endif

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = INVCAL_PARAMETERS };
static const double RIDGE = 1e-5; /* over the trace and 10 */

/* ---- an independent computation, in double --------------------------------------------------- */

typedef struct {
    double k[N][N]; /* inverse */
    double log_det;
} inverse_matrix;

static void row_of(const double v[3], double h[N])
{
    const double row[N] = {v[0],        v[1],        v[2],        v[0] * v[0], v[1] * v[1],
                           v[2] * v[2], v[0] * v[1], v[0] * v[2], v[1] * v[2]};

    memcpy(h, row, sizeof row);
}

static inverse_matrix inverse_of(double a[N][N])
{
    inverse_matrix out;

    memcpy(out.k, a, sizeof out.k);
    out.log_det = invert(out.k[0], N);
    return out;
}

/* Readings over field: the positions taken so far. */
typedef struct {
    invcal_real u[3 * MAX_POSITIONS];
    unsigned count;
} reading_list;

/* (H'H + ridge, + h h' of more)^-1 */
static inverse_matrix covariance(const reading_list *list, double ridge, const double *more)
{
    double a[N][N] = {{0}};
    double h[N];
    double trace = 10;

    for (unsigned i = 0; i < list->count; i++) {
        const invcal_real *u = &list->u[3 * i];
        const double v[3] = {(double)u[0], (double)u[1], (double)u[2]};
        row_of(v, h);
        for (int r = 0; r < N; r++) {
            for (int c = 0; c < N; c++) {
                a[r][c] += h[r] * h[c];
            }
        }
    }
    if (more) {
        row_of(more, h);
        for (int r = 0; r < N; r++) {
            for (int c = 0; c < N; c++) {
                a[r][c] += h[r] * h[c];
            }
        }
    }
    for (int r = 0; r < N; r++) {
        trace += a[r][r];
    }
    for (int r = 0; r < N; r++) {
        a[r][r] += ridge * trace;
    }
    return inverse_of(a);
}

static double leverage_of(const inverse_matrix *inverse, const double up[3])
{
    double h[N];
    double leverage = 0;

    row_of(up, h);
    for (int r = 0; r < N; r++) {
        for (int c = 0; c < N; c++) {
            leverage += h[r] * inverse->k[r][c] * h[c];
        }
    }
    return leverage;
}

static double worst_root(const inverse_matrix *inverse)
{
    double worst = 0;

    for (int r = 0; r < N; r++) {
        worst = larger(worst, sqrt(inverse->k[r][r]));
    }
    return worst;
}

/* log det H'H of n directions that make a spherical 4-design: means of x^2, x^4, x^2 y^2 are 1/3,
 * 1/5, 1/15; the quadratic block has the eigenvalues 1/3 and twice 2/15. */
static double bound(double n)
{
    return 4 * log(n / 3) + 2 * log(2 * n / 15) + 3 * log(n / 15);
}

/* The 26 directions: all of -1, 0, 1 except zero. */
static int direction_of(int code, double up[3])
{
    const double v[3] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
    const double length = length3(v);

    for (int i = 0; i < 3; i++) {
        up[i] = length > 0 ? v[i] / length : 0;
    }
    return length > 0;
}

static double cosine(const double a[3], const double b[3])
{
    return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (length3(a) * length3(b));
}

/* ---- sessions ---------------------------------------------------------------------------------- */

static void add_reading(reading_list *list, const double u[3])
{
    TEST_ASSERT_TRUE(list->count < MAX_POSITIONS);
    for (unsigned i = 0; i < 3; i++) {
        list->u[3 * list->count + i] = (invcal_real)u[i];
    }
    list->count++;
}

static void ask(const reading_list *list, double up[3])
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real next[3];

    invcali_next(POSITIONS_OF(list->u, list->count, &nominal, 0), next);
    for (int i = 0; i < 3; i++) {
        up[i] = (double)next[i];
    }
}

static void prospect(const reading_list *list, const double *up, double root[N])
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real at[3] = {0, 0, 0};
    invcal_real found[N];

    for (int i = 0; i < 3 && up; i++) {
        at[i] = (invcal_real)up[i];
    }
    invcali_prospect(POSITIONS_OF(list->u, list->count, &nominal, 0), up ? at : NULL, found);
    for (int r = 0; r < N; r++) {
        root[r] = (double)found[r];
    }
}

static int sign_of(double x)
{
    return (x > 0.01) - (x < -0.01);
}

/* Random readings of a random triad. */
static reading_list random_readings(random_source *random, unsigned count)
{
    const triad_truth truth = triad_random(random, 0.05);
    reading_list list = {{0}, 0};

    while (list.count < count) {
        double v[3];
        double u[3];
        random_direction(random, v);
        triad_read(&truth, v, u);
        add_reading(&list, u);
    }
    return list;
}

/* A direction at an angle of degrees from up, to a random side. */
static void miss(random_source *random, const double up[3], double degrees, double v[3])
{
    const double angle = degrees / 57.29577951308232;
    double side[3];

    random_direction(random, side);
    const double along = side[0] * up[0] + side[1] * up[1] + side[2] * up[2];
    for (int i = 0; i < 3; i++) {
        side[i] -= along * up[i];
    }
    const double length = length3(side);
    for (int i = 0; i < 3; i++) {
        v[i] = cos(angle) * up[i] + sin(angle) * side[i] / length;
    }
}

/* By how much sigma grows, at most, if three columns of a drift are fitted as well: tau eta, tau from -1/2 to
 * 1/2 in the order of visiting. */
static double cost_of_drift(const reading_list *list)
{
    enum { ALL = N + 3 };
    const inverse_matrix nine = covariance(list, 0, NULL);
    double a[ALL][ALL] = {{0}};
    double most = 0;

    for (unsigned i = 0; i < list->count; i++) {
        const double tau = i / (list->count - 1.0) - 0.5;
        double h[ALL];
        for (int k = 0; k < 3; k++) {
            h[N + k] = (double)list->u[3 * i + (unsigned)k];
        }
        row_of(&h[N], h);
        for (int r = 0; r < ALL; r++) {
            for (int c = 0; c < ALL; c++) {
                a[r][c] += (r < N ? h[r] : tau * h[r]) * (c < N ? h[c] : tau * h[c]);
            }
        }
    }
    for (int p = ALL - 1; p >= N; p--) { /* what they leave of the nine: Schur's complement */
        for (int r = 0; r < p; r++) {
            const double factor = a[r][p] / a[p][p];
            for (int c = 0; c < p; c++) {
                a[r][c] -= factor * a[p][c];
            }
        }
    }
    double left[N][N];
    for (int r = 0; r < N; r++) {
        memcpy(left[r], a[r], sizeof left[r]);
    }
    const inverse_matrix twelve = inverse_of(left);
    for (int r = 0; r < N; r++) {
        most = larger(most, sqrt(twelve.k[r][r] / nine.k[r][r]));
    }
    return most;
}

/* What a guided session has reached after 9, 12 and 18 positions. */
typedef struct {
    double worst9;
    double worst12;
    double worst18;
    double deficit18; /* of log det against its bound */
    double drift14;   /* what a drift costs from 14 on, at most */
} progress;

static progress follow(random_source *random, double errors, double degrees)
{
    const triad_truth truth = triad_random(random, errors);
    reading_list read = {{0}, 0};    /* the one that guides */
    reading_list visited = {{0}, 0}; /* the directions themselves */
    progress p = {0, 0, 0, 0, 0};

    for (unsigned n = 1; n <= 18; n++) {
        double up[3];
        double v[3];
        double u[3];
        ask(&read, up);
        miss(random, up, degrees, v);
        add_reading(&visited, v);
        triad_read(&truth, v, u);
        add_reading(&read, u);
        if (n == 9 || n == 12 || n == 18) {
            const inverse_matrix k = covariance(&visited, 0, NULL);
            *(n == 9 ? &p.worst9 : n == 12 ? &p.worst12 : &p.worst18) = worst_root(&k);
            p.deficit18 = bound(n) - k.log_det;
        }
        if (n >= 14) {
            p.drift14 = fmax(p.drift14, cost_of_drift(&visited));
        }
    }
    return p;
}

static void nine_positions_as_asked_determine_everything_and_eighteen_come_close_to_the_best(void)
{
    random_source random = random_start(1);
    const progress p = follow(&random, 0, 0);

    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(3.01, p.worst9);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.42, p.worst12);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.91, p.worst18);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.3, p.deficit18);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0, p.deficit18);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.16, p.drift14);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

static void hands_that_miss_by_10_degrees_get_nearly_as_far(void)
{
    static double deficit[HANDS];
    random_source random = random_start(2);
    unsigned hidden = 0;

    for (int i = 0; i < HANDS; i++) {
        const progress p = follow(&random, 0.05, 10);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(5, p.worst9);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(2.2, p.worst12);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.25, p.worst18);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.8, p.deficit18);
        deficit[i] = p.deficit18;
        hidden += !(p.drift14 <= 1.5); /* in which case it would not be tested */
    }
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.05, (double)hidden / HANDS);
    qsort(deficit, HANDS, sizeof *deficit, by_size);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.34, deficit[HANDS / 2]);
}

/* The same in float and double, and on every machine. */
static void the_first_positions_are_faces_then_corners(void)
{
    static const char *const expected[] = {
        "+z up",
        "+y up",
        "+x up",
        "-y up",
        "-x up",
        "-z up",
        "-z up, tilt 55 deg, +x and +y rise",
        "+z up, tilt 55 deg, +x and +y rise",
        "+z up, tilt 55 deg, -x and +y rise",
        "-z up, tilt 55 deg, -x and +y rise",
        "-z up, tilt 55 deg, -x and -y rise",
        "+z up, tilt 55 deg, -x and -y rise",
        "+z up, tilt 55 deg, +x and -y rise",
        "-z up, tilt 55 deg, +x and -y rise",
    };
    reading_list list = {{0}, 0};
    char words[INVCAL_TEXT_SIZE];

    for (unsigned n = 0; n < sizeof expected / sizeof expected[0]; n++) {
        double up[3];
        ask(&list, up);
        const invcal_real next[3] = {(invcal_real)up[0], (invcal_real)up[1], (invcal_real)up[2]};
        TEST_ASSERT_EQUAL_STRING(expected[n], invcal_direction_text(next, words));
        add_reading(&list, up);
    }
}

/* ---- the choice -------------------------------------------------------------------------------- */

/* Is up the most informative, with a move right over counting 1/64 less than none? Within the
 * rounding of float. */
static void assert_choice(const reading_list *list, const double up[3])
{
    const inverse_matrix k = covariance(list, RIDGE, NULL);
    double current[3] = {0, 0, 0};
    double other[3];

    for (int i = 0; i < 3 && list->count > 0; i++) {
        current[i] = (double)list->u[3 * (list->count - 1) + (unsigned)i];
    }
    const double closeness = list->count > 0 ? cosine(up, current) : 0;
    const double merit = leverage_of(&k, up) * (1 + closeness / 128);
    TEST_ASSERT_DOUBLE_WITHIN(4 * (double)INVCAL_EPSILON, 1, length3(up));
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.9001, closeness);
    for (int code = 0; code < 27; code++) {
        if (direction_of(code, other)) {
            const double closer = list->count > 0 ? cosine(other, current) : 0;
            TEST_ASSERT_TRUE(closer > 0.8999 || leverage_of(&k, other) * (1 + closer / 128) <=
                                                    merit * FLOAT_OR_DOUBLE(1.004, 1.00101));
        }
    }
}

static void the_next_direction_adds_most_and_is_not_far(void)
{
    random_source random = random_start(3);

    for (int draw = 0; draw < SOME(4000); draw++) {
        const reading_list list = random_readings(&random, (unsigned)draw % 25);
        double up[3];
        ask(&list, up);
        assert_choice(&list, up);
    }
}

static void only_faces_edges_and_corners_are_asked_for(void)
{
    random_source random = random_start(4);

    for (int draw = 0; draw < SOME(300); draw++) {
        const reading_list list = random_readings(&random, (unsigned)draw % 25);
        double up[3];
        double sign[3];
        ask(&list, up);
        for (int i = 0; i < 3; i++) {
            sign[i] = sign_of(up[i]);
        }
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(2 * (double)INVCAL_EPSILON, sign[i] / length3(sign), up[i]);
        }
    }
}

static void what_is_within_reach_of_the_last_position_is_not_asked_for(void)
{
    for (int axis = 0; axis < 3; axis++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            reading_list list = {{0}, 0};
            double held[3] = {0.2, 0.1, -0.1};
            double up[3];
            held[axis] = sign;
            add_reading(&list, held);
            ask(&list, up);
            TEST_ASSERT_EQUAL_INT(0, sign_of(up[axis]));
        }
    }
}

/* Not even if it is the most informative. */
static void the_position_taken_last_is_never_asked_for_again(void)
{
    reading_list list = {{0}, 0};
    double up[3];

    for (int code = 0; code < 26; code++) { /* all but the corner + + + twice */
        for (int times = 0; times < 2 && direction_of(code, up); times++) {
            add_reading(&list, up);
        }
    }
    TEST_ASSERT_TRUE(direction_of(26, up));
    for (int i = 0; i < 3; i++) {
        up[i] *= 0.2; /* a weak reading, which tells little */
    }
    add_reading(&list, up);
    ask(&list, up);
    TEST_ASSERT_TRUE(sign_of(up[0]) < 1 || sign_of(up[1]) < 1 || sign_of(up[2]) < 1);
}

static void what_is_not_a_reading_is_skipped(void)
{
    const double bad[][3] = {{NOT_A_NUMBER, 0, 0},     {0, NOT_A_NUMBER, 1},
                             {0, 1, INFINITE},         {0, 0, 0},
                             {-INFINITE, INFINITE, 0}, {(double)INVCAL_REAL_MAX / 1e8, 0, 0}};
    random_source random = random_start(5);

    for (unsigned count = 0; count < 24; count++) {
        const reading_list list = random_readings(&random, count);
        double expected[3];
        double root[N];
        ask(&list, expected);
        prospect(&list, NULL, root);
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            reading_list more = list;
            double up[3];
            double then[N];
            add_reading(&more, bad[i]);
            ask(&more, up);
            prospect(&more, NULL, then);
            TEST_ASSERT_EQUAL_MEMORY(expected, up, sizeof up);
            TEST_ASSERT_EQUAL_MEMORY(root, then, sizeof root);
        }
    }
}

/* ---- what the position will do ------------------------------------------------------------------ */

static void the_prospect_is_sigma_without_and_with_the_position(void)
{
    static const double close = FLOAT_OR_DOUBLE(2e-3, 1e-9);
    random_source random = random_start(7);

    for (unsigned count = 0; count < 100; count++) {
        const reading_list list = random_readings(&random, count % 25);
        double up[3];
        double before[N];
        double after[N];
        ask(&list, up);
        prospect(&list, NULL, before);
        prospect(&list, up, after);
        const inverse_matrix expected_before = covariance(&list, RIDGE, NULL);
        const inverse_matrix expected_after = covariance(&list, RIDGE, up);
        for (unsigned r = 0; r < N; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(close, 1, before[r] / sqrt(expected_before.k[r][r]));
            TEST_ASSERT_DOUBLE_WITHIN(close, 1, after[r] / sqrt(expected_after.k[r][r]));
        }
    }
}

static void with_eighteen_positions_the_prospect_is_that_of_the_sums_alone(void)
{
    reading_list list = {{0}, 0};
    double root[N];

    for (int i = 0; i < 18; i++) {
        double up[3];
        ask(&list, up);
        add_reading(&list, up);
    }
    const inverse_matrix k = covariance(&list, 0, NULL);
    prospect(&list, NULL, root);
    for (unsigned r = 0; r < N; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1, root[r] / sqrt(k.k[r][r]));
    }
}

static void from_positions_on_a_plane_it_leads_out_of_the_plane(void)
{
    reading_list list = {{0}, 0};
    double up[3];
    double before[N];
    double after[N];

    for (int i = 0; i < 18; i++) {
        const double angle = 0.3490658503988659 * i;
        const double v[3] = {cos(angle), sin(angle), 0};
        add_reading(&list, v);
    }
    ask(&list, up);
    prospect(&list, NULL, before);
    prospect(&list, up, after);
    TEST_ASSERT_TRUE(sign_of(up[2]) != 0);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(10, before[INVCAL_DELTA_Z]); /* open */
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1, before[INVCAL_DELTA_X]);
    TEST_ASSERT_TRUE(after[INVCAL_DELTA_Z] < 0.8 * before[INVCAL_DELTA_Z]);
}

/* ---- words -------------------------------------------------------------------------------------- */

static void all_26_directions_have_their_words(void)
{
    static const struct {
        signed char sign[3];
        const char *words;
    } expected[] = {
        {{0, 0, 1}, "+z up"},
        {{0, 0, -1}, "-z up"},
        {{1, 0, 0}, "+x up"},
        {{-1, 0, 0}, "-x up"},
        {{0, 1, 0}, "+y up"},
        {{0, -1, 0}, "-y up"},
        {{1, 0, 1}, "+z up, tilt 45 deg, +x rises"},
        {{-1, 0, 1}, "+z up, tilt 45 deg, -x rises"},
        {{0, 1, 1}, "+z up, tilt 45 deg, +y rises"},
        {{0, -1, 1}, "+z up, tilt 45 deg, -y rises"},
        {{1, 0, -1}, "-z up, tilt 45 deg, +x rises"},
        {{-1, 0, -1}, "-z up, tilt 45 deg, -x rises"},
        {{0, 1, -1}, "-z up, tilt 45 deg, +y rises"},
        {{0, -1, -1}, "-z up, tilt 45 deg, -y rises"},
        {{1, 1, 0}, "+x up, tilt 45 deg, +y rises"},
        {{1, -1, 0}, "+x up, tilt 45 deg, -y rises"},
        {{-1, 1, 0}, "-x up, tilt 45 deg, +y rises"},
        {{-1, -1, 0}, "-x up, tilt 45 deg, -y rises"},
        {{1, 1, 1}, "+z up, tilt 55 deg, +x and +y rise"},
        {{1, -1, 1}, "+z up, tilt 55 deg, +x and -y rise"},
        {{-1, 1, 1}, "+z up, tilt 55 deg, -x and +y rise"},
        {{-1, -1, 1}, "+z up, tilt 55 deg, -x and -y rise"},
        {{1, 1, -1}, "-z up, tilt 55 deg, +x and +y rise"},
        {{1, -1, -1}, "-z up, tilt 55 deg, +x and -y rise"},
        {{-1, 1, -1}, "-z up, tilt 55 deg, -x and +y rise"},
        {{-1, -1, -1}, "-z up, tilt 55 deg, -x and -y rise"},
    };

    TEST_ASSERT_EQUAL_UINT(26, sizeof expected / sizeof expected[0]);
    for (unsigned i = 0; i < 26; i++) {
        char words[INVCAL_TEXT_SIZE];
        const double sign[3] = {expected[i].sign[0], expected[i].sign[1], expected[i].sign[2]};
        invcal_real up[3];
        for (int k = 0; k < 3; k++) {
            up[k] = (invcal_real)(sign[k] / length3(sign));
        }
        memset(words, '#', sizeof words);
        TEST_ASSERT_TRUE(invcal_direction_text(up, words) == words);
        TEST_ASSERT_EQUAL_STRING(expected[i].words, words);
        for (size_t at = strlen(words) + 1; at < sizeof words; at++) {
            TEST_ASSERT_TRUE(words[at] == '#');
        }
    }
}

static void other_directions_have_words_to_five_degrees(void)
{
    static const struct {
        double up[3];
        const char *words;
    } expected[] = {
        {{0, 0.8660254, 0.5}, "+y up, tilt 30 deg, +z rises"},
        {{-0.5, 0, 0.8660254}, "+z up, tilt 30 deg, -x rises"},
        {{0.9962, 0, -0.0872}, "+x up"},
        {{0, 0.1219, -0.9925}, "-z up, tilt 5 deg, +y rises"},
        {{0.1011, 0, 0.9949}, "+z up"},                       /* 5.80 */
        {{0.1020, 0, 0.9948}, "+z up, tilt 5 deg, +x rises"}, /* 5.85 */
        {{0.1736, 0, 0.9848}, "+z up, tilt 10 deg, +x rises"},
        {{0.2147, 0, 0.9767}, "+z up, tilt 10 deg, +x rises"}, /* 12.4 */
        {{0.2181, 0, 0.9759}, "+z up, tilt 15 deg, +x rises"}, /* 12.6 */
        {{0.2, -0.9165, 0.3464}, "-y up, tilt 25 deg, +z and +x rise"},
        {{0.3464, -0.9165, 0.2}, "-y up, tilt 25 deg, +z and +x rise"}, /* x and z the same */
        {{-0.9165, 0.2, -0.3464}, "-x up, tilt 25 deg, +y and -z rise"},
        {{0, 1.25, 0}, "+y up"}, /* longer than 1 */
    };

    for (unsigned i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        char words[INVCAL_TEXT_SIZE];
        invcal_real up[3];
        for (int k = 0; k < 3; k++) {
            up[k] = (invcal_real)expected[i].up[k];
        }
        TEST_ASSERT_TRUE(invcal_direction_text(up, words) == words);
        TEST_ASSERT_EQUAL_STRING(expected[i].words, words);
    }
}

/* The tilt is rounded to five degrees, for a unit vector in parts of 640. */
static void the_tilt_changes_between_two_fives(void)
{
    for (unsigned i = 0; i < 10; i++) {
        for (int side = -1; side <= 1; side += 2) {
            const double degrees = 7.5 + 5 * i + side * (i == 0 ? 0.4 : 0.12);
            const double radians = degrees / 57.29577951308232;
            /* more than 45 degrees from both other axes */
            const double across = i < 8 ? sin(radians) : sin(radians) / sqrt(2);
            const invcal_real up[3] = {(invcal_real)across, (invcal_real)(i < 8 ? 0 : across),
                                       (invcal_real)cos(radians)};
            char words[INVCAL_TEXT_SIZE];
            const char *tilt = strstr(invcal_direction_text(up, words), "tilt ");
            TEST_ASSERT_NOT_NULL(tilt);
            TEST_ASSERT_EQUAL_INT(5 * (int)(i + 1 + (side > 0)), atoi(tilt + 5));
        }
    }
}

/* Whatever the numbers, no byte is written beyond the words, and they are terminated. */
static void words_for_no_direction_do_no_harm(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 0, 1e30, -1e30, 0.5};

    for (unsigned code = 0; code < 343; code++) {
        const invcal_real up[3] = {(invcal_real)bad[code % 7], (invcal_real)bad[code / 7 % 7],
                                   (invcal_real)bad[code / 49]};
        char words[INVCAL_TEXT_SIZE + 1];
        words[INVCAL_TEXT_SIZE] = '#';
        TEST_ASSERT_TRUE(strlen(invcal_direction_text(up, words)) < INVCAL_TEXT_SIZE);
        TEST_ASSERT_TRUE(words[INVCAL_TEXT_SIZE] == '#');
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(nine_positions_as_asked_determine_everything_and_eighteen_come_close_to_the_best);
    RUN_LONG_TEST(hands_that_miss_by_10_degrees_get_nearly_as_far);
    RUN_TEST(the_first_positions_are_faces_then_corners);
    RUN_TEST(the_next_direction_adds_most_and_is_not_far);
    RUN_TEST(only_faces_edges_and_corners_are_asked_for);
    RUN_TEST(what_is_within_reach_of_the_last_position_is_not_asked_for);
    RUN_TEST(the_position_taken_last_is_never_asked_for_again);
    RUN_SLOW_TEST(what_is_not_a_reading_is_skipped);
    RUN_SLOW_TEST(the_prospect_is_sigma_without_and_with_the_position);
    RUN_TEST(with_eighteen_positions_the_prospect_is_that_of_the_sums_alone);
    RUN_TEST(from_positions_on_a_plane_it_leads_out_of_the_plane);
    RUN_TEST(all_26_directions_have_their_words);
    RUN_TEST(other_directions_have_words_to_five_degrees);
    RUN_TEST(the_tilt_changes_between_two_fives);
    RUN_TEST(words_for_no_direction_do_no_harm);
    return UNITY_END() != 0;
}
