/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself. Open the serial monitor at 115200 baud, turn the sensor
 * as it says, and hold it still until it says "good". At the end the calibration is stored; from
 * then on calibrated readings are printed, after the next power-on too. Send c to calibrate again.
 *
 * It takes 28 KB of flash and 1.6 KB of RAM: enough on an Uno. The sensor is in sensor.cpp, the
 * memory in storage.cpp: change these files for others. To save memory, it prints whole numbers,
 * and its texts are in flash.
 */
#include <invcal.h>
#include <invcal/positions.h>

#include "sensor.h"
#include "storage.h"

const unsigned SHOW_EVERY = 50; /* calibrated samples */

static invcal_session session;
static invcal_calibration calibration;
static bool is_calibrated;

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

static void show_next()
{
    char text[INVCAL_TEXT_SIZE];

    Serial.print(F("next: "));
    Serial.println(invcal_session_next_text(&session, text));
}

static void begin_session()
{
    if (invcal_session_init(&session, sizeof session, SENSOR_COUNTS, SENSOR_RATE) != INVCAL_OK) {
        stop(F("scale or rate of the sensor is out of range"));
    }
    invcal_session_set_limits(&session, SENSOR_LOW, SENSOR_HIGH);
    is_calibrated = false;
    Serial.println(F("calibration begins"));
}

/* As invcal_session_reason_text, whose texts are in RAM on an AVR. */
static const __FlashStringHelper *refusal_text()
{
    switch (invcal_session_reason(&session)) {
    case INVCAL_REST_SHORT:
        return F("too short: hold still longer");
    case INVCAL_REST_DRIFT:
        return F("drifts: turning or settling");
    case INVCAL_REST_CLIPPED:
        return F("at the end of the range");
    case INVCAL_REST_FROZEN:
        return F("readings never change: sensor not read?");
    case INVCAL_REST_GAP:
        return F("too short: samples lost");
    case INVCAL_REST_SAME:
        return F("nothing new: same place");
    default:
        return F("far from 1 g: wrong scale, or a broken sensor");
    }
}

static NOINLINE void save(const invcal_quality &quality)
{
    const bool done = invcal_save(&calibration, &quality, &calibration_store) == INVCAL_OK;

    Serial.println(done ? F("calibration stored")
                        : F("calibration not stored: the EEPROM fails"));
}

/* Leaves out positions that contradict the others. Continues until the verdict is good, with
 * redundancy. (invcal_session_solve also looks for drift and nonlinearity, for which an Uno has no
 * space.) */
static NOINLINE void solve()
{
    invcal_positions positions = {};
    invcal_quality quality;

    positions.mean = session.mean;
    positions.count = session.count;
    positions.nominal = &session.nominal;
    positions.noise = session.noise;
    if (invcal_calibrate_robust(&positions, &calibration, &quality) != INVCAL_OK ||
        quality.verdict != INVCAL_GOOD || quality.dof < 3) {
        return;
    }
    for (unsigned i = 0; i < session.count; i++) {
        if (quality.left_out >> i & 1) {
            Serial.print(F("left out, for it contradicts the others: position "));
            Serial.println(i + 1);
        }
    }
    Serial.println(F("verdict: good"));
    show(F("offset, counts:"), calibration.offset, 1);
    is_calibrated = true;
    save(quality);
}

static void calibrate(const int32_t raw[3])
{
    switch (invcal_session_feed(&session, raw[0], raw[1], raw[2])) {
    case INVCAL_READY:
        Serial.println(F("good: move on"));
        show_next();
        break;
    case INVCAL_REFUSED:
        Serial.print(F("refused: "));
        Serial.println(refusal_text());
        show_next();
        break;
    case INVCAL_TAKEN:
        Serial.print(F("positions taken: "));
        Serial.println(session.count);
        invcal_session_save(&session, &session_store); /* to resume after a reset */
        solve();
        break;
    default:
        break; /* moving, settling */
    }
}

/* ---- from then on ----------------------------------------------------------------------------- */

/* Your application. */
static void measure(const int32_t raw[3])
{
    static unsigned n;
    float a[3];

    invcal_apply(&calibration, raw[0], raw[1], raw[2], a);
    if (++n == SHOW_EVERY) {
        n = 0;
        show(F("a, mg:"), a, 1000);
    }
}

NOINLINE void setup()
{
    Serial.begin(115200);
    if (!sensor_begin()) {
        stop(F("sensor: no answer, or another chip"));
    }
    is_calibrated = invcal_load(&calibration, &calibration_store) == INVCAL_OK;
    Serial.println(is_calibrated ? F("stored calibration: found") : F("stored calibration: none"));
    if (is_calibrated) {
        return;
    }
    begin_session();
    if (invcal_session_load(&session, &session_store) == INVCAL_OK) {
        Serial.print(F("goes on, positions taken: "));
        Serial.println(session.count);
    }
    show_next();
}

void loop()
{
    int32_t raw[3];

    const sensor_status status = sensor_next(raw);
    if (status == SENSOR_SILENT) {
        stop(F("sensor: no sample in due time"));
    }
    if (is_calibrated) {
        measure(raw);
    } else {
        if (status == SENSOR_LOST) { /* while text was printed, or a position was solved */
            invcal_session_gap(&session);
        }
        calibrate(raw);
    }
    if (Serial.read() == 'c') {
        begin_session();
        show_next();
    }
}
