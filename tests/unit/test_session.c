/* SPDX-License-Identifier: MIT
 *
 * A simulated sensor is turned and held like a real one; its calibration must be true.
 */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "invcal/plan.h"
#include "invcal/store.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a simulated sensor, and a record of what its session says ------------------------------- */

#define COUNTS 16384.0 /* per g */
#define RATE SLOW(100.0, 50.0)
#define NOISE 5e-4 /* g, of a sample on each axis */

enum { EVENTS = INVCAL_REFUSED + 1, DAYS = 88 };

static const double zero[3] = {120, -340, 51}; /* counts of the nominal sensor in no field */

typedef struct {
    invcal_background background; /* contains the session; used as a whole if is_background */
    invcal_session *s;
    int is_background;
    /* the sensor */
    triad_truth truth;
    double noise;   /* g */
    double bias[3]; /* g: a magnet, a hand on the case */
    double rate;    /* samples per second */
    double creep;   /* g/s on the x axis */
    double up[3];   /* its orientation */
    double rest_time;
    int32_t rail; /* counts; 0: none */
    random_source random;
    /* its events */
    unsigned seen[EVENTS];
    unsigned refused[INVCAL_STATUS_END];
    unsigned progress;
    uint64_t checksum;
} bench;

static bench b;

static invcal_calibration nominal(void)
{
    const invcal_real z[3] = {(invcal_real)zero[0], (invcal_real)zero[1], (invcal_real)zero[2]};
    const invcal_real counts[3] = {(invcal_real)COUNTS, (invcal_real)COUNTS, (invcal_real)COUNTS};
    invcal_calibration out;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(z, counts, &out));
    return out;
}

/* A sensor with errors of +- size. */
static void begin(double size, uint32_t seed)
{
    const invcal_calibration sheet = nominal();

    memset(&b, 0, sizeof b);
    b.random = random_start(seed);
    if (size > 0) {
        b.truth = triad_random(&b.random, size);
    }
    b.s = &b.background.session;
    b.noise = NOISE;
    b.rate = RATE;
    b.rest_time = 2.5;
    b.up[0] = 0.36; /* not a position of any test */
    b.up[1] = 0.48;
    b.up[2] = -0.8;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_session_init_nominal(b.s, sizeof *b.s, &sheet, (invcal_real)RATE));
}

static void begin_background(double size, uint32_t seed)
{
    const invcal_calibration sheet = nominal();

    begin(size, seed);
    b.is_background = 1;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_background_init(&b.background, sizeof b.background,
                                                            &sheet, (invcal_real)RATE));
}

/* Any event agrees with what the session reports. */
static void note(invcal_event event)
{
    TEST_ASSERT_TRUE(event > INVCAL_NOTHING && (unsigned)event < EVENTS);
    b.progress = invcal_session_progress(b.s);
    TEST_ASSERT_LESS_OR_EQUAL_UINT(100, b.progress);
    if (event == INVCAL_REFUSED) {
        const invcal_status why = invcal_session_reason(b.s);
        TEST_ASSERT_TRUE(why >= INVCAL_OUT_OF_RANGE && why <= INVCAL_REST_SAME);
        TEST_ASSERT_EQUAL_STRING(invcal_status_text(why), invcal_session_reason_text(b.s));
        b.refused[why]++;
    }
    b.seen[event]++;
    b.checksum = (b.checksum ^ (uint64_t)event ^ (uint64_t)b.progress << 8) * 1099511628211u;
}

static void feed(const int32_t raw[3])
{
    const invcal_event event = b.is_background
                                   ? invcal_background_feed(&b.background, raw[0], raw[1], raw[2])
                                   : invcal_session_feed(b.s, raw[0], raw[1], raw[2]);

    if (event != INVCAL_NOTHING) {
        note(event);
    }
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
        if (b.rail > 0) {
            raw[i] = raw[i] < -b.rail ? -b.rail : raw[i];
            raw[i] = raw[i] > b.rail ? b.rail : raw[i];
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

/* The point at a fraction s of the way from a to c on the sphere; if they are opposite, via a
 * third. */
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

/* Moves there and holds still. */
static void reach(const double to[3])
{
    turn(to);
    hold(b.rest_time);
}

/* Moves away, so that the position ends; not to where the next one will be. */
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

/* The calibration against the truth: the largest error of a length, over random directions. */
static double worst_length(const invcal_calibration *calibration)
{
    double worst = 0;

    for (int i = 0; i < 200; i++) {
        double eta[3];
        double u[3];
        invcal_real raw[3];
        invcal_real out[3];
        random_direction(&b.random, eta);
        triad_read(&b.truth, eta, u);
        for (int k = 0; k < 3; k++) {
            raw[k] = (invcal_real)(u[k] * COUNTS + zero[k]);
        }
        invcal_apply(calibration, raw[0], raw[1], raw[2], out);
        const double v[3] = {(double)out[0], (double)out[1], (double)out[2]};
        worst = larger(worst, fabs(length3(v) - 1));
    }
    return worst;
}

static invcal_quality solve(invcal_calibration *calibration)
{
    invcal_quality quality;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_solve(b.s, calibration, &quality));
    return quality;
}

static void next(double up[3])
{
    invcal_real v[3];

    invcal_session_next(b.s, v);
    for (int i = 0; i < 3; i++) {
        up[i] = (double)v[i];
    }
}

static int is_along(const double a[3], const double c[3])
{
    return dot(a, c) > 0.999;
}

/* ---- the procedure ---------------------------------------------------------------------------- */

static void eighteen_positions_give_the_truth(void)
{
    invcal_calibration calibration;

    begin(0.05, 1);
    visit_plan(0, 18);
    TEST_ASSERT_EQUAL_UINT(18, b.seen[INVCAL_TAKEN]);
    TEST_ASSERT_EQUAL_UINT(18, b.s->count);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_REFUSED]);
    const invcal_quality quality = solve(&calibration);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
    TEST_ASSERT_EQUAL_UINT(0, quality.left_out);
    TEST_ASSERT_EQUAL_UINT(18, quality.positions);
    TEST_ASSERT_EQUAL_UINT(9, quality.dof);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(3e-4, worst_length(&calibration));
    const invcal_calibration sheet = nominal();
    const triad_truth found = truth_of(&calibration, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(5 * (double)quality.sigma[r], b.truth.x[r], found.x[r]);
    }
}

static void it_is_what_the_array_of_its_means_gives(void)
{
    const invcal_calibration sheet = nominal();
    invcal_calibration of_session;
    invcal_calibration of_array;
    invcal_quality quality;

    begin(0.05, 2);
    visit_plan(0, 15);
    (void)solve(&of_session);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_calibrate_plain(POSITIONS_OF(b.s->mean, b.s->count, &sheet, 0),
                                                 &of_array, &quality));
    TEST_ASSERT_EQUAL_MEMORY(&of_array, &of_session, sizeof of_array);
}

static void a_rest_settles_is_ready_once_and_is_taken_when_it_is_left(void)
{
    begin(0, 3);
    reach(expected_plan18[0]);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_READY]);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_TAKEN]);
    TEST_ASSERT_TRUE(b.seen[INVCAL_MOVING] > 0 && b.seen[INVCAL_SETTLING] > 0);
    TEST_ASSERT_EQUAL_UINT(100, b.progress);
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
    hold(5);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_READY]);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_TAKEN]);
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void the_mean_is_that_of_the_readings(void)
{
    begin(0.05, 4);
    b.noise = 0;
    b.bias[0] = 1e-7; /* counts are whole */
    for (unsigned i = 0; i < 6; i++) {
        double u[3];
        b.noise = NOISE;
        visit(expected_plan18[i]);
        triad_read(&b.truth, expected_plan18[i], u);
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(4, u[a] * COUNTS + zero[a], (double)b.s->mean[i].v[a]);
        }
    }
}

static void leaving_before_the_time_to_hold_is_reported(void)
{
    begin(0, 5);
    invcal_session_set_hold(b.s, 4);
    reach(expected_plan18[0]); /* 2.5 s */
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_READY]);
    TEST_ASSERT_TRUE(b.progress > 20 && b.progress < 80);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SHORT]);
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
    b.rest_time = 5.5;
    visit(expected_plan18[0]);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_READY]);
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void what_the_detector_refuses_is_passed_on(void)
{
    begin(0, 6);
    visit(expected_plan18[0]);
    turn(expected_plan18[1]);
    b.creep = 0.01;
    hold(5);
    b.creep = 0;
    TEST_ASSERT_TRUE(b.refused[INVCAL_REST_DRIFT] > 0);
    hold(3);
    leave();
    TEST_ASSERT_EQUAL_UINT(2, b.s->count);
}

static void what_lies_at_the_rails_is_refused(void)
{
    begin(0, 7);
    b.rail = (int32_t)(COUNTS * 0.95);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_limits(b.s, -b.rail, b.rail));
    const double z[3] = {0, 0, 1};
    const double edge[3] = {0, 0.70710678, 0.70710678};
    visit(z);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_CLIPPED]);
    visit(edge);
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void a_mean_that_is_not_a_reading_of_the_field_is_refused_at_once_and_at_its_end(void)
{
    begin(0, 8);
    b.bias[2] = 12; /* g */
    reach(expected_plan18[0]);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_OUT_OF_RANGE]);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_READY]);
    leave();
    TEST_ASSERT_EQUAL_UINT(2, b.refused[INVCAL_OUT_OF_RANGE]);
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
    b.bias[2] = 0;
    visit(expected_plan18[1]);
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void finish_takes_the_position_that_is_held_and_nothing_that_is_not_ready(void)
{
    begin(0, 9);
    reach(expected_plan18[0]);
    note(invcal_session_end(b.s));
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_TAKEN]);
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
    turn(expected_plan18[1]);
    hold(0.5);
    note(invcal_session_end(b.s));
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void lost_samples_are_reported_and_the_rest_continues(void)
{
    begin(0, 10);
    reach(expected_plan18[0]);
    invcal_session_gap(b.s);
    hold(1);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
    turn(expected_plan18[1]);
    hold(1); /* too short, with that reason */
    invcal_session_gap(b.s);
    leave();
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_GAP, invcal_session_reason(b.s));
}

/* ---- where to turn next ----------------------------------------------------------------------- */

static void advice_that_is_followed_determines_everything(void)
{
    invcal_calibration calibration;

    begin(0.05, 11);
    for (unsigned i = 0; i < 12; i++) {
        double up[3];
        next(up);
        visit(up);
    }
    TEST_ASSERT_EQUAL_UINT(12, b.s->count);
    TEST_ASSERT_TRUE(invcal_session_is_good(b.s));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, solve(&calibration).verdict);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(5e-4, worst_length(&calibration));
}

static void a_hand_that_errs_by_ten_degrees_is_hardly_worse(void)
{
    for (uint32_t seed = 1; seed <= SOME(20); seed++) {
        invcal_calibration calibration;
        begin(0.05, 100 + seed);
        for (unsigned i = 0; i < 14; i++) {
            double up[3];
            double hit[3];
            next(up);
            astray(up, 10, hit);
            visit(hit);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, solve(&calibration).verdict);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1e-3, worst_length(&calibration));
    }
}

static void a_position_that_is_ready_counts_as_taken(void)
{
    double before[3];
    double ready[3];
    double after[3];

    begin(0, 12);
    next(before);
    turn(before);
    hold(0.4);
    next(ready);
    TEST_ASSERT_TRUE(is_along(before, ready)); /* not yet */
    hold(2.5);
    next(ready);
    TEST_ASSERT_FALSE(is_along(before, ready));
    leave();
    next(after);
    TEST_ASSERT_TRUE(is_along(after, ready));
    for (unsigned i = 1; i < 9; i++) { /* among others, too */
        reach(after);
        next(ready);
        leave();
        next(after);
        TEST_ASSERT_EQUAL_UINT(i + 1, b.s->count);
        TEST_ASSERT_TRUE(is_along(after, ready));
    }
}

static void the_next_direction_has_its_words(void)
{
    char words[INVCAL_TEXT_SIZE];

    begin(0, 13);
    TEST_ASSERT_EQUAL_STRING("+z up", invcal_session_next_text(b.s, words));
}

static void a_position_is_at_a_direction_within_twenty_degrees(void)
{
    const invcal_real up[3] = {0, 0, 1};
    double to[3];

    begin(0, 14);
    TEST_ASSERT_FALSE(invcal_session_is_at(b.s, up));
    const double z[3] = {0, 0, 1};
    astray(z, 19, to);
    visit(to);
    TEST_ASSERT_TRUE(invcal_session_is_at(b.s, up));
    astray(z, 21, to);
    visit(to);
    TEST_ASSERT_EQUAL_UINT(2, b.s->count);
    TEST_ASSERT_FALSE(invcal_session_is_at(b.s, up));

    begin(0, 15); /* the angle, whatever the length */
    for (unsigned i = 0; i < 3; i++) {
        b.s->nominal.matrix[i][i] *= (invcal_real)0.8;
    }
    visit(z);
    TEST_ASSERT_TRUE(invcal_session_is_at(b.s, up));
}

static void a_position_that_is_ready_is_where_it_is(void)
{
    const double z[3] = {0, 0, 1};
    const double x[3] = {1, 0, 0};
    const invcal_real up_z[3] = {0, 0, 1};
    const invcal_real up_x[3] = {1, 0, 0};

    begin(0, 17);
    visit(z);
    turn(x);
    hold(0.4);
    TEST_ASSERT_TRUE(invcal_session_is_at(b.s, up_z)); /* not yet */
    hold(2.5);
    TEST_ASSERT_TRUE(invcal_session_is_at(b.s, up_x));
    TEST_ASSERT_FALSE(invcal_session_is_at(b.s, up_z));
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
    leave();
    TEST_ASSERT_TRUE(invcal_session_is_at(b.s, up_x));
}

/* ---- is it enough? ---------------------------------------------------------------------------- */

static void it_is_good_from_twelve_positions_on(void)
{
    begin(0.05, 15);
    for (unsigned i = 1; i <= 14; i++) {
        double up[3];
        next(up);
        visit(up);
        TEST_ASSERT_EQUAL_INT(i >= 12, invcal_session_is_good(b.s));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(b.s, (invcal_real)1e-7));
    TEST_ASSERT_FALSE(invcal_session_is_good(b.s)); /* asked again */
}

static void with_a_stated_noise_one_redundant_position_is_enough(void)
{
    begin(0.05, 16);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(b.s, (invcal_real)1e-4));
    for (unsigned i = 1; i <= 10; i++) {
        double up[3];
        next(up);
        visit(up);
        TEST_ASSERT_EQUAL_INT(i >= 10, invcal_session_is_good(b.s));
    }
}

/* Until a noise is stated, or another position taken. An AVR solves again. */
static void a_good_solution_is_kept(void)
{
    invcal_calibration first;
    invcal_calibration again;

    begin(0.05, 17);
    visit_plan(0, 18);
    const invcal_quality q = solve(&first);
    TEST_ASSERT_TRUE(invcal_session_is_good(b.s));
#ifndef __AVR__
    b.s->mean[3].v[1] += 100; /* only a new solution notices */
#endif
    const invcal_quality kept = solve(&again);
    TEST_ASSERT_EQUAL_MEMORY(&first, &again, sizeof first);
    TEST_ASSERT_EQUAL_MEMORY(q.sigma, kept.sigma, sizeof q.sigma);
    TEST_ASSERT_EQUAL_UINT(18, kept.positions);
#ifndef __AVR__
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(b.s, (invcal_real)1e-4));
    TEST_ASSERT_EQUAL_UINT(17, solve(&again).positions);
#endif
}

/* The session must end, however good one rest is: is_good and solve use the same data. */
static void a_wrong_rest_does_not_prevent_the_end(void)
{
    for (unsigned wrong = 0; wrong < 9; wrong += 2) {
        invcal_calibration calibration;
        unsigned taken = 0;
        begin(0.03, 200 + wrong);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(b.s, (invcal_real)1e-4));
        while (!invcal_session_is_good(b.s) || taken <= wrong + 2) {
            double up[3];
            TEST_ASSERT_TRUE(taken < 18);
            next(up);
            b.bias[1] = taken == wrong ? 0.05 : 0;
            visit(up);
            taken++;
        }
        const invcal_quality quality = solve(&calibration);
        if (quality.left_out != 0) { /* with ten positions it may not show yet */
            TEST_ASSERT_EQUAL_HEX64(UINT64_C(1) << wrong, (uint64_t)quality.left_out);
            TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1e-3, worst_length(&calibration));
        }
    }
}

static void a_wrong_position_is_named_and_left_out(void)
{
    invcal_calibration calibration;

    begin(0.05, 17);
    for (unsigned i = 0; i < 18; i++) {
        b.bias[1] = i == 5 ? 0.05 : 0;
        visit(expected_plan18[i]);
    }
    const invcal_quality quality = solve(&calibration);
    TEST_ASSERT_EQUAL_UINT(1u << 5, (unsigned)quality.left_out);
    TEST_ASSERT_EQUAL_UINT(17, quality.positions);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(4e-4, worst_length(&calibration));
    TEST_ASSERT_TRUE(invcal_session_is_good(b.s));
}

static void among_fewer_than_eleven_no_outlier_is_looked_for(void)
{
    invcal_calibration calibration;

    begin(0.05, 18);
    for (unsigned i = 0; i < 10; i++) {
        double up[3];
        next(up);
        b.bias[1] = i == 5 ? 0.05 : 0;
        visit(up);
    }
    TEST_ASSERT_EQUAL_UINT(0, (unsigned)solve(&calibration).left_out);
}

static void too_few_positions_and_positions_on_a_plane_are_refused(void)
{
    invcal_calibration calibration;
    invcal_quality quality;
    uint8_t before[sizeof calibration + sizeof quality];
    uint8_t after[sizeof before];

    begin(0, 20);
    memset(&calibration, 7, sizeof calibration);
    memset(&quality, 7, sizeof quality);
    memset(before, 7, sizeof before);
    visit_plan(0, 8);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_session_solve(b.s, &calibration, &quality));
    TEST_ASSERT_FALSE(invcal_session_is_good(b.s));
    begin(0, 21);
    for (unsigned i = 0; i < 12; i++) {
        const double v[3] = {cos(0.5236 * i), sin(0.5236 * i), 0};
        visit(v);
    }
    TEST_ASSERT_EQUAL_UINT(12, b.s->count);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_session_solve(b.s, &calibration, &quality));
    memcpy(after, &calibration, sizeof calibration);
    memcpy(after + sizeof calibration, &quality, sizeof quality);
    TEST_ASSERT_EQUAL_MEMORY(before, after, sizeof before);
}

static void a_solution_does_not_change_the_session(void)
{
    invcal_calibration calibration;

    begin(0.05, 22);
    visit_plan(0, 15);
    const invcal_session before = *b.s;
    (void)solve(&calibration);
    TEST_ASSERT_EQUAL_MEMORY(&before, b.s, sizeof before);
}

static void where_the_table_is_full_the_oldest_position_goes(void)
{
    begin(0.05, 23);
    visit_plan(0, INVCAL_MAX_POSITIONS);
    const invcal_session before = *b.s;
    TEST_ASSERT_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->count);
    visit_plan(3, 2);
    TEST_ASSERT_EQUAL_UINT(INVCAL_MAX_POSITIONS, b.s->count);
    TEST_ASSERT_EQUAL_MEMORY(&before.mean[2], b.s->mean,
                             (INVCAL_MAX_POSITIONS - 2) * sizeof before.mean[0]);
}

/* ---- in the background ------------------------------------------------------------------------ */

static void a_well_covered_direction_is_skipped_and_a_new_one_is_not(void)
{
    begin_background(0.03, 24);
    visit_plan(0, 18);
    TEST_ASSERT_EQUAL_UINT(18, b.s->count);
    visit_plan(0, 36);
    TEST_ASSERT_TRUE(b.refused[INVCAL_REST_SAME] >= 20);
    begin_background(0.03, 25);
    for (unsigned i = 0; i < 40; i++) {
        visit(expected_plan18[i % 2]);
    }
    TEST_ASSERT_TRUE(b.s->count <= 8); /* two directions do not fill the table */
    const double new_one[3] = {0.57735027, -0.57735027, 0.57735027};
    const unsigned before = b.s->count;
    visit(new_one);
    TEST_ASSERT_EQUAL_UINT(before + 1, b.s->count);
}

static void a_full_table_drops_what_adds_least(void)
{
    begin_background(0.03, 26);
    for (unsigned i = 0; b.s->count < INVCAL_MAX_POSITIONS - 1u; i++) {
        double to[3];
        TEST_ASSERT_TRUE(i < 400);
        random_direction(&b.random, to);
        visit(to);
    }
    for (unsigned i = 0; i < 60; i++) {
        double to[3];
        random_direction(&b.random, to);
        visit(to);
        TEST_ASSERT_TRUE(b.s->count < INVCAL_MAX_POSITIONS);
    }
    TEST_ASSERT_TRUE(invcal_session_is_good(b.s));
}

static void positions_vanish_after_their_days_and_younger_ones_stay(void)
{
    begin_background(0.03, 27);
    visit_plan(0, 4);
    for (unsigned day = 0; day < 10; day++) {
        invcal_background_age(&b.background);
    }
    visit_plan(6, 3);
    TEST_ASSERT_EQUAL_UINT(7, b.s->count);
    const invcal_session young = *b.s;
    for (unsigned day = 10; day < DAYS; day++) {
        TEST_ASSERT_EQUAL_UINT(7, b.s->count);
        invcal_background_age(&b.background);
    }
    TEST_ASSERT_EQUAL_UINT(3, b.s->count);
    TEST_ASSERT_EQUAL_MEMORY(&young.mean[4], b.s->mean, 3 * sizeof young.mean[0]);
    for (unsigned day = 0; day < 10; day++) {
        invcal_background_age(&b.background);
    }
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
    invcal_background_age(&b.background);
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
    visit_plan(0, 1); /* its days begin with it */
    for (unsigned day = 1; day < DAYS; day++) {
        invcal_background_age(&b.background);
    }
    TEST_ASSERT_EQUAL_UINT(1, b.s->count);
}

static void an_old_position_is_dropped_before_a_new_one(void)
{
    begin_background(0.03, 28);
    for (unsigned i = 0; i < 9; i++) {
        visit(expected_plan18[2 * i]);
    }
    const unsigned old = b.s->count;
    for (unsigned day = 0; day < DAYS - 2; day++) {
        invcal_background_age(&b.background);
    }
    for (unsigned i = 0; b.s->count == b.seen[INVCAL_TAKEN] && i < 400; i++) {
        double to[3];
        random_direction(&b.random, to);
        visit(to);
    }
    TEST_ASSERT_EQUAL_UINT(
        0, b.background.age[b.s->count - 1]); /* that of one that was dropped was not */
    unsigned young = 0;
    for (unsigned i = 0; i < b.s->count; i++) {
        young += b.background.age[i] == 0;
    }
    TEST_ASSERT_EQUAL_UINT(b.seen[INVCAL_TAKEN] - old, young); /* none of them was dropped */
}

/* After a reset its positions count as new. */
static void a_background_is_begun_and_then_resumed(void)
{
    static invcal_session saved;

    begin_background(0.03, 34);
    visit_plan(0, 6);
    for (unsigned day = 0; day < 30; day++) {
        invcal_background_age(&b.background);
    }
    saved = *b.s;
    TEST_ASSERT_EQUAL_UINT(6, saved.count);
    memset(&b.background, 0x5A, sizeof b.background);
    begin_background(0.03, 35);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_resume(b.s, (const uint8_t *)&saved,
                                                           invcal_session_size(&saved)));
    TEST_ASSERT_EQUAL_UINT(6, b.s->count);
    TEST_ASSERT_EQUAL_MEMORY(saved.mean, b.s->mean, 6 * sizeof saved.mean[0]);
    TEST_ASSERT_EACH_EQUAL_UINT8(0, b.background.age, INVCAL_MAX_POSITIONS);
    for (unsigned day = 1; day < DAYS; day++) {
        invcal_background_age(&b.background);
    }
    TEST_ASSERT_EQUAL_UINT(6, b.s->count);
    invcal_background_age(&b.background);
    TEST_ASSERT_EQUAL_UINT(0, b.s->count);
}

/* ---- settings ----------------------------------------------------------------------------------- */

static void unusable_settings_are_refused_by_name_and_nothing_is_written(void)
{
    invcal_session session;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&session, sizeof session, 16384, 100));
    const invcal_session before = session;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcal_session_set_limits(&session, 5, 5));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_session_set_noise(&session, 0));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_session_set_noise(&session, 1));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_session_set_noise(&session, (invcal_real)NAN));
    TEST_ASSERT_EQUAL_MEMORY(&before, &session, sizeof session);
}

/* The rate may be that of a data sheet: 12.5 Hz. Rests are longer then. */
static void a_rate_need_not_be_whole(void)
{
    const invcal_calibration sheet = nominal();
    invcal_calibration calibration;

    begin(0.05, 32);
    b.rate = 12.5;
    b.rest_time = 6;
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_session_init_nominal(b.s, sizeof *b.s, &sheet, (invcal_real)b.rate));
    TEST_ASSERT_TRUE(b.s->rate == INVCAL_REAL(12.5));
    visit_plan(0, 18);
    (void)invcal_session_end(b.s); /* the last one has not been left for long */
    TEST_ASSERT_EQUAL_UINT(18, b.seen[INVCAL_READY]);
    TEST_ASSERT_EQUAL_UINT(18, b.s->count);
    TEST_ASSERT_TRUE(invcal_session_is_good(b.s));
    (void)solve(&calibration);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(1e-3, worst_length(&calibration));
}

/* Also where its square is beyond the number type: never without a sentence. */
static void a_reading_far_from_the_field_has_a_sentence(void)
{
    static invcal_session session;
    unsigned refused = 0;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_session_init(&session, sizeof session, INVCAL_REAL(1.1e-10), 100));
    for (int32_t i = 0; i < 500; i++) {
        const int32_t noise = (int32_t)(UINT32_C(2654435761) * (uint32_t)i >> 28);
        const int32_t z = INT32_MAX - 1000 + noise;
        if (invcal_session_feed(&session, noise / 2, noise / 3, z) == INVCAL_REFUSED) {
            TEST_ASSERT_EQUAL_STRING("far from the field: wrong scale or offset",
                                     invcal_session_reason_text(&session));
            refused++;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(0, refused);
}

/* ---- not begun, or not successfully ------------------------------------------------------------- */

/* What a program says that ignores the status of the beginning: every sample is refused, and why.
 * Nothing else is ever reported, so that it cannot wait in vain. */
static void assert_refuses_everything(invcal_session *session, invcal_status why)
{
    invcal_calibration calibration;
    invcal_quality quality;

    TEST_ASSERT_TRUE(why != INVCAL_OK);
    for (int32_t i = 0; i < 1000; i++) { /* as if it were moved and held */
        const int32_t z = i % 300 < 200 ? 16384 + i % 3 : 50 * i;
        TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(session, i % 2, 0, z));
        TEST_ASSERT_EQUAL_INT(why, invcal_session_reason(session));
    }
    TEST_ASSERT_EQUAL_STRING(invcal_status_text(why), invcal_session_reason_text(session));
    TEST_ASSERT_EQUAL_UINT(0, session->count);
    TEST_ASSERT_FALSE(invcal_session_is_good(session));
    TEST_ASSERT_TRUE(invcal_session_solve(session, &calibration, &quality) != INVCAL_OK);
}

/* Begins in memory of any contents, unsuccessfully: once for each reason. */
enum { FAILURES = 9 };

static invcal_status fail_to_begin(unsigned how, invcal_session *session)
{
    const invcal_calibration good = nominal();
    invcal_calibration bad = good;
    invcal_status status = INVCAL_OK;

    bad.matrix[1][1] = (invcal_real)(how == 0 ? 0 : NOT_A_NUMBER);
    switch (how) {
    case 0:
    case 1:
        status = invcal_session_init_nominal(session, sizeof *session, &bad, 100);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, status);
        break;
    case 2:
        status = invcal_session_init(session, sizeof *session, 0, 100);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, status);
        break;
    case 3:
        status = invcal_session_init(session, sizeof *session, (invcal_real)NAN, 100);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, status);
        break;
    case 4:
        status = invcal_session_init(session, sizeof *session, 16384, 5);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, status);
        break;
    case 5:
        status = invcal_session_init(session, sizeof *session, 16384, (invcal_real)NAN);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, status);
        break;
    case 6:
        status = invcal_session_init_nominal(session, sizeof *session, &good, INVCAL_REAL(7.99));
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, status);
        break;
    case 7:
        status = invcal_session_init_nominal(session, sizeof *session, &good, 8001);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, status);
        break;
    default: /* of two faults the nominal calibration is named */
        status = invcal_session_init(session, sizeof *session, 0, 0);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOMINAL, status);
        break;
    }
    return status;
}

static const uint8_t fills[] = {0, 1, 0x5A, 0x70, 0xFF};
enum { FILLS = sizeof fills };

static void what_was_never_begun_refuses_every_sample(void)
{
    memset(&b, 0, sizeof b);
    assert_refuses_everything(&b.background.session, INVCAL_NOT_BEGUN);
    memset(&b, 0, sizeof b);
    TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_background_feed(&b.background, 0, 0, 16384));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_session_reason(&b.background.session));
}

static void a_failed_beginning_is_the_reason_why_every_sample_is_refused(void)
{
    static invcal_session session;

    for (unsigned i = 0; i < FAILURES * FILLS; i++) {
        memset(&session, fills[i % FILLS], sizeof session);
        const invcal_status status = fail_to_begin(i / FILLS, &session);
        assert_refuses_everything(&session, status);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&session, sizeof session, 16384, 100));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_reason(&session)); /* and it is cured */
        TEST_ASSERT_EQUAL_INT(INVCAL_NOTHING, invcal_session_feed(&session, 0, 0, 16384));
    }
}

/* A session that was in use is over, too: it does not go on with the former settings. */
static void a_failed_beginning_ends_the_session_before(void)
{
    begin(0, 33);
    visit_plan(0, 3);
    TEST_ASSERT_EQUAL_UINT(3, b.s->count);
    assert_refuses_everything(b.s, fail_to_begin(4, b.s));
}

/* Nothing is taken, there is no progress, and the reason stays, whatever else is called. */
static void other_calls_do_not_revive_it(void)
{
    static invcal_session session;
    char text[INVCAL_TEXT_SIZE];
    invcal_real up[3];

    for (unsigned i = 0; i < FILLS; i++) {
        memset(&session, fills[i], sizeof session);
        (void)fail_to_begin(4, &session);
        (void)invcal_session_set_limits(&session, -32768, 32767);
        invcal_session_set_hold(&session, 2);
        invcal_session_gap(&session);
        TEST_ASSERT_EQUAL_UINT(0, invcal_session_progress(&session));
        const invcal_event event = invcal_session_end(&session);
        TEST_ASSERT_TRUE(event == INVCAL_MOVING || event == INVCAL_REFUSED);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_session_reason(&session));
        TEST_ASSERT_EQUAL_STRING("+z up", invcal_session_next_text(&session, text)); /* any first */
        invcal_session_next(&session, up);
        TEST_ASSERT_FALSE(invcal_session_is_at(&session, up));
        assert_refuses_everything(&session, INVCAL_BAD_RATE);
    }
    memset(&session, 0, sizeof session);
    (void)invcal_session_end(&session);
    assert_refuses_everything(&session, INVCAL_NOT_BEGUN);
}

/* Of a program that was built for another one: every size but this one. */
static const size_t wrong_sizes[] = {0, 1, sizeof(invcal_session) - 1, sizeof(invcal_session) + 1,
                                     (size_t)-1};
enum { WRONG_SIZES = sizeof wrong_sizes / sizeof wrong_sizes[0] };

static invcal_status begin_wrongly(unsigned how, invcal_session *session)
{
    const invcal_calibration sheet = nominal();
    const size_t size = wrong_sizes[how / 2];

    return how % 2 ? invcal_session_init(session, size, 16384, 100)
                   : invcal_session_init_nominal(session, size, &sheet, 100);
}

/* The first bytes are the same in every build: reason, count, two more, layout. */
enum { FIRST = 8 };

static void assert_only_the_first_bytes_changed(const void *bytes, size_t size, uint8_t fill)
{
    TEST_ASSERT_EQUAL_HEX8(INVCAL_OTHER_BUILD, *(const uint8_t *)bytes);
    TEST_ASSERT_EACH_EQUAL_HEX8(fill, (const uint8_t *)bytes + FIRST, size - FIRST);
}

static void of_a_session_of_another_size_only_the_first_bytes_are_written(void)
{
    static invcal_session session;

    for (unsigned i = 0; i < 2 * WRONG_SIZES * FILLS; i++) {
        const uint8_t fill = fills[i % FILLS];
        memset(&session, fill, sizeof session);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, begin_wrongly(i / FILLS, &session));
        assert_only_the_first_bytes_changed(&session, sizeof session, fill);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, invcal_session_reason(&session));
    }
}

static void a_session_of_another_size_refuses_every_sample(void)
{
    static invcal_session session;

    for (unsigned i = 0; i < 2 * WRONG_SIZES * FILLS; i++) {
        const uint8_t fill = fills[i % FILLS];
        memset(&session, fill, sizeof session);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, begin_wrongly(i / FILLS, &session));
        for (int32_t n = 0; n < 300; n++) {
            TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(&session, n % 2, 0, 16384));
            TEST_ASSERT_EQUAL_STRING("other build", invcal_session_reason_text(&session));
        }
        assert_only_the_first_bytes_changed(&session, sizeof session, fill);
    }
}

/* The order of most programs: settings before the samples. */
static void no_other_call_writes_into_a_session_of_another_size(void)
{
    static invcal_session session;

    for (unsigned i = 0; i < FILLS; i++) {
        memset(&session, fills[i], sizeof session);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, begin_wrongly(4, &session));
        (void)invcal_session_set_limits(&session, -32768, 32767);
        (void)invcal_session_set_noise(&session, INVCAL_REAL(0.001));
        invcal_session_set_hold(&session, 2);
        invcal_session_gap(&session);
        (void)invcal_session_end(&session);
        assert_only_the_first_bytes_changed(&session, sizeof session, fills[i]);
    }
}

static void a_background_is_begun_under_the_same_rules(void)
{
    const invcal_calibration good = nominal();

    for (unsigned i = 0; i < 4 * FILLS; i++) {
        const size_t sizes[] = {sizeof b.background - 1, sizeof b.background + 1,
                                sizeof b.background.session, 0};
        memset(&b.background, fills[i % FILLS], sizeof b.background);
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD,
                              invcal_background_init(&b.background, sizes[i / FILLS], &good, 100));
        assert_only_the_first_bytes_changed(&b.background, sizeof b.background, fills[i % FILLS]);
    }
    for (unsigned i = 0; i < 3 * FILLS; i++) {
        const double rates[] = {5, NOT_A_NUMBER, 8001};
        memset(&b.background, fills[i % FILLS], sizeof b.background);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE,
                              invcal_background_init(&b.background, sizeof b.background, &good,
                                                     (invcal_real)rates[i / FILLS]));
        for (int32_t n = 0; n < 300; n++) {
            TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED,
                                  invcal_background_feed(&b.background, n % 2, 0, 16384));
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_session_reason(&b.background.session));
        }
        TEST_ASSERT_EQUAL_UINT(0, b.background.session.count);
    }
}

/* ---- all of it ---------------------------------------------------------------------------------- */

static void to_begin_again_forgets_everything(void)
{
    begin(0, 29);
    const invcal_session fresh = *b.s;
    const invcal_calibration sheet = nominal();
    visit_plan(0, 3);
    invcal_session_set_hold(b.s, 5);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(b.s, (invcal_real)0.001));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_session_init_nominal(b.s, sizeof *b.s, &sheet, (invcal_real)RATE));
    memcpy(b.s->mean, fresh.mean, sizeof fresh.mean); /* none of them counts */
    TEST_ASSERT_EQUAL_MEMORY(&fresh, b.s, sizeof fresh);
}

static void a_session_may_be_moved_at_any_time(void)
{
    static invcal_session other;

    begin(0.05, 30);
    visit_plan(0, 4);
    const uint64_t stayed = b.checksum;
    begin(0.05, 30);
    for (unsigned i = 0; i < 4; i++) {
        turn(expected_plan18[i]);
        memcpy(&other, b.s, sizeof other);
        memset(b.s, 0xA5, sizeof *b.s);
        b.s = b.s == &other ? &b.background.session : b.s;
        memcpy(b.s, &other, sizeof other);
        hold(b.rest_time);
        leave();
    }
    TEST_ASSERT_EQUAL_HEX64(stayed, b.checksum);
}

static void a_session_is_small(void)
{
    if (!INVCAL_DOUBLE && sizeof(void *) == 4 && INVCAL_MAX_POSITIONS == 24) {
        TEST_ASSERT_LESS_OR_EQUAL_UINT(700, sizeof(invcal_session));
    }
}

/* Any samples, any order of calls. */
static void hostile_input_does_no_harm(void)
{
    static const int32_t odd[] = {0, 1, -1, INT32_MIN, INT32_MAX, 16384, -16384, 30000};

    begin(0, 31);
    for (unsigned i = 0; i < SOME(60000); i++) {
        int32_t raw[3];
        const unsigned how = (unsigned)random_uniform(&b.random, 0, 300);
        for (unsigned a = 0; a < 3; a++) {
            raw[a] = how < 20 ? odd[(unsigned)random_uniform(&b.random, 0, 8)]
                              : (int32_t)random_uniform(&b.random, -40, 40) +
                                    (int32_t)(i / 400 % 5) * 4000 * (a == i / 2000 % 3);
        }
        feed(raw);
        if (how == 21) {
            invcal_session_gap(b.s);
        } else if (how == 22) {
            note(invcal_session_end(b.s));
        } else if (how == 23) {
            invcal_session_set_hold(b.s, (invcal_real)random_uniform(&b.random, 0, 3));
        } else if (how == 24) {
            (void)invcal_session_is_good(b.s);
        }
    }
    TEST_ASSERT_TRUE(b.s->count <= INVCAL_MAX_POSITIONS);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(eighteen_positions_give_the_truth);
    RUN_TEST(it_is_what_the_array_of_its_means_gives);
    RUN_TEST(a_rest_settles_is_ready_once_and_is_taken_when_it_is_left);
    RUN_TEST(the_mean_is_that_of_the_readings);
    RUN_TEST(leaving_before_the_time_to_hold_is_reported);
    RUN_TEST(what_the_detector_refuses_is_passed_on);
    RUN_TEST(what_lies_at_the_rails_is_refused);
    RUN_TEST(a_mean_that_is_not_a_reading_of_the_field_is_refused_at_once_and_at_its_end);
    RUN_TEST(finish_takes_the_position_that_is_held_and_nothing_that_is_not_ready);
    RUN_TEST(lost_samples_are_reported_and_the_rest_continues);
    RUN_TEST(advice_that_is_followed_determines_everything);
    RUN_SLOW_TEST(a_hand_that_errs_by_ten_degrees_is_hardly_worse);
    RUN_TEST(a_position_that_is_ready_counts_as_taken);
    RUN_TEST(the_next_direction_has_its_words);
    RUN_TEST(a_position_is_at_a_direction_within_twenty_degrees);
    RUN_TEST(a_position_that_is_ready_is_where_it_is);
    RUN_TEST(it_is_good_from_twelve_positions_on);
    RUN_TEST(with_a_stated_noise_one_redundant_position_is_enough);
    RUN_SLOW_TEST(a_wrong_rest_does_not_prevent_the_end);
    RUN_TEST(a_good_solution_is_kept);
    RUN_TEST(a_wrong_position_is_named_and_left_out);
    RUN_TEST(among_fewer_than_eleven_no_outlier_is_looked_for);
    RUN_TEST(too_few_positions_and_positions_on_a_plane_are_refused);
    RUN_TEST(a_solution_does_not_change_the_session);
    RUN_TEST(where_the_table_is_full_the_oldest_position_goes);
    RUN_SLOW_TEST(a_well_covered_direction_is_skipped_and_a_new_one_is_not);
    RUN_SLOW_TEST(a_full_table_drops_what_adds_least);
    RUN_TEST(positions_vanish_after_their_days_and_younger_ones_stay);
    RUN_SLOW_TEST(an_old_position_is_dropped_before_a_new_one);
    RUN_TEST(a_background_is_begun_and_then_resumed);
    RUN_TEST(unusable_settings_are_refused_by_name_and_nothing_is_written);
    RUN_TEST(a_rate_need_not_be_whole);
    RUN_TEST(a_reading_far_from_the_field_has_a_sentence);
    RUN_TEST(what_was_never_begun_refuses_every_sample);
    RUN_TEST(a_failed_beginning_is_the_reason_why_every_sample_is_refused);
    RUN_TEST(a_failed_beginning_ends_the_session_before);
    RUN_TEST(other_calls_do_not_revive_it);
    RUN_TEST(of_a_session_of_another_size_only_the_first_bytes_are_written);
    RUN_TEST(a_session_of_another_size_refuses_every_sample);
    RUN_TEST(no_other_call_writes_into_a_session_of_another_size);
    RUN_TEST(a_background_is_begun_under_the_same_rules);
    RUN_TEST(to_begin_again_forgets_everything);
    RUN_TEST(a_session_may_be_moved_at_any_time);
    RUN_TEST(a_session_is_small);
    RUN_TEST(hostile_input_does_no_harm);
    return UNITY_END() != 0;
}
