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
 * RAM: session and moves, 3,832 bytes. Stack: 3,156 bytes on a Cortex-M4F, most of them in
 * invcal_imu_next.
 */
#include "flash.h"
#include "imu.h"
#include "invcal/gyro_store.h"
#include "print.h"
#include "report.h"
#include "uart.h"

#define TOUR 12u       /* turns that determine everything */
#define SHOW_EVERY 50u /* one calibrated sample of each in this many is shown */

static invcal_imu both;

/* Session and moves must fit into a sector: an array of -1 elements does not compile. */
typedef char
    both_fit[FLASH_SECTOR_SIZE >= INVCAL_STORE_BYTES(INVCAL_IMU_SIZE, FLASH_GRANULARITY) ? 1 : -1];

/* ---- messages ----------------------------------------------------------------------------------- */

/* Which way to point upwards next. A place where the device already is, as after a rest that was not
 * stored, is not asked for. */
static void report_turn(void)
{
    char text[INVCAL_TEXT_SIZE];

    report("next", invcal_imu_next_text(&both, text));
}

static void report_vector(const char *name, const invcal_real v[3], float unit, unsigned digits)
{
    print(name);
    for (unsigned i = 0; i < 3; i++) {
        print(" ");
        print_fixed(unit * v[i], digits);
    }
    print("\n");
}

static void report_result(const invcal_imu_result *imu)
{
    report("verdict", invcal_verdict_text(imu->verdict));
    report_count("moves", imu->moves);
    report_vector("accelerometer, offset:  ", imu->accelerometer.offset, 1, 2);
    report_vector("gyroscope, offset:      ", imu->gyro.offset, 1, 2);
    for (unsigned i = 0; i < 3; i++) {
        report_vector("gyroscope, 1e-6 rad/s:  ", imu->gyro.matrix[i], 1e6f, 3);
        report_vector("sigma, 1e-4:            ", &imu->sigma[INVCAL_GYRO_XX + 3 * i], 1e4f, 2);
    }
}

/* ---- storage -------------------------------------------------------------------------------------- */

/* A failure is reported; only a reset would then lose something. */
static void save_session(void)
{
    const invcal_status status = invcal_imu_save(&both, &session_store);

    if (status == INVCAL_OK) {
        report_count("session stored, positions", both.session.count);
    } else {
        report("session not stored", invcal_status_text(status));
    }
}

/* If there is none, it begins again. */
static void load_session(void)
{
    const invcal_status status = invcal_imu_load(&both, &session_store);

    if (status == INVCAL_OK) {
        report_count("stored session found, positions", both.session.count);
    } else {
        report("stored session", invcal_status_text(status));
        report("new session", "begun");
    }
}

static invcal_status begin_session(void)
{
    invcal_status status =
        invcal_session_init(&both.session, sizeof both.session, IMU_COUNTS, IMU_RATE);

    if (status == INVCAL_OK) {
        status = invcal_imu_init(&both, sizeof both, 1 / IMU_GYRO_UNIT, IMU_GYRO_RATE);
    }
    if (status == INVCAL_OK) {
        (void)invcal_session_set_limits(&both.session, IMU_LOW, IMU_HIGH);
        (void)invcal_imu_set_limits(&both, IMU_LOW, IMU_HIGH);
    }
    if (status != INVCAL_OK) {
        report("new session", invcal_status_text(status));
    }
    return status;
}

/* ---- the session ---------------------------------------------------------------------------------- */

static void report_move(void)
{
    const unsigned last = both.rests - 1u;
    const invcal_status reason = invcal_imu_move_reason(&both, last);

    if (last > 0 && reason != INVCAL_OK) {
        report("move refused", invcal_status_text(reason));
    }
}

/* Stores the result if it is good. Returns 1 then. */
static int solve(void)
{
    static invcal_imu_result imu;
    const invcal_status status = invcal_imu_solve(&both, NULL, &imu);

    if (status != INVCAL_OK || imu.verdict != INVCAL_GOOD) {
        report("not yet",
               status == INVCAL_OK ? invcal_verdict_text(imu.verdict) : invcal_status_text(status));
        return 0;
    }
    report_result(&imu);
    const invcal_status saved = invcal_imu_save_result(&imu, &calibration_store);
    report(saved == INVCAL_OK ? "calibration stored" : "calibration not stored",
           invcal_status_text(saved));
    return saved == INVCAL_OK;
}

/* Returns 1 when it is done. */
static int handle_event(invcal_event event)
{
    report_event(&both.session, event);
    if (event == INVCAL_READY || event == INVCAL_REFUSED) {
        report_turn();
    } else if (event == INVCAL_TAKEN) {
        report_move();
        save_session();
        return both.rests > TOUR && solve();
    }
    return 0;
}

/* Returns what the sensor ended with: IMU_ACCELEROMETER when the calibration is done. */
static imu_status calibrate(void)
{
    int32_t raw[3];

    report_turn();
    for (;;) {
        const imu_status status = imu_next(raw);
        if (status == IMU_GYRO) {
            invcal_imu_feed_gyro(&both, raw[0], raw[1], raw[2]);
        } else if (status == IMU_ACCELEROMETER) {
            if (handle_event(invcal_imu_feed(&both, raw[0], raw[1], raw[2]))) {
                return IMU_ACCELEROMETER;
            }
        } else if (status == IMU_LOST) {
            invcal_imu_gap(&both);
        } else {
            return status;
        }
    }
}

/* ---- from then on --------------------------------------------------------------------------------- */

/* Your application. It returns only if the sensor stops responding. */
static void measure(const invcal_imu_result *result)
{
    invcal_real a[3] = {0, 0, 0};
    invcal_real rate[3] = {0, 0, 0};
    imu_status status = IMU_LOST;
    int32_t raw[3];

    for (unsigned n = 0; status <= IMU_LOST; status = imu_next(raw)) {
        if (status == IMU_GYRO) {
            invcal_imu_apply(result, raw[0], raw[1], raw[2], a, rate);
        } else if (status == IMU_ACCELEROMETER) {
            invcal_apply(&result->accelerometer, raw[0], raw[1], raw[2], a);
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
    static invcal_imu_result result;

    uart_begin();
    imu_status status = imu_begin(1);
    report("power on, sensor", imu_status_text(status));
    if (status != IMU_ACCELEROMETER) {
        return 1;
    }
    invcal_status found = invcal_imu_load_result(&result, &calibration_store);
    report("stored calibration", found == INVCAL_OK ? "found" : invcal_status_text(found));
    if (found != INVCAL_OK) {
        found = begin_session();
        if (found == INVCAL_OK) {
            load_session();
        }
        status = found == INVCAL_OK ? calibrate() : IMU_CONFIG_FAILED;
        found = invcal_imu_load_result(&result, &calibration_store);
    }
    if (status == IMU_ACCELEROMETER && found == INVCAL_OK) {
        measure(&result);
    }
    report("sensor", imu_status_text(status));
    return 1; /* the reason was printed; on a board, wait for a reset here */
}
