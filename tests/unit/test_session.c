/* SPDX-License-Identifier: MIT
 *
 * A simulated sensor is turned and held like a real one; what it calibrates must be the truth.
 */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/session.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a simulated sensor, and a record of what its session says ------------------------------- */

#define GRAVITY 9.80665
#define COUNTS 16384.0 /* per g */
#define RATE 100.0
#define NOISE 5e-4 /* g, of a sample on each axis */

enum {
    RECORDED = 600,
    MEANS = ROOM(600, 120),
    WHATS = INVCAL_SESSION_FINISHED + 1,
    PATTERN = 0x5A
};

static const double zero[3] = {120, -340, 51}; /* counts of the nominal sensor in no field */

typedef struct {
    invcal_session_setup setup;
    invcal_session room[2]; /* the session lives in one of these, and may move */
    invcal_session *s;
    /* the sensor */
    triad_truth truth;
    double noise;   /* g */
    double bias[3]; /* g: a magnet, a hand on the case */
    double creep;   /* g/s on the x axis */
    double rate;
    double up[3]; /* where it points */
    double rest_time;
    invcal_real temperature;
    random_source random;
    int32_t last[3];
    /* what was said */
    unsigned seen[WHATS];
    unsigned refused[INVCAL_REST_SAME + 1];
    unsigned events;
    uint8_t what[RECORDED], progress[RECORDED]; /* all of them, MOVING and SETTLING too */
    invcal_event news;                          /* the last that was neither */
    uint64_t checksum;
    unsigned taken;
    invcal_real mean[MEANS][3];
} bench;

static bench b;

static invcal_session_setup free_hand(void)
{
    invcal_session_setup setup;

    memset(&setup, 0, sizeof setup);
    for (unsigned i = 0; i < 3; i++) {
        setup.settings.nominal.offset[i] = (invcal_real)zero[i];
        setup.settings.nominal.matrix[i][i] = (invcal_real)(GRAVITY / COUNTS);
    }
    setup.settings.field = (invcal_real)GRAVITY;
    setup.rate = (invcal_real)RATE;
    return setup;
}

/* The paper's program 3 x 6 (Table 2): its verticals are expected_plan18. */
static invcal_session_setup program(void)
{
    invcal_session_setup setup = free_hand();

    setup.plan.per_group = 6;
    setup.plan.start[0] = 30;
    setup.plan.start[1] = 30;
    setup.plan.start[2] = 120;
    return setup;
}

static invcal_session_setup background(void)
{
    invcal_session_setup setup = free_hand();

    setup.background = 1;
    return setup;
}

/* A sensor with errors of +- size. */
static void begin(invcal_session_setup setup, double size, uint32_t seed)
{
    memset(&b, 0, sizeof b);
    b.random = random_start(seed);
    if (size > 0) {
        b.truth = triad_random(&b.random, size);
    }
    b.setup = setup;
    b.s = &b.room[0];
    b.noise = NOISE;
    b.rate = (double)setup.rate;
    b.rest_time = 2.5;
    b.up[0] = 0.36; /* no position of any test */
    b.up[1] = 0.48;
    b.up[2] = -0.8;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(b.s, &b.setup));
}

static int is_position(invcal_session_what what)
{
    return what == INVCAL_SESSION_TAKEN || what == INVCAL_SESSION_ENOUGH ||
           what == INVCAL_SESSION_FINISHED;
}

static void mix(uint64_t value)
{
    b.checksum = (b.checksum ^ value) * 1099511628211u;
}

static void check_sum(const invcal_event *e)
{
    mix((uint64_t)e->what);
    mix(e->progress);
    mix((uint64_t)e->reason);
    mix((uint64_t)e->status);
    mix(e->positions);
    mix((uint64_t)e->is_asked);
    for (unsigned i = 0; i < 3; i++) {
        mix((uint64_t)e->rest.sum[i]);
    }
    mix(e->rest.count);
    mix(e->rest.begin);
    mix(e->rest.end);
}

static void record_mean(const invcal_rest *rest)
{
    TEST_ASSERT_TRUE(rest->count > 0);
    if (TEST_RAM < 65536 && b.taken == MEANS) {
        skip_large();
    }
    TEST_ASSERT_TRUE(b.taken < MEANS);
    for (unsigned i = 0; i < 3; i++) {
        b.mean[b.taken][i] = (invcal_real)((double)rest->sum[i] / (double)rest->count);
    }
    b.taken++;
}

/* An event, whatever it is, agrees with itself and with what came before. */
static void note(invcal_session_what what, const invcal_event *e)
{
    TEST_ASSERT_EQUAL_INT(what, e->what);
    TEST_ASSERT_TRUE(what > INVCAL_SESSION_NOTHING && what < (invcal_session_what)WHATS);
    TEST_ASSERT_LESS_OR_EQUAL_UINT(100, e->progress);
    TEST_ASSERT_TRUE(e->is_asked == 0 || e->is_asked == 1);
    if (what == INVCAL_SESSION_REFUSED) {
        TEST_ASSERT_TRUE((e->reason != INVCAL_REST_GOOD) != (e->status != INVCAL_OK));
        b.refused[e->reason]++;
    } else {
        TEST_ASSERT_EQUAL_INT(INVCAL_REST_GOOD, e->reason);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, e->status);
    }
    if (is_position(what)) {
        record_mean(&e->rest);
    }
    if (!b.setup.background) {
        TEST_ASSERT_EQUAL_UINT(b.taken, e->positions);
    }
    b.seen[what]++;
    if (b.events < RECORDED) {
        b.what[b.events] = (uint8_t)what;
        b.progress[b.events] = (uint8_t)e->progress;
        b.events++;
    }
    if (what != INVCAL_SESSION_MOVING && what != INVCAL_SESSION_SETTLING) {
        b.news = *e;
    }
    check_sum(e);
}

static void feed(const int32_t raw[3])
{
    invcal_event event;
    invcal_event before;

    memset(&before, PATTERN, sizeof before);
    memcpy(&event, &before, sizeof event);
    memcpy(b.last, raw, sizeof b.last);
    const invcal_session_what what = invcal_session_feed(b.s, raw, b.temperature, &event);
    if (what == INVCAL_SESSION_NOTHING) {
        TEST_ASSERT_TRUE(memcmp(&before, &event, sizeof event) == 0);
    } else {
        note(what, &event);
    }
}

static invcal_session_what finish(void)
{
    invcal_event event;

    memset(&event, PATTERN, sizeof event);
    const invcal_session_what what = invcal_session_finish(b.s, &event);
    note(what, &event);
    return what;
}

/* One sample of the triad pointing along b.up, with a linear acceleration, g. */
static void sense(const double acceleration[3])
{
    double force[3];
    double u[3];
    int32_t raw[3];

    for (unsigned i = 0; i < 3; i++) {
        force[i] = b.up[i] + acceleration[i];
    }
    triad_read(&b.truth, force, u);
    for (unsigned i = 0; i < 3; i++) {
        const double noise = b.noise > 0 ? b.noise * random_normal(&b.random) : 0;
        raw[i] = (int32_t)floor((u[i] + b.bias[i] + noise) * COUNTS + zero[i] + 0.5);
        if (b.setup.low < b.setup.high) {
            raw[i] = raw[i] < b.setup.low ? b.setup.low : raw[i];
            raw[i] = raw[i] > b.setup.high ? b.setup.high : raw[i];
        }
    }
    feed(raw);
}

static void hold(double seconds)
{
    static const double none[3] = {0, 0, 0};

    for (long i = 0; i < (long)(seconds * b.rate); i++) {
        b.bias[0] += b.creep / b.rate;
        sense(none);
    }
}

static double dot(const double a[3], const double c[3])
{
    return a[0] * c[0] + a[1] * c[1] + a[2] * c[2];
}

/* Part s of the way from a to c on the sphere; where they are opposite, by way of a third. */
static void between(const double a[3], const double c[3], double s, double out[3])
{
    double side[3];
    const double cosine = dot(a, c);

    for (unsigned i = 0; i < 3; i++) {
        side[i] = c[i] - cosine * a[i];
    }
    if (length3(side) < 1e-3) {
        const double other[3] = {a[1], a[2], a[0] + 0.5};
        for (unsigned i = 0; i < 3; i++) {
            side[i] = other[i] - dot(a, other) * a[i];
        }
    }
    const double length = length3(side);
    const double angle = s * acos(fmax(-1, fmin(1, cosine)));
    for (unsigned i = 0; i < 3; i++) {
        out[i] = a[i] * cos(angle) + side[i] / length * sin(angle);
    }
}

/* One second of a smooth turn (a polynomial of degree five), shaken by a hand. */
static void turn(const double to[3])
{
    const double from[3] = {b.up[0], b.up[1], b.up[2]};
    const long n = (long)b.rate;

    for (long i = 0; i < n; i++) {
        const double t = ((double)i + 0.5) / (double)n;
        const double shake = 0.1 * sin(3.14159265 * t);
        const double a[3] = {shake * sin(9 * t), shake * cos(11 * t), -shake * cos(7 * t)};
        between(from, to, t * t * t * (10 - 15 * t + 6 * t * t), b.up);
        sense(a);
    }
    memcpy(b.up, to, sizeof b.up);
}

/* Goes there and holds still. */
static void reach(const double to[3])
{
    turn(to);
    hold(b.rest_time);
}

/* Goes away, so that the position is closed; not to where the next one will be. */
static void leave(void)
{
    const double away[3] = {0.6 * b.up[0] - 0.8 * b.up[1], 0.6 * b.up[1] + 0.8 * b.up[0], b.up[2]};
    const double tilted[3] = {b.up[0], 0.5 * b.up[1] - 0.9 * b.up[2],
                              0.5 * b.up[2] + 0.9 * b.up[1]};
    const double *to = fabs(b.up[2]) < 0.7 ? away : tilted;
    const double length = length3(to);
    const double unit[3] = {to[0] / length, to[1] / length, to[2] / length};

    turn(unit);
}

static void visit(const double to[3])
{
    reach(to);
    leave();
}

static void visit_plan(unsigned first, unsigned count)
{
    for (unsigned i = first; i < first + count; i++) {
        visit(expected_plan18[i % 18]);
    }
}

/* A direction at an angle from `from`, in degrees, on a random side of it. */
static void astray(const double from[3], double degrees, double out[3])
{
    double other[3];

    random_direction(&b.random, other);
    const double angle = acos(dot(from, other));
    between(from, other, degrees / 57.29577951308232 / angle, out);
}

/* ---- what is expected, computed in double from the readings ---------------------------------- */

typedef struct {
    double m[9][9];
} matrix9;

static void reading_of(const invcal_real mean[3], double u[3])
{
    for (unsigned i = 0; i < 3; i++) {
        u[i] = ((double)mean[i] - zero[i]) / COUNTS;
    }
}

static void row_of(const double u[3], double h[9])
{
    const double row[9] = {u[0],        u[1],        u[2],        u[0] * u[0], u[1] * u[1],
                           u[2] * u[2], u[0] * u[1], u[0] * u[2], u[1] * u[2]};

    memcpy(h, row, sizeof row);
}

static void add_row(matrix9 *sum, const invcal_real mean[3], double weight)
{
    double u[3];
    double h[9];

    reading_of(mean, u);
    row_of(u, h);
    for (unsigned r = 0; r < 9; r++) {
        for (unsigned c = 0; c < 9; c++) {
            sum->m[r][c] += weight * h[r] * h[c];
        }
    }
}

/* Gauss and Jordan, in place; the logarithm of the determinant, -infinity for a singular one. */
static double invert(matrix9 *a)
{
    double log_det = 0;

    for (unsigned k = 0; k < 9; k++) {
        const double pivot = a->m[k][k];
        if (!(pivot > 1e-12)) {
            return -INFINITE;
        }
        log_det += log(pivot);
        a->m[k][k] = 1;
        for (unsigned c = 0; c < 9; c++) {
            a->m[k][c] /= pivot;
        }
        for (unsigned r = 0; r < 9; r++) {
            const double f = a->m[r][k];
            if (r == k) {
                continue;
            }
            a->m[r][k] = 0;
            for (unsigned c = 0; c < 9; c++) {
                a->m[r][c] -= f * a->m[k][c];
            }
        }
    }
    return log_det;
}

static double worst_root(const matrix9 *k)
{
    double worst = 0;

    for (unsigned r = 0; r < 9; r++) {
        worst = fmax(worst, sqrt(k->m[r][r]));
    }
    return worst;
}

/* h K h' */
static double gain_of(const matrix9 *k, const invcal_real mean[3])
{
    double u[3];
    double h[9];
    double sum = 0;

    reading_of(mean, u);
    row_of(u, h);
    for (unsigned r = 0; r < 9; r++) {
        for (unsigned c = 0; c < 9; c++) {
            sum += h[r] * k->m[r][c] * h[c];
        }
    }
    return sum;
}

/* K of the positions taken so far, and log det of its inverse. */
static double taken_covariance(matrix9 *k)
{
    memset(k, 0, sizeof *k);
    for (unsigned i = 0; i < b.taken; i++) {
        add_row(k, b.mean[i], 1);
    }
    return invert(k);
}

/* The same of a table that fades. */
static double table_covariance(const invcal_session *s, matrix9 *k)
{
    memset(k, 0, sizeof *k);
    for (unsigned i = 0; i < s->stored; i++) {
        add_row(k, s->mean[i], pow(31.0 / 32, s->age[i]));
    }
    return invert(k);
}

/* log det of n positions that determine everything as well as any n can: those of a spherical
 * 4-design. E xx = 1/3, E xxyy = 1/15, E x^4 = 1/5: the nine eigenvalues of H'H / n are three
 * times 1/3, three times 1/15, and of the squares 1/3 and twice 2/15. */
static double largest_log_det(double n)
{
    return 9 * log(n) - 4 * log(3.0) - 3 * log(15.0) + 2 * log(2.0 / 15);
}

typedef struct {
    invcal_solution solution;
    invcal_quality quality;
} result;

static result calibrate_means(unsigned count)
{
    result r;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibrate(&b.mean[0][0], count, &b.setup.settings,
                                                      &r.solution, &r.quality, NULL));
    return r;
}

static void same_solution(const result *expected, const result *actual)
{
    const double tolerance = FLOAT_OR_DOUBLE(3e-6, 1e-12);

    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(tolerance, parameter(&expected->solution, r),
                                  parameter(&actual->solution, r));
    }
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(tolerance * COUNTS,
                                  (double)expected->solution.calibration.offset[i],
                                  (double)actual->solution.calibration.offset[i]);
        for (unsigned c = 0; c < 3; c++) {
            TEST_ASSERT_DOUBLE_WITHIN(tolerance * GRAVITY / COUNTS,
                                      (double)expected->solution.calibration.matrix[i][c],
                                      (double)actual->solution.calibration.matrix[i][c]);
        }
    }
}

static void same_quality(const result *expected, const result *actual)
{
    const double tolerance = FLOAT_OR_DOUBLE(2e-2, 1e-6);

    TEST_ASSERT_EQUAL_INT(expected->quality.verdict, actual->quality.verdict);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)expected->quality.dof, (double)actual->quality.dof);
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(tolerance, 1,
                                  sigma_of_parameter(&actual->quality, r) /
                                      sigma_of_parameter(&expected->quality, r));
    }
}

static void is_truth(const result *found, double sigmas)
{
    for (unsigned r = 0; r < 9; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(sigmas * sigma_of_parameter(&found->quality, r), b.truth.x[r],
                                  parameter(&found->solution, r));
    }
}

/* Solves, which must not touch the session. */
static invcal_status try_solve(result *found, invcal_outliers *outliers)
{
    invcal_session before;

    memcpy(&before, b.s, sizeof before);
    const invcal_status status =
        invcal_session_solve(b.s, &found->solution, &found->quality, outliers);
    TEST_ASSERT_TRUE(memcmp(&before, b.s, sizeof before) == 0);
    return status;
}

static result solve(void)
{
    result found;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, NULL));
    return found;
}

static void is_refused(invcal_status expected, invcal_outliers *outliers)
{
    result found;
    result before;

    memset(&before, PATTERN, sizeof before);
    memcpy(&found, &before, sizeof found);
    TEST_ASSERT_EQUAL_INT(expected, try_solve(&found, outliers));
    TEST_ASSERT_TRUE(memcmp(&before, &found, sizeof found) == 0);
}

static invcal_guidance next(void)
{
    invcal_guidance guidance;
    invcal_session before;

    memcpy(&before, b.s, sizeof before);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_next(b.s, &guidance));
    TEST_ASSERT_TRUE(memcmp(&before, b.s, sizeof before) == 0);
    return guidance;
}

static void next_is(const double expected[3])
{
    const invcal_guidance guidance = next();

    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, expected[i], (double)guidance.up[i]);
    }
}

static void nothing_is_next(void)
{
    invcal_guidance guidance;
    invcal_guidance before;

    memset(&before, PATTERN, sizeof before);
    memcpy(&guidance, &before, sizeof guidance);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_session_next(b.s, &guidance));
    TEST_ASSERT_TRUE(memcmp(&before, &guidance, sizeof guidance) == 0);
}

/* ---- a program ------------------------------------------------------------------------------- */

static void a_program_is_followed_to_its_end(void)
{
    begin(program(), 0.03, 1);
    for (unsigned i = 0; i < 18; i++) {
        next_is(expected_plan18[i]);
        reach(expected_plan18[i]);
        TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.news.what);
        TEST_ASSERT_EQUAL_UINT(i, b.taken);
        leave();
        TEST_ASSERT_EQUAL_UINT(i + 1, b.taken);
        TEST_ASSERT_EQUAL_INT(i < 17 ? INVCAL_SESSION_TAKEN : INVCAL_SESSION_FINISHED, b.news.what);
        TEST_ASSERT_EQUAL_INT(1, b.news.is_asked);
        TEST_ASSERT_EQUAL_UINT(i + 1, b.news.positions);
    }
    nothing_is_next();
    TEST_ASSERT_EQUAL_UINT(17, b.seen[INVCAL_SESSION_TAKEN]);
    TEST_ASSERT_EQUAL_UINT(18, b.seen[INVCAL_SESSION_READY]);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_REFUSED]);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_ENOUGH]);
}

static void its_calibration_is_the_truth_and_that_of_the_means(void)
{
    for (uint32_t seed = 0; seed < SOME(6); seed++) {
        begin(program(), 0.05, seed);
        visit_plan(0, 18);
        TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_FINISHED]);
        const result found = solve();
        const result expected = calibrate_means(18);
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, found.quality.verdict);
        is_truth(&found, 5);
        same_solution(&expected, &found);
        same_quality(&expected, &found);
        /* 200 samples and more in a mean: a sixth of the paper's worst, 1.15 of 0.5 mg */
        for (unsigned r = 0; r < 9; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(2.5e-4, b.truth.x[r], parameter(&found.solution, r));
        }
    }
}

static void what_comes_after_the_program_is_taken_too(void)
{
    begin(program(), 0.01, 3);
    visit_plan(0, 20);
    TEST_ASSERT_EQUAL_UINT(20, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_FINISHED]);
    nothing_is_next();
    const result found = solve();
    const result expected = calibrate_means(20);
    same_solution(&expected, &found);
}

static void a_position_that_was_not_asked_counts_but_is_asked_again(void)
{
    begin(program(), 0, 4);
    visit(expected_plan18[1]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, b.news.what);
    TEST_ASSERT_EQUAL_INT(0, b.news.is_asked);
    TEST_ASSERT_EQUAL_UINT(1, b.news.positions);
    TEST_ASSERT_EQUAL_UINT(1, b.s->normal.count);
    next_is(expected_plan18[0]);
    for (unsigned i = 0; i < 18; i++) {
        TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_FINISHED]);
        next_is(expected_plan18[i]);
        visit(expected_plan18[i]);
        TEST_ASSERT_EQUAL_INT(1, b.news.is_asked);
    }
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_FINISHED]);
    const result found = solve();
    const result expected = calibrate_means(19);
    same_solution(&expected, &found);
    same_quality(&expected, &found);
}

static void twenty_degrees_are_near_enough(void)
{
    for (uint32_t seed = 0; seed < 8; seed++) {
        double direction[3];
        begin(program(), 0, seed);
        const double degrees = seed % 2 ? 19 : 21;
        astray(expected_plan18[0], degrees, direction);
        visit(direction);
        TEST_ASSERT_EQUAL_UINT(1, b.taken);
        TEST_ASSERT_EQUAL_INT(degrees < 20, b.news.is_asked);
        next_is(expected_plan18[degrees < 20 ? 1 : 0]);
    }
}

/* Nor does it count as the one asked for while it is held. */
static void while_another_position_is_held_the_same_one_is_asked_for(void)
{
    begin(program(), 0, 4);
    reach(expected_plan18[1]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.news.what);
    next_is(expected_plan18[0]);
    leave();
    next_is(expected_plan18[0]);
    reach(expected_plan18[0]);
    next_is(expected_plan18[1]);
}

/* ---- free hand ------------------------------------------------------------------------------- */

/* Follows the session's advice, with errors of the hand up to so many degrees. */
static void follow(unsigned count, double degrees)
{
    for (unsigned i = 0; i < count; i++) {
        const invcal_guidance guidance = next();
        const double asked[3] = {(double)guidance.up[0], (double)guidance.up[1],
                                 (double)guidance.up[2]};
        double direction[3];
        astray(asked, random_uniform(&b.random, 0, degrees), direction);
        visit(direction);
    }
}

static void advice_followed_determines_everything(void)
{
    matrix9 k;

    begin(free_hand(), 0, 5);
    b.noise = 1e-4;
    follow(9, 0);
    TEST_ASSERT_EQUAL_UINT(9, b.taken);
    (void)taken_covariance(&k);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(3.01 * 1.005, worst_root(&k));
    follow(9, 0);
    TEST_ASSERT_EQUAL_UINT(18, b.taken);
    const double log_det = taken_covariance(&k);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 9.465, largest_log_det(18)); /* the README's figure */
    TEST_ASSERT_LESS_THAN_DOUBLE(largest_log_det(18) + 0.01, log_det);
    TEST_ASSERT_GREATER_THAN_DOUBLE(largest_log_det(18) - 0.31, log_det);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_REFUSED]);
}

static void a_hand_that_errs_by_ten_degrees_does_hardly_worse(void)
{
    matrix9 k;

    for (uint32_t seed = 0; seed < 12; seed++) {
        begin(free_hand(), 0.05, seed);
        follow(18, 10);
        TEST_ASSERT_EQUAL_UINT(18, b.taken);
        const double log_det = taken_covariance(&k);
        TEST_ASSERT_GREATER_THAN_DOUBLE(largest_log_det(18) - 1.5, log_det);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.6, worst_root(&k));
        const result found = solve();
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, found.quality.verdict);
        is_truth(&found, 5);
    }
}

/* The 26 directions to faces, edges and corners of a cube. */
static unsigned cube(double direction[27][3])
{
    unsigned count = 0;

    for (int code = 0; code < 27; code++) {
        const double v[3] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
        for (unsigned i = 0; i < 3 && code != 13; i++) {
            direction[count][i] = v[i] / length3(v);
        }
        count += code != 13;
    }
    return count;
}

static double gain_towards(const matrix9 *k, const double up[3])
{
    const invcal_real mean[3] = {(invcal_real)(up[0] * COUNTS + zero[0]),
                                 (invcal_real)(up[1] * COUNTS + zero[1]),
                                 (invcal_real)(up[2] * COUNTS + zero[2])};

    return gain_of(k, mean);
}

/* `up` tells as much as any, within 1 %, and of those that do it is the nearest to the latest
 * position, but not that again. K with the small ridge of guidance.h. */
static void is_best_and_nearest(const double up[3])
{
    double direction[27][3];
    double latest[3];
    matrix9 k = {{{0}}};
    double largest = 1;
    double most = 0;
    double nearest = -1;

    for (unsigned i = 0; i < b.taken; i++) {
        add_row(&k, b.mean[i], 1);
    }
    for (unsigned r = 0; r < 9; r++) {
        largest = fmax(largest, k.m[r][r]);
    }
    for (unsigned r = 0; r < 9; r++) {
        k.m[r][r] += 1e-4 * largest;
    }
    (void)invert(&k);
    reading_of(b.mean[b.taken - 1], latest);
    const unsigned count = cube(direction);
    for (unsigned i = 0; i < count; i++) {
        most = fmax(most, gain_towards(&k, direction[i]));
    }
    for (unsigned i = 0; i < count; i++) {
        const double cosine = dot(direction[i], latest) / length3(latest);
        if (gain_towards(&k, direction[i]) > 0.995 * most && cosine < 0.88) {
            nearest = fmax(nearest, cosine);
        }
    }
    TEST_ASSERT_GREATER_THAN_DOUBLE(0.985 * most, gain_towards(&k, up));
    const double cosine = dot(up, latest) / length3(latest);
    TEST_ASSERT_GREATER_THAN_DOUBLE(nearest - 0.01, cosine);
    TEST_ASSERT_LESS_THAN_DOUBLE(0.92, cosine);
}

static void free_hand_the_best_and_nearest_is_next(void)
{
    begin(free_hand(), 0.02, 6);
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        const invcal_guidance guidance = next();
        const double up[3] = {(double)guidance.up[0], (double)guidance.up[1],
                              (double)guidance.up[2]};
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1, length3(up));
        if (i > 0 && i < INVCAL_MAX_POSITIONS) {
            is_best_and_nearest(up);
        }
        visit(up);
        TEST_ASSERT_EQUAL_INT(1, b.news.is_asked);
        TEST_ASSERT_EQUAL_UINT(i + 1, b.taken);
    }
}

/* From READY on the advice is what it will be once the position has been left. */
static void free_hand_a_position_that_is_ready_counts_as_taken(void)
{
    begin(free_hand(), 0.02, 7);
    for (unsigned i = 0; i < 4; i++) {
        reach(expected_plan18[5 * i % 18]);
        TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.news.what);
        const invcal_guidance held = next();
        leave();
        TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, b.news.what);
        const invcal_guidance taken = next();
        for (unsigned k = 0; k < 3; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)taken.up[k], (double)held.up[k]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-2 * (double)taken.gain, (double)taken.gain, (double)held.gain);
    }
}

/* ---- events ---------------------------------------------------------------------------------- */

static unsigned skip_events(unsigned at, invcal_session_what what)
{
    while (at < b.events && b.what[at] == (uint8_t)what) {
        at++;
    }
    return at;
}

static void a_rest_settles_is_ready_once_and_is_taken(void)
{
    unsigned at;

    begin(free_hand(), 0.02, 7);
    turn(expected_plan18[0]);
    b.events = 0;
    hold(3);
    leave();
    at = skip_events(0, INVCAL_SESSION_MOVING);
    const unsigned first = at;
    at = skip_events(at, INVCAL_SESSION_SETTLING);
    TEST_ASSERT_TRUE(at >= first + 5); /* three quarters of a second, and more */
    for (unsigned i = first + 1; i < at; i++) {
        TEST_ASSERT_TRUE(b.progress[i] >= b.progress[i - 1]);
    }
    TEST_ASSERT_LESS_THAN_UINT(25, b.progress[first]);
    TEST_ASSERT_GREATER_THAN_UINT(50, b.progress[at - 1]);
    TEST_ASSERT_LESS_THAN_UINT(100, b.progress[at - 1]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.what[at]);
    TEST_ASSERT_EQUAL_UINT(100, b.progress[at]);
    const unsigned ready = at + 1;
    at = skip_events(ready, INVCAL_SESSION_SETTLING);
    TEST_ASSERT_TRUE(at > ready);
    TEST_ASSERT_EQUAL_UINT(100, b.progress[at - 1]);
    at = skip_events(at, INVCAL_SESSION_MOVING);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, b.what[at]);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_READY]);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_TAKEN]);
}

/* ---- how long to stay -------------------------------------------------------------------------- */

/* Seconds of the hold from its beginning to READY; 0 if it was not said. An event is an eighth. */
static double time_to_ready(const double to[3], double longest)
{
    const unsigned before = b.seen[INVCAL_SESSION_READY];

    turn(to);
    for (unsigned i = 1; i <= (unsigned)(10 * longest); i++) {
        hold(0.1);
        if (b.seen[INVCAL_SESSION_READY] > before) {
            return 0.1 * i;
        }
    }
    return 0;
}

/* sigma of a mean that white noise reaches after so many seconds. */
static invcal_real after(double seconds)
{
    return (invcal_real)(NOISE * GRAVITY / sqrt(seconds * RATE));
}

/* Half a second goes by at the beginning of a rest, and the noise is known to a tenth. */
static void the_noise_of_the_first_rest_tells_how_long_to_stay(void)
{
    static const double seconds[] = {4, 8, 20};

    for (unsigned i = 0; i < SOME(3); i++) {
        invcal_session_setup setup = free_hand();
        setup.mean_sigma = after(seconds[i]);
        begin(setup, 0.02, 40 + i);
        const double first = time_to_ready(expected_plan18[0], 60);
        TEST_ASSERT_DOUBLE_WITHIN(0.15 * seconds[i], seconds[i] + 0.6, first);
        leave();
        b.noise = 3 * NOISE; /* another noise, later, changes nothing */
        const double second = time_to_ready(expected_plan18[1], 60);
        TEST_ASSERT_DOUBLE_WITHIN(0.15 * seconds[i] + 0.5, first, second);
        TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_TAKEN]);
    }
}

static void more_noise_takes_the_square_of_the_time(void)
{
    invcal_session_setup setup = free_hand();

    setup.mean_sigma = after(3);
    begin(setup, 0, 43);
    b.noise = 2 * NOISE;
    TEST_ASSERT_DOUBLE_WITHIN(1.8, 12.6, time_to_ready(expected_plan18[0], 60));
}

static void no_noise_makes_a_rest_longer_than_a_minute(void)
{
    invcal_session_setup setup = free_hand();

    setup.mean_sigma = after(1000);
    begin(setup, 0, 44);
    TEST_ASSERT_DOUBLE_WITHIN(0.5, INVCAL_SESSION_HOLD_MAX + 0.6,
                              time_to_ready(expected_plan18[0], 70));
}

static void who_leaves_too_early_is_told_and_the_position_is_not_taken(void)
{
    invcal_session_setup setup = free_hand();

    setup.mean_sigma = after(8);
    begin(setup, 0.02, 45);
    turn(expected_plan18[0]);
    hold(4);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_READY]);
    TEST_ASSERT_TRUE(b.progress[b.events - 1] > 25 && b.progress[b.events - 1] < 65);
    leave();
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_REFUSED, b.news.what);
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_SHORT, b.news.reason);
    TEST_ASSERT_EQUAL_UINT(0, b.news.positions);
    TEST_ASSERT_TRUE(time_to_ready(expected_plan18[3], 30) > 4);
    finish();
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, b.news.what);
}

/* The first rest must tell first what there is to wait for; from the second on it is known. */
static void progress_grows_to_the_time_that_is_wanted(void)
{
    invcal_session_setup setup = free_hand();

    setup.mean_sigma = after(10);
    begin(setup, 0, 46);
    TEST_ASSERT_TRUE(time_to_ready(expected_plan18[0], 30) > 5);
    leave();
    turn(expected_plan18[1]);
    b.events = 0;
    hold(14);
    unsigned at = skip_events(0, INVCAL_SESSION_MOVING);
    for (unsigned last = 0; b.what[at] == INVCAL_SESSION_SETTLING; at++) {
        TEST_ASSERT_TRUE(b.progress[at] >= last && b.progress[at] <= last + 10);
        last = b.progress[at];
        TEST_ASSERT_LESS_THAN_UINT(100, last);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.what[at]);
    TEST_ASSERT_GREATER_THAN_UINT(90, b.progress[at - 1]);
    TEST_ASSERT_EQUAL_UINT(100, b.progress[at]);
}

static void progress_ends_at_99(void)
{
    begin(free_hand(), 0.02, 50);
    invcal_session_hold(b.s, 25); /* in steps of half a percent */
    turn(expected_plan18[0]);
    b.events = 0;
    hold(28);
    const unsigned at = skip_events(skip_events(0, INVCAL_SESSION_MOVING), INVCAL_SESSION_SETTLING);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_READY, b.what[at]);
    TEST_ASSERT_EQUAL_UINT(99, b.progress[at - 1]);
    TEST_ASSERT_EQUAL_UINT(98, b.progress[at - 4]);
}

static void a_time_may_be_demanded_in_place_of_it(void)
{
    begin(free_hand(), 0.02, 47);
    invcal_session_hold(b.s, 6);
    TEST_ASSERT_DOUBLE_WITHIN(0.4, 6.6, time_to_ready(expected_plan18[0], 20));
    leave();
    invcal_session_hold(b.s, 0);
    TEST_ASSERT_TRUE(time_to_ready(expected_plan18[1], 20) < 3);
    invcal_session_hold(b.s, (invcal_real)NAN);
    TEST_ASSERT_TRUE(b.s->hold >= 0 && b.s->hold <= 0);
    invcal_session_hold(b.s, -1);
    TEST_ASSERT_TRUE(b.s->hold >= 0 && b.s->hold <= 0);
    invcal_session_hold(b.s, (invcal_real)1e9);
    TEST_ASSERT_EQUAL_DOUBLE(INVCAL_SESSION_HOLD_LONGEST, b.s->hold);
}

static void in_the_background_nobody_waits(void)
{
    invcal_session_setup setup = background();

    setup.mean_sigma = after(20);
    begin(setup, 0.02, 48);
    TEST_ASSERT_TRUE(time_to_ready(expected_plan18[0], 20) < 3);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_TAKEN]);
}

static void while_it_is_too_short_the_next_position_stays_the_same(void)
{
    invcal_session_setup setup = program();
    invcal_guidance next;

    setup.mean_sigma = after(8);
    begin(setup, 0.02, 49);
    turn(expected_plan18[0]);
    hold(4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_next(b.s, &next));
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, expected_plan18[0][i], next.up[i]);
    }
    hold(8);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_next(b.s, &next));
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, expected_plan18[1][1], next.up[1]);
}

/* Every eighth of a second there is something to tell. */
static void between_the_events_there_is_nothing(void)
{
    begin(free_hand(), 0, 8);
    turn(expected_plan18[0]);
    hold(2);
    TEST_ASSERT_UINT_WITHIN(1, 24, b.events);
}

/* Two events that begin with different rubbish end alike. */
static void events_are_complete(void)
{
    static invcal_session twin;

    begin(program(), 0.02, 9);
    turn(expected_plan18[1]);
    for (unsigned i = 0; i < 600; i++) {
        invcal_event a;
        invcal_event c;
        const double phase = i < 300 ? 0 : (double)(i - 300) / 50;
        const int32_t noise = (int32_t)(8 * random_normal(&b.random));
        const int32_t raw[3] = {noise + (int32_t)(12000 * sin(phase)), (int32_t)(i % 2),
                                noise + (int32_t)(16384 * cos(phase))};
        memset(&a, PATTERN, sizeof a);
        memset(&c, 0xA5, sizeof c);
        memcpy(&twin, b.s, sizeof twin);
        (void)invcal_session_feed(&twin, raw, 20, &a);
        if (invcal_session_feed(b.s, raw, 20, &c) == INVCAL_SESSION_NOTHING) {
            continue;
        }
        b.checksum = 0;
        check_sum(&a);
        const uint64_t of_a = b.checksum;
        b.checksum = 0;
        check_sum(&c);
        TEST_ASSERT_TRUE(of_a == b.checksum);
        TEST_ASSERT_TRUE(memcmp(&a.rest.variance, &c.rest.variance, sizeof(invcal_real)) == 0);
        b.seen[a.what]++;
    }
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_READY]);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_TAKEN]);
}

/* What was taken tells its sum, its noise and its place in the stream. */
static void a_position_taken_tells_of_its_rest(void)
{
    begin(free_hand(), 0, 10);
    b.noise = 2e-3;
    turn(expected_plan18[1]); /* samples 0 ... 99; the rest: 100 ... 599 */
    hold(5);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_GREATER_THAN_UINT(350, b.news.rest.count);
    TEST_ASSERT_LESS_OR_EQUAL_UINT(500, b.news.rest.count);
    TEST_ASSERT_TRUE(b.news.rest.begin >= 90 && b.news.rest.begin < 200);
    TEST_ASSERT_TRUE(b.news.rest.end > 500 && b.news.rest.end <= 610);
    TEST_ASSERT_DOUBLE_WITHIN(0.15, 1, (double)b.news.rest.variance / pow(2e-3 * COUNTS, 2));
    for (unsigned i = 0; i < 3; i++) {
        const double expected = expected_plan18[1][i] * COUNTS + zero[i];
        TEST_ASSERT_DOUBLE_WITHIN(8, expected, (double)b.mean[0][i]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-2, (double)b.mean[0][i], (double)b.s->mean[0][i]);
    }
}

static void the_refusals_of_still_are_handed_on(void)
{
    begin(free_hand(), 0, 11);
    visit(expected_plan18[0]);
    turn(expected_plan18[1]);
    b.creep = 0.006; /* a third of a degree in a second */
    hold(5);
    b.creep = 0;
    TEST_ASSERT_TRUE(b.refused[INVCAL_REST_DRIFT] > 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_DRIFT, b.news.reason);

    begin(free_hand(), 0, 12);
    visit(expected_plan18[0]);
    reach(expected_plan18[0]);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SAME]);
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_SAME, b.news.reason);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);

    begin(free_hand(), 0, 13);
    turn(expected_plan18[0]);
    hold(1.3);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SHORT]);

    begin(free_hand(), 0, 14);
    reach(expected_plan18[0]);
    const int32_t stuck[3] = {b.last[0], b.last[1], b.last[2]};
    for (int i = 0; i < 200; i++) {
        feed(stuck);
    }
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
}

static void what_lies_at_the_rails_is_refused(void)
{
    invcal_session_setup setup = free_hand();

    setup.low = -16384;
    setup.high = 16384; /* + 51 counts of zero: at + 1 g z is beyond */
    begin(setup, 0, 15);
    visit(expected_plan18[1]);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_CLIPPED]);
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    visit(expected_plan18[0]);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    visit(expected_plan18[16]); /* + y: zero is - 340 counts */
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    visit(expected_plan18[13]); /* - y */
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    TEST_ASSERT_EQUAL_UINT(2, b.refused[INVCAL_REST_CLIPPED]);
}

/* A scale that is wrong by 20: lengths of 20 or 1/20, where 0.1 ... 10 could be of this field. */
static void a_mean_that_is_no_reading_of_the_field_is_refused_at_once(void)
{
    for (int i = 0; i < 2; i++) {
        invcal_session_setup setup = free_hand();
        for (unsigned a = 0; a < 3; a++) {
            setup.settings.nominal.matrix[a][a] *= i ? 20 : INVCAL_REAL(0.05);
        }
        setup.background = i == 1;
        begin(setup, 0, 16);
        for (unsigned k = 0; k < 3; k++) {
            const unsigned before = b.seen[INVCAL_SESSION_REFUSED];
            reach(expected_plan18[k]);
            TEST_ASSERT_EQUAL_UINT(before + 1, b.seen[INVCAL_SESSION_REFUSED]);
            TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_REFUSED, b.news.what);
            TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, b.news.status);
            TEST_ASSERT_EQUAL_INT(INVCAL_REST_GOOD, b.news.reason);
            leave();
        }
        TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_READY]);
        TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_TAKEN]);
        TEST_ASSERT_EQUAL_UINT(0, b.news.positions);
        TEST_ASSERT_EQUAL_UINT(0, b.s->stored);
        TEST_ASSERT_EQUAL_UINT(0, b.s->normal.count);
        TEST_ASSERT_TRUE(b.s->normal.jtj >= 0 && b.s->normal.jtj <= 0);
        is_refused(INVCAL_TOO_FEW, NULL);
    }
}

/* ---- enough ---------------------------------------------------------------------------------- */

static int is_enough(unsigned count)
{
    result r;

    if (count < 9 || invcal_calibrate(&b.mean[0][0], count, &b.setup.settings, &r.solution,
                                      &r.quality, NULL) != INVCAL_OK) {
        return 0;
    }
    for (unsigned p = 0; p < 9; p++) {
        const double target = (double)b.setup.target[p / 3];
        if (target > 0 &&
            !(sigma_of_parameter(&r.quality, p) * (double)r.quality.coverage <= 1.96 * target)) {
            return 0;
        }
    }
    return r.quality.verdict == INVCAL_GOOD &&
           ((double)r.quality.dof >= 3 || b.setup.settings.noise > 0);
}

/* By position the number at which ENOUGH was said; 0: never. */
static unsigned enough_at(unsigned positions)
{
    unsigned at = 0;
    int was = 0;

    for (unsigned i = 0; i < positions; i++) {
        visit_plan(i * 7, 1); /* 7 and 18 have no common factor: in mixed order */
        const int now = is_enough(b.taken);
        TEST_ASSERT_EQUAL_UINT(i + 1, b.taken);
        TEST_ASSERT_EQUAL_INT(now && !was ? INVCAL_SESSION_ENOUGH : INVCAL_SESSION_TAKEN,
                              b.news.what);
        at = now && !was ? i + 1 : at;
        was |= now;
    }
    TEST_ASSERT_EQUAL_UINT(at > 0, b.seen[INVCAL_SESSION_ENOUGH]);
    return at;
}

/* A position mean of 0.5 mg / sqrt(200) = 35e-6; the program's sigma are 0.41, 0.48, 1.15 of it. */
static void enough_is_said_once_when_sigma_is_within_the_target(void)
{
    static const double targets[5][3] = {
        {2.2e-5, 0, 0}, {0, 2.6e-5, 0}, {0, 0, 6e-5}, {2.4e-5, 2.8e-5, 6.5e-5}, {1e-3, 6e-5, 1e-3}};
    unsigned earliest = 99;
    unsigned latest = 0;

    for (unsigned i = 0; i < 5; i++) {
        invcal_session_setup setup = free_hand();
        for (unsigned k = 0; k < 3; k++) {
            setup.target[k] = (invcal_real)targets[i][k];
        }
        begin(setup, 0.02, 20 + i);
        const unsigned at = enough_at(22);
        TEST_ASSERT_TRUE(at >= 10);
        earliest = at < earliest ? at : earliest;
        latest = at > latest ? at : latest;
    }
    TEST_ASSERT_TRUE(latest > earliest); /* not always at the same position */
}

static void a_calibration_that_nothing_checks_is_not_enough(void)
{
    invcal_session_setup setup = free_hand();

    setup.settings.noise = (invcal_real)(1e-4 * GRAVITY);
    setup.target[0] = setup.target[1] = setup.target[2] = INVCAL_REAL(0.1);
    begin(setup, 0.02, 30);
    follow(9, 0);
    const result nine = solve();
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_REDUNDANCY, nine.quality.verdict);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_ENOUGH]);
    follow(1, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_ENOUGH, b.news.what);
    TEST_ASSERT_EQUAL_INT(1, b.news.is_asked);
    TEST_ASSERT_EQUAL_UINT(10, b.news.positions);
}

static void without_a_target_nothing_is_enough(void)
{
    begin(free_hand(), 0.02, 31);
    visit_plan(0, 20);
    TEST_ASSERT_EQUAL_UINT(20, b.seen[INVCAL_SESSION_TAKEN]);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_ENOUGH]);
}

static void a_target_out_of_reach_is_never_met(void)
{
    invcal_session_setup setup = free_hand();

    setup.target[0] = setup.target[2] = 1;
    setup.target[1] = INVCAL_REAL(1e-9);
    begin(setup, 0.02, 32);
    visit_plan(0, 18);
    TEST_ASSERT_EQUAL_UINT(18, b.seen[INVCAL_SESSION_TAKEN]);
}

/* ---- solve ----------------------------------------------------------------------------------- */

static void too_few_positions_are_refused(void)
{
    invcal_outliers outliers;

    begin(free_hand(), 0.02, 40);
    is_refused(INVCAL_TOO_FEW, NULL);
    is_refused(INVCAL_TOO_FEW, &outliers);
    follow(8, 0);
    is_refused(INVCAL_TOO_FEW, NULL);
    is_refused(INVCAL_TOO_FEW, &outliers);
    TEST_ASSERT_EQUAL_UINT(0, outliers.count);
}

/* A prior on everything is a calibration already; what one position adds is better than nothing. */
static void one_position_is_enough_with_a_prior(void)
{
    invcal_session_setup setup = free_hand();

    setup.settings.noise = (invcal_real)(1e-4 * GRAVITY);
    for (unsigned r = 0; r < 9; r++) {
        setup.settings.prior[r] = INVCAL_REAL(0.01);
    }
    begin(setup, 0.01, 51);
    is_refused(INVCAL_TOO_FEW, NULL);
    visit(expected_plan18[0]);
    const result expected = calibrate_means(1);
    const result found = solve();
    same_solution(&expected, &found);
}

/* The verticals of group 1: x is never seen. */
static void visit_plane(unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const double angle = 0.1 + 6.283185307179586 * i / count;
        const double up[3] = {0, cos(angle), sin(angle)};
        visit(up);
    }
}

static void positions_on_a_plane_are_refused(void)
{
    invcal_outliers outliers;

    begin(free_hand(), 0, 41);
    visit_plane(13);
    TEST_ASSERT_EQUAL_UINT(13, b.taken);
    is_refused(INVCAL_UNDETERMINED, NULL);
    is_refused(INVCAL_UNDETERMINED, &outliers);
}

/* The prior holds what they leave open; to look for outliers must not take that away. */
static void positions_on_a_plane_and_a_prior_are_solved_with_outliers_or_without(void)
{
    invcal_session_setup setup = free_hand();
    invcal_outliers outliers;
    result found;

    setup.settings.noise = (invcal_real)(1e-4 * GRAVITY);
    for (unsigned r = 0; r < 9; r++) {
        setup.settings.prior[r] = INVCAL_REAL(0.01);
    }
    begin(setup, 0.01, 42);
    visit_plane(13);
    const result expected = calibrate_means(13);
    const result kept = solve();
    same_solution(&expected, &kept);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, b.truth.x[1], parameter(&kept.solution, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
    TEST_ASSERT_EQUAL_UINT(0, outliers.count);
    same_solution(&expected, &found);
}

static void a_solution_does_not_stop_the_session(void)
{
    begin(program(), 0.03, 43);
    visit_plan(0, 14);
    (void)solve();
    (void)next();
    visit_plan(14, 4);
    const result found = solve();
    const result expected = calibrate_means(18);
    same_solution(&expected, &found);
    same_quality(&expected, &found);
}

static void more_positions_than_the_table_holds_go_into_the_sums(void)
{
    enum { MORE = INVCAL_MAX_POSITIONS + 10 };
    invcal_real table[INVCAL_MAX_POSITIONS][3];

    begin(free_hand(), 0.03, 44);
    b.rest_time = 2;
    for (unsigned i = 0; i < MORE; i++) {
        double direction[3];
        random_direction(&b.random, direction);
        visit(direction);
        if (i + 1 == INVCAL_MAX_POSITIONS) {
            memcpy(table, b.s->mean, sizeof table);
        }
    }
    TEST_ASSERT_EQUAL_UINT(MORE, b.taken);
    TEST_ASSERT_EQUAL_UINT(MORE, b.news.positions);
    TEST_ASSERT_EQUAL_UINT(MORE, b.s->normal.count);
    TEST_ASSERT_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->stored);
    TEST_ASSERT_TRUE(memcmp(table, b.s->mean, sizeof table) == 0);
    for (unsigned i = 0; i < INVCAL_MAX_POSITIONS; i++) {
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-2, (double)b.mean[i][a], (double)table[i][a]);
        }
    }
    const result found = solve();
    const result expected = calibrate_means(MORE);
    same_solution(&expected, &found);
    is_truth(&found, 5);
    /* the residuals seen stand for all: dof = stored (1 - 9 / used) */
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, INVCAL_MAX_POSITIONS * (1 - 9 / (double)MORE),
                              (double)found.quality.dof);
}

/* ---- outliers -------------------------------------------------------------------------------- */

/* Visits count positions; `wrong` of them is 0.05 g off on the y axis. */
static void visit_with_error(unsigned count, unsigned wrong)
{
    for (unsigned i = 0; i < count; i++) {
        b.bias[1] = i == wrong ? 0.05 : 0;
        visit(expected_plan18[i * 7 % 18]);
    }
    TEST_ASSERT_EQUAL_UINT(count, b.taken);
}

/* invcal_calibrate without position k. */
static result without(unsigned k)
{
    const unsigned count = b.taken;
    invcal_real kept[3];

    memcpy(kept, b.mean[k], sizeof kept);
    memcpy(b.mean[k], b.mean[count - 1], sizeof kept);
    const result r = calibrate_means(count - 1);
    memcpy(b.mean[k], kept, sizeof kept);
    return r;
}

static double largest_error(const result *found)
{
    double largest = 0;

    for (unsigned r = 0; r < 9; r++) {
        largest = fmax(largest, fabs(parameter(&found->solution, r) - b.truth.x[r]));
    }
    return largest;
}

static void a_wrong_position_is_named_and_left_out(void)
{
    for (unsigned wrong = 0; wrong < 18; wrong += 4) { /* 4 x 7: both rows with y and without */
        invcal_outliers outliers;
        result found;
        begin(program(), 0.03, 50 + wrong);
        visit_with_error(18, wrong);
        double u[3];
        reading_of(b.mean[wrong], u);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
        if (fabs(u[1]) < 0.3) {
            continue; /* across the field 0.05 g change the length by 1 mg only */
        }
        TEST_ASSERT_EQUAL_UINT(1, outliers.count);
        TEST_ASSERT_EQUAL_UINT(wrong, outliers.position[0]);
        TEST_ASSERT_TRUE(outliers.removed == (invcal_mask)1 << wrong);
        const result expected = without(wrong);
        same_solution(&expected, &found);
        same_quality(&expected, &found);
        is_truth(&found, 5);

        const result spoiled = solve(); /* outliers null: it stays */
        const result all = calibrate_means(18);
        same_solution(&all, &spoiled);
        TEST_ASSERT_EQUAL_UINT(18, b.s->normal.count);
        TEST_ASSERT_GREATER_THAN_DOUBLE(3e-3, largest_error(&spoiled));
        TEST_ASSERT_LESS_THAN_DOUBLE(3e-4, largest_error(&found));
    }
}

static void without_a_wrong_position_none_is_left_out(void)
{
    invcal_outliers outliers;
    result found;

    begin(program(), 0.03, 56);
    visit_with_error(18, 99);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
    TEST_ASSERT_EQUAL_UINT(0, outliers.count);
    TEST_ASSERT_TRUE(outliers.removed == 0);
    const result expected = calibrate_means(18);
    same_solution(&expected, &found);
    same_quality(&expected, &found);
}

static void among_fewer_than_eleven_no_outlier_is_looked_for(void)
{
    invcal_outliers outliers;
    invcal_outliers none;
    invcal_session_setup setup = free_hand();
    result found;

    setup.settings.noise = (invcal_real)(1e-4 * GRAVITY);
    begin(setup, 0.01, 57);
    follow(9, 0);
    b.bias[2] = 0.05;
    follow(1, 0);
    TEST_ASSERT_EQUAL_UINT(10, b.taken);
    memset(&none, 0, sizeof none);
    memset(&outliers, PATTERN, sizeof outliers);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
    TEST_ASSERT_EQUAL_UINT(0, outliers.count);
    TEST_ASSERT_TRUE(outliers.removed == 0 && outliers.suspected == 0);
    const result expected = calibrate_means(10);
    same_solution(&expected, &found);
    same_quality(&expected, &found);
}

/* Of more positions than the table holds only those in it can be left out. */
static void a_wrong_position_of_the_table_leaves_the_sums_of_all(void)
{
    enum { MORE = INVCAL_MAX_POSITIONS + 6 };
    invcal_outliers outliers;
    result found;

    begin(free_hand(), 0.02, 58);
    for (unsigned i = 0; i < MORE; i++) {
        b.bias[1] = i == 8 ? 0.05 : 0;
        visit(expected_faces_and_edges[(i * 5 + 2) % 18]);
    }
    TEST_ASSERT_EQUAL_UINT(MORE, b.taken);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
    TEST_ASSERT_EQUAL_UINT(1, outliers.count);
    TEST_ASSERT_EQUAL_UINT(8, outliers.position[0]);
    const result expected = without(8);
    same_solution(&expected, &found);
    is_truth(&found, 5);
}

/* ---- the end, and gaps ----------------------------------------------------------------------- */

static void finish_takes_the_position_that_is_held(void)
{
    begin(program(), 0.03, 60);
    visit_plan(0, 17);
    reach(expected_plan18[17]);
    TEST_ASSERT_EQUAL_UINT(17, b.taken);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_FINISHED, finish());
    TEST_ASSERT_EQUAL_UINT(18, b.taken);
    TEST_ASSERT_EQUAL_INT(1, b.news.is_asked);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_MOVING, finish()); /* nothing is held any more */
    TEST_ASSERT_EQUAL_UINT(18, b.s->normal.count);
    const result found = solve();
    const result expected = calibrate_means(18);
    same_solution(&expected, &found);
}

static void finish_takes_nothing_that_is_not_ready(void)
{
    begin(free_hand(), 0, 61);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_MOVING, finish());
    turn(expected_plan18[0]);
    hold(1.3);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_REFUSED, finish());
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_SHORT, b.news.reason);
    TEST_ASSERT_EQUAL_UINT(0, b.s->stored);
}

/* What was READY and drifts away is not held any more: the next rest is a new one. */
static void after_a_refusal_another_rest_is_ready(void)
{
    begin(free_hand(), 0, 63);
    turn(expected_plan18[0]);
    hold(1.7);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_SESSION_READY]);
    b.creep = 0.0032;
    hold(4);
    b.creep = 0;
    TEST_ASSERT_TRUE(b.refused[INVCAL_REST_DRIFT] > 0);
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    visit(expected_plan18[1]);
    TEST_ASSERT_EQUAL_UINT(2, b.seen[INVCAL_SESSION_READY]);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
}

static void a_gap_is_handed_on(void)
{
    begin(free_hand(), 0, 62);
    turn(expected_plan18[0]);
    hold(1);
    invcal_session_gap(b.s);
    hold(0.3);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_GAP]);
    TEST_ASSERT_EQUAL_UINT(0, b.refused[INVCAL_REST_SHORT]);
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
}

/* ---- in the background ----------------------------------------------------------------------- */

/* One more rest of a device that is put down now and then. Returns what came of it. */
static invcal_session_what put_down(const double up[3])
{
    b.news.what = INVCAL_SESSION_NOTHING;
    visit(up);
    return b.news.what;
}

static int is_in_table(const double up[3])
{
    for (unsigned i = 0; i < b.s->stored; i++) {
        double u[3];
        reading_of(b.s->mean[i], u);
        if (dot(u, up) > 0.99 * length3(u)) {
            return 1;
        }
    }
    return 0;
}

/* On its back, on its face, in a holder: day after day. What it once read elsewhere is worth more
 * than all that. */
static void few_directions_do_not_fill_the_table(void)
{
    static const double usual[3][3] = {{0, 0, 1}, {0, 0, -1}, {0.6, 0, 0.8}};
    const double rare[3] = {-0.6, 0.64, 0.48};

    begin(background(), 0.02, 70);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, put_down(rare));
    for (unsigned i = 0; i < 60; i++) {
        (void)put_down(usual[i % 3]);
    }
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SESSION_REFUSED]);
    TEST_ASSERT_TRUE(is_in_table(rare));
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1 + 3 * 5, b.s->stored);
    TEST_ASSERT_GREATER_OR_EQUAL_UINT(45, b.seen[INVCAL_SESSION_COVERED]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_COVERED, b.news.what);
}

/* The same for as many days as a position lives. */
static void a_rare_direction_is_kept_beside_usual_ones_for_weeks(void)
{
    static const double usual[2][3] = {{0, 0, 1}, {0.6, 0, 0.8}};
    const double rare[3] = {-0.6, 0.64, 0.48};

    begin(background(), 0.02, 71);
    (void)put_down(rare);
    for (unsigned day = 0; day < 40; day++) {
        (void)put_down(usual[0]);
        (void)put_down(usual[1]);
        (void)put_down(usual[0]);
        (void)put_down(usual[1]);
        invcal_session_age(b.s);
    }
    TEST_ASSERT_TRUE(is_in_table(rare));
}

static void a_well_covered_direction_is_passed_over_and_a_new_one_is_not(void)
{
    matrix9 k;
    unsigned covered = 0;
    unsigned new = 0;

    begin(background(), 0.02, 72);
    for (unsigned i = 0; i < 150; i++) {
        double up[3];
        random_direction(&b.random, up);
        const invcal_session before = *b.s;
        const double log_det = table_covariance(&before, &k);
        const invcal_session_what what = put_down(up);
        TEST_ASSERT_TRUE(what == INVCAL_SESSION_TAKEN || what == INVCAL_SESSION_COVERED);
        TEST_ASSERT_TRUE(b.news.rest.count > 0);
        invcal_real mean[3];
        for (unsigned a = 0; a < 3; a++) {
            mean[a] = (invcal_real)((double)b.news.rest.sum[a] / (double)b.news.rest.count);
        }
        const double gain = log_det > -20 ? gain_of(&k, mean) : 99;
        if (gain < 0.3) {
            TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_COVERED, what);
            covered++;
        }
        if (gain > 0.42 && before.stored < INVCAL_MAX_POSITIONS) {
            TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, what);
            new ++;
        }
        if (what == INVCAL_SESSION_COVERED) {
            TEST_ASSERT_TRUE(memcmp(before.mean, b.s->mean, sizeof before.mean) == 0);
            TEST_ASSERT_TRUE(memcmp(&before.normal, &b.s->normal, sizeof before.normal) == 0);
            TEST_ASSERT_EQUAL_UINT(before.stored, b.s->stored);
        }
        TEST_ASSERT_EQUAL_UINT(b.s->stored, b.s->normal.count);
    }
    TEST_ASSERT_TRUE(covered >= 30 && new >= 20);
    const result found = solve();
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, found.quality.verdict);
    is_truth(&found, 5);
    (void)table_covariance(b.s, &k);
    TEST_ASSERT_LESS_THAN_DOUBLE(1.8, worst_root(&k));
}

/* Where the table of `s` holds this mean; s->stored if nowhere. Its order means nothing. */
static unsigned place_of(const invcal_session *s, const invcal_real mean[3])
{
    unsigned i = 0;

    while (i < s->stored && memcmp(s->mean[i], mean, sizeof s->mean[0]) != 0) {
        i++;
    }
    return i;
}

/* The first position of the table of `s` that is not in that of `other`; s->stored if all are. */
static unsigned missing(const invcal_session *s, const invcal_session *other)
{
    unsigned i = 0;

    while (i < s->stored && place_of(other, s->mean[i]) < other->stored) {
        i++;
    }
    return i;
}

/* The one dropped tells hardly more than the least of those that were there, beside the new one;
 * those are still there, with their ages. */
static void is_least_telling(const invcal_session *before)
{
    const unsigned dropped = missing(before, b.s);
    const unsigned added = missing(b.s, before);
    matrix9 k = {{{0}}};
    double least = INFINITE;

    TEST_ASSERT_LESS_THAN_UINT(before->stored, dropped);
    TEST_ASSERT_LESS_THAN_UINT(b.s->stored, added);
    TEST_ASSERT_EQUAL_UINT(0, b.s->age[added]);
    for (unsigned i = 0; i < before->stored; i++) {
        add_row(&k, before->mean[i], pow(31.0 / 32, before->age[i]));
    }
    add_row(&k, b.s->mean[added], 1);
    (void)invert(&k);
    for (unsigned i = 0; i < before->stored; i++) {
        least = fmin(least, pow(31.0 / 32, before->age[i]) * gain_of(&k, before->mean[i]));
    }
    const double weight = pow(31.0 / 32, before->age[dropped]);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1.6 * least, weight * gain_of(&k, before->mean[dropped]));
    for (unsigned i = 0; i < before->stored; i++) {
        const unsigned now = place_of(b.s, before->mean[i]);
        TEST_ASSERT_EQUAL_INT(i == dropped, now == b.s->stored);
        if (i != dropped) {
            TEST_ASSERT_EQUAL_UINT(before->age[i], b.s->age[now]);
        }
    }
}

static void a_full_table_drops_what_tells_least(void)
{
    matrix9 k;
    unsigned replaced = 0;

    begin(background(), 0.02, 73);
    b.rest_time = 2;
    for (unsigned i = 0; i < 250; i++) {
        double up[3];
        random_direction(&b.random, up);
        const invcal_session before = *b.s;
        const double log_det = table_covariance(&before, &k);
        const double root = worst_root(&k);
        const invcal_session_what what = put_down(up);
        TEST_ASSERT_LESS_OR_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->stored);
        if (what == INVCAL_SESSION_TAKEN && before.stored == INVCAL_MAX_POSITIONS) {
            replaced++;
            TEST_ASSERT_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->stored);
            is_least_telling(&before);
            TEST_ASSERT_GREATER_THAN_DOUBLE(log_det - 1e-3, table_covariance(b.s, &k));
            TEST_ASSERT_LESS_THAN_DOUBLE(1.15 * root, worst_root(&k));
        }
        if (i % 4 == 3) {
            invcal_session_age(b.s);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(20, replaced);
    const result found = solve();
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, found.quality.verdict);
    is_truth(&found, 5);
}

/* Four circles of eight positions about the pole. It is new enough, h K h' = 0.363; but once it is
 * among them it tells 0.266, and each of the others 0.273 or more. */
static void a_full_table_of_what_tells_more_stays_as_it_is(void)
{
    static const double height[4] = {0.738, 0.155, -0.212, -0.803};
    const double pole[3] = {0, 0, 1};
    invcal_real mean[3];
    matrix9 k;

    if (INVCAL_MAX_POSITIONS != 32) {
        TEST_IGNORE_MESSAGE("stated for a table of 32");
    }
    begin(background(), 0, 74);
    b.rest_time = 2;
    for (unsigned i = 0; i < 32; i++) {
        const double angle = 6.283185307179586 * (i % 8 + i / 8 % 2 * 0.5) / 8;
        const double z = height[i / 8];
        const double up[3] = {sqrt(1 - z * z) * cos(angle), sqrt(1 - z * z) * sin(angle), z};
        TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, put_down(up));
    }
    const invcal_session before = *b.s;
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_COVERED, put_down(pole));
    TEST_ASSERT_EQUAL_UINT(32, b.s->stored);
    TEST_ASSERT_TRUE(memcmp(before.mean, b.s->mean, sizeof before.mean) == 0);
    TEST_ASSERT_TRUE(memcmp(before.age, b.s->age, sizeof before.age) == 0);
    TEST_ASSERT_TRUE(memcmp(&before.normal, &b.s->normal, sizeof before.normal) == 0);
    /* and these are the figures */
    for (unsigned a = 0; a < 3; a++) {
        mean[a] = (invcal_real)((double)b.news.rest.sum[a] / (double)b.news.rest.count);
    }
    (void)table_covariance(&before, &k);
    TEST_ASSERT_DOUBLE_WITHIN(0.005, 0.363, gain_of(&k, mean));
    memset(&k, 0, sizeof k);
    for (unsigned i = 0; i < 32; i++) {
        add_row(&k, before.mean[i], 1);
    }
    add_row(&k, mean, 1);
    (void)invert(&k);
    for (unsigned i = 0; i < 32; i++) {
        TEST_ASSERT_GREATER_THAN_DOUBLE(gain_of(&k, mean) + 0.003, gain_of(&k, before.mean[i]));
    }
}

static double trace_of(const invcal_normal *normal)
{
    double sum = 0;

    for (unsigned r = 0; r < 9; r++) {
        sum += element(normal, r, r);
    }
    return sum;
}

/* Each day takes 1/32: after 88 a sixteenth is left, and after 89 nothing. */
static void positions_fade_and_vanish(void)
{
    begin(background(), 0.02, 74);
    for (unsigned i = 0; i < 18; i++) {
        (void)put_down(expected_faces_and_edges[i * 5 % 18]);
    }
    const unsigned stored = b.s->stored;
    TEST_ASSERT_TRUE(stored >= 12);
    const double fresh = trace_of(&b.s->normal);
    const double jtj = (double)b.s->normal.jtj;
    const result at_first = solve();
    for (unsigned day = 1; day <= 88; day++) {
        invcal_session_age(b.s);
        const double faded = pow(31.0 / 32, day);
        TEST_ASSERT_EQUAL_UINT(stored, b.s->stored);
        TEST_ASSERT_EQUAL_UINT(stored, b.s->normal.count);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, faded, trace_of(&b.s->normal) / fresh);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, faded, (double)b.s->normal.jtj / jtj);
    }
    /* all alike: the solution is the same. Their noise is that of readings that count less */
    const result found = solve();
    same_solution(&at_first, &found);
    invcal_session_age(b.s);
    TEST_ASSERT_EQUAL_UINT(0, b.s->stored);
    TEST_ASSERT_EQUAL_UINT(0, b.s->normal.count);
    is_refused(INVCAL_TOO_FEW, NULL);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, put_down(expected_plan18[0]));
    TEST_ASSERT_EQUAL_UINT(1, b.s->stored);
}

/* Two batches, ten days apart. */
static void old_positions_vanish_and_younger_ones_stay(void)
{
    invcal_real younger[6][3];

    begin(background(), 0.02, 75);
    for (unsigned i = 0; i < 6; i++) {
        (void)put_down(expected_faces_and_edges[i * 5 % 18]);
    }
    for (unsigned day = 0; day < 10; day++) {
        invcal_session_age(b.s);
    }
    for (unsigned i = 6; i < 12; i++) {
        (void)put_down(expected_faces_and_edges[i * 5 % 18]);
    }
    TEST_ASSERT_EQUAL_UINT(12, b.s->stored);
    memcpy(younger, &b.s->mean[6], sizeof younger);
    for (unsigned day = 10; day < 88; day++) {
        invcal_session_age(b.s);
    }
    TEST_ASSERT_EQUAL_UINT(12, b.s->stored);
    invcal_session_age(b.s);
    TEST_ASSERT_EQUAL_UINT(6, b.s->stored);
    TEST_ASSERT_EQUAL_UINT(6, b.s->normal.count);
    double expected = 0;
    for (unsigned i = 0; i < 6; i++) {
        const unsigned now = place_of(b.s, younger[i]);
        TEST_ASSERT_LESS_THAN_UINT(6, now);
        TEST_ASSERT_EQUAL_UINT(79, b.s->age[now]);
        double u[3];
        double h[9];
        reading_of(younger[i], u);
        row_of(u, h);
        for (unsigned r = 0; r < 9; r++) {
            expected += pow(31.0 / 32, 79) * h[r] * h[r];
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1, trace_of(&b.s->normal) / expected);
}

/* Weighted least squares of what the table holds, by its ages, without one of its positions. */
static result calibrate_table(unsigned without_this)
{
    const invcal_mask left_out = without_this < b.s->stored ? (invcal_mask)1 << without_this : 0;
    const invcal_positions positions = {&b.s->mean[0][0], b.s->age, b.s->stored, left_out};
    invcal_normal normal;
    result r;

    invcal_normal_init(&normal);
    for (unsigned i = 0; i < b.s->stored; i++) {
        double u[3];
        invcal_observation row;
        reading_of(b.s->mean[i], u);
        const invcal_real v[3] = {(invcal_real)u[0], (invcal_real)u[1], (invcal_real)u[2]};
        const invcal_real weight = (invcal_real)pow(31.0 / 32, b.s->age[i]);
        if (i == without_this) {
            continue;
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_observation_exact(v, &row));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_normal_add(&normal, &row, weight));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_calibrate_sums(&normal, &positions, &b.setup.settings,
                                                           &r.solution, &r.quality));
    return r;
}

/* Half of the positions have lost half of their weight, and of these one is wrong. */
static void a_wrong_position_that_has_faded_is_left_out(void)
{
    invcal_outliers outliers;
    result found;
    unsigned wrong = 0;

    begin(background(), 0.02, 79);
    for (unsigned i = 0; i < 18; i++) {
        b.bias[0] = i == 5 ? 0.05 : 0; /* the position + x - z */
        (void)put_down(expected_faces_and_edges[i * 5 % 18]);
        wrong = i == 5 ? b.s->stored - 1u : wrong;
        for (unsigned day = 0; i == 8 && day < 22; day++) {
            invcal_session_age(b.s);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(11, b.s->stored);
    TEST_ASSERT_EQUAL_UINT(0, b.s->age[b.s->stored - 1u]);
    TEST_ASSERT_LESS_THAN_UINT(b.s->stored, wrong);
    TEST_ASSERT_EQUAL_UINT(22, b.s->age[wrong]);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, try_solve(&found, &outliers));
    TEST_ASSERT_EQUAL_UINT(1, outliers.count);
    TEST_ASSERT_EQUAL_UINT(wrong, outliers.position[0]);
    const result expected = calibrate_table(wrong);
    same_solution(&expected, &found);
    same_quality(&expected, &found);
    is_truth(&found, 5);
}

static void a_day(unsigned rests)
{
    for (unsigned i = 0; i < rests; i++) {
        double up[3];
        random_direction(&b.random, up);
        reach(up);
    }
    invcal_session_age(b.s);
}

static void a_drift_is_followed(void)
{
    invcal_session_setup setup = background();

    setup.rate = 40;
    begin(setup, 0.02, 76);
    b.rest_time = 2.2;
    for (unsigned day = 0; day < 20; day++) {
        a_day(6);
    }
    const result before = solve();
    is_truth(&before, 5);
    b.truth.x[0] += 5e-3;
    for (unsigned day = 0; day < 5; day++) {
        a_day(6);
    }
    const result meanwhile = solve();
    const result weighted = calibrate_table(INVCAL_MAX_POSITIONS);
    same_solution(&weighted, &meanwhile);
    same_quality(&weighted, &meanwhile);
    TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&meanwhile.quality, &before.quality));
    for (unsigned day = 5; day < 90; day++) {
        a_day(6);
    }
    const result after = solve();
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, after.quality.verdict);
    is_truth(&after, 5);
    TEST_ASSERT_LESS_THAN_DOUBLE(4e-4, largest_error(&after));
    TEST_ASSERT_EQUAL_INT(1, invcal_session_improves(&after.quality, &meanwhile.quality));
}

static void in_a_procedure_nothing_ages(void)
{
    invcal_session before;

    begin(free_hand(), 0.02, 77);
    visit_plan(0, 10);
    memcpy(&before, b.s, sizeof before);
    for (unsigned day = 0; day < 100; day++) {
        invcal_session_age(b.s);
    }
    TEST_ASSERT_TRUE(memcmp(&before, b.s, sizeof before) == 0);
}

/* ---- which is the better one ----------------------------------------------------------------- */

static invcal_real *sigma_at(invcal_quality *q, unsigned r)
{
    return r < 3 ? &q->sigma_delta[r] : r < 6 ? &q->sigma_dk[r - 3] : &q->sigma_gamma[r - 6];
}

static invcal_quality quality_of(invcal_verdict verdict, double sigma)
{
    invcal_quality q;

    memset(&q, 0, sizeof q);
    q.verdict = verdict;
    q.coverage = 2;
    for (unsigned r = 0; r < 9; r++) {
        *sigma_at(&q, r) = (invcal_real)sigma;
    }
    return q;
}

static void the_better_one_is_no_worse_in_verdict_and_smaller_in_sigma(void)
{
    static const invcal_verdict verdict[3] = {INVCAL_GOOD, INVCAL_NO_REDUNDANCY, INVCAL_WEAK};

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned k = 0; k < 3; k++) {
            const invcal_quality small = quality_of(verdict[i], 1e-4);
            const invcal_quality like = quality_of(verdict[k], 1e-4);
            const invcal_quality large = quality_of(verdict[k], 2e-4);
            TEST_ASSERT_EQUAL_INT(i <= k, invcal_session_improves(&small, &large));
            TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&large, &small));
            TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&small, &like));
        }
    }
}

static void every_sigma_counts_with_its_square(void)
{
    const invcal_quality present = quality_of(INVCAL_GOOD, 1e-4);

    for (unsigned r = 0; r < 9; r++) {
        invcal_quality found = present;
        *sigma_at(&found, r) = INVCAL_REAL(0.9e-4);
        TEST_ASSERT_EQUAL_INT(1, invcal_session_improves(&found, &present));
        *sigma_at(&found, r) = INVCAL_REAL(1.1e-4);
        TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&found, &present));
        /* 1.2^2 + 0.8^2 = 2.08, though 1.2 + 0.8 = 2 */
        *sigma_at(&found, r) = INVCAL_REAL(1.2e-4);
        *sigma_at(&found, (r + 4) % 9) = INVCAL_REAL(0.8e-4);
        TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&found, &present));
        *sigma_at(&found, (r + 4) % 9) = INVCAL_REAL(0.7e-4);
        TEST_ASSERT_EQUAL_INT(1, invcal_session_improves(&found, &present));
        *sigma_at(&found, r) = (invcal_real)NOT_A_NUMBER;
        TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&found, &present));
    }
}

static void a_sigma_that_is_small_by_luck_does_not_win(void)
{
    const invcal_quality present = quality_of(INVCAL_GOOD, 1e-4);
    invcal_quality lucky = quality_of(INVCAL_GOOD, 0.5e-4);

    lucky.coverage = (invcal_real)12.7; /* Student's t of one residual */
    TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&lucky, &present));
    TEST_ASSERT_EQUAL_INT(1, invcal_session_improves(&present, &lucky));
}

static void another_nominal_calibration_makes_the_sums_anew(void)
{
    begin(program(), 0.02, 79);
    visit_plan(0, 18);
    invcal_session before = *b.s;
    const result expected = solve();
    invcal_calibration nominal = b.setup.settings.nominal;
    for (unsigned i = 0; i < 3; i++) {
        nominal.offset[i] += 400;
        nominal.matrix[i][i] *= INVCAL_REAL(1.03);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_renew(b.s, &nominal));
    const result renewed = solve();
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(0.1, 1e-4),
                                  (double)expected.solution.calibration.offset[i],
                                  (double)renewed.solution.calibration.offset[i]);
    }
    nominal.matrix[2][2] = 0;
    before = *b.s;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_SETTING, invcal_session_renew(b.s, &nominal));
    TEST_ASSERT_EQUAL_MEMORY(&before, b.s, sizeof before);
    nominal.matrix[2][2] = nominal.matrix[0][0];
    nominal.offset[0] += 1000000;
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, invcal_session_renew(b.s, &nominal));
    TEST_ASSERT_EQUAL_MEMORY(&before, b.s, sizeof before);
    b.s->normal.count = b.s->stored + 1u;
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_session_renew(b.s, &b.setup.settings.nominal));
}

static void more_positions_make_the_better_one(void)
{
    begin(program(), 0.02, 78);
    visit_plan(0, 18);
    const result eighteen = solve();
    begin(program(), 0.02, 78);
    visit_plan(0, 36);
    const result more = solve();
    TEST_ASSERT_EQUAL_INT(1, invcal_session_improves(&more.quality, &eighteen.quality));
    TEST_ASSERT_EQUAL_INT(0, invcal_session_improves(&eighteen.quality, &more.quality));
}

/* ---- temperature ----------------------------------------------------------------------------- */

/* Each position at one temperature, which does not change before it is closed. */
static void visit_at(const double *temperature, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        turn(expected_plan18[i]);
        b.temperature = (invcal_real)temperature[i];
        hold(b.rest_time);
        leave();
        TEST_ASSERT_EQUAL_UINT(i + 1, b.taken);
    }
}

static void temperatures_are(double mean, double coldest, double warmest)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, mean, (double)b.s->temperature);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, coldest, (double)b.s->coldest);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, warmest, (double)b.s->warmest);
}

static void the_session_knows_how_warm_it_was(void)
{
    const double warm[6] = {21.5, 24, 22.25, 30.75, 25.5, 23};
    const double cold[4] = {-12, -3.5, -20.5, -8};

    begin(free_hand(), 0.02, 80);
    visit_at(warm, 6);
    temperatures_are(24.5, 21.5, 30.75); /* 147 / 6 */
    begin(free_hand(), 0.02, 81);
    visit_at(cold, 4);
    temperatures_are(-11, -20.5, -3.5);
}

static void a_temperature_that_is_none_changes_nothing(void)
{
    const double temperature[5] = {20, NOT_A_NUMBER, 26, NOT_A_NUMBER, 29};

    begin(free_hand(), 0.02, 82);
    visit_at(temperature, 2);
    temperatures_are(20, 20, 20);
    begin(free_hand(), 0.02, 82);
    visit_at(temperature, 5);
    temperatures_are(25, 20, 29); /* 75 / 3 */
}

static void a_temperature_too_large_for_a_mean_changes_nothing(void)
{
    const double most = (double)INVCAL_REAL_MAX;
    const double temperature[4] = {most, -most, INFINITE, most};

    begin(free_hand(), 0.02, 84);
    visit_at(temperature, 4);
    temperatures_are(most, most, most);
}

static void the_first_temperature_need_not_come_with_the_first_position(void)
{
    const double temperature[4] = {NOT_A_NUMBER, 20, 26, 29};

    begin(free_hand(), 0.02, 83);
    visit_at(temperature, 4);
    temperatures_are(25, 20, 29);
}

/* The position that is held at the end has no sample after it. */
static void finish_does_not_spoil_the_temperature(void)
{
    const double temperature[2] = {24, 26};

    begin(free_hand(), 0.02, 84);
    visit_at(temperature, 2);
    b.temperature = 25;
    reach(expected_plan18[5]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, finish());
    temperatures_are(25, 24, 26);

    begin(free_hand(), 0.02, 85);
    b.temperature = 25;
    reach(expected_plan18[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, finish());
    leave();
    visit(expected_plan18[3]);
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    temperatures_are(25, 25, 25);
}

static void in_the_background_temperatures_count_for_what_is_taken(void)
{
    begin(background(), 0.02, 86);
    b.temperature = 30;
    for (unsigned i = 0; i < 60 && b.seen[INVCAL_SESSION_COVERED] == 0; i++) {
        (void)put_down(expected_faces_and_edges[i * 5 % 18]);
    }
    TEST_ASSERT_TRUE(b.seen[INVCAL_SESSION_COVERED] > 0);
    temperatures_are(30, 30, 30);
    b.temperature = 50;
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_COVERED, put_down(expected_faces_and_edges[0]));
    temperatures_are(30, 30, 30);
}

/* The mean is over the positions that are there. */
static void temperatures_fade_with_their_positions(void)
{
    begin(background(), 0.02, 87);
    b.temperature = 30;
    for (unsigned i = 0; i < 3; i++) {
        (void)put_down(expected_faces_and_edges[i]);
    }
    temperatures_are(30, 30, 30);
    for (unsigned day = 0; day < 100; day++) {
        invcal_session_age(b.s);
    }
    TEST_ASSERT_EQUAL_UINT(0, b.s->stored);
    b.temperature = 20;
    TEST_ASSERT_EQUAL_INT(INVCAL_SESSION_TAKEN, put_down(expected_faces_and_edges[4]));
    temperatures_are(20, 20, 20);
}

/* ---- the setup ------------------------------------------------------------------------------- */

static void is_setup(invcal_status expected, const invcal_session_setup *setup)
{
    static invcal_session session;
    static invcal_session before;

    memset(&before, PATTERN, sizeof before);
    memcpy(&session, &before, sizeof session);
    TEST_ASSERT_EQUAL_INT(expected, invcal_session_init(&session, setup));
    TEST_ASSERT_EQUAL_INT(expected != INVCAL_OK, memcmp(&before, &session, sizeof session) == 0);
}

static void unusable_targets_are_refused(void)
{
    static const double bad[] = {-1e-6, -1, NOT_A_NUMBER, INFINITE, -INFINITE};

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (unsigned k = 0; k < 3; k++) {
            invcal_session_setup setup = free_hand();
            setup.target[k] = (invcal_real)bad[i];
            is_setup(INVCAL_BAD_SETTING, &setup);
        }
    }
    invcal_session_setup setup = free_hand();
    setup.target[0] = INVCAL_REAL(1e-4);
    is_setup(INVCAL_OK, &setup);
}

static void unusable_programs_are_refused(void)
{
    invcal_session_setup setup = program();

    for (unsigned n = 1; n < 5; n++) {
        setup.plan.per_group = n;
        is_setup(INVCAL_TOO_FEW, &setup);
    }
    setup.plan.per_group = 5;
    is_setup(INVCAL_OK, &setup);
    setup.plan.per_group = 1000;
    is_setup(INVCAL_OK, &setup);
    setup.plan.per_group = 1001;
    is_setup(INVCAL_BAD_SETTING, &setup);
    for (unsigned k = 0; k < 3; k++) {
        setup = program();
        setup.plan.start[k] = (invcal_real)NOT_A_NUMBER;
        is_setup(INVCAL_BAD_SETTING, &setup);
        setup.plan.start[k] = 361;
        is_setup(INVCAL_BAD_SETTING, &setup);
    }
    setup = free_hand();
    setup.plan.start[1] = 999; /* no program: its angles do not matter */
    is_setup(INVCAL_OK, &setup);
}

static void unusable_streams_are_refused(void)
{
    static const double bad_rate[] = {0, 7.9, 8001, -100, NOT_A_NUMBER, INFINITE};
    static const int32_t rails[][2] = {{5, 5}, {7, -7}, {1, 0}, {INT32_MAX, INT32_MIN}};
    invcal_session_setup setup = free_hand();

    for (unsigned i = 0; i < sizeof bad_rate / sizeof bad_rate[0]; i++) {
        setup.rate = (invcal_real)bad_rate[i];
        is_setup(INVCAL_BAD_SETTING, &setup);
    }
    setup.rate = 8;
    is_setup(INVCAL_OK, &setup);
    setup.rate = 8000;
    is_setup(INVCAL_OK, &setup);
    for (unsigned i = 0; i < sizeof rails / sizeof rails[0]; i++) {
        setup.low = rails[i][0];
        setup.high = rails[i][1];
        is_setup(INVCAL_BAD_SETTING, &setup);
    }
    setup.low = -32768;
    setup.high = 32767;
    is_setup(INVCAL_OK, &setup);
}

static void unusable_settings_are_refused(void)
{
    invcal_session_setup setup = free_hand();

    setup.settings.field = 0;
    is_setup(INVCAL_BAD_SETTING, &setup);
    setup = program();
    setup.settings.nominal.matrix[1][1] = 0;
    is_setup(INVCAL_BAD_SETTING, &setup);
    setup = background();
    setup.settings.nominal.offset[2] = (invcal_real)NOT_A_NUMBER;
    is_setup(INVCAL_BAD_SETTING, &setup);
    setup = free_hand();
    setup.settings.prior[0] = INVCAL_REAL(0.01); /* without noise */
    is_setup(INVCAL_BAD_SETTING, &setup);
    setup.settings.noise = INVCAL_REAL(0.001);
    is_setup(INVCAL_OK, &setup);
}

static void to_begin_again_forgets_everything(void)
{
    static invcal_session fresh;

    begin(program(), 0.02, 90);
    memset(&fresh, 0, sizeof fresh);
    memcpy(&fresh, b.s, sizeof fresh);
    b.temperature = 33;
    visit_plan(0, 12);
    TEST_ASSERT_FALSE(memcmp(&fresh, b.s, sizeof fresh) == 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(b.s, &b.setup));
    TEST_ASSERT_EQUAL_UINT(0, b.s->stored);
    TEST_ASSERT_EQUAL_UINT(0, b.s->normal.count);
    TEST_ASSERT_TRUE(b.s->temperature >= 0 && b.s->temperature <= 0);
    is_refused(INVCAL_TOO_FEW, NULL);
    b.taken = 0;
    next_is(expected_plan18[0]);
    visit_plan(0, 1); /* where the first stream ended does not matter */
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
}

/* ---- the structure --------------------------------------------------------------------------- */

/* Copies the session elsewhere and wipes where it was. */
static void move(void)
{
    invcal_session *to = b.s == &b.room[0] ? &b.room[1] : &b.room[0];

    memcpy(to, b.s, sizeof *to);
    memset(b.s, 0xEE, sizeof *b.s);
    b.s = to;
}

static result moved(invcal_session_setup setup, int moves)
{
    begin(setup, 0.02, 91);
    for (unsigned i = 0; i < 14; i++) {
        turn(expected_plan18[i]);
        if (moves) {
            move();
        }
        hold(0.63);
        if (moves) {
            move();
        }
        hold(1.7);
    }
    (void)finish();
    return solve();
}

static void a_session_may_be_moved_at_any_time(void)
{
    for (int i = 0; i < 2; i++) {
        const result stayed = moved(i ? background() : program(), 0);
        const uint64_t events = b.checksum;
        const unsigned taken = b.taken;
        const result went = moved(i ? background() : program(), 1);
        TEST_ASSERT_EQUAL_UINT(14, taken);
        TEST_ASSERT_TRUE(events == b.checksum);
        for (unsigned r = 0; r < 9; r++) {
            TEST_ASSERT_TRUE(memcmp(&stayed.solution, &went.solution, sizeof went.solution) == 0);
        }
    }
}

static void a_session_is_small(void)
{
#if !INVCAL_DOUBLE && INVCAL_MAX_POSITIONS == 32
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1100, sizeof(invcal_session));
#else
    /* numbers are twice as long; nothing else is */
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1100 * sizeof(invcal_real) / 4 +
                                       (INVCAL_MAX_POSITIONS > 32) * 32 *
                                           (3 * sizeof(invcal_real) + 1),
                                   sizeof(invcal_session));
#endif
}

/* ---- hostile input --------------------------------------------------------------------------- */

static int32_t any_count(void)
{
    return (int32_t)floor(random_uniform(&b.random, -2147483648.0, 2147483647.0));
}

/* Noise, extremes, constants, steps, and rests that would be good ones but for their size. */
static void hostile_sample(unsigned i, int32_t raw[3])
{
    static const int32_t extreme[4] = {INT32_MIN, INT32_MAX, INT32_MIN + 1, 0};
    const unsigned kind = i / 700 % 6;

    for (unsigned a = 0; a < 3; a++) {
        raw[a] = kind == 0   ? any_count()
                 : kind == 1 ? extreme[(i + a) % 4]
                 : kind == 2
                     ? extreme[(i / 700 + a) % 2] - (a && i / 700 % 2 ? (int32_t)(i % 3) : 0)
                 : kind == 3 ? (int32_t)(1u << (i / 97 % 31)) - (int32_t)(i % 2)
                 : kind == 4
                     ? b.last[a] / 2 * 2 + (int32_t)(i % 2)
                     : (int32_t)(16000 * (int32_t)(i / 350 % 7 == a)) + (int32_t)(i * (a + 1) % 5);
    }
    if (kind == 2 && i / 700 % 2) { /* INT32_MIN - 1 is none */
        raw[0] = INT32_MAX - (int32_t)(i % 3);
        raw[1] = INT32_MAX - (int32_t)(i % 5);
        raw[2] = INT32_MIN + (int32_t)(i % 7);
    }
}

/* All that was taken reads between 0.1 and 10 times the field. */
static void means_are_sane(double counts)
{
    for (unsigned i = 0; i < b.taken; i++) {
        double u[3];
        for (unsigned a = 0; a < 3; a++) {
            u[a] = ((double)b.mean[i][a] - zero[a]) / counts;
        }
        TEST_ASSERT_TRUE(length3(u) > 0.0999 && length3(u) < 10.001);
    }
}

static void hostile_stream(invcal_session_setup setup, double counts, unsigned samples)
{
    static const double temperature[4] = {NOT_A_NUMBER, INFINITE, -300, 25};
    invcal_guidance guidance;
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;
    int32_t raw[3];

    for (unsigned a = 0; a < 3; a++) {
        setup.settings.nominal.matrix[a][a] = (invcal_real)(GRAVITY / counts);
    }
    begin(setup, 0, 92);
    for (unsigned i = 0; i < samples && b.taken + 1 < RECORDED; i++) {
        hostile_sample(i, raw);
        b.temperature = (invcal_real)temperature[i / 1000 % 4];
        feed(raw);
        if (i % 9973 == 0) {
            invcal_session_gap(b.s);
            invcal_session_age(b.s);
            (void)finish();
            (void)invcal_session_next(b.s, &guidance);
            (void)invcal_session_solve(b.s, &solution, &quality, &outliers);
        }
    }
    TEST_ASSERT_LESS_OR_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->stored);
    means_are_sane(counts);
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        TEST_ASSERT_TRUE(fabs((double)b.s->normal.moment[i]) < 1e4 * (b.taken + 1));
    }
    TEST_ASSERT_EQUAL_UINT(b.setup.background ? b.s->stored : b.taken, b.s->normal.count);
}

static void hostile_input_does_no_harm(void)
{
    static const double rates[4] = {8, 100, 1000, 8000};
    static const double counts[2] = {COUNTS, 1073741824.0};

    for (unsigned i = 0; i < 16; i++) {
        invcal_session_setup setup = i / 8 ? background() : program();
        setup.rate = (invcal_real)rates[i % 4];
        hostile_stream(setup, counts[i / 4 % 2], i % 4 == 1 ? 100000 : 20000);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_program_is_followed_to_its_end);
    RUN_TEST(its_calibration_is_the_truth_and_that_of_the_means);
    RUN_SLOW_TEST(what_comes_after_the_program_is_taken_too);
    RUN_TEST(a_position_that_was_not_asked_counts_but_is_asked_again);
    RUN_TEST(while_another_position_is_held_the_same_one_is_asked_for);
    RUN_TEST(twenty_degrees_are_near_enough);
    RUN_TEST(advice_followed_determines_everything);
    RUN_LONG_TEST(a_hand_that_errs_by_ten_degrees_does_hardly_worse);
    RUN_SLOW_TEST(free_hand_the_best_and_nearest_is_next);
    RUN_TEST(free_hand_a_position_that_is_ready_counts_as_taken);
    RUN_TEST(a_rest_settles_is_ready_once_and_is_taken);
    RUN_TEST(the_noise_of_the_first_rest_tells_how_long_to_stay);
    RUN_TEST(more_noise_takes_the_square_of_the_time);
    RUN_TEST(no_noise_makes_a_rest_longer_than_a_minute);
    RUN_TEST(who_leaves_too_early_is_told_and_the_position_is_not_taken);
    RUN_TEST(progress_grows_to_the_time_that_is_wanted);
    RUN_TEST(progress_ends_at_99);
    RUN_TEST(a_time_may_be_demanded_in_place_of_it);
    RUN_TEST(in_the_background_nobody_waits);
    RUN_TEST(while_it_is_too_short_the_next_position_stays_the_same);
    RUN_TEST(between_the_events_there_is_nothing);
    RUN_TEST(events_are_complete);
    RUN_TEST(a_position_taken_tells_of_its_rest);
    RUN_TEST(the_refusals_of_still_are_handed_on);
    RUN_TEST(what_lies_at_the_rails_is_refused);
    RUN_TEST(a_mean_that_is_no_reading_of_the_field_is_refused_at_once);
    RUN_SLOW_TEST(enough_is_said_once_when_sigma_is_within_the_target);
    RUN_TEST(a_calibration_that_nothing_checks_is_not_enough);
    RUN_SLOW_TEST(without_a_target_nothing_is_enough);
    RUN_SLOW_TEST(a_target_out_of_reach_is_never_met);
    RUN_TEST(too_few_positions_are_refused);
    RUN_TEST(one_position_is_enough_with_a_prior);
    RUN_TEST(positions_on_a_plane_are_refused);
    RUN_TEST(positions_on_a_plane_and_a_prior_are_solved_with_outliers_or_without);
    RUN_SLOW_TEST(a_solution_does_not_stop_the_session);
    RUN_SLOW_TEST(more_positions_than_the_table_holds_go_into_the_sums);
    RUN_SLOW_TEST(a_wrong_position_is_named_and_left_out);
    RUN_TEST(without_a_wrong_position_none_is_left_out);
    RUN_TEST(among_fewer_than_eleven_no_outlier_is_looked_for);
    RUN_SLOW_TEST(a_wrong_position_of_the_table_leaves_the_sums_of_all);
    RUN_SLOW_TEST(finish_takes_the_position_that_is_held);
    RUN_TEST(finish_takes_nothing_that_is_not_ready);
    RUN_TEST(after_a_refusal_another_rest_is_ready);
    RUN_TEST(a_gap_is_handed_on);
    RUN_LONG_TEST(few_directions_do_not_fill_the_table);
    RUN_LONG_TEST(a_rare_direction_is_kept_beside_usual_ones_for_weeks);
    RUN_LONG_TEST(a_well_covered_direction_is_passed_over_and_a_new_one_is_not);
    RUN_LONG_TEST(a_full_table_drops_what_tells_least);
    RUN_SLOW_TEST(a_full_table_of_what_tells_more_stays_as_it_is);
    RUN_SLOW_TEST(positions_fade_and_vanish);
    RUN_TEST(old_positions_vanish_and_younger_ones_stay);
    RUN_SLOW_TEST(a_wrong_position_that_has_faded_is_left_out);
    RUN_LONG_TEST(a_drift_is_followed);
    RUN_TEST(in_a_procedure_nothing_ages);
    RUN_TEST(the_better_one_is_no_worse_in_verdict_and_smaller_in_sigma);
    RUN_TEST(every_sigma_counts_with_its_square);
    RUN_TEST(a_sigma_that_is_small_by_luck_does_not_win);
    RUN_SLOW_TEST(another_nominal_calibration_makes_the_sums_anew);
    RUN_SLOW_TEST(more_positions_make_the_better_one);
    RUN_TEST(the_session_knows_how_warm_it_was);
    RUN_TEST(a_temperature_that_is_none_changes_nothing);
    RUN_TEST(a_temperature_too_large_for_a_mean_changes_nothing);
    RUN_TEST(the_first_temperature_need_not_come_with_the_first_position);
    RUN_TEST(finish_does_not_spoil_the_temperature);
    RUN_SLOW_TEST(in_the_background_temperatures_count_for_what_is_taken);
    RUN_TEST(temperatures_fade_with_their_positions);
    RUN_TEST(unusable_targets_are_refused);
    RUN_TEST(unusable_programs_are_refused);
    RUN_TEST(unusable_streams_are_refused);
    RUN_TEST(unusable_settings_are_refused);
    RUN_SLOW_TEST(to_begin_again_forgets_everything);
    RUN_SLOW_TEST(a_session_may_be_moved_at_any_time);
    RUN_TEST(a_session_is_small);
    RUN_SLOW_TEST(hostile_input_does_no_harm);
    return UNITY_END() != 0;
}
