/* SPDX-License-Identifier: MIT
 *
 * Instructions (AVR: cycles) that each operation takes, by the counter of the emulated machine.
 * Prints one line for each, its name and the figure, and OK. Counting itself is subtracted.
 */
#include <string.h>

#include "../report.h"
#include "invcal/invcal.h"

enum { POSITIONS = 18, REPEATS = 16 };

/* The paper's program of 18 positions read by a sensor with errors of some percent, raw counts. */
static invcal_real raw[POSITIONS][3];
static invcal_settings settings;
static invcal_session session;

/* ---- the clock ------------------------------------------------------------------------------ */

static uint32_t idle; /* what two readings of the counter take */
static uint32_t begun;

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
    const invcal_real scale[3] = {1 / INVCAL_REAL(8192.0), 1 / INVCAL_REAL(8192.0),
                                  1 / INVCAL_REAL(8192.0)};
    invcal_plan plan = {.per_group = POSITIONS / INVCAL_PLAN_GROUPS};
    invcal_plan_position p;

    (void)invcal_plan_starts(plan.per_group, plan.start);
    (void)invcal_calibration_nominal(zero, scale, &settings.nominal);
    settings.field = 1;
    for (unsigned i = 0; i < POSITIONS; i++) {
        (void)invcal_plan_position_at(&plan, i, &p);
        for (unsigned a = 0; a < 3; a++) {
            invcal_real sum = INVCAL_REAL(0.01);
            for (unsigned c = 0; c < 3; c++) {
                sum += matrix[a][c] * p.vertical[c];
            }
            /* whole counts: some noise, as a sensor has it */
            raw[i][a] = (invcal_real)(int32_t)(8192 * sum);
        }
    }
}

static void add_position(invcal_normal *normal, const invcal_real position[3])
{
    invcal_observation row;

    if (invcal_observe(&settings.nominal, settings.field, position, &row) == INVCAL_OK) {
        (void)invcal_normal_add(normal, &row, 1);
    }
}

static void bench_core(void)
{
    invcal_normal normal;
    invcal_solution solution;
    invcal_real calibrated[3];

    begin();
    invcal_normal_init(&normal);
    for (unsigned i = 0; i < POSITIONS; i++) {
        add_position(&normal, raw[i]);
    }
    const invcal_status status = invcal_solve(&normal, &settings, &solution);
    report("18_positions_and_solve", end());
    if (status != INVCAL_OK) {
        board_exit(1);
    }
    begin();
    add_position(&normal, raw[0]);
    report("add_position", end());
    begin();
    (void)invcal_solve(&normal, &settings, &solution);
    report("solve", end());
    begin();
    for (unsigned i = 0; i < REPEATS; i++) {
        invcal_apply(&solution.calibration, raw[i], calibrated);
    }
    report("apply", end() / REPEATS);
}

static void bench_all(void)
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;

    begin();
    const invcal_status status =
        invcal_calibrate(&raw[0][0], POSITIONS, &settings, &solution, &quality, NULL);
    report("18_positions_and_everything", end());
    if (status != INVCAL_OK || quality.verdict != INVCAL_GOOD) {
        board_exit(1);
    }
    begin();
    (void)invcal_outliers_find(&raw[0][0], POSITIONS, &settings, &outliers);
    report("outliers_of_18", end());
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
    invcal_session_setup setup;
    invcal_event event;
    int32_t sample[3];
    uint32_t total = 0;

    memset(&setup, 0, sizeof setup);
    setup.settings = settings;
    setup.rate = (invcal_real)rate;
    if (invcal_session_init(&session, &setup) != INVCAL_OK) {
        board_exit(1);
    }
    for (unsigned i = 0; i < 5 * rate; i++) {
        next_sample(sample);
        begin();
        (void)invcal_session_feed(&session, sample, 20, &event);
        total += end();
    }
    return total / (5 * rate);
}

static void bench_session(void)
{
    invcal_guidance next;

    report("feed_100_Hz", feed(100));
    report("feed_400_Hz", feed(400));
    report("feed_1000_Hz", feed(1000));
    for (unsigned i = 0; i < POSITIONS; i++) {
        add_position(&session.normal, raw[i]);
    }
    begin();
    (void)invcal_session_next(&session, &next);
    report("next_orientation", end());
}

/* A sample of one axis at rest, on average; and what all of them tell. */
static void bench_allan(void)
{
    static invcal_allan allan;
    invcal_noise noise;
    int32_t sample[3];
    uint32_t total = 0;
    enum { SAMPLES = 2048 };

    (void)invcal_allan_init(&allan, NULL, INVCAL_ALLAN_TAUS, INVCAL_ALLAN_OVERLAPPING);
    for (unsigned i = 0; i < SAMPLES; i++) {
        next_sample(sample);
        begin();
        invcal_allan_push(&allan, sample[0]);
        total += end();
    }
    report("allan_push", total / SAMPLES);
    begin();
    const invcal_status status = invcal_allan_noise(&allan, 1, 1, &noise);
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
    invcal_thermal_settings thermal;
    invcal_thermal_calibration calibration;
    invcal_thermal_place place;
    invcal_solution solution;
    invcal_quality quality;

    memset(&thermal, 0, sizeof thermal);
    for (unsigned i = 0; i < 2 * POSITIONS; i++) {
        temperature[i] = i < POSITIONS ? 10 : 50;
        for (unsigned a = 0; a < 3; a++) {
            means[i][a] = raw[i % POSITIONS][a] + (i < POSITIONS ? 0 : 100);
        }
    }
    begin();
    invcal_status status =
        invcal_thermal_calibrate(&means[0][0], temperature, 2 * POSITIONS, &settings, &thermal,
                                 &calibration, &quality, NULL);
    report("36_positions_thermal", end());
    if (status != INVCAL_OK || calibration.fitted != INVCAL_THERMAL_DEGREE) {
        board_exit(1);
    }
    begin();
    (void)invcal_thermal_at(&calibration, 30, &solution, &place);
    report("thermal_at", end());
}

int main(void)
{
    begin();
    idle = end();
    make_positions();
    bench_core();
    bench_all();
    bench_session();
    bench_allan();
    bench_thermal();
    report_text("OK\n");
    return 0;
}
