/* SPDX-License-Identifier: MIT
 *
 * Calibrates an accelerometer and a gyroscope, from power-on to calibrated readings:
 *
 *     a result is stored            it is applied
 *     else a session is stored      it resumes, with its rests and moves
 *     else                          a session begins
 *
 * Session and moves are stored together after every position, the result at the end. While the
 * flash is written, the chip's queue holds the samples: the device is moving then, and a move with
 * a gap is lost.
 *
 * RAM: session and moves, 3,712 bytes. Stack: 3,156 bytes on a Cortex-M4F, most of them in
 * find_turn.
 */
#include "flash.h"
#include "imu.h"
#include "invcal/gyro.h"
#include "invcal/plan.h"
#include "print.h"
#include "report.h"
#include "uart.h"

#define SHOW_EVERY 50u /* one calibrated sample of each in this many is shown */

static invcal_imu_session both;
static invcal_turn turn; /* to the next rest */

/* Session and moves must fit into a sector: an array of -1 elements does not compile. */
typedef char both_fit
    [FLASH_SECTOR_SIZE >= INVCAL_STORE_BYTES(INVCAL_IMU_SESSION_SIZE, FLASH_GRANULARITY) ? 1 : -1];

/* ---- where to turn ------------------------------------------------------------------------------ */

/* The up direction after the turn. */
static void report_turn(void)
{
    char text[INVCAL_TEXT_SIZE];

    report("next", invcal_direction_text(turn.up, text));
}

/* The turn to a rest, counted from 0: through the faces, from z up to z up; then the most
 * informative. */
static void find_turn(unsigned rest)
{
    invcal_turns turns;

    if (rest <= INVCAL_TOUR) {
        (void)invcal_tour(rest > 0 ? rest - 1 : INVCAL_TOUR - 1, &turn);
    } else if (invcal_turns_after(&turns, both.session.mean, both.session.count,
                                  &both.session.nominal, &both.moves, NULL) == INVCAL_OK) {
        if (rest > both.moves.count) { /* the last turn was made, its rest is not taken yet */
            (void)invcal_turns_add(&turns, &turn);
        }
        invcal_turns_next(&turns, &turn);
    }
}

/* Skips a place where the device already is, as after a rest that was not stored. */
static void request_rest(unsigned rest)
{
    find_turn(rest);
    if (invcal_session_is_at(&both.session, turn.up)) {
        find_turn(rest + 1);
    }
    report_turn();
}

/* ---- messages ----------------------------------------------------------------------------------- */

static void report_vector(const char *name, const invcal_real v[3], float unit, unsigned digits)
{
    print(name);
    for (unsigned i = 0; i < 3; i++) {
        print(" ");
        print_fixed(unit * v[i], digits);
    }
    print("\n");
}

static void report_result(const invcal_imu *imu)
{
    report("verdict", invcal_verdict_text(imu->verdict));
    report_count("moves", imu->moves);
    report_vector("accelerometer, offset:  ", imu->accelerometer.offset, 1, 2);
    report_vector("gyroscope, offset:      ", imu->gyro.offset, 1, 2);
    for (unsigned i = 0; i < 3; i++) {
        report_vector("gyroscope, 1e-6 rad/s:  ", imu->gyro.matrix[i], 1e6f, 3);
        report_vector("sigma, 1e-4:            ", &imu->sigma[3 * i], 1e4f, 2);
    }
}

/* ---- storage -------------------------------------------------------------------------------------- */

/* A failure is reported; only a reset would then lose something. */
static void save_session(void)
{
    const invcal_status status = invcal_imu_session_save(&both, &session_store);

    if (status == INVCAL_OK) {
        report_count("session stored, positions", both.session.count);
    } else {
        report("session not stored", invcal_status_text(status));
    }
}

/* If there is none, it begins again. */
static void load_session(void)
{
    const invcal_status status = invcal_imu_session_load(&both, &session_store);

    if (status == INVCAL_OK) {
        report_count("stored session found, positions", both.session.count);
    } else {
        report("stored session", invcal_status_text(status));
        report("new session", "begun");
    }
}

static invcal_status begin_session(void)
{
    const invcal_calibration gyro = {
        {0, 0, 0}, {{IMU_GYRO_UNIT, 0, 0}, {0, IMU_GYRO_UNIT, 0}, {0, 0, IMU_GYRO_UNIT}}};
    invcal_status status =
        invcal_session_init(&both.session, sizeof both.session, IMU_COUNTS, IMU_RATE);

    if (status == INVCAL_OK) {
        status = invcal_moves_init(&both.moves, sizeof both.moves, &gyro, IMU_GYRO_RATE);
    }
    if (status == INVCAL_OK) {
        (void)invcal_session_set_limits(&both.session, IMU_LOW, IMU_HIGH);
        (void)invcal_moves_set_limits(&both.moves, IMU_LOW, IMU_HIGH);
    }
    if (status != INVCAL_OK) {
        report("new session", invcal_status_text(status));
    }
    return status;
}

/* ---- the session ---------------------------------------------------------------------------------- */

static void report_move(void)
{
    const unsigned last = both.moves.count - 1u;
    const invcal_status reason = invcal_moves_reason(&both.moves, last);

    if (last > 0 && reason != INVCAL_OK) {
        report("move refused", invcal_status_text(reason));
    }
}

/* Stores the result if it is good. Returns 1 then. */
static int solve(void)
{
    static invcal_imu imu;
    const invcal_status status = invcal_imu_solve(both.session.mean, both.session.count,
                                                  &both.session.nominal, &both.moves, NULL, &imu);

    if (status != INVCAL_OK || imu.verdict != INVCAL_GOOD) {
        report("not yet",
               status == INVCAL_OK ? invcal_verdict_text(imu.verdict) : invcal_status_text(status));
        return 0;
    }
    report_result(&imu);
    const invcal_status saved = invcal_imu_save(&imu, &calibration_store);
    report(saved == INVCAL_OK ? "calibration stored" : "calibration not stored",
           invcal_status_text(saved));
    return saved == INVCAL_OK;
}

/* Returns 1 when it is done. */
static int handle_event(invcal_event event)
{
    report_event(&both.session, event);
    if (event == INVCAL_READY) {
        request_rest(both.moves.count + 1u);
    } else if (event == INVCAL_REFUSED) {
        report_turn();
    } else if (event == INVCAL_TAKEN) {
        report_move();
        save_session();
        return both.moves.count > INVCAL_TOUR && solve();
    }
    return 0;
}

/* Returns what the sensor ended with: IMU_ACCELEROMETER when the calibration is done. */
static imu_status calibrate(void)
{
    int32_t raw[3];

    request_rest(both.moves.count);
    for (;;) {
        const imu_status status = imu_next(raw);
        if (status == IMU_GYRO) {
            invcal_moves_feed(&both.moves, raw[0], raw[1], raw[2]);
        } else if (status == IMU_ACCELEROMETER) {
            const invcal_event event = invcal_session_feed(&both.session, raw[0], raw[1], raw[2]);
            invcal_moves_follow(&both.moves, &both.session.rests, event);
            if (handle_event(event)) {
                return IMU_ACCELEROMETER;
            }
        } else if (status == IMU_LOST) {
            invcal_session_gap(&both.session);
            invcal_moves_gap(&both.moves);
        } else {
            return status;
        }
    }
}

/* ---- from then on --------------------------------------------------------------------------------- */

/* Your application. It corrects g-sensitivity with the latest acceleration, and returns only if the sensor
 * stops responding. */
static void measure(const invcal_imu_record *record)
{
    invcal_real a[3] = {0, 0, 0};
    invcal_real rate[3] = {0, 0, 0};
    imu_status status = IMU_LOST;
    int32_t raw[3];

    for (unsigned n = 0; status <= IMU_LOST; status = imu_next(raw)) {
        if (status == IMU_GYRO) {
            invcal_apply(&record->gyro, raw[0], raw[1], raw[2], rate);
            for (unsigned i = 0; i < 3 && record->g_is_used; i++) {
                const invcal_real *g = record->slope[i];
                rate[i] -= g[0] * a[0] + g[1] * a[1] + g[2] * a[2];
            }
        } else if (status == IMU_ACCELEROMETER) {
            invcal_apply(&record->accelerometer.calibration, raw[0], raw[1], raw[2], a);
            if (++n % SHOW_EVERY == 0) {
                report_reading(a);
                report_vector("rate, mrad/s:", rate, 1000, 1);
            }
        }
    }
    report("sensor", imu_status_text(status));
}

int main(void)
{
    static invcal_imu_record record;

    uart_begin();
    imu_status status = imu_begin(1);
    report("power on, sensor", imu_status_text(status));
    if (status != IMU_ACCELEROMETER) {
        return 1;
    }
    invcal_status found = invcal_imu_load(&record, &calibration_store);
    report("stored calibration", found == INVCAL_OK ? "found" : invcal_status_text(found));
    if (found != INVCAL_OK) {
        found = begin_session();
        if (found == INVCAL_OK) {
            load_session();
        }
        status = found == INVCAL_OK ? calibrate() : IMU_CONFIG_FAILED;
        found = invcal_imu_load(&record, &calibration_store);
    }
    if (status == IMU_ACCELEROMETER && found == INVCAL_OK) {
        measure(&record);
    }
    report("sensor", imu_status_text(status));
    return 1; /* the reason was printed; on a board, wait for a reset here */
}
