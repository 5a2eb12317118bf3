/* SPDX-License-Identifier: MIT
 *
 * Which turns to make. Expected figures are closed form, or those of turns_design.h.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "imu/turns.h"
#include "turns_design.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double PI = 3.14159265358979324;
static const invcal_real z_up[3] = {0, 0, 1};
static const world_settings perfect = {0, 0, 0, 0, 0};
static const world_settings perfect_held = {1, 0, 0, 0, 0};
static invcali_turns t;

static invcal_status turns_begin(const invcal_real up[3], const world_settings *settings)
{
    invcal_real prior[18];
    invcal_imu_settings stated_ones;

    if (!settings) {
        return invcali_turns_begin(&t, up, NULL, 0);
    }
    stated_ones = world_stated(settings, prior);
    return invcali_turns_begin(&t, up, &stated_ones, settings->noise);
}

/* In the order of the solution. */
static invcal_status turns_sigma(const invcal_turn *turn, invcal_real sigma[18], uint32_t *open)
{
    invcal_real of[18];
    uint32_t weak;

    const invcal_status status = invcali_turns_sigma(&t, turn, of, &weak);
    if (status == INVCAL_OK || status == INVCAL_UNDETERMINED) {
        *open = 0;
        for (unsigned i = 0; i < 18; i++) {
            sigma[i] = of[invcali_imu_parameter(i)];
            *open |= (weak >> invcali_imu_parameter(i) & 1u) << i;
        }
    }
    return status;
}

static void begin(const world_settings *settings)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(z_up, settings));
}

static void tour(const world_settings *settings, unsigned turns)
{
    begin(settings);
    for (unsigned i = 0; i < turns; i++) {
        invcal_turn turn;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_tour(i, &turn));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)turn.up[a], (double)t.up[a]);
        }
    }
}

static void about(unsigned axis, double degrees, unsigned turns)
{
    for (unsigned i = 0; i < turns; i++) {
        invcal_turn turn = {{0, 0, 0}, (invcal_real)(degrees * DEGREE), {0, 0, 0}};
        turn.axis[axis] = 1;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
    }
}

static double at(unsigned r, unsigned c)
{
    return (double)t.sum[r < c ? INVCAL_PACKED(c, r) : INVCAL_PACKED(r, c)];
}

/* Gaussian elimination with the largest pivot, in double. Returns the rank; the determinant if the
 * rank is full. */
static unsigned rank_of(double *log_det)
{
    double a[18][18];
    double first = 0;
    unsigned rank = 0;
    int is_taken[18] = {0};

    for (unsigned r = 0; r < t.n; r++) {
        for (unsigned c = 0; c < t.n; c++) {
            a[r][c] = at(r, c);
        }
    }
    *log_det = 0;
    for (; rank < t.n; rank++) {
        unsigned p = 18;
        for (unsigned r = 0; r < t.n; r++) {
            p = !is_taken[r] && (p == 18 || a[r][r] > a[p][p]) ? r : p;
        }
        first = rank > 0 ? first : a[p][p];
        if (!(a[p][p] > 1e-5 * first)) {
            break;
        }
        is_taken[p] = 1;
        *log_det += log(a[p][p]);
        for (unsigned r = 0; r < t.n; r++) {
            const double factor = is_taken[r] ? 0 : a[r][p] / a[p][p];
            for (unsigned c = 0; c < t.n; c++) {
                a[r][c] -= factor * a[p][c];
            }
        }
    }
    return rank;
}

static unsigned rank(void)
{
    double log_det;

    return rank_of(&log_det);
}

/* Up is a unit vector to 1e-4; after a turn it is one to rounding. */
static void up_does_not_drift(void)
{
    static const invcal_real longer[3] = {0, 0, INVCAL_REAL(1.00009)};
    const invcal_real *up = t.up;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(longer, &perfect));
    about(0, 90, 1);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, (double)(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]));
}

/* ---- the gyroscope beside a calibrated accelerometer --------------------------------------------- */

static void the_tour_determines_scale_and_misalignment_as_closed_form_says(void)
{
    invcal_real sigma[18];
    uint32_t open = 1;

    tour(&perfect_held, INVCAL_TOUR);
    for (unsigned r = 0; r < 9; r++) {
        for (unsigned c = 0; c < 9; c++) {
            /* a diagonal: these are the eigenvalues, their ratio is pi^2 / 4 */
            const double expected = r != c ? 0 : r % 4 == 0 ? PI * PI / 2 : 2;
            TEST_ASSERT_DOUBLE_WITHIN(1e-5, expected, at(r, c));
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_UINT(0, open);
    for (unsigned r = 0; r < 9; r++) { /* over the noise of a turn, which is sqrt(2) of a mean's */
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, r % 4 == 0 ? 1 / PI : 0.5, (double)sigma[r] / sqrt(2));
        TEST_ASSERT_TRUE(sigma[9 + r] <= 0 && sigma[9 + r] >= 0);
    }
}

static void ranks_are_those_of_the_number_of_axes(void)
{
    invcal_real sigma[18];
    uint32_t open;
    random_source random = random_start(5);

    begin(&perfect_held);
    about(0, 90, 8);
    TEST_ASSERT_EQUAL_UINT(3, rank());
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(0x1B6, open); /* all but xx, yx, zx */
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_TRUE(sigma[r] <= 10);
    }
    about(1, 90, 4);
    TEST_ASSERT_EQUAL_UINT(6, rank());
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(1u << 2 | 1u << 5 | 1u << 8, open);
    static const unsigned expected[] = {0, 2, 4, 6, 8, 9, 9};
    for (unsigned turns = 3; turns <= 6; turns++) {
        for (unsigned k = 0; k < 20; k++) {
            begin(&perfect_held);
            for (unsigned i = 0; i < turns; i++) {
                invcal_turn turn;
                double n[3];
                random_direction(&random, n);
                for (unsigned a = 0; a < 3; a++) {
                    turn.axis[a] = (invcal_real)n[a];
                }
                turn.angle = (invcal_real)(random_uniform(&random, 100, 150) * DEGREE);
                TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
            }
            TEST_ASSERT_LESS_OR_EQUAL_UINT(expected[turns], rank());
            if (FLOAT_OR_DOUBLE(0, 1) > 0) {
                TEST_ASSERT_EQUAL_UINT(expected[turns], rank());
            }
        }
    }
}

/* ---- both sensors -------------------------------------------------------------------------------- */

static void expect_sigma(const double expected[18])
{
    invcal_real sigma[18];
    uint32_t open;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_UINT(0, open);
    for (unsigned r = 0; r < 18; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(2e-5, expected[r], (double)sigma[r]);
    }
}

static void the_tour_determines_all_18(void)
{
    tour(&perfect, INVCAL_TOUR);
    TEST_ASSERT_EQUAL_UINT(18, rank());
    expect_sigma(tour12_sigma);
    tour(&perfect, 9);
    TEST_ASSERT_EQUAL_UINT(18, rank());
    expect_sigma(tour9_sigma);
    tour(&perfect, INVCAL_TOUR_FULL);
    expect_sigma(tour16_sigma);
}

/* From the rests alone three gammas stay open: the turns determine what lengths do not. */
static void the_lengths_of_six_faces_alone_have_rank_6(void)
{
    static const world_settings deaf = {0, 0, INVCAL_REAL(0.9), 0, 0};

    tour(&deaf, INVCAL_TOUR); /* a turn has 3000 times less information than a rest */
    TEST_ASSERT_EQUAL_UINT(6, rank());
}

static void one_axis_leaves_open_what_the_script_names(void)
{
    invcal_real sigma[18];
    uint32_t open;

    begin(&perfect);
    about(0, 90, 8);
    TEST_ASSERT_EQUAL_UINT(one_axis_rank, rank());
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(one_axis_open, open);
    begin(&perfect);
    about(0, 90, 4);
    about(1, 90, 4);
    TEST_ASSERT_EQUAL_UINT(two_axes_rank, rank());
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(two_axes_open, open);
}

/* ---- guidance ------------------------------------------------------------------------------------ */

static void add_word(const invcal_real up[3], char *path)
{
    char *end = path + strlen(path);

    for (unsigned a = 0; a < 3; a++) {
        if (up[a] * up[a] > INVCAL_REAL(0.1)) {
            *end++ = up[a] > 0 ? '+' : '-';
            *end++ = (char)('x' + a);
        }
    }
    *end = '\0';
}

/* Follows the guidance, which must give the expected turns. Returns det^(1/n). */
static double follow(const world_settings *settings, unsigned turns, const char *expected)
{
    char path[200] = "+z";
    double log_det;

    begin(settings);
    for (unsigned i = 0; i < turns; i++) {
        invcal_turn turn;
        invcali_turns_next(&t, &turn);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
        strcat(path, " ");
        add_word(turn.up, path);
    }
    TEST_ASSERT_EQUAL_STRING_LEN(expected, path, strlen(path));
    TEST_ASSERT_EQUAL_UINT(t.n, rank_of(&log_det));
    return exp(log_det / t.n);
}

static void guidance_goes_where_it_learns_most(void)
{
    const double within = FLOAT_OR_DOUBLE(1e-4, 1e-5);

    TEST_ASSERT_DOUBLE_WITHIN(within, greedy12_of_9_root, follow(&perfect_held, 12, greedy_of_9));
    TEST_ASSERT_DOUBLE_WITHIN(within, greedy24_of_9_root, follow(&perfect_held, 24, greedy_of_9));
    TEST_ASSERT_DOUBLE_WITHIN(within, greedy12_of_18_root, follow(&perfect, 12, greedy_of_18));
    TEST_ASSERT_DOUBLE_WITHIN(within, greedy24_of_18_root, follow(&perfect, 24, greedy_of_18));
}

/* Per turn and over the noise of a turn, of which the variance is 2: the figures of mathematics_imu.md. The tour has
 * (pi^2)^(3/9) 4^(6/9) of twelve turns. */
static void twelve_turns_of_it_add_more_than_the_tour(void)
{
    double log_det;

    tour(&perfect_held, INVCAL_TOUR);
    TEST_ASSERT_EQUAL_UINT(9, rank_of(&log_det));
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, cbrt(PI * PI * 16) / 12, 2 * exp(log_det / 9) / 12);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.906, 2 * follow(&perfect_held, 12, greedy_of_9) / 12);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.955, 2 * follow(&perfect_held, 24, greedy_of_9) / 24);
}

static void of_any_rest_there_is_a_next_turn(void)
{
    random_source random = random_start(3);

    for (unsigned k = 0; k < 100; k++) {
        invcal_real from[3];
        double d[3];
        invcal_turn turn;
        random_direction(&random, d);
        for (unsigned a = 0; a < 3; a++) {
            from[a] = (invcal_real)d[a];
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(from, NULL));
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 3e-4, (double)t.noise);
        t.seconds = (invcal_real)(k % 2); /* or so fast that gyroscope noise does not count */
        for (unsigned i = 0; i < 6; i++) {
            invcali_turns_next(&t, &turn);
            const double angle = (double)turn.angle / DEGREE;
            TEST_ASSERT_TRUE(angle > 17.45 && angle < 162.55); /* a sine of 0.3 */
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
        }
        TEST_ASSERT_EQUAL_UINT(18, rank());
    }
}

/* Nearly half a turn adds most, but not for directions whose sine, squared, is below 0.09 (17.46
 * degrees). So it goes to any of 26, from this side of that and not from the other. */
static void guidance_goes_as_far_as_it_may(void)
{
    static const double aside[3] = {-0.01, -0.85, -0.52};

    for (int n = 0; n < 27; n++) {
        const double to[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        double axis[3];
        if (n == 13) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            axis[i] = to[p] * aside[q] - to[q] * aside[p];
        }
        const double across = length3(axis);
        for (int k = 0; k < 2; k++) {
            double turn_by[3], c[3][3], up[3];
            invcal_real from[3];
            invcal_turn turn;
            for (int i = 0; i < 3; i++) {
                turn_by[i] = axis[i] / across * (k == 0 ? 162.7 : 162.4) * DEGREE;
            }
            rotation_by(turn_by, c);
            world_up((const double(*)[3])c, to, up);
            for (int i = 0; i < 3; i++) {
                from[i] = (invcal_real)(up[i] / length3(to));
            }
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(from, &perfect_held));
            invcali_turns_next(&t, &turn);
            double cosine = 0;
            for (int i = 0; i < 3; i++) {
                cosine += (double)turn.up[i] * to[i] / length3(to);
            }
            TEST_ASSERT_EQUAL_INT(k, cosine > 0.999);
        }
    }
}

/* An overwritten plan. */
static void nonsense_has_no_next_turn(void)
{
    invcal_turn turn;

    begin(&perfect);
    t.up[1] = (invcal_real)NAN;
    memset(&turn, 0x5A, sizeof turn);
    invcali_turns_next(&t, &turn);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turns_add(&t, &turn));
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_DOUBLE_WITHIN(0, 0, (double)turn.axis[a]);
        TEST_ASSERT_DOUBLE_WITHIN(0, 0, (double)turn.up[a]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, (double)turn.angle / DEGREE);
}

/* ---- turns --------------------------------------------------------------------------------------- */

static unsigned face_of(const invcal_real up[3])
{
    for (unsigned a = 0; a < 3; a++) {
        if (!(up[a] * up[a] < INVCAL_REAL(0.5))) {
            return 2 * a + (up[a] < 0);
        }
    }
    return 6;
}

/* Up after a turn, by the mathematics of the tests. */
static void turned(const invcal_real from[3], const invcal_turn *turn, double up[3])
{
    double th[3], c[3][3], was[3];

    for (unsigned a = 0; a < 3; a++) {
        th[a] = (double)turn->axis[a] * (double)turn->angle;
        was[a] = (double)from[a];
    }
    rotation_by(th, c);
    world_up((const double(*)[3])c, was, up);
}

static void the_tour_takes_each_edge_once_about_horizontal_axes(void)
{
    int edges[6][6] = {{0}};
    int full[3] = {0, 0, 0};
    invcal_real from[3] = {0, 0, 1};
    invcal_turn turn;

    for (unsigned i = 0; i < INVCAL_TOUR_FULL; i++) {
        double up[3];
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_tour(i, &turn));
        turned(from, &turn, up);
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-12), up[a], (double)turn.up[a]);
            TEST_ASSERT_DOUBLE_WITHIN(0, 0, (double)(turn.axis[a] * from[a])); /* both are axes */
            full[a] += turn.angle > 6 && turn.axis[a] > 0;
        }
        const unsigned a = face_of(from);
        const unsigned b = face_of(turn.up);
        if (i < INVCAL_TOUR) {
            edges[a < b ? a : b][a < b ? b : a]++;
        }
        memcpy(from, turn.up, sizeof from);
    }
    for (unsigned a = 0; a < 6; a++) {
        for (unsigned b = a + 1; b < 6; b++) {
            TEST_ASSERT_EQUAL_INT(a / 2 != b / 2, edges[a][b]);
        }
    }
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT(1, full[a]);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, invcali_tour(INVCAL_TOUR_FULL, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, invcali_tour(UINT_MAX, &turn));
}

static void the_shortest_turn_is_that_of_closed_form(void)
{
    random_source random = random_start(1);

    for (unsigned k = 0; k < 2000; k++) {
        invcal_real v[2][3];
        double d[2][3], up[3];
        invcal_turn turn;
        for (unsigned i = 0; i < 2; i++) {
            random_direction(&random, d[i]);
            for (unsigned a = 0; a < 3; a++) {
                v[i][a] = (invcal_real)d[i][a];
            }
        }
        const double cosine = d[0][0] * d[1][0] + d[0][1] * d[1][1] + d[0][2] * d[1][2];
        if (fabs(cosine) > 0.9999) {
            continue;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turn_to(v[0], v[1], &turn));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-3, 1e-9), acos(cosine) / DEGREE,
                                  (double)turn.angle / DEGREE);
        turned(v[0], &turn, up);
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-12), d[1][a], up[a]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, d[1][a], (double)turn.up[a]);
        }
    }
}

/* With a sine of 0.001 or less there is no shortest turn. */
static void opposite_directions_have_no_shortest_turn(void)
{
    static const double square[4] = {0.97e-6, 1.03e-6, 0.97e-6, 1.03e-6};

    for (unsigned k = 0; k < 4; k++) {
        const double along = k < 2 ? sqrt(1 - square[k]) : -sqrt(1 - square[k]);
        const invcal_real up[3] = {0, (invcal_real)sqrt(square[k]), (invcal_real)along};
        invcal_turn turn;
        TEST_ASSERT_EQUAL_INT(k % 2 == 0 ? INVCAL_BAD_DIRECTION : INVCAL_OK,
                              invcali_turn_to(z_up, up, &turn));
    }
}

static void bad_arguments_are_refused(void)
{
    static const invcal_real down[3] = {0, 0, -1};
    static const invcal_real x_up[3] = {1, 0, 0};
    static const invcal_real longer[3] = {0, 0, INVCAL_REAL(1.01)};
    const invcal_real none[3] = {INVCAL_REAL_MAX, INVCAL_REAL_MAX, INVCAL_REAL_MAX};
    invcal_real prior[18] = {0};
    world_settings settings = perfect;
    invcal_turn turn;
    invcal_turn kept;

    memset(&kept, 0x55, sizeof kept);
    memcpy(&turn, &kept, sizeof turn);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turn_to(z_up, down, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turn_to(z_up, z_up, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turn_to(longer, x_up, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turn_to(x_up, longer, &turn));
    TEST_ASSERT_EQUAL_MEMORY(&kept, &turn, sizeof turn);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, turns_begin(none, NULL));
    settings.noise = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, turns_begin(z_up, &settings));
    settings.noise = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, turns_begin(z_up, &settings));
    settings.noise = 0;
    settings.rate_noise = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, turns_begin(z_up, &settings));
    settings.rate_noise = 0;
    settings.instability = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, turns_begin(z_up, &settings));
    settings.instability = 0;
    settings.prior = prior;
    prior[17] = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_PRIOR, turns_begin(z_up, &settings));
    prior[17] = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(z_up, &settings));

    const invcali_turns before = t;
    invcal_real sigma[18] = {7};
    uint32_t open = 7;
    turn = (invcal_turn){{0, 0, INVCAL_REAL(1.01)}, 1, {0, 0, 0}};
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, invcali_turns_add(&t, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, turns_sigma(&turn, sigma, &open));
    turn.axis[2] = 1;
    turn.angle = (invcal_real)(720.3 * DEGREE);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, invcali_turns_add(&t, &turn));
    turn.angle = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, invcali_turns_add(&t, &turn));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_ANGLE, turns_sigma(&turn, sigma, &open));
    TEST_ASSERT_EQUAL_MEMORY(&before, &t, sizeof t);
    TEST_ASSERT_TRUE(open == 7 && sigma[0] > 6);
    turn.angle = (invcal_real)(-720 * DEGREE);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
    turn.angle = (invcal_real)(720 * DEGREE);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_DOUBLE_WITHIN(0, a == 2, (double)t.up[a]);
    }
}

/* About x by an angle, z up: the turn shows the x of E x by the angle, and y by sin y - (1 - cos)
 * z; the rest is about up. The variance is 2. */
static void turns_of_any_angle_agree_with_closed_form(void)
{
    static const double degrees[] = {-720, -700, -541, -539, -450, -361, -200, -179, -100, -30,
                                     30,   100,  179,  200,  361,  450,  539,  541,  700,  720};

    for (unsigned k = 0; k < sizeof degrees / sizeof degrees[0]; k++) {
        const double angle = degrees[k] * DEGREE;
        begin(&perfect_held);
        about(0, degrees[k], 1);
        const double up[3] = {0, sin(angle), cos(angle)};
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-6, 1e-12), up[a], (double)t.up[a]);
        }
        const double row[3] = {angle, sin(angle), cos(angle) - 1};
        for (unsigned r = 0; r < 3; r++) {
            for (unsigned c = 0; c <= r; c++) {
                const double expected = c == 0 && r > 0 ? 0 : row[r] * row[c] / 2;
                TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-12), expected, at(3 * r, 3 * c));
            }
        }
    }
}

/* Next to z, up or down: a turn about x shows the angle, except for the part of x along up. */
static void next_to_the_vertical_nothing_is_lost(void)
{
    for (unsigned k = 0; k < 2; k++) {
        const double length = sqrt(1 + 5e-6);
        const invcal_real up[3] = {(invcal_real)(1e-3 / length), (invcal_real)(2e-3 / length),
                                   (invcal_real)((k == 0 ? 1 : -1) / length)};
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_begin(up, &perfect_held));
        about(0, 90, 1);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-12),
                                  PI * PI / 8 * (1 - 1e-6 / (length * length)), at(0, 0));
    }
}

/* ---- noise, priors, prospects --------------------------------------------------------------------- */

/* An angle of a turn of T has the variance 2 a^2 + N^2 T + (N^2 / 2 + (1.5 B)^2) T^2. */
static void the_noise_of_a_turn_is_that_of_the_design(void)
{
    static const world_settings noisy = {1, INVCAL_REAL(2e-4), INVCAL_REAL(1e-4), INVCAL_REAL(2e-4),
                                         0};
    invcal_real sigma[18];
    uint32_t open;

    for (unsigned k = 0; k < 2; k++) {
        const double time = k == 0 ? 1.5 : 0.5;
        begin(&noisy);
        t.seconds = k == 0 ? t.seconds : INVCAL_REAL(0.5);
        for (unsigned i = 0; i < INVCAL_TOUR; i++) {
            invcal_turn turn;
            (void)invcali_tour(i, &turn);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_add(&t, &turn));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_sigma(NULL, sigma, &open));
        const double variance = 2 * 4e-8 + 1e-8 * time + (1e-8 / 2 + 2.25 * 4e-8) * time * time;
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 2e-4, (double)t.noise);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, sqrt(variance / 4e-8) / PI, (double)sigma[0]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, sqrt(variance / 4e-8) / 2, (double)sigma[1]);
    }
    begin(&noisy); /* a full turn takes four times as long: information (2 pi)^2 / variance */
    about(0, 360, 1);
    const double variance = 2 * 4e-8 + 1e-8 * 6 + (1e-8 / 2 + 2.25 * 4e-8) * 36;
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 4 * PI * PI * 4e-8 / variance, at(0, 0));
    for (unsigned eighths = 1; eighths <= 3; eighths++) { /* up to a quarter all take the same */
        const double angle = 45 * DEGREE * eighths;
        const double time = eighths == 3 ? 1.5 * 1.5 : 1.5;
        begin(&noisy);
        about(0, 45.0 * eighths, 1);
        TEST_ASSERT_DOUBLE_WITHIN(
            1e-5,
            angle * angle * 4e-8 /
                (2 * 4e-8 + 1e-8 * time + (1e-8 / 2 + 2.25 * 4e-8) * time * time),
            at(0, 0));
    }
}

static void a_prior_is_information(void)
{
    invcal_real prior[18] = {0};
    world_settings settings = perfect;

    prior[4] = INVCAL_REAL(0.003);
    prior[17] = INVCAL_REAL(0.0003);
    settings.prior = prior;
    begin(&settings);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.01, at(4, 4)); /* with a noise of 0.0003 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1, at(17, 17));
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, at(3, 3)); /* none gives none */
    settings.held = 1;
    prior[9] = INVCAL_REAL(0.0003);
    begin(&settings);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.01, at(4, 4));
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, (double)t.sum[INVCAL_PACKED(9, 9)]); /* what is held has none */
}

/* Without turns sigma is that of a prior; a turn has sqrt(2) of the noise of a mean. Weak is what exceeds 2.5 of
 * a turn, undetermined are all if one exceeds 1000. Then each is known to 10 times the noise of a mean besides,
 * information 0.01, and open is what has less than 10 times that in all. */
static void sigma_is_judged_at_its_bounds(void)
{
    static const struct {
        double sigma; /* over the noise of a mean */
        invcal_status status;
        uint32_t open;
    } cases[] = {{3.53, INVCAL_OK, 0},
                 {3.54, INVCAL_OK, 0x1FF},
                 {1413, INVCAL_OK, 0x1FF},
                 {1416, INVCAL_UNDETERMINED, 0x1FF}};
    invcal_real prior[18] = {0};
    invcal_real sigma[19];
    uint32_t open;
    world_settings settings = perfect_held;

    settings.prior = prior;
    for (unsigned k = 0; k < 4; k++) {
        for (unsigned r = 0; r < 19; r++) {
            prior[r % 18] = (invcal_real)(cases[k].sigma * 3e-4);
            sigma[r] = 7;
        }
        begin(&settings);
        TEST_ASSERT_EQUAL_INT(cases[k].status, turns_sigma(NULL, sigma, &open));
        TEST_ASSERT_EQUAL_HEX32(cases[k].open, open);
        for (unsigned r = 0; r < 19; r++) {
            const double expected = r == 18 ? 7 : r >= 9 ? 0 : k == 3 ? 10 : cases[k].sigma;
            TEST_ASSERT_DOUBLE_WITHIN(1e-3 * expected, expected, (double)sigma[r]);
        }
    }
    for (unsigned r = 0; r < 18; r++) {
        prior[r] = 0;
    }
    prior[1] = (invcal_real)(3e-4 / sqrt(0.0895));
    prior[2] = (invcal_real)(3e-4 / sqrt(0.0905));
    begin(&settings);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(0x1FFu ^ 1u << 2, open);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 10, (double)sigma[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 1 / sqrt(0.0995), (double)sigma[1]);
    settings.held = 0;
    sigma[18] = 7;
    begin(&settings);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_TRUE(sigma[18] == 7);
}

/* All are known, but only to 3000 times the noise: that is open. */
static void what_only_a_wide_prior_determines_is_open(void)
{
    invcal_real prior[18];
    invcal_real sigma[18];
    uint32_t open;
    world_settings settings = perfect_held;

    for (unsigned r = 0; r < 18; r++) {
        prior[r] = 1;
    }
    settings.prior = prior;
    begin(&settings);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, turns_sigma(NULL, sigma, &open));
    TEST_ASSERT_EQUAL_HEX32(0x1FF, open);
}

static void a_prospect_is_what_the_turn_then_achieves(void)
{
    invcal_real sigma[2][18];
    uint32_t open[2];
    invcal_turn turn;

    begin(&perfect);
    for (unsigned i = 0; i < INVCAL_TOUR_FULL; i++) {
        (void)invcali_tour(i, &turn);
        const invcal_status status = turns_sigma(&turn, sigma[0], &open[0]);
        (void)invcali_turns_add(&t, &turn);
        TEST_ASSERT_EQUAL_INT(status, turns_sigma(NULL, sigma[1], &open[1]));
        TEST_ASSERT_EQUAL_INT(i < 7 ? INVCAL_UNDETERMINED : INVCAL_OK, status);
        TEST_ASSERT_EQUAL_HEX32(open[0], open[1]);
        for (unsigned r = 0; r < 18; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-3, (double)sigma[0][r], (double)sigma[1][r]);
        }
    }
}

/* Weak: a sigma above 2.5 times the noise of a turn. */
static void what_is_known_too_little_is_named(void)
{
    invcal_real sigma[18];
    uint32_t open;

    begin(&perfect_held);
    about(0, 90, 4);
    about(1, 90, 4);
    about(0, 90, 1);
    about(2, 10, 1);
    about(2, 40, 1);
    const invcal_status status = turns_sigma(NULL, sigma, &open);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, status);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_EQUAL_INT((double)sigma[r] > 2.5 * sqrt(2), open >> r & 1u);
    }
    TEST_ASSERT_TRUE(open != 0 && open != 0x1FF);
}

/* ---- beside the solver --------------------------------------------------------------------------- */

static world w;
static const world_settings stated = {0, INVCAL_REAL(3e-4), INVCAL_REAL(1e-4), INVCAL_REAL(1e-4),
                                      0};

static invcal_status turns_after(const invcal_real raw[][3], unsigned count,
                                 const world_settings *settings)
{
    const invcal_calibration unit = unit_nominal();
    const invcal_positions positions = {(const invcal_vector *)(const void *)raw, count, &unit,
                                        settings->noise, NULL};
    const invcal_imu_settings stated_ones = world_stated(settings, NULL);

    return invcali_turns_after(&t, &w.imu, &positions, &stated_ones);
}

/* The tour by steady turns, without errors. Returns how long a turn is by its segments. */
static double make_tour(invcal_real raw[WORLD_RESTS][3])
{
    double time = 0;

    world_begin(&w, 400, 1);
    world_without_noise(&w);
    w.wobble = 0;
    world_rest(&w, 1.5);
    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        invcal_turn turn;
        double vector[3];
        (void)invcali_tour(i, &turn);
        for (unsigned a = 0; a < 3; a++) {
            vector[a] = (double)turn.axis[a] * PI / 2;
        }
        world_move(&w, vector, 1.2);
    }
    world_end(&w);
    TEST_ASSERT_EQUAL_INT(13, w.imu.rests);
    world_means(&w, raw);
    for (unsigned i = 0; i < w.imu.own.used; i++) {
        time += w.imu.own.segment[i].time / 2 / 400.0;
    }
    return time / (double)INVCAL_TOUR;
}

/* The plan and its result are the same. */
static void after_the_turns_it_knows_what_it_had_planned(void)
{
    world_settings held = stated;
    invcal_real raw[WORLD_RESTS][3];
    invcal_real expected[171];
    invcal_real sigma[2][18];
    uint32_t open;
    world_solution imu;

    begin(&stated);
    t.seconds = (invcal_real)make_tour(raw);
    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        invcal_turn turn;
        (void)invcali_tour(i, &turn);
        (void)invcali_turns_add(&t, &turn);
    }
    memcpy(expected, t.sum, sizeof expected);
    (void)turns_sigma(NULL, sigma[0], &open);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_after((const invcal_real(*)[3])raw, 13, &stated));
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 1, (double)t.up[2]);
    for (unsigned i = 0; i < 171; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.02 * (1 + fabs((double)expected[i])), (double)expected[i],
                                  (double)t.sum[i]);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_sigma(NULL, sigma[1], &open));
    for (unsigned r = 0; r < 18; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.02, (double)sigma[0][r], (double)sigma[1][r]);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &stated, &imu));
    held.held = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_after((const invcal_real(*)[3])raw, 13, &held));
    TEST_ASSERT_EQUAL_UINT(9, rank());
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * (double)expected[0], (double)expected[0], at(0, 0));
}

/* It may have any contents before. A rest of half the length: up is still a unit vector. */
static void it_begins_where_the_last_rest_is(void)
{
    world_settings held = stated;
    invcal_real raw[WORLD_RESTS][3];
    (void)make_tour(raw);
    memset(&t, 0x5A, sizeof t);
    for (unsigned a = 0; a < 3; a++) {
        raw[11][a] /= 2;
    }
    w.imu.rests = 12;
    held.held = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_after((const invcal_real(*)[3])raw, 12, &held));
    TEST_ASSERT_EQUAL_UINT(9, t.n);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1.5, (double)t.seconds);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, -1, (double)t.up[1]); /* the tour's last but one */
}

static void bad_rests_are_refused(void)
{
    world_settings bad = stated;
    invcal_real raw[WORLD_RESTS][3];

    (void)make_tour(raw);
    bad.noise = -1;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, turns_after((const invcal_real(*)[3])raw, 13, &bad));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, turns_after((const invcal_real(*)[3])raw, 0, &stated));
    raw[12][2] = 30;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE,
                          turns_after((const invcal_real(*)[3])raw, 13, &stated));
}

/* Errors of the tour in a hand that wobbles, over the sigma of the plan: 1.07 at most in 300 runs,
 * as the solution weights rests and moves by residuals of 37 rows. */
static void errors_are_what_the_plan_says(void)
{
    enum { RUNS = 20 };
    invcal_real sigma[18];
    uint32_t open;
    double squares[5] = {0};
    int counts[5] = {0};

    begin(NULL);
    t.seconds = 1; /* about as long as those of world_tour */
    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        invcal_turn turn;
        (void)invcali_tour(i, &turn);
        (void)invcali_turns_add(&t, &turn);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, turns_sigma(NULL, sigma, &open));
    for (unsigned run = 0; run < RUNS; run++) {
        world_solution imu;
        world_begin(&w, 100, 700 + run);
        world_draw(&w, 0.01, 0.01);
        world_tour(&w);
        world_end(&w);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, NULL, &imu));
        for (unsigned i = 0; i < 18; i++) {
            const unsigned kind = i >= 9 ? i / 3 - 1 : i % 4 == 0 ? 0 : 1;
            const double truth = i < 9 ? w.m[i / 3][i % 3] : w.triad.x[i - 9];
            const double found =
                i < 9 ? (double)imu.parameter[i] : parameter(&imu.result.accelerometer, i - 9);
            const double error = (found - truth) / ((double)t.noise * (double)sigma[i]);
            squares[kind] += error * error;
            counts[kind]++;
        }
    }
    for (unsigned kind = 0; kind < 5; kind++) {
        const double rms = sqrt(squares[kind] / counts[kind]);
        TEST_ASSERT_TRUE(rms > 0.7 && rms < 1.25);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(up_does_not_drift);
    RUN_TEST(the_tour_determines_scale_and_misalignment_as_closed_form_says);
    RUN_TEST(ranks_are_those_of_the_number_of_axes);
    RUN_TEST(the_tour_determines_all_18);
    RUN_TEST(the_lengths_of_six_faces_alone_have_rank_6);
    RUN_SLOW_TEST(one_axis_leaves_open_what_the_script_names);
    RUN_SLOW_TEST(guidance_goes_where_it_learns_most);
    RUN_SLOW_TEST(twelve_turns_of_it_add_more_than_the_tour);
    RUN_SLOW_TEST(of_any_rest_there_is_a_next_turn);
    RUN_SLOW_TEST(guidance_goes_as_far_as_it_may);
    RUN_TEST(nonsense_has_no_next_turn);
    RUN_TEST(the_tour_takes_each_edge_once_about_horizontal_axes);
    RUN_TEST(the_shortest_turn_is_that_of_closed_form);
    RUN_TEST(opposite_directions_have_no_shortest_turn);
    RUN_TEST(bad_arguments_are_refused);
    RUN_TEST(turns_of_any_angle_agree_with_closed_form);
    RUN_TEST(next_to_the_vertical_nothing_is_lost);
    RUN_TEST(the_noise_of_a_turn_is_that_of_the_design);
    RUN_TEST(a_prior_is_information);
    RUN_TEST(sigma_is_judged_at_its_bounds);
    RUN_TEST(what_only_a_wide_prior_determines_is_open);
    RUN_SLOW_TEST(a_prospect_is_what_the_turn_then_achieves);
    RUN_TEST(what_is_known_too_little_is_named);
    RUN_SLOW_TEST(after_the_turns_it_knows_what_it_had_planned);
    RUN_SLOW_TEST(it_begins_where_the_last_rest_is);
    RUN_SLOW_TEST(bad_rests_are_refused);
    RUN_SLOW_TEST(errors_are_what_the_plan_says);
    return UNITY_END();
}
