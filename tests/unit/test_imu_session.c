/* SPDX-License-Identifier: MIT
 *
 * Both sensors fed sample by sample, saved, reset, and continued: by their bytes, and through a
 * memory that loses power.
 */
#include <stddef.h>
#include <string.h>

#include "gyro_world.h"
#include "unity.h"

#define RATE 100 /* samples per second of both */
#define COUNTS_PER_G 16384
enum {
    FROM = offsetof(invcal_imu, own.layout),
    OF_MOVES = offsetof(invcal_imu, session) - FROM,
    OF_SESSION = offsetof(invcal_session, mean),
    MEAN = 3 * sizeof(invcal_real),
    SIZE = OF_MOVES + OF_SESSION + INVCAL_MAX_POSITIONS * MEAN,
    FILL = 0x5A
};

static invcal_imu both;
static invcal_imu back;
static uint8_t kept[SIZE + 32]; /* longer ones are tried, too */
static invcal_imu_result imu[2];

/* ---- a memory that loses power ------------------------------------------------------------------ */

enum { SLOT = SIZE + 64, GRANULE = 8 };
enum { LARGE = SIZE + 256 };
static uint8_t cells[2][SLOT];
static uint8_t used[2][SLOT];
static long power; /* bytes until it fails */
static int rules_broken;

static int read_cells(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    rules_broken += slot > 1 || size > 32 || offset + size > SLOT;
    memcpy(bytes, &cells[slot][offset], size);
    return power <= 0;
}

static int erase_cells(void *context, unsigned slot)
{
    (void)context;
    for (unsigned i = 0; i < SLOT && power > 0; i++, power--) {
        cells[slot][i] = 0xFF;
        used[slot][i] = 0;
    }
    return power <= 0;
}

static int program_cells(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context;
    rules_broken += slot > 1 || offset + size > SLOT || (offset | size) % GRANULE != 0;
    for (uint32_t i = 0; i < size && power > 0; i++, power--) {
        rules_broken += used[slot][offset + i];
        used[slot][offset + i] = 1;
        cells[slot][offset + i] &= bytes[i];
    }
    return power <= 0;
}

static const invcal_store store = {read_cells, erase_cells, program_cells, NULL, SLOT, GRANULE};

/* Another one, that never fails and holds more. */
static uint8_t large[2][LARGE];

static int read_large(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &large[slot][offset], size);
    return 0;
}

static int erase_large(void *context, unsigned slot)
{
    (void)context;
    memset(large[slot], 0xFF, LARGE);
    return 0;
}

static int program_large(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context;
    memcpy(&large[slot][offset], bytes, size);
    return 0;
}

static const invcal_store large_store = {read_large, erase_large, program_large, NULL, LARGE, 1};

/* ---- two sensors in a hand ---------------------------------------------------------------------- */

static struct {
    double m[3][3]; /* true rate = m nominal rate */
    triad_truth triad;
    double up[3];
    random_source random;
    int is_off;        /* nobody reads the sensors */
    unsigned reset_at; /* samples of the next move after which power is off for a moment; 0: none */
} hand;

/* What a device states whenever it begins; its memory has any contents. */
static void begin_both(invcal_imu *of)
{
    invcal_calibration gyro = unit_nominal();

    for (int i = 0; i < 3; i++) {
        gyro.matrix[i][i] = (invcal_real)(1 / COUNTS);
    }
    memset(of, FILL, sizeof *of);
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_session_init(&of->session, sizeof of->session, COUNTS_PER_G, RATE));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_init_nominal(of, sizeof *of, &gyro, RATE));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_limits(&of->session, -32768, 32767));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_set_limits(of, -5000000, 5000000));
}

static void begin(uint32_t seed)
{
    memset(&hand, 0, sizeof hand);
    hand.random = random_start(seed);
    hand.triad = triad_random(&hand.random, 0.02);
    world_unit(hand.m);
    for (int i = 0; i < 9; i++) {
        hand.m[i / 3][i % 3] += 0.01 * random_normal(&hand.random);
    }
    hand.up[2] = 1;
    begin_both(&both);
}

/* One sample of each, at the nominal rate, for this up direction. */
static invcal_event sample(const double rate[3], const double up[3])
{
    int32_t raw[3];
    double u[3];

    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)lround(COUNTS * (0.01 + rate[i] + 1e-3 * random_normal(&hand.random)));
    }
    if (!hand.is_off) {
        invcal_imu_feed_gyro(&both, raw[0], raw[1], raw[2]);
    }
    triad_read(&hand.triad, up, u);
    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)lround(COUNTS_PER_G * u[i] + 16 * random_normal(&hand.random));
    }
    if (hand.is_off) {
        return INVCAL_NOTHING;
    }
    return invcal_imu_feed(&both, raw[0], raw[1], raw[2]);
}

static uint32_t keep(const invcal_imu *of)
{
    const uint32_t size = OF_MOVES + invcal_session_size(&of->session);

    TEST_ASSERT_TRUE(size <= SIZE);
    memcpy(kept, (const uint8_t *)of + FROM, size);
    return size;
}

/* A device that begins, and resumes from these bytes. */
static invcal_status put_back(uint32_t size)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&large_store, kept, size));
    begin_both(&back);
    return invcal_imu_load(&back, &large_store);
}

/* Both are as they were begun: nothing is taken over. */
static void assert_as_begun(void)
{
    static invcal_imu begun;

    begin_both(&begun);
    TEST_ASSERT_EQUAL_MEMORY(&begun.own, &back.own, sizeof begun.own);
    TEST_ASSERT_EQUAL_MEMORY(&begun.session, &back.session, OF_SESSION);
    TEST_ASSERT_EQUAL_MEMORY(&begun.session.rests, &back.session.rests, sizeof begun.session.rests);
    TEST_ASSERT_EQUAL_UINT(0, back.session.count + back.rests);
}

static void put_back_refused(invcal_status expected, uint32_t size)
{
    TEST_ASSERT_EQUAL_INT(expected, put_back(size));
    assert_as_begun();
}

/* Turned by a quarter until `axis` (from 1; negative: down) is up, in 1.1 s; then held for 2 s. */
static unsigned turn_to(int axis)
{
    const double none[3] = {0, 0, 0};
    double vector[3], inverse[3][3], c[3][3], up[3];
    double to[3] = {0, 0, 0};
    unsigned taken = 0;

    to[(axis < 0 ? -axis : axis) - 1] = axis < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        vector[i] = hand.up[(i + 2) % 3] * to[(i + 1) % 3] - hand.up[(i + 1) % 3] * to[(i + 2) % 3];
    }
    const double length = length3(vector);
    const double dot = to[0] * hand.up[0] + to[1] * hand.up[1] + to[2] * hand.up[2];
    for (int i = 0; i < 3 && length > 0; i++) {
        vector[i] *= (atan2(length, dot) + 0.02 * random_normal(&hand.random)) / length;
    }
    inverse3((const double(*)[3])hand.m, inverse);
    world_unit(c);
    memcpy(up, hand.up, sizeof up);
    for (unsigned n = 0; n < 310; n++) {
        const double tau = n < 110 ? (n + 0.5) / 110 : 0;
        double step[3], r[3][3], rate[3];
        for (int i = 0; i < 3; i++) {
            step[i] = vector[i] * 30 * tau * tau * (1 - tau) * (1 - tau) / 110;
        }
        rotation_by(step, r);
        world_turn(c, (const double(*)[3])r);
        world_up((const double(*)[3])c, hand.up, up);
        for (int i = 0; i < 3; i++) {
            rate[i] = RATE *
                      (inverse[i][0] * step[0] + inverse[i][1] * step[1] + inverse[i][2] * step[2]);
        }
        if (hand.reset_at > 0 && n == hand.reset_at) {
            hand.is_off = 1;
        }
        if (hand.is_off && n == hand.reset_at + 10) { /* 0.1 s later: from its bytes alone */
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both)));
            memcpy(&both, &back, sizeof both);
            hand.is_off = 0;
            hand.reset_at = 0;
        }
        taken += sample(n < 110 ? rate : none, up) == INVCAL_TAKEN;
    }
    memcpy(hand.up, up, sizeof up);
    return taken;
}

static const int tour[] = {3, 1, 2, 3, -1, 2, -3, 1, -2, -3, -1, -2, 3};
enum { TOUR = sizeof tour / sizeof tour[0] };

/* Quarter turns until that many rests have ended. */
static void take(unsigned rests)
{
    for (unsigned k = 0; k < rests; k++) {
        (void)turn_to(tour[k % TOUR]);
    }
    TEST_ASSERT_EQUAL_UINT(rests - 1, both.session.count);
}

/* ---- what is kept ------------------------------------------------------------------------------- */

/* The part of the moves that lasts, from the header: numbers of this machine, one after the
 * other. */
static uint8_t *put(uint8_t *at, const void *what, size_t size)
{
    memcpy(at, what, size);
    return at + size;
}

static size_t reference(const invcal_imu *imu_of, uint8_t *bytes)
{
    const invcal_private_moves *m = &imu_of->own;
    const uint32_t layout = 0x62000000u + 0x1000u * sizeof(invcal_real) +
                            0x40000u * INVCAL_MAX_MOVES + INVCAL_MAX_SEGMENTS;
    const uint8_t nothing[3] = {0, 0, 0};
    uint8_t *at = bytes;

    at = put(at, &layout, 4);
    at = put(at, &m->low, 4);
    at = put(at, &m->between, 4);
    at = put(at, &m->blocks, 2);
    at = put(at, &m->first, 2);
    at = bytes + offsetof(invcal_imu, own.rate) - FROM; /* aligned */
    at = put(at, &m->rate, sizeof m->rate);
    at = put(at, m->bias, MEAN);
    for (unsigned i = 0; i < INVCAL_MAX_MOVES; i++) {
        at = put(at, m->rest[i].bias, 6);
        at = put(at, &m->rest[i].when, 2);
        at = put(at, &m->rest[i].move, 1);
        at = put(at, nothing,
                 offsetof(invcal_private_still, move) + 1 < sizeof(invcal_private_still));
    }
    for (unsigned i = 0; i < INVCAL_MAX_SEGMENTS; i++) {
        at = put(at, m->segment[i].v, 6);
        at = put(at, m->segment[i].kappa, 6);
        at = put(at, &m->segment[i].time, 2);
    }
    at = bytes + offsetof(invcal_imu, nominal) - FROM; /* the same */
    at = put(at, imu_of->nominal.offset, MEAN);
    at = put(at, imu_of->nominal.matrix, 3 * MEAN);
    at = put(at, &imu_of->rests, 1);
    return (size_t)(at - bytes);
}

static void what_lasts_is_what_was_taken(void)
{
    static uint8_t expected[SIZE];

    begin(1);
    take(4);
    const uint32_t size = keep(&both);
    const size_t of_moves = reference(&both, expected);
    TEST_ASSERT_TRUE(of_moves <= OF_MOVES && OF_MOVES - of_moves < sizeof(uint64_t)); /* aligned */
    TEST_ASSERT_EQUAL_MEMORY(expected, kept, of_moves);
    TEST_ASSERT_EQUAL_UINT32(OF_MOVES + OF_SESSION + 3 * MEAN, size);
    TEST_ASSERT_EQUAL_MEMORY(&both.session, kept + OF_MOVES, size - OF_MOVES);
    TEST_ASSERT_EQUAL_UINT32(SIZE, INVCAL_IMU_SIZE);
#if INVCAL_MAX_SEGMENTS == 192 && INVCAL_MAX_MOVES == 32 /* as if it were copied from a device */
    TEST_ASSERT_EQUAL_HEX32(sizeof(invcal_real) == 8 ? 0x628080C0u : 0x628040C0u, both.own.layout);
#endif
}

/* Everything that lasts, and nothing of the stream. */
static void assert_back(void)
{
    TEST_ASSERT_EQUAL_MEMORY(&both.own.layout, &back.own.layout,
                             sizeof(invcal_private_moves) - offsetof(invcal_private_moves, layout));
    TEST_ASSERT_EQUAL_UINT(both.session.count, back.session.count);
    for (unsigned i = 0; i < both.session.count; i++) {
        TEST_ASSERT_EQUAL_MEMORY(both.session.mean[i].v, back.session.mean[i].v, MEAN);
    }
    TEST_ASSERT_EQUAL_MEMORY(&both.session.nominal, &back.session.nominal,
                             sizeof both.session.nominal);
    TEST_ASSERT_EQUAL_UINT(back.own.first, back.own.fixed);
    TEST_ASSERT_EQUAL_UINT(back.own.first, back.own.used);
    TEST_ASSERT_EQUAL_UINT(0, back.own.marks + back.own.missing + back.own.spoilt);
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_TRUE(back.own.rho[i] == 0 && back.own.v[i] == 0 && back.own.still[i] == 0);
    }
}

static invcal_status solve(const invcal_imu *of, invcal_imu_result *out)
{
    return invcal_imu_solve(of, NULL, out);
}

/* After each rest, and at each time in a move and in the rest after it. */
static void both_come_back_as_they_were(void)
{
    const double none[3] = {0, 0, 0};

    begin(2);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both))); /* nothing yet */
    assert_back();
    for (unsigned k = 0; k < TOUR; k++) {
        (void)turn_to(tour[k]);
        for (unsigned n = 0; n < 25; n++) {
            (void)sample(none, hand.up);
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both)));
            assert_back();
        }
        memset(imu, 0, sizeof imu);
        TEST_ASSERT_EQUAL_INT(solve(&both, &imu[0]), solve(&back, &imu[1]));
        TEST_ASSERT_EQUAL_MEMORY(&imu[0].gyro, &imu[1].gyro, sizeof imu[0].gyro);
    }
    TEST_ASSERT_EQUAL_UINT(TOUR - 1, both.rests);
}

/* At any time in a move: rests and the other moves stay, that one is refused as a gap, and in the
 * end the result is that of the others. */
static void a_reset_in_a_move_loses_that_move(void)
{
    for (unsigned at = 10; at < 120; at += SLOW(20, 60)) {
        unsigned refused = 0;
        begin(3);
        for (unsigned k = 0; k < TOUR + 4; k++) {
            hand.reset_at = k == 5 ? at : 0;
            (void)turn_to(tour[k % TOUR]);
        }
        TEST_ASSERT_EQUAL_UINT(both.session.count, both.rests);
        for (unsigned i = 1; i < both.rests; i++) {
            const invcal_status reason = invcal_imu_move_reason(&both, i);
            refused += reason != INVCAL_OK;
            TEST_ASSERT_TRUE(reason == INVCAL_OK || reason == INVCAL_MOVE_GAP);
        }
        TEST_ASSERT_EQUAL_UINT(1, refused);
        TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&both, 0));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, solve(&both, &imu[0]));
        TEST_ASSERT_EQUAL_UINT(0, imu[0].left_out);
        for (int i = 0; i < 9; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(4 * (double)imu[0].sigma[INVCAL_GYRO_XX + i],
                                      hand.m[i / 3][i % 3],
                                      (double)imu[0].gyro.matrix[i / 3][i % 3] * COUNTS);
            TEST_ASSERT_TRUE(imu[0].sigma[INVCAL_GYRO_XX + i] < INVCAL_REAL(3e-3));
        }
    }
}

/* Resumed at rest, without a reset in that rest: as often as necessary. */
static void a_reset_after_each_rest_leaves_only_rests(void)
{
    begin(4);
    for (unsigned k = 0; k < 6; k++) {
        hand.reset_at = k > 0 ? 60 : 0;
        (void)turn_to(tour[k]);
    }
    /* the rest that ended was not taken, as power failed before */
    TEST_ASSERT_EQUAL_UINT(both.session.count, both.rests);
    for (unsigned i = 1; i < both.rests; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&both, i));
    }
    TEST_ASSERT_EQUAL_UINT(0, both.own.first);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, solve(&both, &imu[0]));
}

/* ---- what is refused ---------------------------------------------------------------------------- */

/* Another version, number type, order of bytes, number of moves or of segments. */
static void another_layout_is_of_another_build(void)
{
    const uint32_t layout = OF_MOVES + offsetof(invcal_session, layout);

    begin(5);
    take(3);
    const uint32_t size = keep(&both);
    for (unsigned bit = 0; bit < 32; bit++) {
        kept[bit / 8] ^= (uint8_t)(1u << bit % 8);
        put_back_refused(INVCAL_OTHER_SETTINGS, size);
        kept[bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
    for (unsigned bit = 0; bit < 32; bit++) { /* of the session */
        kept[layout + bit / 8] ^= (uint8_t)(1u << bit % 8);
        put_back_refused(INVCAL_OTHER_SETTINGS, size);
        kept[layout + bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(size));
}

static void another_length_is_refused(void)
{
    begin(6);
    take(3);
    const uint32_t size = keep(&both);
    for (uint32_t other = 1; other <= SIZE + 20; other += other % 8 < 7 ? 1 : SLOW(1, 50)) {
        if (other == size) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(other));
        } else {
            put_back_refused(other < OF_MOVES ? INVCAL_OTHER_SETTINGS
                             : other <= SIZE  ? INVCAL_DAMAGED
                                              : INVCAL_NO_SPACE,
                             other);
        }
    }
}

/* The result of resuming changed contents; then restores them. */
static void comes_back_as(invcal_status expected, invcal_imu *changed)
{
    TEST_ASSERT_EQUAL_INT(expected, put_back(keep(changed)));
    if (expected != INVCAL_OK) {
        assert_as_begun();
    }
    memcpy(changed, &both, sizeof both);
}

/* Other rails, noise, time to hold: what was taken comes, and what was stated now stays. */
static void what_was_stated_stays_as_it_was_begun(void)
{
    begin(14);
    take(4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_set_limits(&both, -7, 8));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_limits(&both.session, -9, 10));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_noise(&both.session, INVCAL_REAL(0.001)));
    invcal_session_set_hold(&both.session, 5);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both)));
    TEST_ASSERT_EQUAL_UINT(3, back.session.count);
    TEST_ASSERT_EQUAL_UINT(3, back.rests);
    TEST_ASSERT_EQUAL_INT32(-5000000, back.own.low);
    TEST_ASSERT_EQUAL_UINT32(9999999, back.own.between);
    TEST_ASSERT_EQUAL_INT32(-32768, back.session.rests.low);
    TEST_ASSERT_TRUE(back.session.noise == 0);
    invcal_session_set_hold(&both.session, 0); /* as if never called */
    TEST_ASSERT_EQUAL_UINT(both.session.rests.dwell, back.session.rests.dwell);
}

/* Of either sensor, in any bit: neither rate nor nominal calibration may be another one. */
static void other_settings_of_either_sensor_are_refused(void)
{
    const size_t rates[2] = {offsetof(invcal_imu, own.rate) - FROM,
                             OF_MOVES + offsetof(invcal_session, rate)};
    const size_t nominals[2] = {offsetof(invcal_imu, nominal) - FROM,
                                OF_MOVES + offsetof(invcal_session, nominal)};

    begin(15);
    take(3);
    const uint32_t size = keep(&both);
    for (unsigned which = 0; which < 2; which++) {
        for (size_t i = 0; i < sizeof(invcal_real); i++) {
            kept[rates[which] + i] ^= 1;
            put_back_refused(INVCAL_OTHER_SETTINGS, size);
            kept[rates[which] + i] ^= 1;
        }
        for (size_t i = 0; i < sizeof(invcal_calibration); i++) {
            kept[nominals[which] + i] ^= 0x80;
            put_back_refused(INVCAL_OTHER_SETTINGS, size);
            kept[nominals[which] + i] ^= 0x80;
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(size));
}

/* Both must be begun: one alone takes nothing over. */
static void what_was_not_begun_is_not_resumed(void)
{
    begin(16);
    take(4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save(&both, &large_store));
    for (unsigned i = 1; i < 4; i++) {
        begin_both(&back);
        if (i & 1) {
            memset(&back.own, 0, sizeof back.own);
            TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_save(&back, &large_store));
        }
        if (i & 2) {
            memset(&back.session, 0, sizeof back.session);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_load(&back, &large_store));
        TEST_ASSERT_EQUAL_UINT(0, back.session.count);
        if (i & 1) { /* and stays so */
            TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_load(&back, &large_store));
        } else {
            TEST_ASSERT_EQUAL_UINT(0, back.rests);
        }
        if (i & 2) {
            TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcal_session_feed(&back.session, 1, 2, 3));
            TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_session_reason(&back.session));
        }
    }
}

/* Into a session that has positions and moves already: those go, too. */
static void refused_bytes_leave_nothing_behind(void)
{
    static const struct {
        uint32_t size;
        invcal_status status;
    } wrong[] = {{OF_MOVES, INVCAL_DAMAGED},
                 {OF_MOVES + OF_SESSION, INVCAL_DAMAGED},
                 {SIZE, INVCAL_DAMAGED},
                 {SIZE + 1, INVCAL_NO_SPACE}};
    static uint8_t bytes[SIZE + 1];

    begin(17);
    take(4);
    const uint32_t size = keep(&both);
    memcpy(bytes, kept, sizeof bytes);
    for (unsigned i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(size));
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&large_store, bytes, wrong[i].size));
        TEST_ASSERT_EQUAL_INT(wrong[i].status, invcal_imu_load(&back, &large_store));
        assert_as_begun();
    }
}

static void contents_that_moves_cannot_have_are_refused(void)
{
    static const double rates[] = {7.99, 8000.1, 0, -100, NOT_A_NUMBER, INFINITE, 8, 8000};
    static invcal_imu c;

    begin(7);
    take(6);
    memcpy(&c, &both, sizeof c);
    comes_back_as(INVCAL_OK, &c);
    for (unsigned i = 0; i < 8; i++) {
        c.own.rate = (invcal_real)rates[i];
        comes_back_as(INVCAL_OTHER_SETTINGS, &c);
    }
    for (unsigned i = 0; i < 9; i++) {
        c.nominal.matrix[i / 3][i % 3] = (invcal_real)NOT_A_NUMBER;
        comes_back_as(INVCAL_OTHER_SETTINGS, &c);
    }
    memset(c.nominal.matrix, 0, sizeof c.nominal.matrix);
    comes_back_as(INVCAL_OTHER_SETTINGS, &c);
    for (unsigned i = 0; i < 3; i++) {
        c.own.bias[i] = (invcal_real)INFINITE;
        comes_back_as(INVCAL_DAMAGED, &c);
        c.own.bias[i] = (invcal_real)NOT_A_NUMBER;
        comes_back_as(INVCAL_DAMAGED, &c);
    }
    c.own.low = INT32_MAX; /* no rails at all, which are not read */
    c.own.between = UINT32_MAX;
    comes_back_as(INVCAL_OK, &c);
    c.rests = INVCAL_MAX_MOVES + 1;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.rests--;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.rests = 255;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.first = INVCAL_MAX_SEGMENTS + 1;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.first--;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.rest[2].move++;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.rest[2].move = 0;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.first = (uint16_t)(c.own.first - c.own.rest[2].move);
    c.own.rest[2].move = 0; /* neither segments nor a reason */
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.first = (uint16_t)(c.own.first - c.own.rest[2].move + 1);
    c.own.rest[2].move = 1;
    comes_back_as(INVCAL_OK, &c);
    c.own.rest[0].move = 1;
    c.own.first++;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.rest[0].move = -INVCAL_STATUS_END;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.rest[0].move = INT8_MIN;
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.rest[0].move = -INVCAL_MOUNTING;
    comes_back_as(INVCAL_OK, &c);
    c.own.rest[3].when = (uint16_t)(c.own.rest[4].when + 1);
    comes_back_as(INVCAL_DAMAGED, &c);
    c.own.blocks = (uint16_t)(c.own.rest[4].when - 1);
    comes_back_as(INVCAL_DAMAGED, &c);
    c.session.noise = (invcal_real)NOT_A_NUMBER; /* not read */
    comes_back_as(INVCAL_OK, &c);
}

/* Valid tables, except that they are too large. */
static void one_more_than_fits_is_refused(void)
{
    static invcal_imu c;

    begin(12);
    for (unsigned i = 0; i < INVCAL_MAX_MOVES; i++) {
        both.own.rest[i].when = 0;
        both.own.rest[i].move = -INVCAL_MOVE_GAP;
    }
    both.rests = INVCAL_MAX_MOVES;
    memcpy(&c, &both, sizeof c);
    comes_back_as(INVCAL_OK, &c);
    memset(c.own.segment, 0xFF, sizeof c.own.segment); /* as a rest: of a reason */
    c.own.blocks = UINT16_MAX;
    c.rests++;
    comes_back_as(INVCAL_DAMAGED, &c);
    for (unsigned more = 0; more < 2; more++) {
        unsigned left = INVCAL_MAX_SEGMENTS + more;
        c.own.first = (uint16_t)left;
        for (unsigned i = 1; left > 0; i++) {
            const unsigned segments = left < 100 ? left : 100;
            c.own.rest[i].move = (int8_t)segments;
            left -= segments;
        }
        comes_back_as(more ? INVCAL_DAMAGED : INVCAL_OK, &c);
    }
}

/* Also for the only rest. */
static void the_move_of_a_reset_is_a_gap(void)
{
    begin(13);
    take(2);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both)));
    memcpy(&both, &back, sizeof both);
    (void)turn_to(tour[2]);
    (void)turn_to(tour[3]);
    TEST_ASSERT_TRUE(both.rests >= 2);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_imu_move_reason(&both, 0));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVE_GAP, invcal_imu_move_reason(&both, 1));
}

/* As many segments as fit into the table stay; INVCAL_MAX_MOVES rests, too. */
static void a_full_table_comes_back(void)
{
    begin(8);
    take(3);
    memset(both.own.rest, 0, sizeof both.own.rest);
    unsigned left = INVCAL_MAX_SEGMENTS;
    for (unsigned i = 0; i < INVCAL_MAX_MOVES; i++) {
        const unsigned segments = left < 127 ? left : 127;
        both.own.rest[i].move =
            (int8_t)(i == 0 || segments == 0 ? -INVCAL_NO_SPACE : (int)segments);
        left -= i == 0 ? 0 : segments;
    }
    both.rests = INVCAL_MAX_MOVES;
    both.own.first = (uint16_t)(INVCAL_MAX_SEGMENTS - left);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, put_back(keep(&both)));
    assert_back();
    memcpy(&both, &back, sizeof both);
    for (unsigned k = 0; k < 3; k++) { /* and can be fed */
        (void)turn_to(tour[k]);
    }
    TEST_ASSERT_EQUAL_UINT(INVCAL_MAX_MOVES, both.rests);
}

/* What is accepted can be fed and solved. */
static void any_content_does_no_harm(void)
{
    const double none[3] = {0, 0, 0};
    random_source random = random_start(3);
    unsigned accepted = 0;

    begin(9);
    take(10);
    const uint32_t size = keep(&both);
    static uint8_t sound[SIZE];
    memcpy(sound, kept, size);
    for (unsigned k = 0; k < 3000; k++) {
        memcpy(kept, sound, size);
        for (unsigned i = 0; i < 1 + k % 3; i++) {
            const uint32_t most = k % 2 ? size : 84 + 10 * INVCAL_MAX_MOVES;
            kept[(uint32_t)random_uniform(&random, 4, most)] =
                (uint8_t)random_uniform(&random, 0, 256);
        }
        if (put_back(size) != INVCAL_OK) {
            assert_as_begun();
        } else {
            accepted++;
            memcpy(&both, &back, sizeof both);
            (void)solve(&both, &imu[0]);
            for (unsigned n = 0; n < 30; n++) {
                (void)sample(none, hand.up);
            }
        }
    }
    TEST_ASSERT_TRUE(accepted > 300 && accepted < 2900);
}

/* ---- power cuts ----------------------------------------------------------------------------------- */

void setUp(void)
{
    memset(cells, 0xFF, sizeof cells);
    memset(used, 0, sizeof used);
    power = 1000000;
    rules_broken = 0;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, rules_broken, "a rule of the memory was broken");
}

/* Wherever power fails, means and moves belong to the same rest: both old or both new. */
static void a_power_cut_at_any_byte_of_a_save_keeps_both_together(void)
{
    static invcal_imu before;
    static uint8_t old_cells[2][SLOT], old_used[2][SLOT];
    int found[2] = {0, 0};
    int saved = 0;

    begin(10);
    take(5);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save(&both, &store));
    memcpy(&before, &both, sizeof both);
    (void)turn_to(tour[5]);
    TEST_ASSERT_EQUAL_UINT(before.session.count + 1u, both.session.count);
    memcpy(old_cells, cells, sizeof cells);
    memcpy(old_used, used, sizeof used);
    for (long cut = 1; !saved; cut += cut % 64 == 63 || cut < 200 ? 1 : 7) {
        memcpy(cells, old_cells, sizeof cells);
        memcpy(used, old_used, sizeof used);
        power = cut;
        saved = invcal_imu_save(&both, &store) == INVCAL_OK;
        power = 1000000;
        begin_both(&back);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_load(&back, &store));
        const int is_new = back.session.count == both.session.count;
        const invcal_imu *expected = is_new ? &both : &before;
        TEST_ASSERT_EQUAL_MEMORY((const uint8_t *)expected + offsetof(invcal_private_moves, layout),
                                 (const uint8_t *)&back + offsetof(invcal_private_moves, layout),
                                 sizeof(invcal_private_moves) -
                                     offsetof(invcal_private_moves, layout));
        TEST_ASSERT_EQUAL_MEMORY(expected->session.mean, back.session.mean,
                                 expected->session.count * MEAN);
        TEST_ASSERT_TRUE(!saved || is_new);
        found[is_new]++;
    }
    TEST_ASSERT_TRUE(found[0] > 500 && found[1] > 0);
}

static void load_refused(invcal_status expected)
{
    begin_both(&back);
    TEST_ASSERT_EQUAL_INT(expected, invcal_imu_load(&back, &store));
    assert_as_begun();
}

static void what_is_not_a_session_of_both_is_not_loaded(void)
{
    static uint8_t too_large[SIZE + 1];

    begin(11);
    take(3);
    load_refused(INVCAL_NO_RECORD);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_save(&both.session, &store)); /* one sensor */
    load_refused(INVCAL_OTHER_SETTINGS);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, too_large, 1));
    load_refused(INVCAL_OTHER_SETTINGS);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&store, too_large, sizeof too_large));
    load_refused(INVCAL_NO_SPACE);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save(&both, &store));
    memset(&back, 0, sizeof back);
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_imu_load(&back, &store));
    TEST_ASSERT_EACH_EQUAL_HEX8(0, &back, sizeof back);
    begin_both(&back);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_load(&back, &store));
    assert_back();
}

/* A memory that fails costs what was taken, but leaves both as they were begun. */
static void a_failing_memory_leaves_both_as_they_were_begun(void)
{
    begin(18);
    take(3);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_save(&both, &store));
    power = 0;
    load_refused(INVCAL_IO);
    power = 1000000;
    begin_both(&back);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_imu_load(&back, &store));
    assert_back();
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(what_lasts_is_what_was_taken);
    RUN_SLOW_TEST(both_come_back_as_they_were);
    RUN_SLOW_TEST(a_reset_in_a_move_loses_that_move);
    RUN_TEST(a_reset_after_each_rest_leaves_only_rests);
    RUN_TEST(another_layout_is_of_another_build);
    RUN_SLOW_TEST(another_length_is_refused);
    RUN_TEST(what_was_stated_stays_as_it_was_begun);
    RUN_TEST(other_settings_of_either_sensor_are_refused);
    RUN_TEST(what_was_not_begun_is_not_resumed);
    RUN_TEST(refused_bytes_leave_nothing_behind);
    RUN_TEST(contents_that_moves_cannot_have_are_refused);
    RUN_TEST(one_more_than_fits_is_refused);
    RUN_TEST(the_move_of_a_reset_is_a_gap);
    RUN_TEST(a_full_table_comes_back);
    RUN_LONG_TEST(any_content_does_no_harm);
    RUN_LONG_TEST(a_power_cut_at_any_byte_of_a_save_keeps_both_together);
    RUN_TEST(what_is_not_a_session_of_both_is_not_loaded);
    RUN_TEST(a_failing_memory_leaves_both_as_they_were_begun);
    return UNITY_END() != 0;
}
