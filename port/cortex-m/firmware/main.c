/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself, from power-on to calibrated readings:
 *
 *     a calibration is stored       it is applied
 *     else a session is stored      it goes on where it was
 *     else                          a session begins
 *
 * After every position the session is stored, at the end the calibration. All that happens is told
 * on the UART: whoever holds the device needs nothing else.
 *
 * RAM: the session, 1,016 bytes, and in keep.c 748 bytes to store it. Stack: 1,900 bytes on a
 * Cortex-M4F, most of them in solve.
 */
#include "imu.h"
#include "keep.h"
#include "tell.h"
#include "uart.h"

#define MOST 20u  /* positions; then it is solved, were the target not reached */
#define SHOWN 50u /* one calibrated sample in so many is shown */

static invcal_session session;

/* ---- the session ------------------------------------------------------------------------------ */

static invcal_status begin_session(void)
{
    static const invcal_real zero[3] = {0, 0, 0};
    static const invcal_real scale[3] = {IMU_SCALE, IMU_SCALE, IMU_SCALE};
    invcal_session_setup setup = {
        .settings = {.field = 1, .noise = 0.00015f}, /* g; of the mean of a position */
        .target = {0.0001f, 0.0001f, 0.0003f},       /* g; 1; rad: that is enough */
        .rate = IMU_RATE,
        .low = IMU_LOW,
        .high = IMU_HIGH,
    };
    invcal_status status = invcal_calibration_nominal(zero, scale, &setup.settings.nominal);

    if (status == INVCAL_OK) {
        status = invcal_session_init(&session, &setup);
    }
    tell("new session", status == INVCAL_OK ? "begun" : invcal_status_text(status));
    return status;
}

static void digest(const invcal_event *event)
{
    tell_event(event);
    switch (event->what) {
    case INVCAL_SESSION_READY:
    case INVCAL_SESSION_REFUSED:
        tell_next(&session);
        break;
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
        (void)keep_save_session(&session); /* if it fails, and was told, only a reset is feared */
        break;
    default:
        break;
    }
}

/* Until the target is reached. A position that contradicts the others keeps it away; so there is an
 * end, and solve finds out which one it is. */
static imu_status take_positions(void)
{
    imu_sample sample;
    invcal_event event;

    tell_next(&session);
    while (!session.is_enough && session.normal.count < MOST) {
        const imu_status status = imu_next(&sample);
        if (status == IMU_LOST) { /* the flash took its time */
            invcal_session_gap(&session);
        } else if (status != IMU_OK) {
            return status;
        }
        if (invcal_session_feed(&session, sample.raw, sample.temperature, &event) !=
            INVCAL_SESSION_NOTHING) {
            digest(&event);
        }
    }
    return IMU_OK;
}

/* ---- the calibration -------------------------------------------------------------------------- */

/* Without positions that contradict the others. Returns 1 and stores it if it is good. */
static int solve(invcal_calibration *calibration)
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;
    const invcal_status status = invcal_session_solve(&session, &solution, &quality, &outliers);

    if (status != INVCAL_OK) {
        tell("not calibrated", invcal_status_text(status));
        return 0;
    }
    for (unsigned i = 0; i < outliers.count; i++) {
        tell_count("left out, for it contradicts the others: position", outliers.position[i] + 1);
    }
    tell_calibration(&solution, &quality);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    *calibration = solution.calibration;
    if (keep_save_calibration(&session, &solution, &quality) == INVCAL_OK) {
        (void)keep_forget_session(); /* if it fails: the calibration is looked for first */
    }
    return 1;
}

/* Begins anew until the result is good. Returns 0 if the sensor or the setup is of no use. */
static int calibrate(invcal_calibration *calibration)
{
    if (keep_load_session(&session) != INVCAL_OK && begin_session() != INVCAL_OK) {
        return 0;
    }
    for (;;) {
        const imu_status status = take_positions();
        if (status != IMU_OK) {
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

/* What your device does with it. Comes back only if the sensor falls silent. */
static void measure(const invcal_calibration *calibration)
{
    imu_sample sample;
    imu_status status;

    for (unsigned n = 1; (status = imu_next(&sample)) == IMU_OK || status == IMU_LOST; n++) {
        invcal_real a[3] = {(invcal_real)sample.raw[0], (invcal_real)sample.raw[1],
                            (invcal_real)sample.raw[2]};
        invcal_apply(calibration, a, a);
        if (n % SHOWN == 0) {
            tell_reading(a);
        }
    }
    tell("sensor", imu_status_text(status));
}

int main(void)
{
    invcal_calibration calibration;

    uart_begin();
    const imu_status status = imu_begin();
    tell("power on, sensor", imu_status_text(status));
    if (status != IMU_OK) {
        return 1;
    }
    if (keep_load_calibration(&calibration) == INVCAL_OK || calibrate(&calibration)) {
        measure(&calibration);
    }
    return 1; /* told why; on a board, wait for a reset here */
}
