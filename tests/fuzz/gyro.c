/* SPDX-License-Identifier: MIT
 *
 * Moves and both sensors: samples, blocks of rests and of none in any order, gaps, rails; then a solution from
 * any means and settings. The table stays in order; what is delivered is finite, and a refusal says why.
 * fuzz: more than 20 inputs per second of CPU time
 */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "invcal/gyro.h"

enum { MOST = 40, BITS = 3 };

static invcal_moves moves;
static invcal_private_rests rests;
static double up[3];          /* as the samples turn it, if they are those of a hand */
static double resting[3];     /* in the newest quiet block */
static double taken[MOST][3]; /* in the rests */

/* The table is that of its rests, in their order, and nothing lies beyond it. */
static void look(void)
{
    unsigned segments = 0;

    REQUIRE(moves.count <= INVCAL_MAX_MOVES && moves.used <= INVCAL_MAX_SEGMENTS);
    REQUIRE(moves.first <= moves.fixed && moves.fixed <= moves.used);
    for (unsigned i = 0; i < moves.count; i++) {
        const invcal_status status = invcal_moves_reason(&moves, i);
        REQUIRE((status == INVCAL_OK) == (moves.rest[i].move > 0));
        REQUIRE(status == INVCAL_OK || *invcal_status_text(status) != '\0');
        segments += moves.rest[i].move > 0 ? (unsigned)moves.rest[i].move : 0;
    }
    REQUIRE(segments == moves.first);
    require_finite(moves.bias, 3);
}

/* A block, as the detector of rests would tell of it, or not. */
static void follow(source *s, unsigned kind)
{
    invcal_event event = INVCAL_MOVING;

    if (rests.pended == 0) {
        rests.begin = rests.time;
    }
    rests.time += 1u << BITS;
    if (kind % 8 < 4) {
        rests.pended = 2;
        rests.end = rests.time;
        memcpy(resting, up, sizeof up);
        event = kind % 8 == 1 ? INVCAL_READY : INVCAL_SETTLING;
    } else if (kind % 8 < 6) {
        event = kind % 8 == 4 ? INVCAL_TAKEN : INVCAL_REFUSED;
    }
    if (kind > 250) {
        rests.begin = take_u32(s);
        rests.end = take_u32(s);
    }
    invcal_moves_follow(&moves, &rests, event);
    if (event == INVCAL_TAKEN) {
        memmove(taken[0], taken[1], sizeof taken - sizeof taken[0]);
        memcpy(taken[MOST - 1], resting, sizeof resting);
    }
    if (event == INVCAL_TAKEN || event == INVCAL_REFUSED) {
        rests.pended = 0;
    }
    look();
}

/* Turns by omega, against which up turns the other way. */
static void turn(const int32_t raw[3])
{
    double omega[3], next[3];
    double length = 0;

    for (unsigned a = 0; a < 3; a++) {
        omega[a] = raw[a] * (double)moves.nominal.matrix[a][a] / (double)moves.rate;
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
        invcal_moves_feed(&moves, raw[0], raw[1], raw[2]);
        turn(raw);
    }
    require_finite(moves.v, 3);
    require_finite(moves.rho, 3);
}

static void solve(source *s)
{
    const unsigned count = take_byte(s) % 3 == 0 ? take_byte(s) % MOST : moves.count;
    const conditions c = take_conditions(s);
    invcal_real mean[MOST][3];
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    invcal_imu_settings settings = INVCAL_IMU_USUAL;
    invcal_imu out;
    int8_t axes[3];
    invcal_real unit;

    for (unsigned i = 0; i < count; i++) {
        for (unsigned a = 0; a < 3; a++) {
            mean[i][a] = take_real(s, (invcal_real)(1000 * taken[MOST - count + i][a]));
        }
    }
    settings.held = take_byte(s) % 2;
    settings.noise = take_real(s, INVCAL_REAL(0.001));
    settings.rate_noise = take_real(s, settings.rate_noise);
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        prior[i] = take_real(s, INVCAL_REAL(0.05));
    }
    settings.prior = take_byte(s) % 2 ? prior : NULL;
    const invcal_status status =
        invcal_imu_solve((const invcal_vector *)&mean[0][0], count, &c.nominal, &moves,
                         take_byte(s) % 4 ? &settings : NULL, &out);
    REQUIRE(*invcal_status_text(status) != '\0');
    if (status == INVCAL_OK) {
        require_finite(out.gyro.offset, 3);
        require_finite(out.parameter, INVCAL_IMU_PARAMETERS);
        require_sigma(out.sigma, INVCAL_IMU_PARAMETERS);
        require_sigma(&out.move_rms, 1);
        REQUIRE(out.moves > 0 && out.passes > 0 && out.verdict <= INVCAL_WEAK);
        REQUIRE((out.open != 0) == (out.verdict == INVCAL_WEAK));
        REQUIRE(out.worst < moves.count);
    }
    REQUIRE(status != INVCAL_UNDETERMINED || out.open < 1u << INVCAL_IMU_PARAMETERS);
    mark(axes, sizeof axes);
    if (invcal_imu_mounting((const invcal_vector *)&mean[0][0], count, &c.nominal, &moves, axes,
                            &unit) != INVCAL_OK) {
        require_mark(axes, sizeof axes);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    invcal_calibration nominal;

    memset(&nominal, 0, sizeof nominal);
    memset(&rests, 0, sizeof rests);
    memset(taken, 0, sizeof taken);
    memset(resting, 0, sizeof resting);
    up[0] = up[1] = 0;
    up[2] = 1;
    rests.bits = BITS;
    for (unsigned a = 0; a < 3; a++) {
        nominal.matrix[a][a] = take_real(&s, INVCAL_REAL(1e-4));
    }
    mark(&moves, sizeof moves);
    if (invcal_moves_init(&moves, sizeof moves, &nominal, take_real(&s, 100)) != INVCAL_OK) {
        REQUIRE(moves.layout == 0); /* which says that they are not begun */
        mark(&moves.layout, sizeof moves.layout);
        require_mark(&moves, sizeof moves);
        return 0;
    }
    while (s.left > 0) {
        const unsigned what = take_byte(&s);
        switch (what % 8) {
        case 0:
            invcal_moves_gap(&moves);
            look();
            break;
        case 1:
            (void)invcal_moves_set_limits(&moves, take_i32(&s), take_i32(&s));
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
