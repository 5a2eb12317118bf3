/* SPDX-License-Identifier: MIT
 *
 * Moves and both sensors: samples, blocks of rests and of none in any order, gaps, rails; then a solution from
 * any means and settings. The table stays in order; what is delivered is finite, and a refusal says why.
 * fuzz: more than 20 inputs per second of CPU time
 */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "imu/turns.h"

enum { MOST = 40, BITS = 3 };

static invcal_imu moves;
static invcal_private_rests *const rests = &moves.session.rests;
static double up[3];          /* as the samples turn it, if they are those of a hand */
static double resting[3];     /* in the newest quiet block */
static double taken[MOST][3]; /* in the rests */

/* The table is that of its rests, in their order, and nothing lies beyond it. */
static void look(void)
{
    unsigned segments = 0;

    REQUIRE(moves.rests <= INVCAL_MAX_MOVES && moves.own.used <= INVCAL_MAX_SEGMENTS);
    REQUIRE(moves.own.first <= moves.own.fixed && moves.own.fixed <= moves.own.used);
    for (unsigned i = 0; i < moves.rests; i++) {
        const invcal_status status = invcal_imu_move_reason(&moves, i);
        REQUIRE((status == INVCAL_OK) == (moves.own.rest[i].move > 0));
        REQUIRE(status == INVCAL_OK || *invcal_status_text(status) != '\0');
        segments += moves.own.rest[i].move > 0 ? (unsigned)moves.own.rest[i].move : 0;
    }
    REQUIRE(segments == moves.own.first);
    require_finite(moves.own.bias, 3);
}

/* A block, as the detector of rests would tell of it, or not. */
static void follow(source *s, unsigned kind)
{
    invcal_event event = INVCAL_MOVING;

    if (rests->pended == 0) {
        rests->begin = rests->time;
    }
    rests->time += 1u << BITS;
    if (kind % 8 < 4) {
        rests->pended = 2;
        rests->end = rests->time;
        memcpy(resting, up, sizeof up);
        event = kind % 8 == 1 ? INVCAL_READY : INVCAL_SETTLING;
    } else if (kind % 8 < 6) {
        event = kind % 8 == 4 ? INVCAL_TAKEN : INVCAL_REFUSED;
    }
    if (kind > 250) {
        rests->begin = take_u32(s);
        rests->end = take_u32(s);
    }
    invcali_imu_follow(&moves, event);
    if (event == INVCAL_TAKEN) {
        memmove(taken[0], taken[1], sizeof taken - sizeof taken[0]);
        memcpy(taken[MOST - 1], resting, sizeof resting);
    }
    if (event == INVCAL_TAKEN || event == INVCAL_REFUSED) {
        rests->pended = 0;
    }
    look();
}

/* Turns by omega, against which up turns the other way. */
static void turn(const int32_t raw[3])
{
    double omega[3], next[3];
    double length = 0;

    for (unsigned a = 0; a < 3; a++) {
        omega[a] = raw[a] * (double)moves.nominal.matrix[a][a] / (double)moves.own.rate;
    }
    for (unsigned a = 0; a < 3; a++) {
        const unsigned b = (a + 1) % 3;
        const unsigned c = (a + 2) % 3;
        next[a] = up[a] + up[b] * omega[c] - up[c] * omega[b];
        length += next[a] * next[a];
    }
    for (unsigned a = 0; a < 3 && length < 2; a++) {
        up[a] = next[a] / sqrt(length);
    }
}

/* Turns about some axis, at some rate; or anything. */
static void feed(source *s)
{
    const unsigned kind = take_byte(s);
    const unsigned count = take_byte(s) % 64;
    int32_t raw[3];

    for (unsigned a = 0; a < 3; a++) {
        const int32_t usual = (int32_t)take_byte(s) - 128;
        raw[a] = kind > 240 ? take_i32(s) : usual * (kind % 2 ? 20 : 2000);
    }
    for (unsigned i = 0; i < count; i++) {
        invcal_imu_feed_gyro(&moves, raw[0], raw[1], raw[2]);
        turn(raw);
    }
    require_finite(moves.own.v, 3);
    require_finite(moves.own.rho, 3);
}

static void solve(source *s)
{
    const unsigned count = take_byte(s) % 3 == 0 ? take_byte(s) % MOST : moves.rests;
    const conditions c = take_conditions(s);
    invcal_real mean[MOST][3];
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    invcal_positions positions = {(const invcal_vector *)&mean[0][0], count, &c.nominal, 0, NULL};
    invcal_imu_settings settings;
    invcal_imu_result out;
    int8_t axes[3];
    invcal_real unit;

    for (unsigned i = 0; i < count; i++) {
        for (unsigned a = 0; a < 3; a++) {
            mean[i][a] = take_real(s, (invcal_real)(1000 * taken[MOST - count + i][a]));
        }
    }
    memset(&settings, 0, sizeof settings);
    settings.held = take_byte(s) % 2;
    positions.noise = take_real(s, INVCAL_REAL(0.001));
    settings.rate_noise = take_real(s, INVCAL_REAL(8.7e-5));
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        prior[i] = take_real(s, INVCAL_REAL(0.05));
    }
    settings.prior = take_byte(s) % 2 ? prior : NULL;
    const invcal_status status =
        invcali_imu_solve_of(&moves, &positions, take_byte(s) % 4 ? &settings : NULL, &out);
    REQUIRE(*invcal_status_text(status) != '\0');
    if (status == INVCAL_OK) {
        require_finite(out.gyro.offset, 3);
        require_finite(&out.gyro.matrix[0][0], 9);
        require_sigma(out.sigma, INVCAL_IMU_PARAMETERS);
        require_sigma(&out.move_rms, 1);
        REQUIRE(out.moves > 0 && out.verdict <= INVCAL_WEAK);
        REQUIRE((out.weak != 0) == (out.verdict == INVCAL_WEAK));
        REQUIRE(out.worst < moves.rests);
    }
    REQUIRE(status != INVCAL_UNDETERMINED || out.weak < 1u << INVCAL_IMU_PARAMETERS);
    mark(axes, sizeof axes);
    if (invcali_imu_mounting_of(&moves, &positions, axes, &unit) != INVCAL_OK) {
        require_mark(axes, sizeof axes);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    invcal_calibration nominal;

    memset(&nominal, 0, sizeof nominal);
    memset(taken, 0, sizeof taken);
    memset(resting, 0, sizeof resting);
    up[0] = up[1] = 0;
    up[2] = 1;
    for (unsigned a = 0; a < 3; a++) {
        nominal.matrix[a][a] = take_real(&s, INVCAL_REAL(1e-4));
    }
    mark(&moves, sizeof moves);
    if (invcal_session_init(&moves.session, sizeof moves.session, 1000, 100) != INVCAL_OK) {
        REQUIRE(0);
    }
    if (invcal_imu_init_nominal(&moves, sizeof moves, &nominal, take_real(&s, 100)) != INVCAL_OK) {
        REQUIRE(moves.own.layout == 0); /* which says that they are not begun */
        REQUIRE(moves.session.reason != INVCAL_OK);
        mark(&moves.own.layout, sizeof moves.own.layout);
        mark(&moves.own.fault, 1);
        require_mark(&moves.own, sizeof moves.own);
        return 0;
    }
    memset(rests, 0, sizeof *rests);
    rests->bits = BITS;
    while (s.left > 0) {
        const unsigned what = take_byte(&s);
        switch (what % 8) {
        case 0:
            invcal_imu_gap(&moves);
            look();
            break;
        case 1:
            (void)invcal_imu_set_limits(&moves, take_i32(&s), take_i32(&s));
            break;
        case 2:
        case 3:
        case 4:
            feed(&s);
            break;
        case 5:
            if (what > 200) {
                solve(&s);
                break;
            } /* fall through */
        default:
            follow(&s, take_byte(&s));
            break;
        }
    }
    return 0;
}
