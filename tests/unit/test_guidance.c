/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/guidance.h"
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
static const double RIDGE = 1e-4;

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

/* By Gauss and Jordan; positive definite, so the diagonal will do for pivots. */
static inverse_matrix invert(double a[N][N])
{
    inverse_matrix out = {{{0}}, 0};

    for (int i = 0; i < N; i++) {
        out.k[i][i] = 1;
    }
    for (int p = 0; p < N; p++) {
        const double pivot = a[p][p];
        out.log_det += log(pivot);
        for (int c = 0; c < N; c++) {
            a[p][c] /= pivot;
            out.k[p][c] /= pivot;
        }
        for (int r = 0; r < N; r++) {
            const double factor = r == p ? 0 : a[r][p];
            for (int c = 0; c < N; c++) {
                a[r][c] -= factor * a[p][c];
                out.k[r][c] -= factor * out.k[p][c];
            }
        }
    }
    return out;
}

/* (H'H + ridge, + h h' of more)^-1 */
static inverse_matrix covariance(const invcal_normal *normal, double ridge, const double *more)
{
    double a[N][N];
    double h[N] = {0};
    double largest = 1;

    if (more) {
        row_of(more, h);
    }
    for (unsigned r = 0; r < N; r++) {
        largest = fmax(largest, element(normal, r, r));
    }
    for (unsigned r = 0; r < N; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[r][c] = element(normal, r, c) + h[r] * h[c];
            a[c][r] = a[r][c];
        }
        a[r][r] += ridge * largest;
    }
    return invert(a);
}

static double gain_of(const inverse_matrix *inverse, const double up[3])
{
    double h[N];
    double gain = 0;

    row_of(up, h);
    for (int r = 0; r < N; r++) {
        for (int c = 0; c < N; c++) {
            gain += h[r] * inverse->k[r][c] * h[c];
        }
    }
    return gain;
}

static double worst_root(const inverse_matrix *inverse)
{
    double worst = 0;

    for (int r = 0; r < N; r++) {
        worst = fmax(worst, sqrt(inverse->k[r][r]));
    }
    return worst;
}

/* log det H'H of n directions that make a spherical 4-design: means of x^2, x^4, x^2 y^2 are 1/3,
 * 1/5, 1/15; the quadratic block has the eigenvalues 1/3 and twice 2/15. */
static double bound(double n)
{
    return 4 * log(n / 3) + 2 * log(2 * n / 15) + 3 * log(n / 15);
}

/* The 26 directions: all of -1, 0, 1 but zero. */
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

static void add_reading(invcal_normal *normal, const double u[3], invcal_real reading[3])
{
    invcal_observation row;

    for (int i = 0; i < 3; i++) {
        reading[i] = (invcal_real)u[i];
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(reading, &row));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(normal, &row, 1));
}

static invcal_guidance ask(const invcal_normal *normal, const invcal_real *current)
{
    invcal_guidance next;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_guidance_next(normal, current, &next));
    return next;
}

static void up_of(const invcal_guidance *next, double up[3])
{
    for (int i = 0; i < 3; i++) {
        up[i] = (double)next->up[i];
    }
}

/* Sums of count random readings of a random triad. */
static int sign_of(invcal_real x)
{
    return (x > (invcal_real)0.01) - (x < (invcal_real)-0.01);
}

static invcal_normal random_sums(random_source *random, unsigned count)
{
    const triad_truth truth = triad_random(random, 0.05);
    invcal_normal normal;

    invcal_normal_init(&normal);
    for (unsigned i = 0; i < count; i++) {
        double v[3];
        double u[3];
        invcal_real reading[3];
        random_direction(random, v);
        triad_read(&truth, v, u);
        add_reading(&normal, u, reading);
    }
    return normal;
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

/* What a guided session has reached after 9, 12 and 18 positions. */
typedef struct {
    double worst9;
    double worst12;
    double worst18;
    double deficit18; /* of log det against its bound */
} progress;

static progress follow(random_source *random, double errors, double degrees)
{
    const triad_truth truth = triad_random(random, errors);
    invcal_normal normal; /* of the readings, which guide */
    invcal_normal true_normal;
    invcal_real reading[3];
    progress p = {0, 0, 0, 0};

    invcal_normal_init(&normal);
    invcal_normal_init(&true_normal);
    for (unsigned n = 1; n <= 18; n++) {
        const invcal_guidance next = ask(&normal, n > 1 ? reading : NULL);
        double up[3];
        double v[3];
        double u[3];
        up_of(&next, up);
        miss(random, up, degrees, v);
        add_reading(&true_normal, v, reading);
        triad_read(&truth, v, u);
        add_reading(&normal, u, reading);
        if (n == 9 || n == 12 || n == 18) {
            const inverse_matrix k = covariance(&true_normal, 0, NULL);
            *(n == 9 ? &p.worst9 : n == 12 ? &p.worst12 : &p.worst18) = worst_root(&k);
            p.deficit18 = bound(n) - k.log_det;
        }
    }
    return p;
}

static void nine_positions_as_asked_determine_everything_and_eighteen_are_near_the_best(void)
{
    random_source random = random_start(1);
    const progress p = follow(&random, 0, 0);

    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(3.01, p.worst9);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.42, p.worst12);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.91, p.worst18);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.3, p.deficit18);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0, p.deficit18);
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

    for (int i = 0; i < HANDS; i++) {
        const progress p = follow(&random, 0.05, 10);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(5, p.worst9);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(2.2, p.worst12);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.25, p.worst18);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.8, p.deficit18);
        deficit[i] = p.deficit18;
    }
    qsort(deficit, HANDS, sizeof *deficit, by_size);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.34, deficit[HANDS / 2]);
}

/* The same in float and double, and on every machine. */
static void the_first_positions_are_faces_then_corners(void)
{
    static const char *const expected[] = {
        "+z up",
        "+x up",
        "+y up",
        "-x up",
        "-y up",
        "-z up",
        "-z up, tilt 55 deg, +x and +y rise",
        "+z up, tilt 55 deg, +x and +y rise",
        "+z up, tilt 55 deg, +x and -y rise",
        "-z up, tilt 55 deg, +x and -y rise",
        "-z up, tilt 55 deg, -x and -y rise",
        "+z up, tilt 55 deg, -x and -y rise",
        "+z up, tilt 55 deg, -x and +y rise",
        "-z up, tilt 55 deg, -x and +y rise",
    };
    invcal_normal normal;
    invcal_real reading[3];
    char words[INVCAL_GUIDANCE_WORDS];

    invcal_normal_init(&normal);
    for (unsigned n = 0; n < sizeof expected / sizeof expected[0]; n++) {
        const invcal_guidance next = ask(&normal, n > 0 ? reading : NULL);
        double up[3];
        invcal_guidance_words(next.up, words);
        TEST_ASSERT_EQUAL_STRING(expected[n], words);
        up_of(&next, up);
        add_reading(&normal, up, reading);
    }
}

/* ---- the choice -------------------------------------------------------------------------------- */

/* Is next the nearest of those within 1 % of the largest gain? Within the rounding of float. */
static void assert_choice(const invcal_normal *normal, const double *current,
                          const invcal_guidance *next)
{
    const inverse_matrix k = covariance(normal, RIDGE, NULL);
    double up[3];
    double other[3];
    double most = 0;

    up_of(next, up);
    TEST_ASSERT_DOUBLE_WITHIN(4 * (double)INVCAL_EPSILON, 1, length3(up));
    for (int code = 0; code < 27; code++) {
        most = direction_of(code, other) ? fmax(most, gain_of(&k, other)) : most;
    }
    const double gain = gain_of(&k, up);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-3, 1e-9), 1, (double)next->gain / gain);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(most * FLOAT_OR_DOUBLE(0.988, 0.98999), gain);
    if (current) {
        const double near = cosine(up, current);
        for (int code = 0; code < 27; code++) {
            if (direction_of(code, other) && gain_of(&k, other) >= 0.993 * most) {
                const double nearer = cosine(other, current);
                TEST_ASSERT_TRUE(nearer > 0.8999 || near <= 0.9001);
                TEST_ASSERT_TRUE(nearer > 0.8999 || near > nearer - 2e-3);
            }
        }
    }
}

static void the_direction_asked_for_has_the_largest_gain_and_is_the_nearest_such(void)
{
    random_source random = random_start(3);

    for (int draw = 0; draw < SOME(2000); draw++) {
        const invcal_normal normal = random_sums(&random, (unsigned)draw % 25);
        double current[3];
        invcal_real reading[3];
        random_direction(&random, current);
        const double length = random_uniform(&random, 0.2, 5);
        for (int i = 0; i < 3; i++) {
            reading[i] = (invcal_real)(length * current[i]);
        }
        const invcal_guidance near = ask(&normal, reading);
        const invcal_guidance any = ask(&normal, NULL);
        assert_choice(&normal, current, &near);
        assert_choice(&normal, NULL, &any);
    }
}

static void only_faces_edges_and_corners_are_asked_for(void)
{
    random_source random = random_start(4);

    for (int draw = 0; draw < SOME(300); draw++) {
        const invcal_normal normal = random_sums(&random, (unsigned)draw % 25);
        const invcal_guidance next = ask(&normal, NULL);
        double sign[3];
        for (int i = 0; i < 3; i++) {
            sign[i] = sign_of(next.up[i]);
        }
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(2 * (double)INVCAL_EPSILON, sign[i] / length3(sign),
                                      (double)next.up[i]);
        }
    }
}

static void the_position_that_is_held_is_not_asked_for_again_while_another_is_as_good(void)
{
    invcal_normal empty;

    invcal_normal_init(&empty); /* all faces are equal */
    for (int axis = 0; axis < 3; axis++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            invcal_real held[3] = {(invcal_real)0.2, (invcal_real)0.1, (invcal_real)-0.1};
            held[axis] = (invcal_real)sign;
            const invcal_guidance next = ask(&empty, held);
            TEST_ASSERT_EQUAL_INT(0, sign_of(next.up[axis]));
        }
    }
}

static void where_nothing_else_is_as_good_the_same_position_is_asked_for_again(void)
{
    invcal_normal normal;
    invcal_real reading[3];
    double up[3];

    invcal_normal_init(&normal);
    for (int code = 0; code < 27; code++) { /* all but the corner + + + */
        if (code != 26 && direction_of(code, up)) {
            for (int times = 0; times < 4; times++) {
                add_reading(&normal, up, reading);
            }
        }
    }
    TEST_ASSERT_TRUE(direction_of(26, up));
    for (int i = 0; i < 3; i++) {
        reading[i] = (invcal_real)up[i];
    }
    const invcal_guidance next = ask(&normal, reading);
    TEST_ASSERT_TRUE(sign_of(next.up[0]) == 1 && sign_of(next.up[1]) == 1 &&
                     sign_of(next.up[2]) == 1);
}

static void a_current_reading_without_a_direction_counts_as_none(void)
{
    static const double bad[][3] = {{NOT_A_NUMBER, 0, 0},
                                    {0, NOT_A_NUMBER, 1},
                                    {0, 1, INFINITE},
                                    {-INFINITE, INFINITE, 0},
                                    {0, 0, 0},
                                    {(double)INVCAL_REAL_MAX / 1e8, 0, 0}};
    random_source random = random_start(5);

    for (unsigned count = 0; count < 24; count++) {
        const invcal_normal normal = random_sums(&random, count);
        const invcal_guidance expected = ask(&normal, NULL);
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            const invcal_real current[3] = {(invcal_real)bad[i][0], (invcal_real)bad[i][1],
                                            (invcal_real)bad[i][2]};
            const invcal_guidance next = ask(&normal, current);
            TEST_ASSERT_EQUAL_MEMORY(expected.up, next.up, sizeof next.up);
            TEST_ASSERT_TRUE(expected.gain == next.gain);
        }
    }
}

static void rows_of_known_direction_guide_as_exact_ones_do(void)
{
    random_source random = random_start(6);
    invcal_normal exact;
    invcal_normal linear;

    invcal_normal_init(&exact);
    invcal_normal_init(&linear);
    for (int i = 0; i < 20; i++) {
        double v[3];
        invcal_real eta[3];
        invcal_observation row;
        random_direction(&random, v);
        add_reading(&exact, v, eta);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_vertical(eta, eta, &row));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&linear, &row, 1));
        const invcal_guidance expected = ask(&exact, eta);
        const invcal_guidance next = ask(&linear, eta);
        TEST_ASSERT_EQUAL_MEMORY(expected.up, next.up, sizeof next.up);
        TEST_ASSERT_TRUE(expected.gain == next.gain);
    }
}

/* ---- what the position will do ------------------------------------------------------------------ */

static void sigma_before_and_after_is_that_without_and_with_the_position(void)
{
    static const double near = FLOAT_OR_DOUBLE(2e-3, 1e-9);
    random_source random = random_start(7);

    for (unsigned count = 0; count < 100; count++) {
        const invcal_normal normal = random_sums(&random, count % 25);
        const invcal_guidance next = ask(&normal, NULL);
        double up[3];
        up_of(&next, up);
        const inverse_matrix before = covariance(&normal, RIDGE, NULL);
        const inverse_matrix after = covariance(&normal, RIDGE, up);
        /* The largest sums may have grown, and the ridge with them. */
        const double with = count % 25 > 12 ? 2e-3 : 0.5;
        invcal_normal added = normal;
        invcal_real reading[3];
        add_reading(&added, up, reading);
        const invcal_guidance then = ask(&added, NULL);
        for (unsigned r = 0; r < N; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(near, 1, (double)next.before[r] / sqrt(before.k[r][r]));
            TEST_ASSERT_DOUBLE_WITHIN(near, 1, (double)next.after[r] / sqrt(after.k[r][r]));
            TEST_ASSERT_DOUBLE_WITHIN(with, 1, (double)next.after[r] / (double)then.before[r]);
        }
    }
}

static void with_eighteen_positions_sigma_is_that_of_the_sums_alone(void)
{
    invcal_normal normal;
    invcal_real reading[3];

    invcal_normal_init(&normal);
    for (int i = 0; i < 18; i++) {
        const invcal_guidance next = ask(&normal, NULL);
        double up[3];
        up_of(&next, up);
        add_reading(&normal, up, reading);
    }
    const invcal_guidance next = ask(&normal, NULL);
    const inverse_matrix k = covariance(&normal, 0, NULL);
    for (unsigned r = 0; r < N; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1, (double)next.before[r] / sqrt(k.k[r][r]));
    }
}

static void the_parameters_that_improve_are_named(void)
{
    random_source random = random_start(8);
    unsigned small = 0;

    for (unsigned draw = 0; draw < SOME(200); draw++) {
        const invcal_normal normal = random_sums(&random, (draw * TEST_SHORT + 59) % 60);
        const invcal_guidance next = ask(&normal, NULL);
        double falls[N];
        double most = 0;
        for (unsigned r = 0; r < N; r++) {
            falls[r] = 1 - (double)next.after[r] / (double)next.before[r];
            most = fmax(most, falls[r]);
        }
        small += most < 0.1;
        for (unsigned r = 0; r < N; r++) {
            if (fabs(falls[r] - fmin(most, 0.1)) > 1e-5) {
                TEST_ASSERT_EQUAL_INT(falls[r] > fmin(most, 0.1), next.improves >> r & 1);
            }
        }
        TEST_ASSERT_TRUE(next.improves > 0 && next.improves < 0x200);
    }
    /* Where none falls by a tenth, still one is named: of more than one in twenty. */
    TEST_ASSERT_TRUE(small > SOME(200) / 20);
}

static void from_positions_on_a_plane_it_leads_out_of_the_plane(void)
{
    invcal_normal normal;
    invcal_real reading[3];

    invcal_normal_init(&normal);
    for (int i = 0; i < 18; i++) {
        const double angle = 0.3490658503988659 * i;
        const double v[3] = {cos(angle), sin(angle), 0};
        add_reading(&normal, v, reading);
    }
    const invcal_guidance next = ask(&normal, reading);
    TEST_ASSERT_TRUE(sign_of(next.up[2]) != 0);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(100, (double)next.gain);
    TEST_ASSERT_TRUE(next.improves & (1 << INVCAL_DELTA_Z | 1 << INVCAL_DK_Z));
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(10, (double)next.before[INVCAL_DELTA_Z]); /* open */
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1, (double)next.before[INVCAL_DELTA_X]);
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
        char words[INVCAL_GUIDANCE_WORDS];
        const double sign[3] = {expected[i].sign[0], expected[i].sign[1], expected[i].sign[2]};
        invcal_real up[3];
        for (int k = 0; k < 3; k++) {
            up[k] = (invcal_real)(sign[k] / length3(sign));
        }
        memset(words, '#', sizeof words);
        invcal_guidance_words(up, words);
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
        {{0.1736, 0, 0.9848}, "+z up, tilt 10 deg, +x rises"},
        {{0.2147, 0, 0.9767}, "+z up, tilt 10 deg, +x rises"}, /* 12.4 */
        {{0.2181, 0, 0.9759}, "+z up, tilt 15 deg, +x rises"}, /* 12.6 */
        {{0.2, -0.9165, 0.3464}, "-y up, tilt 25 deg, +z and +x rise"},
    };

    for (unsigned i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        char words[INVCAL_GUIDANCE_WORDS];
        invcal_real up[3];
        for (int k = 0; k < 3; k++) {
            up[k] = (invcal_real)expected[i].up[k];
        }
        invcal_guidance_words(up, words);
        TEST_ASSERT_EQUAL_STRING(expected[i].words, words);
    }
}

static void a_direction_of_ones_own_is_judged_like_one_that_is_asked_for(void)
{
    random_source random = random_start(11);

    for (int draw = 0; draw < SOME(100); draw++) {
        const invcal_normal normal = random_sums(&random, (unsigned)draw % 25);
        const invcal_guidance asked = ask(&normal, NULL);
        invcal_guidance own;
        memset(&own, 7, sizeof own);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_guidance_of(&normal, asked.up, &own));
        TEST_ASSERT_EQUAL_MEMORY(asked.up, own.up, sizeof own.up);
        TEST_ASSERT_TRUE(asked.gain == own.gain && asked.improves == own.improves);
        TEST_ASSERT_EQUAL_MEMORY(asked.after, own.after, sizeof own.after);
    }
}

static void what_is_no_direction_of_ones_own_is_refused(void)
{
    static const double bad[][3] = {{0, 0, 0}, {0, 0, 1.001}, {NOT_A_NUMBER, 0, 1}};
    static const invcal_status status[] = {INVCAL_OUT_OF_RANGE, INVCAL_NOT_UNIT, INVCAL_NOT_FINITE};
    random_source random = random_start(12);
    const invcal_normal normal = random_sums(&random, 12);

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real up[3] = {(invcal_real)bad[i][0], (invcal_real)bad[i][1],
                                   (invcal_real)bad[i][2]};
        invcal_guidance next;
        invcal_guidance before;
        memset(&next, 7, sizeof next);
        before = next;
        TEST_ASSERT_EQUAL_INT(status[i], invcal_guidance_of(&normal, up, &next));
        TEST_ASSERT_EQUAL_MEMORY(&before, &next, sizeof next);
    }
}

/* ---- refusals ----------------------------------------------------------------------------------- */

static void assert_refused(const invcal_normal *normal)
{
    invcal_guidance next;
    invcal_guidance before;

    memset(&next, 0x5A, sizeof next);
    before = next;
    const invcal_real up[3] = {0, 0, 1};
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_guidance_next(normal, NULL, &next));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_guidance_of(normal, up, &next));
    TEST_ASSERT_EQUAL_MEMORY(&before, &next, sizeof next);
}

static void sums_that_are_not_finite_are_refused_and_nothing_is_written(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE};
    random_source random = random_start(9);

    for (unsigned count = 0; count < 30; count += 29) {
        for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
            for (int k = 0; k < 3; k++) {
                invcal_normal normal = random_sums(&random, count);
                normal.moment[i] = (invcal_real)bad[k];
                assert_refused(&normal);
            }
        }
    }
}

static void what_is_no_sum_of_squares_is_refused(void)
{
    random_source random = random_start(10);

    static const unsigned squares[] = {0, 3, 5, 16, 19, 21, 26, 28, 30}; /* of the moments */

    for (unsigned i = 0; i < sizeof squares / sizeof squares[0]; i++) {
        invcal_normal normal = random_sums(&random, 18);
        normal.moment[squares[i]] = -1;
        assert_refused(&normal);
    }
}

static void the_sums_are_not_changed(void)
{
    random_source random = random_start(11);
    const invcal_normal normal = random_sums(&random, 12);
    const invcal_normal before = normal;

    (void)ask(&normal, NULL);
    TEST_ASSERT_EQUAL_MEMORY(&before, &normal, sizeof normal);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(nine_positions_as_asked_determine_everything_and_eighteen_are_near_the_best);
    RUN_LONG_TEST(hands_that_miss_by_10_degrees_get_nearly_as_far);
    RUN_TEST(the_first_positions_are_faces_then_corners);
    RUN_TEST(the_direction_asked_for_has_the_largest_gain_and_is_the_nearest_such);
    RUN_TEST(only_faces_edges_and_corners_are_asked_for);
    RUN_TEST(the_position_that_is_held_is_not_asked_for_again_while_another_is_as_good);
    RUN_TEST(where_nothing_else_is_as_good_the_same_position_is_asked_for_again);
    RUN_SLOW_TEST(a_current_reading_without_a_direction_counts_as_none);
    RUN_TEST(rows_of_known_direction_guide_as_exact_ones_do);
    RUN_SLOW_TEST(sigma_before_and_after_is_that_without_and_with_the_position);
    RUN_TEST(with_eighteen_positions_sigma_is_that_of_the_sums_alone);
    RUN_TEST(the_parameters_that_improve_are_named);
    RUN_TEST(from_positions_on_a_plane_it_leads_out_of_the_plane);
    RUN_TEST(all_26_directions_have_their_words);
    RUN_TEST(other_directions_have_words_to_five_degrees);
    RUN_TEST(a_direction_of_ones_own_is_judged_like_one_that_is_asked_for);
    RUN_TEST(what_is_no_direction_of_ones_own_is_refused);
    RUN_TEST(sums_that_are_not_finite_are_refused_and_nothing_is_written);
    RUN_TEST(what_is_no_sum_of_squares_is_refused);
    RUN_TEST(the_sums_are_not_changed);
    return UNITY_END() != 0;
}
