/* SPDX-License-Identifier: MIT
 *
 * Instructions (AVR: cycles) that each operation takes, by the counter of the emulated machine.
 * Prints one line for each, its name and the figure, and OK. Counting itself is subtracted. What a
 * user waits for comes first; with BENCH_TRACED=1, which is for cycles.py, it is all.
 */
#include <string.h>

#include "../positions.h"
#include "../report.h"
#include "plan/guidance.h"
#include "invcal/allan.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "invcal/frame.h"
#include "invcal/magnetometer.h"
#include "imu/turns.h"
#include "invcal/plan.h"
#include "invcal/store.h"
#include "invcal/thermal.h"

#ifndef BENCH_TRACED
#define BENCH_TRACED 0
#endif

enum { POSITIONS = 18, REPEATS = 16 };

/* The paper's program of 18 positions read by a sensor with errors of some percent, raw counts. */
static invcal_real raw[POSITIONS][3];
static invcal_calibration nominal;
static invcal_session session;

/* ---- the clock ------------------------------------------------------------------------------ */

static uint32_t idle; /* the cost of two readings of the counter */
static uint32_t begun;

/* Of what must not fail. */
static void require(invcal_status status)
{
    if (status != INVCAL_OK) {
        board_exit(1);
    }
}

static void begin(void)
{
    begun = board_count();
}

static uint32_t end(void)
{
    return board_count() - begun - idle;
}

/* ---- what is measured ----------------------------------------------------------------------- */

static void make_positions(void)
{
    static const invcal_real matrix[3][3] = {{INVCAL_REAL(1.02), INVCAL_REAL(0.01), 0},
                                             {INVCAL_REAL(-0.01), INVCAL_REAL(0.97), 0},
                                             {INVCAL_REAL(0.02), 0, INVCAL_REAL(1.01)}};
    const invcal_real zero[3] = {0, 0, 0};
    const invcal_real counts[3] = {8192, 8192, 8192};
    invcal_plan plan;
    invcal_plan_position p;

    require(invcal_plan_init(&plan, POSITIONS / 3));
    (void)invcal_nominal(zero, counts, &nominal);
    for (unsigned i = 0; i < POSITIONS; i++) {
        require(invcal_plan_get(&plan, i, &p));
        for (unsigned a = 0; a < 3; a++) {
            invcal_real sum = INVCAL_REAL(0.01);
            for (unsigned c = 0; c < 3; c++) {
                sum += matrix[a][c] * p.up[c];
            }
            /* whole counts give some noise, like a sensor's */
            raw[i][a] = (invcal_real)(int32_t)(8192 * sum);
        }
    }
}

static void bench_core(void)
{
    invcal_sums sums;
    invcal_calibration calibration;
    invcal_real calibrated[3];

    begin();
    invcal_sums_init(&sums);
    for (unsigned i = 0; i < POSITIONS; i++) {
        (void)invcal_sums_add(&sums, &nominal, raw[i], 1);
    }
    const invcal_status status = invcal_sums_solve(&sums, &nominal, &calibration);
    report("18_positions_and_solve", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
    invcal_sums_init(&sums);
    for (unsigned i = 1; i < POSITIONS; i++) {
        (void)invcal_sums_add(&sums, &nominal, raw[i], 1);
    }
    begin();
    (void)invcal_sums_add(&sums, &nominal, raw[0], 1);
    report("add_position", end());
    begin();
    (void)invcal_sums_solve(&sums, &nominal, &calibration);
    report("solve", end());
    begin();
    for (unsigned i = 0; i < REPEATS; i++) {
        invcal_apply(&calibration, raw[i][0], raw[i][1], raw[i][2], calibrated);
    }
    report("apply", end() / REPEATS);
}

/* A sine, within 1 %: its parabola, corrected (Bhaskara). */
static invcal_real wave(invcal_real angle)
{
    const invcal_real turns = angle / INVCAL_REAL(6.2831853);
    const invcal_real phase = turns - (invcal_real)(int32_t)turns; /* 0 ... 1 */
    const invcal_real x = phase < INVCAL_REAL(0.5) ? phase : phase - INVCAL_REAL(0.5);
    const invcal_real y = 16 * x * (INVCAL_REAL(0.5) - x);
    const invcal_real half = 4 * y / (5 - y);

    return phase < INVCAL_REAL(0.5) ? half : -half;
}

/* Three faces, each twice. */
static void bench_frame(void)
{
    invcal_frame frame;
    invcal_frame_quality quality;
    invcal_rotation rotation;

    invcal_frame_init(&frame);
    for (unsigned i = 0; i < 6; i++) {
        const invcal_real up[3] = {i % 3 == 0, i % 3 == 1, i % 3 == 2};
        const invcal_real mean[3] = {nominal.offset[0] + up[0] / nominal.matrix[0][0],
                                     nominal.offset[1] + up[1] / nominal.matrix[1][1],
                                     nominal.offset[2] + up[2] / nominal.matrix[2][2]};
        begin();
        (void)invcal_frame_add(&frame, &nominal, mean, up);
        const uint32_t count = end();
        if (i == 5) {
            report("frame_add", count);
        }
    }
    begin();
    const invcal_status status = invcal_frame_solve(&frame, &rotation, &quality);
    report("frame_solve", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
}

/* A magnetometer that turns about two axes at different rates: only samples; samples with looks;
 * and the solution. */
static void bench_magnetometer(void)
{
    static invcal_magnetometer magnetometer;
    invcal_magnetometer_found found;
    invcal_calibration calibration;
    invcal_quality quality;
    uint32_t total = 0;
    uint32_t samples = 0;
    uint32_t most = 0;
    uint32_t next = 0;
    invcal_real along[3];
    enum { MOTION = 12000 };

    require(invcal_magnetometer_init(&magnetometer, &nominal));
    for (unsigned i = 0; i < MOTION; i++) {
        const invcal_real t = (invcal_real)(int32_t)i / 100;
        const invcal_real s[4] = {wave(2 * t), wave(2 * t + INVCAL_REAL(1.5707963)),
                                  wave(INVCAL_REAL(0.73) * t),
                                  wave(INVCAL_REAL(0.73) * t + INVCAL_REAL(1.5707963))};
        const invcal_real field[3] = {8200 * s[0] * s[3], 8000 * s[0] * s[2], 8300 * s[1] + 3000};
        const uint32_t due = magnetometer.own.due;
        begin();
        (void)invcal_magnetometer_feed(&magnetometer, field[0], field[1], field[2]);
        const uint32_t count = end();
        total += count;
        if (i % 1000 == 1) {
            begin();
            invcal_magnetometer_next(&magnetometer, along);
            const uint32_t once = end();
            next = once > next ? once : next;
        }
        if (magnetometer.own.due == due) {
            samples += count;
        } else if (count > most) {
            most = count;
        }
    }
    report("magnetometer_sample", samples / MOTION);
    report("magnetometer_with_looks", total / MOTION);
    report("magnetometer_look", most);
    report("magnetometer_next", next);
    begin();
    const invcal_status status =
        invcal_magnetometer_solve(&magnetometer, &calibration, &quality, &found);
    report("magnetometer_solve", end());
    if (status != INVCAL_OK || found.covered != INVCAL_CELLS) {
        board_exit(1);
    }
}

/* Eighteen orientations, the field at a right angle to up. */
static void bench_dip(void)
{
    invcal_dip dip;
    invcal_dip_quality quality;
    invcal_rotation rotation;
    invcal_plan plan;
    invcal_plan_position p;

    require(invcal_plan_init(&plan, POSITIONS / 3));
    invcal_dip_init(&dip);
    for (unsigned i = 0; i < POSITIONS; i++) {
        require(invcal_plan_get(&plan, i, &p));
        const invcal_real *const up = p.up;
        const invcal_real one[3] = {up[1] + INVCAL_REAL(0.1), up[2], up[0]};
        const invcal_real field[3] = {up[1] * one[2] - up[2] * one[1],
                                      up[2] * one[0] - up[0] * one[2],
                                      up[0] * one[1] - up[1] * one[0]};
        begin();
        (void)invcal_dip_add(&dip, up, field);
        const uint32_t count = end();
        if (i + 1 == POSITIONS) {
            report("dip_add", count);
        }
    }
    begin();
    const invcal_status status = invcal_dip_solve(&dip, 1, &rotation, &quality);
    report("dip_solve", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
}

static void bench_all(void)
{
    const invcal_real prior[INVCAL_PARAMETERS] = {0, 0, 0, 0, 0, 0, INVCAL_CROSS_AXIS};
    invcal_calibration calibration;
    invcal_quality quality;
    invcal_positions positions = *POSITIONS_OF(raw, POSITIONS, &nominal, 0);

    begin();
    const invcal_status status = invcal_calibrate_plain(&positions, &calibration, &quality);
    report("18_positions_and_everything", end());
    if (status != INVCAL_OK || quality.verdict != INVCAL_GOOD) {
        board_exit(1);
    }
    begin();
    (void)invcal_calibrate(&positions, &calibration, &quality);
    report("judged_18_positions", end());
    begin();
    (void)invcal_calibrate_robust(&positions, &calibration, &quality);
    report("robust_18_positions", end());
    positions.noise = INVCAL_REAL(0.001);
    begin();
    (void)invcal_calibrate_prior(&positions, prior, &calibration, &quality);
    report("18_positions_with_prior", end());
    begin();
    const uint16_t set = invcal_undetermined(&positions);
    report("undetermined", end());
    if (set != 0) {
        board_exit(1);
    }
}

static void bench_six_faces(void)
{
    invcal_real face[6][3] = {{0}};
    invcal_calibration calibration;
    invcal_quality quality;

    for (unsigned i = 0; i < 6; i++) {
        face[i][i / 2] = i % 2 ? -8100 : 8300;
    }
    begin();
    const invcal_status status =
        invcal_calibrate_faces(POSITIONS_OF(face[0], 6, &nominal, INVCAL_REAL(0.001)),
                               INVCAL_CROSS_AXIS, &calibration, &quality);
    report("six_faces", end());
    if (status != INVCAL_OK || quality.held != 7u << INVCAL_GAMMA_XY) {
        board_exit(1);
    }
}

/* A sensor at rest: noise of some counts. */
static void next_sample(int32_t sample[3])
{
    static uint32_t state = 1;

    for (unsigned a = 0; a < 3; a++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        sample[a] = (int32_t)(state >> 28) - 8 + (a == 2 ? 8192 : 0);
    }
}

/* Five seconds at rest, decisions included. */
static uint32_t feed(unsigned rate)
{
    int32_t sample[3];
    uint32_t total = 0;

    if (invcal_session_init_nominal(&session, sizeof session, &nominal, rate) != INVCAL_OK) {
        board_exit(1);
    }
    for (unsigned i = 0; i < 5 * rate; i++) {
        next_sample(sample);
        begin();
        (void)invcal_session_feed(&session, sample[0], sample[1], sample[2]);
        total += end();
    }
    return total / (5 * rate);
}

/* Three seconds in each position; the first `wrong` of them read 1 % too much. Sixteen are without
 * the ninth and the last. */
static uint32_t solve_session(unsigned positions, unsigned wrong)
{
    enum { RATE = 32, SECONDS = 3 };
    int32_t sample[3];
    invcal_calibration calibration;
    invcal_quality quality;
    unsigned left_out = 0;

    require(invcal_session_init_nominal(&session, sizeof session, &nominal, RATE));
    for (unsigned i = 0; i < positions; i++) {
        for (unsigned k = 0; k < RATE * SECONDS; k++) {
            next_sample(sample);
            sample[2] -= 8192;
            for (unsigned a = 0; a < 3; a++) {
                const int32_t mean = (int32_t)raw[i + (positions == 16 ? i / 8 : 0)][a];
                sample[a] += i < wrong ? mean + mean / 100 : mean;
            }
            (void)invcal_session_feed(&session, sample[0], sample[1], sample[2]);
        }
    }
    (void)invcal_session_end(&session);
    begin();
    const invcal_status status = invcal_session_solve(&session, &calibration, &quality);
    const uint32_t count = end();
    for (invcal_mask set = quality.left_out; set; set &= set - 1) {
        left_out++;
    }
    if (session.count != positions || status != INVCAL_OK || left_out != wrong) {
        board_exit(1);
    }
    return count;
}

static void bench_session(void)
{
    invcal_real up[3];

    report("feed_100_Hz", feed(100));
    begin();
    invcali_next(POSITIONS_OF(raw[0], POSITIONS, &nominal, 0), up);
    report("next_orientation", end());
}

/* A memory that takes no time of its own, of granularity 8; how many bytes were moved. */
static uint8_t slots[2][INVCAL_STORE_BYTES(INVCAL_SESSION_SIZE, 8)];
static uint32_t read_bytes;
static uint32_t programmed_bytes;

static int read_slot(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &slots[slot][offset], size);
    read_bytes += size;
    return 0;
}

static int erase_slot(void *context, unsigned slot)
{
    (void)context;
    memset(slots[slot], 0xFF, sizeof slots[slot]);
    return 0;
}

static int program_slot(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                        uint32_t size)
{
    (void)context;
    memcpy(&slots[slot][offset], bytes, size);
    programmed_bytes += size;
    return 0;
}

static void begin_store(void)
{
    read_bytes = programmed_bytes = 0;
    begin();
}

/* Saves go over two earlier ones: both slots are read. */
static void bench_store(void)
{
    const invcal_store store = {read_slot, erase_slot, program_slot, NULL, sizeof slots[0], 8};
    invcal_calibration calibration;
    invcal_quality quality;
    int failed = invcal_session_solve(&session, &calibration, &quality) != INVCAL_OK;

    (void)invcal_session_save(&session, &store);
    (void)invcal_session_save(&session, &store);
    begin_store();
    failed |= invcal_session_save(&session, &store) != INVCAL_OK;
    report("save_session", end());
    report("save_session_read_bytes", read_bytes);
    report("save_session_programmed_bytes", programmed_bytes);
    begin_store();
    failed |= invcal_session_load(&session, &store) != INVCAL_OK;
    report("load_session", end());
    report("load_session_read_bytes", read_bytes);
    (void)invcal_save(&calibration, &quality, &store);
    (void)invcal_save(&calibration, &quality, &store);
    begin_store();
    failed |= invcal_save(&calibration, &quality, &store) != INVCAL_OK;
    report("save", end());
    report("save_read_bytes", read_bytes);
    report("save_programmed_bytes", programmed_bytes);
    begin_store();
    failed |= invcal_load(&calibration, &store) != INVCAL_OK;
    report("load", end());
    report("load_read_bytes", read_bytes);
    if (failed) {
        board_exit(1);
    }
}

/* The end of a rest, with as many positions as are kept in the background. */
static void bench_background(void)
{
    enum { RATE = 32, SECONDS = 4, ONE_G = 8192 };
    static invcal_background background;
    int32_t sample[3];
    uint32_t most = 0;

    require(invcal_background_init(&background, sizeof background, &nominal, RATE));
    background.session.count = INVCAL_MAX_POSITIONS - 1;
    for (unsigned i = 0; i + 1 < INVCAL_MAX_POSITIONS; i++) {
        memcpy(&background.session.mean[i], raw[i % POSITIONS], sizeof raw[0]);
    }
    for (unsigned i = 0; i < RATE * SECONDS; i++) {
        next_sample(sample);
        sample[2] -= i < RATE * SECONDS / 2 ? 0 : 2 * ONE_G; /* turned over */
        begin();
        const invcal_event event =
            invcal_background_feed(&background, sample[0], sample[1], sample[2]);
        const uint32_t count = end();
        most = event == INVCAL_TAKEN || event == INVCAL_REFUSED ? count : most;
    }
    report("background_rest", most);
    if (most == 0) {
        board_exit(1);
    }
}

/* A sample of one axis at rest, on average; and the solution from all of them. */
static void bench_allan(void)
{
    static invcal_allan allan;
    invcal_noise noise;
    int32_t sample[3];
    uint32_t total = 0;
    enum { SAMPLES = 2048 };

    require(invcal_allan_init(&allan, sizeof allan));
    for (unsigned i = 0; i < SAMPLES; i++) {
        next_sample(sample);
        begin();
        invcal_allan_feed(&allan, sample[0]);
        total += end();
    }
    report("allan_push", total / SAMPLES);
    begin();
    const invcal_status status = invcal_allan_solve(&allan, 1, &noise);
    report("allan_noise", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
}

/* The program at two temperatures, with offsets that follow them. */
static void bench_thermal(void)
{
    static invcal_real means[2 * POSITIONS][3];
    static invcal_real temperature[2 * POSITIONS];
    invcal_thermal thermal;
    invcal_thermal_place place;
    invcal_calibration calibration;
    invcal_quality quality;

    for (unsigned i = 0; i < 2 * POSITIONS; i++) {
        temperature[i] = i < POSITIONS ? 10 : 50;
        for (unsigned a = 0; a < 3; a++) {
            means[i][a] = raw[i % POSITIONS][a] + (i < POSITIONS ? 0 : 100);
        }
    }
    begin();
    const invcal_status status =
        invcal_thermal_calibrate(POSITIONS_AT(means[0], temperature, 2 * POSITIONS, &nominal, 0),
                                 INVCAL_THERMAL_DEGREE, &thermal, &quality);
    report("36_positions_thermal", end());
    if (status != INVCAL_OK || thermal.fitted != INVCAL_THERMAL_DEGREE) {
        board_exit(1);
    }
    begin();
    (void)invcal_thermal_at(&thermal, 30, &calibration, &place);
    report("thermal_at", end());
}

static invcal_imu both;

/* Quarter turns about x, z and y, five each, of five segments. */
static void make_moves(void)
{
    invcal_real up[3] = {0, 0, 1};

    for (unsigned i = 0; i < INVCAL_MAX_POSITIONS; i++) {
        const unsigned axis = (3 - i / 5 % 3) % 3;
        const unsigned next = (axis + 1) % 3;
        const unsigned last = (axis + 2) % 3;
        for (unsigned a = 0; a < 3; a++) {
            both.session.mean[i].v[a] = up[a] * INVCAL_REAL(8192.0);
        }
        const invcal_real was = up[next];
        up[next] = up[last];
        up[last] = -was;
        both.own.rest[i].when = (uint16_t)(20 * i);
        both.own.rest[i].move = i > 0 ? 5 : -INVCAL_TOO_FEW;
        for (unsigned k = 0; k < 5 && i + 1 < INVCAL_MAX_POSITIONS; k++) {
            invcal_private_segment *s = &both.own.segment[both.own.first++];
            s->v[axis] = 10294;
            s->time = 2 * 100;
        }
    }
    both.own.used = both.own.fixed = both.own.first;
    both.rests = INVCAL_MAX_POSITIONS;
    both.session.count = INVCAL_MAX_POSITIONS;
}

static void bench_gyro(void)
{
    enum { BLOCK = 64 };
    const int32_t at[3] = {20, -10, 5};
    static invcal_imu_result imu;
    invcal_calibration gyro = nominal;

    require(invcal_session_init_nominal(&both.session, sizeof both.session, &nominal, 100));
    require(invcal_imu_init_nominal(&both, sizeof both, &gyro, 400));
    uint32_t count = 0;
    for (unsigned i = 0; i < BLOCK; i++) {
        begin();
        invcal_imu_feed_gyro(&both, at[0], at[1], at[2]);
        count += end();
    }
    report("gyro_feed", count / BLOCK);
    count = 0;
    for (unsigned i = 0; i < BLOCK; i++) {
        invcal_imu_feed_gyro(&both, at[0], at[1], at[2]);
        begin();
        invcali_imu_follow(&both, INVCAL_MOVING);
        const uint32_t one = end();
        count = one > count ? one : count;
    }
    report("gyro_follow", count);
    require(invcal_imu_init_nominal(&both, sizeof both, &gyro, 400));
    make_moves();
    begin();
    const invcal_status status = invcal_imu_solve(&both, NULL, &imu);
    count = end();
    if (status != INVCAL_OK) {
        board_exit(1);
    }
    report("imu_solve", count);
    invcal_turn turn;
    begin();
    invcal_imu_next(&both, &turn);
    report("imu_next", end());
    const invcal_positions positions = invcali_imu_positions(&both);
    static invcali_imu_work work;
    require(invcali_imu_begin(&work, &both, &positions, NULL, &imu));
    begin();
    require(invcali_imu_sum(&work));
    report("imu_pass", end());
    const invcal_real a[3] = {0, 0, 1};
    invcal_real rate[3];
    imu.g_is_used = 1;
    begin();
    invcal_imu_apply(&imu, 20, -10, 5, a, rate);
    report("imu_apply", end());
}

/* Halfway through the tour. */
static void bench_turns(void)
{
    static invcali_turns turns;
    static invcal_real sigma[INVCAL_IMU_PARAMETERS];
    const invcal_real up[3] = {0, 0, 1};
    invcal_turn turn;
    uint32_t open;
    invcal_status status = invcali_turns_begin(&turns, up, NULL, 0);

    for (unsigned i = 0; i < 9 && status == INVCAL_OK; i++) {
        status = invcali_tour(i, &turn);
        begin();
        (void)invcali_turns_add(&turns, &turn);
        const uint32_t count = end();
        if (i == 8) {
            report("turns_add", count);
        }
    }
    begin();
    invcali_turns_next(&turns, &turn);
    report("turns_next", end());
    begin();
    status = invcali_turns_sigma(&turns, &turn, sigma, &open);
    report("turns_sigma", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
}

int main(void)
{
    begin();
    idle = end();
    make_positions();
    bench_core();
    bench_session();
    report("session_solve", solve_session(POSITIONS, 0));
    bench_store();
    if (BENCH_TRACED) {
        return 0;
    }
    report("session_solve_16", solve_session(16, 0));
    report("session_solve_1_wrong", solve_session(POSITIONS, 1));
    report("session_solve_3_wrong", solve_session(POSITIONS, 3));
    report("feed_400_Hz", feed(400));
    report("feed_1000_Hz", feed(1000));
    bench_frame();
    bench_magnetometer();
    bench_dip();
    bench_all();
    bench_six_faces();
    bench_background();
    bench_allan();
    bench_thermal();
    bench_gyro();
    bench_turns();
    report_text("OK\n");
    return 0;
}
