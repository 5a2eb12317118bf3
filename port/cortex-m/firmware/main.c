/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself, from power-on to calibrated readings:
 *
 *     a calibration is stored       it is applied
 *     else a session is stored      it resumes, with its positions
 *     else                          a session begins
 *
 * The session is stored after every position, the calibration at the end. Everything that happens is
 * reported on the UART: the user needs nothing else.
 *
 * RAM: the session, 560 bytes. Stack: 988 bytes on a Cortex-M4F, most of them in solve.
 */
#include "imu.h"
#include "invcal/result.h"
#include "storage.h"
#include "report.h"
#include "uart.h"

#define SHOW_EVERY 50u /* one calibrated sample in this many is shown */

static invcal_session session;

/* ---- the session ------------------------------------------------------------------------------ */

static invcal_status begin_session(void)
{
    const invcal_status status =
        invcal_session_init(&session, sizeof session, IMU_COUNTS, IMU_RATE);

    if (status == INVCAL_OK) {
        (void)invcal_session_set_limits(&session, IMU_LOW, IMU_HIGH);
        (void)invcal_session_set_noise(&session, 0.00015f); /* g, of the mean of a position */
    }
    if (status != INVCAL_OK) {
        report("new session", invcal_status_text(status));
    }
    return status;
}

/* Are the positions enough, or is the table full? A position that contradicts the others is not
 * considered here, so it does not delay the end. */
static int is_enough(void)
{
    invcal_calibration calibration;
    invcal_quality quality;

    return session.count == INVCAL_MAX_POSITIONS ||
           (invcal_session_solve(&session, &calibration, &quality) == INVCAL_OK &&
            invcal_reaches(&quality, 0.0001f, 0.0001f, 0.0003f)); /* sigma: g, 1, rad */
}

/* Returns 1 when it is enough. */
static int handle_event(invcal_event event)
{
    report_event(&session, event);
    if (event == INVCAL_READY || event == INVCAL_REFUSED) {
        report_next(&session);
    }
    if (event != INVCAL_TAKEN) {
        return 0;
    }
    (void)storage_save_session(
        &session); /* a failure is reported; only a reset would lose something */
    return is_enough();
}

static imu_status take_positions(void)
{
    int32_t raw[3];
    int done = is_enough(); /* a stored session may be complete */

    if (!done) {
        report_next(&session);
    }
    while (!done) {
        const imu_status status = imu_next(raw);
        if (status == IMU_LOST) { /* while the flash was written */
            invcal_session_gap(&session);
        } else if (status == IMU_ACCELEROMETER) {
            done = handle_event(invcal_session_feed(&session, raw[0], raw[1], raw[2]));
        } else {
            return status;
        }
    }
    return IMU_ACCELEROMETER;
}

/* ---- the calibration -------------------------------------------------------------------------- */

/* Stores the result if it is good. Returns 1 then. */
static int solve(invcal_calibration *calibration)
{
    invcal_quality quality;
    const invcal_status status = invcal_session_solve(&session, calibration, &quality);

    if (status != INVCAL_OK) {
        report("not calibrated", invcal_status_text(status));
        return 0;
    }
    for (unsigned i = 0; i < session.count; i++) {
        if (quality.left_out >> i & 1u) {
            report_count("left out, for it contradicts the others: position", i + 1);
        }
    }
    report_calibration(calibration, &session.nominal, &quality);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    if (storage_save_calibration(calibration, &quality) == INVCAL_OK) {
        (void)storage_erase_session(); /* a failure is harmless: the calibration is loaded first */
    }
    return 1;
}

/* Repeats the session until the result is good. Returns 0 if sensor or setup fail. */
static int calibrate(invcal_calibration *calibration)
{
    if (begin_session() != INVCAL_OK) {
        return 0;
    }
    if (storage_load_session(&session) != INVCAL_OK) {
        report("new session", "begun");
    }
    for (;;) {
        const imu_status status = take_positions();
        if (status != IMU_ACCELEROMETER) {
            report("sensor", imu_status_text(status));
            return 0;
        }
        if (solve(calibration)) {
            return 1;
        }
        (void)storage_erase_session();
        if (begin_session() != INVCAL_OK) {
            return 0;
        }
        report("new session", "begun");
    }
}

/* Your application. It returns only if the sensor stops responding. */
static void measure(const invcal_calibration *calibration)
{
    imu_status status = IMU_LOST;
    int32_t raw[3];
    invcal_real a[3];

    for (unsigned n = 0; status <= IMU_LOST; status = imu_next(raw)) {
        if (status == IMU_ACCELEROMETER) {
            invcal_apply(calibration, raw[0], raw[1], raw[2], a);
            if (++n % SHOW_EVERY == 0) {
                report_reading(a);
            }
        }
    }
    report("sensor", imu_status_text(status));
}

int main(void)
{
    invcal_calibration calibration;

    uart_begin();
    const imu_status status = imu_begin(0);
    report("power on, sensor", imu_status_text(status));
    if (status != IMU_ACCELEROMETER) {
        return 1;
    }
    if (storage_load_calibration(&calibration) == INVCAL_OK || calibrate(&calibration)) {
        measure(&calibration);
    }
    return 1; /* the reason was printed; on a board, wait for a reset here */
}
