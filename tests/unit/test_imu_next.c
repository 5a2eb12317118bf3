/* SPDX-License-Identifier: MIT
 *
 * Which turn to make next, over whole sessions; and the result applied to samples.
 */
#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "invcal/plan.h"
#include "imu/turns.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

#define RATE 100 /* samples per second of both */
#define COUNTS_PER_G 16384

static const char tour[] = "zxyzXyZxYZXYz"; /* small: that axis up, large: down */
enum { TOUR = sizeof tour - 2 };

static invcal_imu imu;

static void begin(void)
{
    memset(&imu, 0, sizeof imu);
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_session_init(&imu.session, sizeof imu.session, COUNTS_PER_G, RATE));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init(&imu, sizeof imu, (invcal_real)COUNTS, RATE));
}

/* A face as a letter of the tour; '?' for none. */
static char face_of(const invcal_real up[3])
{
    for (int i = 0; i < 3; i++) {
        if (up[i] > INVCAL_REAL(0.999)) {
            return (char)('x' + i);
        }
        if (up[i] < INVCAL_REAL(-0.999)) {
            return (char)('X' + i);
        }
    }
    return '?';
}

static void direction_of(char face, double up[3])
{
    const int is_down = face < 'a';

    up[0] = up[1] = up[2] = 0;
    up[face - (is_down ? 'X' : 'x')] = is_down ? -1 : 1;
}

static double angle_of(const double a[3], const invcal_real b[3])
{
    const double dot = a[0] * (double)b[0] + a[1] * (double)b[1] + a[2] * (double)b[2];

    return acos(fmin(1, fmax(-1, dot))) / DEGREE;
}

/* The axis is a unit vector, across both up directions, and the turn leads from one to the other. */
static void assert_turn(const double from[3], const invcal_turn *turn)
{
    double th[3], c[3][3], up[3];

    for (int i = 0; i < 3; i++) {
        th[i] = (double)turn->axis[i] * (double)turn->angle;
    }
    rotation_by(th, c);
    world_up((const double(*)[3])c, from, up);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 1, length3(up));
    TEST_ASSERT_DOUBLE_WITHIN(0.05, 0, angle_of(up, turn->up));
}

/* ---- by hand: rests and moves as they are kept -------------------------------------------------- */

/* A rest with this up direction, after a move with this reason. */
static void add_rest(const double up[3], invcal_status reason)
{
    if (imu.session.count == INVCAL_MAX_POSITIONS) {
        memmove(&imu.session.mean[0], &imu.session.mean[1],
                (INVCAL_MAX_POSITIONS - 1) * sizeof imu.session.mean[0]);
        imu.session.count--;
    }
    for (int i = 0; i < 3; i++) {
        imu.session.mean[imu.session.count].v[i] = (invcal_real)(COUNTS_PER_G * up[i]);
    }
    imu.session.count++;
    TEST_ASSERT_TRUE(imu.rests < INVCAL_MAX_MOVES);
    const int move = imu.rests == 0 ? -INVCAL_TOO_FEW : reason == INVCAL_OK ? 1 : -(int)reason;
    if (move > 0) {
        invcal_private_segment *s = &imu.own.segment[imu.own.first++];
        memset(s, 0, sizeof *s);
        s->time = 200;
    }
    imu.own.rest[imu.rests++].move = (int8_t)move;
    imu.session.last = INVCAL_TAKEN;
}

static void add_face(char face, invcal_status reason)
{
    double up[3];

    direction_of(face, up);
    add_rest(up, reason);
}

static char next(void)
{
    invcal_turn turn;

    invcal_imu_next(&imu, &turn);
    return face_of(turn.up);
}

static void the_tour_is_asked_for_in_its_order(void)
{
    invcal_turn turn;
    double up[3];

    begin();
    for (int k = 0; k < TOUR; k++) {
        add_face(tour[k], INVCAL_OK);
        direction_of(tour[k], up);
        invcal_imu_next(&imu, &turn);
        assert_turn(up, &turn);
        TEST_ASSERT_EQUAL_INT(tour[k + 1], face_of(turn.up));
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, 90, (double)turn.angle / DEGREE);
    }
}

static void a_refused_turn_is_asked_for_again(void)
{
    for (int k = 1; k <= TOUR; k++) {
        int turns = 0;
        begin();
        for (int i = 0; i < k; i++) {
            add_face(tour[i], INVCAL_OK);
        }
        add_face(tour[k], INVCAL_MOVE_GAP);
        char at = tour[k];
        TEST_ASSERT_EQUAL_INT(tour[k - 1], next());
        while (turns < 9 && next() != '?' && imu.rests < 24) { /* a full table ends it */
            invcal_turn turn;
            double up[3];
            direction_of(at, up);
            invcal_imu_next(&imu, &turn);
            TEST_ASSERT_DOUBLE_WITHIN(0.01, 90, angle_of(up, turn.up));
            at = face_of(turn.up);
            add_face(at, INVCAL_OK);
            turns++;
        }
    }
}

/* However many are refused, and wherever it begins: in the end every edge was made. */
static void what_is_asked_for_ends_with_every_edge(void)
{
    random_source random = random_start(7);

    for (int run = 0; run < SOME(300); run++) {
        unsigned long made = 0;
        int turns = 0;
        double up[3];
        begin();
        char at = tour[(int)random_uniform(&random, 0, 12)];
        add_face(at, INVCAL_OK);
        for (;;) {
            invcal_turn turn;
            const int is_good = turns > 3 || random_uniform(&random, 0, 1) > 0.4;
            invcal_imu_next(&imu, &turn);
            const char to = face_of(turn.up);
            direction_of(at, up);
            assert_turn(up, &turn);
            if (made == 0xFFF) {
                break;
            }
            TEST_ASSERT_TRUE(to != '?');
            for (int i = 0; i < TOUR && is_good; i++) {
                made |= (tour[i] == at && tour[i + 1] == to) || (tour[i] == to && tour[i + 1] == at)
                            ? 1ul << i
                            : 0;
            }
            add_face(to, is_good ? INVCAL_OK : INVCAL_REST_CLIPPED);
            at = to;
            TEST_ASSERT_TRUE(++turns <= 24);
            if (imu.rests == INVCAL_MAX_MOVES || imu.session.count == INVCAL_MAX_POSITIONS) {
                break; /* the oldest would be lost */
            }
        }
    }
}

/* After the tour it is the turn that turns.h finds, from where the device is. */
static void after_the_tour_it_is_the_most_informative_turn(void)
{
    static world w;
    static invcali_turns turns;
    invcal_turn expected;
    invcal_turn turn;
    invcal_real raw[WORLD_RESTS][3];

    world_begin(&w, 100, 21);
    world_tour(&w);
    world_end(&w);
    world_means(&w, raw);
    memcpy(w.imu.session.mean, raw, 13 * sizeof raw[0]);
    w.imu.session.count = 13;
    w.imu.session.last = INVCAL_TAKEN;
    TEST_ASSERT_EQUAL_INT(13, w.imu.rests);
    const invcal_positions positions = invcali_imu_positions(&w.imu);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_turns_after(&turns, &w.imu, &positions, NULL));
    invcali_turns_next(&turns, &expected);
    invcal_imu_next(&w.imu, &turn);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, (double)expected.up[i], (double)turn.up[i]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, (double)expected.axis[i], (double)turn.axis[i]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, (double)expected.angle, (double)turn.angle);
    w.imu.own.rest[4].move = -INVCAL_MOVE_GAP; /* unless one is refused: from z, to y */
    invcal_imu_next(&w.imu, &turn);
    TEST_ASSERT_TRUE(face_of(turn.up) != '?');
}

/* Rests on no face, upside down, or the same again: it goes on from there. */
static void any_path_leads_back_to_the_tour(void)
{
    static const double edge[3] = {0, 0.70710678118654752, 0.70710678118654752};
    invcal_turn turn;
    double up[3];

    begin();
    add_face('z', INVCAL_OK);
    add_rest(edge, INVCAL_OK);
    invcal_imu_next(&imu, &turn);
    assert_turn(edge, &turn);
    TEST_ASSERT_EQUAL_INT('z', face_of(turn.up)); /* where the first turn begins */
    add_face('Z', INVCAL_OK);
    TEST_ASSERT_EQUAL_INT('y',
                          next()); /* no turn of the tour was made, and y is its first from here */
    add_face('Z', INVCAL_OK);
    TEST_ASSERT_EQUAL_INT('y', next());
    begin();
    add_face('z', INVCAL_OK);
    add_face('x', INVCAL_OK);
    add_face('y', INVCAL_OK);
    add_face('Y', INVCAL_OK); /* half a turn is none of the tour */
    invcal_imu_next(&imu, &turn);
    direction_of('Y', up);
    assert_turn(up, &turn);
    TEST_ASSERT_EQUAL_INT('x', face_of(turn.up));
}

static void assert_unknown(void)
{
    invcal_turn turn;
    char text[INVCAL_TEXT_SIZE];

    memset(&turn, 0x5A, sizeof turn);
    invcal_imu_next(&imu, &turn);
    TEST_ASSERT_TRUE(turn.angle == 0 && turn.up[0] == 0 && turn.up[1] == 0 && turn.up[2] == 1);
    TEST_ASSERT_EQUAL_STRING("+z up", invcal_imu_next_text(&imu, text));
}

static void without_a_rest_z_is_first(void)
{
    memset(&imu, 0, sizeof imu);
    assert_unknown();
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_session_init(&imu.session, sizeof imu.session, COUNTS_PER_G, RATE));
    assert_unknown();
    begin();
    assert_unknown();
}

/* As from damaged bytes. */
static void no_reading_does_harm(void)
{
    static const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 0, 1e38};
    invcal_turn turn;

    for (int k = 0; k < 5; k++) {
        for (int at = 0; at <= TOUR; at++) {
            begin();
            for (int i = 0; i <= TOUR; i++) {
                add_face(tour[i], INVCAL_OK);
            }
            for (int i = 0; i < 3; i++) {
                imu.session.mean[at].v[i] = (invcal_real)bad[k];
            }
            invcal_imu_next(&imu, &turn);
            double squares = 0;
            for (int i = 0; i < 3; i++) {
                squares += (double)turn.up[i] * (double)turn.up[i];
            }
            TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1, squares);
            TEST_ASSERT_TRUE(turn.angle >= 0 && turn.angle < 4);
        }
    }
}

/* A refused rest is none, and a move from a rest without its mean is not one of the tour. */
static void only_rests_with_a_mean_count(void)
{
    begin();
    for (int i = 0; i < 4; i++) {
        add_face(tour[i], INVCAL_OK);
    }
    imu.session.last = INVCAL_REFUSED;
    TEST_ASSERT_EQUAL_INT('X', next());
    memmove(&imu.session.mean[0], &imu.session.mean[1], 3 * sizeof imu.session.mean[0]);
    imu.session.count = 3;
    TEST_ASSERT_EQUAL_INT('x', next()); /* the turn from z to x is not known any more */
}

static void after_the_tour_a_bad_reading_leaves_z(void)
{
    static const double bad[3] = {NOT_A_NUMBER, 0, 0};

    begin();
    for (int i = 0; i <= TOUR; i++) {
        add_face(tour[i], INVCAL_OK);
    }
    add_rest(bad, INVCAL_OK);
    assert_unknown();
}

/* ---- a whole session, sample by sample ---------------------------------------------------------- */

static struct {
    random_source random;
    double up[3];
    double m[3][3];
    invcal_turn asked; /* when the last rest was READY */
    int ready, taken, refused;
    int gap; /* of the next turn: samples are lost */
} hand;

static void sample(const double rate[3], const double up[3])
{
    double inverse[3][3];
    int32_t raw[3];

    inverse3((const double(*)[3])hand.m, inverse);
    for (int i = 0; i < 3; i++) {
        const double nominal =
            inverse[i][0] * rate[0] + inverse[i][1] * rate[1] + inverse[i][2] * rate[2];
        raw[i] = (int32_t)lround(COUNTS * (0.01 + nominal + 1e-3 * random_normal(&hand.random)));
    }
    invcal_imu_feed_gyro(&imu, raw[0], raw[1], raw[2]);
    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)lround(COUNTS_PER_G * up[i] + 16 * random_normal(&hand.random));
    }
    switch (invcal_imu_feed(&imu, raw[0], raw[1], raw[2])) {
    case INVCAL_READY:
        hand.ready++;
        invcal_imu_next(&imu, &hand.asked);
        break;
    case INVCAL_TAKEN:
        hand.taken++;
        break;
    case INVCAL_REFUSED:
        hand.refused++;
        break;
    default:
        break;
    }
}

/* Turns by that, then rests. */
static void make(const invcal_turn *turn)
{
    enum { TURNING = 110, ALL = 320 };
    double c[3][3], up[3];

    world_unit(c);
    memcpy(up, hand.up, sizeof up);
    for (int n = 0; n < ALL; n++) {
        const double tau = n < TURNING ? (n + 0.5) / TURNING : 0;
        double step[3], rate[3], r[3][3];
        for (int i = 0; i < 3; i++) {
            step[i] = (double)turn->axis[i] * (double)turn->angle * 30 * tau * tau * (1 - tau) *
                      (1 - tau) / TURNING;
            rate[i] = RATE * step[i];
        }
        rotation_by(step, r);
        world_turn(c, (const double(*)[3])r);
        world_up((const double(*)[3])c, hand.up, up);
        if (hand.gap && n == TURNING / 2) {
            invcal_imu_gap(&imu);
            hand.gap = 0;
        }
        sample(rate, up);
    }
    memcpy(hand.up, up, sizeof up);
}

static void a_session_follows_what_it_is_asked_for(void)
{
    enum { LOST = 4, MORE = 3 };
    const invcal_turn none = {{0, 0, 1}, 0, {0, 0, 1}};
    invcal_turn half;
    static invcal_imu_result result;
    int8_t axes[3];
    invcal_real unit;
    char path[40] = "";
    double found = 0;
    int turns = 0;

    begin();
    memset(&hand, 0, sizeof hand);
    hand.random = random_start(5);
    hand.up[2] = 1;
    world_unit(hand.m);
    for (int i = 0; i < 9; i++) {
        hand.m[i / 3][i % 3] += 0.01 * random_normal(&hand.random);
    }
    make(&none);
    make(&none);
    while (face_of(hand.asked.up) != '?' && turns < 30) {
        path[turns] = face_of(hand.asked.up);
        hand.gap = turns == LOST;
        make(&hand.asked);
        TEST_ASSERT_EQUAL_INT(++turns + 1, hand.ready);
    }
    /* "xyzXy", lost: back to X, and the rest of the edges */
    TEST_ASSERT_EQUAL_INT(0, memcmp(path, "xyzXyX", 6));
    TEST_ASSERT_TRUE(turns >= TOUR + 1 && turns <= 18);
    for (int i = 0; i < MORE; i++) {
        make(&hand.asked);
    }
    half = hand.asked;
    half.angle = (invcal_real)(180 * DEGREE);
    hand.asked.angle = 0;
    make(&half); /* of which none is the shortest, but another turn is asked for */
    TEST_ASSERT_TRUE(hand.asked.angle > 0);
    for (int i = 0; i < 200; i++) { /* it moves again, so the last rest is taken */
        const double rate[3] = {sin(i * 0.3), cos(i * 0.3), 0};
        const double up[3] = {sin(i * 0.3), cos(i * 0.3), 0};
        sample(rate, up);
    }
    TEST_ASSERT_EQUAL_INT(hand.ready, hand.taken);
    TEST_ASSERT_EQUAL_INT(hand.taken, imu.session.count);
    TEST_ASSERT_EQUAL_INT(imu.session.count, imu.rests);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_solve(&imu, NULL, &result));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, result.verdict);
    TEST_ASSERT_EQUAL_INT(imu.rests - 2, result.moves);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_mounting(&imu, axes, &unit));
    TEST_ASSERT_TRUE(axes[0] == 1 && axes[1] == 2 && axes[2] == 3 && unit == 1);
    for (int i = 0; i < 9; i++) {
        const double sigma = (double)result.sigma[INVCAL_GYRO_XX + i];
        const double m = (double)result.gyro.matrix[i / 3][i % 3] * COUNTS;
        TEST_ASSERT_TRUE(sigma < 1e-3);
        found += pow((m - hand.m[i / 3][i % 3]) / sigma, 2) / 9;
    }
    TEST_ASSERT_TRUE(sqrt(found) < 2.5);
}

/* ---- the result applied ------------------------------------------------------------------------- */

static void g_sensitivity_is_subtracted_if_it_was_found(void)
{
    static const invcal_real a[3] = {INVCAL_REAL(0.5), INVCAL_REAL(-0.25), INVCAL_REAL(0.75)};
    invcal_imu_result r;
    invcal_real rate[3];

    memset(&r, 0, sizeof r);
    for (int i = 0; i < 3; i++) {
        r.gyro.offset[i] = (invcal_real)(10 * (i + 1));
        for (int j = 0; j < 3; j++) {
            r.gyro.matrix[i][j] = (invcal_real)((i == j ? 0.01 : 0) + 1e-4 * (3 * i + j));
            r.slope[i][j] = (invcal_real)(1e-3 * (1 + 3 * i - 2 * j));
        }
        r.slope[i][3] = 7; /* drift is not */
    }
    for (int used = 0; used < 2; used++) {
        r.g_is_used = (uint8_t)used;
        invcal_imu_apply(&r, 1000, -2000, 3000, a, rate);
        for (int i = 0; i < 3; i++) {
            const double raw[3] = {1000 - 10, -2000 - 20, 3000 - 30};
            double expected = 0;
            for (int j = 0; j < 3; j++) {
                expected += (double)r.gyro.matrix[i][j] * raw[j] -
                            (used ? (double)r.slope[i][j] * (double)a[j] : 0);
            }
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-13), expected, (double)rate[i]);
        }
    }
    const invcal_real unknown[3] = {(invcal_real)NAN, (invcal_real)NAN, (invcal_real)NAN};
    r.g_is_used = 0;
    invcal_imu_apply(&r, 10, 20, 30, unknown, rate);
    TEST_ASSERT_TRUE(rate[0] == 0 && rate[1] == 0 && rate[2] == 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_tour_is_asked_for_in_its_order);
    RUN_TEST(a_refused_turn_is_asked_for_again);
    RUN_TEST(what_is_asked_for_ends_with_every_edge);
    RUN_TEST(after_the_tour_it_is_the_most_informative_turn);
    RUN_TEST(any_path_leads_back_to_the_tour);
    RUN_TEST(without_a_rest_z_is_first);
    RUN_TEST(no_reading_does_harm);
    RUN_TEST(only_rests_with_a_mean_count);
    RUN_TEST(after_the_tour_a_bad_reading_leaves_z);
    RUN_TEST(a_session_follows_what_it_is_asked_for);
    RUN_TEST(g_sensitivity_is_subtracted_if_it_was_found);
    return UNITY_END() != 0;
}
