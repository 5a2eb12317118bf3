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
 * invcal_imu_session_save after INVCAL_TAKEN, and invcal_imu_session_load in begin_session.
 */
#include <invcal.h>
#include <invcal/gyro.h>
#include <invcal/plan.h>

#include "imu.h"
#include "storage.h"

#if defined(RAMEND) && RAMEND < 0x1FFF
#error "this sketch takes 7 KB of RAM: a Mega, or a board that is not an AVR"
#endif

const unsigned SHOW_EVERY = 50; /* calibrated samples */

static invcal_imu_session both;
static invcal_imu_record calibration;
static bool is_calibrated;
static unsigned at;   /* rests before the next one */
static unsigned made; /* bit i: turn i of the tour was made, and was not refused */

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

/* The tour of the faces begins and ends with z up. */
static void find_next(invcal_turn *turn)
{
    invcal_tour((at + INVCAL_TOUR - 1) % INVCAL_TOUR, turn);
}

/* Skips a face that already points up. */
static void show_next()
{
    char text[INVCAL_TEXT_SIZE];
    invcal_turn turn;

    find_next(&turn);
    if (invcal_session_is_at(&both.session, turn.up)) {
        at++;
        find_next(&turn);
    }
    Serial.print(F("next: "));
    Serial.println(invcal_direction_text(turn.up, text));
}

static void begin_session()
{
    const float unit = (float)(M_PI / 180) / IMU_GYRO_COUNTS;
    const invcal_calibration gyro = {{0, 0, 0}, {{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}}};

    if (invcal_session_init(&both.session, sizeof both.session, IMU_COUNTS, IMU_RATE) != INVCAL_OK ||
        invcal_moves_init(&both.moves, sizeof both.moves, &gyro, IMU_RATE) != INVCAL_OK) {
        stop(F("scale or rate of the sensor is out of range"));
    }
    invcal_session_set_limits(&both.session, IMU_LOW, IMU_HIGH);
    invcal_moves_set_limits(&both.moves, IMU_LOW, IMU_HIGH);
    is_calibrated = false;
    at = made = 0;
    Serial.println(F("calibration begins"));
    show_next();
}

/* Nothing is stored before the verdict is good: until then, another tour. An AVR takes some seconds, and the
 * turn that is made meanwhile is refused. */
static NOINLINE void solve()
{
    invcal_imu imu;

    made = 0;
    const invcal_status status = invcal_imu_solve(both.session.mean, both.session.count,
                                                  &both.session.nominal, &both.moves, NULL, &imu);
    if (status != INVCAL_OK || imu.verdict != INVCAL_GOOD) {
        Serial.print(F("not yet: "));
        Serial.println(status != INVCAL_OK ? invcal_status_text(status)
                                           : invcal_verdict_text(imu.verdict));
        return;
    }
    Serial.println(F("verdict: good"));
    show(F("accelerometer, offset, counts:"), imu.accelerometer.offset, 1);
    show(F("gyroscope, offset, counts:"), imu.gyro.offset, 1);
    invcal_imu_record_init(&calibration, &imu);
    is_calibrated = true;
    Serial.println(invcal_imu_save(&imu, &calibration_store) == INVCAL_OK
                       ? F("calibration stored")
                       : F("calibration not stored: the EEPROM fails"));
}

/* A rest, and the turn that led to it. The tour goes round until each of its turns was good once. */
static void take()
{
    const invcal_status reason = invcal_moves_reason(&both.moves, both.moves.count - 1);
    int turns = 0;

    if (reason == INVCAL_OK) {
        made |= 1u << (at + INVCAL_TOUR - 2) % INVCAL_TOUR; /* at is the place after this one */
    } else if (both.moves.count > 1) {
        Serial.print(F("move refused: "));
        Serial.println(invcal_status_text(reason));
    }
    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        turns += made >> i & 1;
    }
    Serial.print(F("turns made, of 12: "));
    Serial.println(turns);
    if (turns == INVCAL_TOUR) {
        solve();
    }
}

static void calibrate(const int32_t accelerometer[3], const int32_t gyro[3])
{
    invcal_moves_feed(&both.moves, gyro[0], gyro[1], gyro[2]);
    const invcal_event event = invcal_session_feed(&both.session, accelerometer[0], accelerometer[1], accelerometer[2]);
    invcal_moves_follow(&both.moves, &both.session.rests, event);
    switch (event) {
    case INVCAL_READY:
        Serial.println(F("good: move on"));
        at++;
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

    invcal_apply(&calibration.accelerometer.calibration, accelerometer[0], accelerometer[1], accelerometer[2], a);
    invcal_apply(&calibration.gyro, gyro[0], gyro[1], gyro[2], rate);
    for (int i = 0; i < 3 && calibration.g_is_used; i++) {
        const float *g = calibration.slope[i];
        rate[i] -= g[0] * a[0] + g[1] * a[1] + g[2] * a[2];
    }
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
    is_calibrated = invcal_imu_load(&calibration, &calibration_store) == INVCAL_OK;
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
        invcal_session_gap(&both.session);
        invcal_moves_gap(&both.moves);
    } else if (is_calibrated) {
        measure(accelerometer, gyro);
    } else {
        calibrate(accelerometer, gyro);
    }
    if (Serial.read() == 'c') {
        begin_session();
    }
}
