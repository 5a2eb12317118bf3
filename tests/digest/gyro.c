/* SPDX-License-Identifier: MIT
 *
 * Both sensors of an IMU, from a tour of quarter turns; and which turns would be best.
 */
#include "digest.h"
#include "invcal/positions.h"

#include "invcal/gyro_store.h"
#include "imu/turns.h"

enum { RATE = 100, TURN = 6 * RATE / 5, REST = 9 * RATE / 5 };

static const input_sensor accelerometer = {
    {490, -820, 330}, {{16712, 66, -98}, {66, 16138, 164}, {-98, 164, 16548}}, 8};
/* 65.5 counts per degree/s */
static const input_sensor gyro = {
    {85, -131, 24}, {{3660, 45, -15}, {-56, 3820, 26}, {11, -34, 3786}}, 3};

static invcal_imu both;
static invcal_imu_result imu;

/* ---- the hand ------------------------------------------------------------------------------- */

/* A step: the rate in its middle, rad/s, and the force at its end. */
static void read_sensors(const float rate[3], const float force[3])
{
    int32_t raw[3];

    input_sample(&gyro, rate, raw);
    invcal_imu_feed_gyro(&both, raw[0], raw[1], raw[2]);
    input_sample(&accelerometer, force, raw);
    const invcal_event event = invcal_imu_feed(&both, raw[0], raw[1], raw[2]);
    if (event >= INVCAL_READY) {
        digest_bits("event", event);
        digest_bits("rests", both.rests);
    }
}

/* In the axes of the device, up turns in the opposite sense. */
static void make_turn(const invcal_turn *turn, float up[3])
{
    const float speed = turn->angle * RATE / TURN;

    for (unsigned step = 0; step < TURN; step++) {
        const float part = ((float)step + 0.5f) / TURN;
        const float window = 30 * part * part * (1 - part) * (1 - part);
        float rate[3], back[3], force[3];
        for (int i = 0; i < 3; i++) {
            rate[i] = window * (speed * turn->axis[i] + 0.2f * (part - (float)i / 2));
            back[i] = -rate[i] / RATE;
        }
        input_turn(up, back);
        input_to_unit(up);
        for (int i = 0; i < 3; i++) {
            force[i] = up[i] + 0.05f * input_noise();
        }
        read_sensors(rate, force);
    }
}

static void rest(const float up[3])
{
    static const float none[3] = {0, 0, 0};

    for (unsigned step = 0; step < REST; step++) {
        read_sensors(none, up);
    }
}

/* ---- moves ---------------------------------------------------------------------------------- */

static void move_results(void)
{
    const invcal_private_moves *const moves = &both.own;

    digest_set("moves");
    digest_reals("bias", moves->bias, 3);
    for (unsigned i = 0; i < both.rests; i++) {
        digest_bits("reason", invcal_imu_move_reason(&both, i));
        digest_bits("when", moves->rest[i].when);
        for (int a = 0; a < 3; a++) {
            digest_bits("bias", (uint16_t)moves->rest[i].bias[a]);
        }
    }
    for (unsigned i = 0; i < moves->first; i++) {
        for (int a = 0; a < 3; a++) {
            digest_bits("v", (uint16_t)moves->segment[i].v[a]);
            digest_bits("kappa", (uint16_t)moves->segment[i].kappa[a]);
        }
        digest_bits("time", moves->segment[i].time);
    }
}

static void begin(void)
{
    static const float none[3] = {0, 0, 0};
    static const float g[3] = {16384, 16384, 16384};
    static const float degrees[3] = {3752.9f, 3752.9f, 3752.9f};
    invcal_calibration nominal;

    (void)invcal_nominal(none, g, &nominal);
    digest_bits("session",
                invcal_session_init_nominal(&both.session, sizeof both.session, &nominal, RATE));
    (void)invcal_nominal(none, degrees, &nominal);
    digest_bits("moves", invcal_imu_init_nominal(&both, sizeof both, &nominal, RATE));
    digest_bits("rails", invcal_imu_set_limits(&both, -32768, 32767));
}

static uint8_t slot[2][INVCAL_STORE_BYTES(INVCAL_IMU_SIZE, 1)];

static int read_slot(void *context, unsigned which, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &slot[which][offset], size);
    return 0;
}

static int erase_slot(void *context, unsigned which)
{
    (void)context;
    memset(slot[which], 0xFF, sizeof slot[which]);
    return 0;
}

static int program_slot(void *context, unsigned which, uint32_t offset, const uint8_t *bytes,
                        uint32_t size)
{
    (void)context;
    memcpy(&slot[which][offset], bytes, size);
    return 0;
}

/* What is not kept over a reset is lost. */
static void reset(void)
{
    static const invcal_store store = {read_slot, erase_slot,     program_slot,
                                       NULL,      sizeof slot[0], 1};

    digest_bits("saved", invcal_imu_save(&both, &store));
    begin();
    digest_bits("resumed", invcal_imu_load(&both, &store));
}

static void tour(void)
{
    float up[3] = {0, 0, 1};
    invcal_turn turn;

    digest_set("begin");
    begin();
    rest(up);
    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        digest_numbered("turn", i);
        digest_bits("status", invcali_tour(i, &turn));
        make_turn(&turn, up);
        rest(up);
        if (i == 6) {
            reset();
        }
    }
    digest_set("finish");
    const invcal_event event = invcal_session_end(&both.session);
    invcali_imu_follow(&both, event);
    digest_bits("event", event);
}

/* ---- the solution --------------------------------------------------------------------------- */

static void solve(void)
{
    const invcal_imu_settings unknown = {0, 0, 0, NULL};

    digest_set("solution");
    digest_bits("status", invcal_imu_solve(&both, &unknown, &imu));
    digest_calibration(&imu.gyro, &both.nominal);
    digest_calibration(&imu.accelerometer, &both.session.nominal);
    digest_reals("sigma", imu.sigma, INVCAL_IMU_PARAMETERS);
    digest_reals("slope", imu.slope[0], 12);
    digest_reals("slope_sigma", imu.slope_sigma[0], 12);
    digest_reals("noise", &imu.noise, 1);
    digest_reals("move_noise", &imu.move_noise, 1);
    digest_reals("move_rms", &imu.move_rms, 1);
    digest_reals("move_max", &imu.move_max, 1);
    digest_bits("left_out", (uint32_t)imu.left_out);
    digest_bits("idle", (uint32_t)imu.idle);
    digest_bits("weak", imu.weak);
    digest_bits("dof", imu.dof);
    digest_bits("worst", imu.worst);
    digest_bits("moves", imu.moves);
    digest_bits("verdict", imu.verdict);
    digest_bits("g_is_used", imu.g_is_used);
}

static void record_results(void)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    invcal_imu_result result;

    digest_set("record");
    digest_bits("encoded", invcal_imu_encode(&imu, NULL, bytes));
    digest_bytes("bytes", bytes, sizeof bytes);
    memset(&result, 0, sizeof result);
    digest_bits("decoded", invcal_imu_decode(bytes, sizeof bytes, &result, NULL));
    digest_reals("offset", result.gyro.offset, 3);
}

static void mounting(void)
{
    int8_t axes[3] = {0, 0, 0};
    float unit = 0;

    digest_set("mounting");
    digest_bits("status", invcal_imu_mounting(&both, axes, &unit));
    for (int i = 0; i < 3; i++) {
        digest_bits("axis", (uint8_t)axes[i]);
    }
    digest_reals("unit", &unit, 1);
}

/* ---- which turns ---------------------------------------------------------------------------- */

static void plan(const char *name, invcali_turns *turns, invcal_status status)
{
    digest_set(name);
    digest_bits("status", status);
    for (int i = 0; i < 4; i++) {
        float sigma[INVCAL_IMU_PARAMETERS];
        invcal_turn turn;
        uint32_t open = 0;
        invcali_turns_next(turns, &turn);
        digest_reals("axis", turn.axis, 3);
        digest_reals("angle", &turn.angle, 1);
        digest_reals("up", turn.up, 3);
        digest_bits("added", invcali_turns_add(turns, &turn));
        digest_bits("status", invcali_turns_sigma(turns, NULL, sigma, &open));
        digest_reals("sigma", sigma, INVCAL_IMU_PARAMETERS);
        digest_bits("open", open);
    }
}

static void next(void)
{
    char text[INVCAL_TEXT_SIZE];
    invcal_turn turn;

    digest_set("next");
    invcal_imu_next(&both, &turn);
    digest_reals("axis", turn.axis, 3);
    digest_reals("angle", &turn.angle, 1);
    digest_reals("up", turn.up, 3);
    (void)invcal_imu_next_text(&both, text);
    digest_bytes("text", (const uint8_t *)text, (unsigned)strlen(text));
}

void part_gyro(void)
{
    static const float up[3] = {0, 0, 1};
    static invcali_turns turns;

    tour();
    move_results();
    solve();
    record_results();
    mounting();
    plan("turns from the beginning", &turns, invcali_turns_begin(&turns, up, NULL, 0));
    const invcal_positions positions = invcali_imu_positions(&both);
    plan("turns after these", &turns, invcali_turns_after(&turns, &both, &positions, NULL));
    next();
}
