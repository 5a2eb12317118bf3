/* SPDX-License-Identifier: MIT
 *
 * Calibrates an accelerometer and a gyroscope by the same moves. Open the serial monitor at 115200 baud, turn
 * the sensor as it says, in about a second, and hold it still until it says "good". At the end the sketch stores
 * the calibration; from then on it prints calibrated readings, also after the next power-on. Send c to calibrate
 * again.
 *
 * It takes 7 KB of RAM: a Mega, or a board that is not an AVR. The sensor is in imu.cpp, the memory in
 * storage.cpp. Session and moves are not stored: an EEPROM takes seconds for them, the sensor's queue holds less
 * than one, and a move with lost samples is refused. With a fast memory, FRAM or flash, add
 * invcal_imu_save after INVCAL_TAKEN, and invcal_imu_load in begin_session.
 */
#include <invcal.h>
#include <invcal/gyro_store.h>
#include <invcal/plan.h>

#include "imu.h"
#include "storage.h"

#if defined(RAMEND) && RAMEND < 0x1FFF
#error "this sketch takes 7 KB of RAM: a Mega, or a board that is not an AVR"
#endif

const unsigned SHOW_EVERY = 50; /* calibrated samples */
const unsigned TURNS = 12;      /* of the tour through the faces */

static invcal_imu both;
static invcal_imu_result calibration;
static bool is_calibrated;
static unsigned good; /* moves that were not refused, since the last solution */

/* Not inlined into loop, or its variables would be on the stack while the others run. */
#define NOINLINE __attribute__((noinline))

/* Never returns: only a reset helps. */
static void stop(const __FlashStringHelper *text)
{
    Serial.println(text);
    Serial.flush();
    for (;;) {
    }
}

/* As whole numbers, for which less code is linked than for float. */
static void show(const __FlashStringHelper *name, const float v[3], float unit)
{
    Serial.print(name);
    for (int i = 0; i < 3; i++) {
        Serial.print(' ');
        const float x = v[i] * unit;
        Serial.print((long)(x < 0 ? x - 0.5f : x + 0.5f));
    }
    Serial.println();
}

/* ---- the session ------------------------------------------------------------------------------ */

/* The tour of the faces, and after it the turn that adds most. */
static void show_next()
{
    char text[INVCAL_TEXT_SIZE];

    Serial.print(F("next: "));
    Serial.println(invcal_imu_next_text(&both, text));
}

static void begin_session()
{
    const float counts = (float)(180 / M_PI) * IMU_GYRO_COUNTS; /* per rad/s */

    if (invcal_session_init(&both.session, sizeof both.session, IMU_COUNTS, IMU_RATE) != INVCAL_OK ||
        invcal_imu_init(&both, sizeof both, counts, IMU_RATE) != INVCAL_OK) {
        stop(F("scale or rate of the sensor is out of range"));
    }
    invcal_session_set_limits(&both.session, IMU_LOW, IMU_HIGH);
    invcal_imu_set_limits(&both, IMU_LOW, IMU_HIGH);
    is_calibrated = false;
    good = 0;
    Serial.println(F("calibration begins"));
    show_next();
}

/* Nothing is stored before the verdict is good: until then, more turns, three at a time. An AVR takes some
 * seconds, and the turn that is made meanwhile is refused. */
static NOINLINE void solve()
{
    const invcal_status status = invcal_imu_solve(&both, NULL, &calibration);

    good = TURNS - 3;
    if (status != INVCAL_OK || calibration.verdict != INVCAL_GOOD) {
        Serial.print(F("not yet: "));
        Serial.println(status != INVCAL_OK ? invcal_status_text(status)
                                           : invcal_verdict_text(calibration.verdict));
        return;
    }
    Serial.println(F("verdict: good"));
    show(F("accelerometer, offset, counts:"), calibration.accelerometer.offset, 1);
    show(F("gyroscope, offset, counts:"), calibration.gyro.offset, 1);
    is_calibrated = true;
    Serial.println(invcal_imu_save_result(&calibration, &calibration_store) == INVCAL_OK
                       ? F("calibration stored")
                       : F("calibration not stored: the EEPROM fails"));
}

/* A rest, and the turn that led to it. */
static void take()
{
    const invcal_status reason = invcal_imu_move_reason(&both, both.rests - 1);

    if (reason == INVCAL_OK) {
        good++;
    } else if (both.rests > 1) {
        Serial.print(F("move refused: "));
        Serial.println(invcal_status_text(reason));
    }
    Serial.print(F("turns made, of 12: "));
    Serial.println(good);
    if (good >= TURNS) {
        solve();
    }
}

static void calibrate(const int32_t accelerometer[3], const int32_t gyro[3])
{
    invcal_imu_feed_gyro(&both, gyro[0], gyro[1], gyro[2]);
    switch (invcal_imu_feed(&both, accelerometer[0], accelerometer[1], accelerometer[2])) {
    case INVCAL_READY:
        Serial.println(F("good: move on"));
        show_next();
        break;
    case INVCAL_REFUSED:
        Serial.print(F("refused: "));
        Serial.println(invcal_session_reason_text(&both.session));
        show_next();
        break;
    case INVCAL_TAKEN:
        take();
        break;
    default:
        break; /* moving, settling */
    }
}

/* ---- from then on ----------------------------------------------------------------------------- */

/* Your application. */
static void measure(const int32_t accelerometer[3], const int32_t gyro[3])
{
    static unsigned n;
    float a[3], rate[3];

    invcal_apply(&calibration.accelerometer, accelerometer[0], accelerometer[1], accelerometer[2], a);
    invcal_imu_apply(&calibration, gyro[0], gyro[1], gyro[2], a, rate);
    if (++n == SHOW_EVERY) {
        n = 0;
        show(F("a, mg:"), a, 1000);
        show(F("rate, mrad/s:"), rate, 1000);
    }
}

void setup()
{
    Serial.begin(115200);
    if (!imu_begin()) {
        stop(F("sensor: no answer, or another chip"));
    }
    is_calibrated = invcal_imu_load_result(&calibration, &calibration_store) == INVCAL_OK;
    Serial.println(is_calibrated ? F("stored calibration: found") : F("stored calibration: none"));
    if (!is_calibrated) {
        begin_session();
    }
}

void loop()
{
    int32_t accelerometer[3], gyro[3];

    const imu_status status = imu_next(accelerometer, gyro);
    if (status == IMU_SILENT) {
        stop(F("sensor: no sample in due time"));
    }
    if (status == IMU_LOST) { /* while something was solved */
        invcal_imu_gap(&both);
    } else if (is_calibrated) {
        measure(accelerometer, gyro);
    } else {
        calibrate(accelerometer, gyro);
    }
    if (Serial.read() == 'c') {
        begin_session();
    }
}
