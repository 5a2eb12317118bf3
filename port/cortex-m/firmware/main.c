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
#include "keep.h"
#include "tell.h"
#include "uart.h"

#define SHOWN 50u /* one calibrated sample in this many is shown */

static invcal_session session;

/* ---- the session ------------------------------------------------------------------------------ */

static invcal_status begin_session(void)
{
    const invcal_status status = invcal_session_init(&session, IMU_COUNTS, IMU_RATE);

    if (status == INVCAL_OK) {
        (void)invcal_session_rails(&session, IMU_LOW, IMU_HIGH);
        (void)invcal_session_noise(&session, 0.00015f); /* g, of the mean of a position */
    }
    tell("new session", status == INVCAL_OK ? "begun" : invcal_status_text(status));
    return status;
}

/* Are the positions taken enough, or is there no room for more? One that contradicts the others does not
 * count here: it does not put off the end. */
static int is_enough(void)
{
    static const invcal_real enough[3] = {0.0001f, 0.0001f, 0.0003f}; /* sigma: g, 1, rad */

    return session.count == INVCAL_MAX_POSITIONS || invcal_session_reaches(&session, enough);
}

/* Returns 1 when it is enough. */
static int digest(invcal_event event)
{
    tell_event(&session, event);
    if (event == INVCAL_READY || event == INVCAL_REFUSED) {
        tell_next(&session);
    }
    if (event != INVCAL_TAKEN) {
        return 0;
    }
    (void)keep_save_session(
        &session); /* a failure is reported; only a reset would lose something */
    return is_enough();
}

static imu_status take_positions(void)
{
    int32_t raw[3];
    int done = is_enough(); /* a stored session may be complete */

    if (!done) {
        tell_next(&session);
    }
    while (!done) {
        const imu_status status = imu_next(raw);
        if (status == IMU_LOST) { /* the flash took its time */
            invcal_session_gap(&session);
        } else if (status == IMU_ACCELEROMETER) {
            done = digest(invcal_session_feed(&session, raw));
        } else {
            return status;
        }
    }
    return IMU_ACCELEROMETER;
}

/* ---- the calibration -------------------------------------------------------------------------- */

/* Returns 1 if it is good: it is stored then. */
static int solve(invcal_calibration *calibration)
{
    invcal_quality quality;
    const invcal_status status = invcal_session_solve(&session, calibration, &quality);

    if (status != INVCAL_OK) {
        tell("not calibrated", invcal_status_text(status));
        return 0;
    }
    for (unsigned i = 0; i < session.count; i++) {
        if (quality.left_out >> i & 1u) {
            tell_count("left out, for it contradicts the others: position", i + 1);
        }
    }
    tell_calibration(calibration, &session.nominal, &quality);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    if (keep_save_calibration(calibration, &quality) == INVCAL_OK) {
        (void)keep_forget_session(); /* if it fails: the calibration is looked for first */
    }
    return 1;
}

/* Begins again until the result is good. Returns 0 if the sensor or the setup is of no use. */
static int calibrate(invcal_calibration *calibration)
{
    if (keep_load_session(&session) != INVCAL_OK && begin_session() != INVCAL_OK) {
        return 0;
    }
    for (;;) {
        const imu_status status = take_positions();
        if (status != IMU_ACCELEROMETER) {
            tell("sensor", imu_status_text(status));
            return 0;
        }
        if (solve(calibration)) {
            return 1;
        }
        (void)keep_forget_session();
        if (begin_session() != INVCAL_OK) {
            return 0;
        }
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
            invcal_apply_counts(calibration, raw, a);
            if (++n % SHOWN == 0) {
                tell_reading(a);
            }
        }
    }
    tell("sensor", imu_status_text(status));
}

int main(void)
{
    invcal_calibration calibration;

    uart_begin();
    const imu_status status = imu_begin(0);
    tell("power on, sensor", imu_status_text(status));
    if (status != IMU_ACCELEROMETER) {
        return 1;
    }
    if (keep_load_calibration(&calibration) == INVCAL_OK || calibrate(&calibration)) {
        measure(&calibration);
    }
    return 1; /* the reason was printed; on a board, wait for a reset here */
}
