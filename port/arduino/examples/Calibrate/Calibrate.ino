/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself. Open the serial monitor at 115200 baud, turn the sensor
 * as it says, and hold it still until it says "good". At the end the calibration is stored; from
 * then on calibrated readings are printed, after the next power-on too. Send c to calibrate anew.
 *
 * Needs 5 KB of RAM: a Mega 2560, or anything larger. The sensor is in sensor.cpp, the memory in
 * storage.cpp: change them for other ones.
 */
#include <invcal.h>

#include "sensor.h"
#include "storage.h"

const unsigned MOST = 20;  /* positions; then it is solved, were the target not reached */
const unsigned SHOWN = 50; /* one calibrated sample in so many is shown */

static invcal_session session;
static invcal_calibration calibration;
static bool is_calibrated;

/* Never comes back: there is nothing left to do without a reset. */
static void stop(const char *why)
{
    Serial.println(why);
    Serial.flush();
    for (;;) {
    }
}

static void show(const __FlashStringHelper *name, const float v[3], int digits)
{
    Serial.print(name);
    for (int i = 0; i < 3; i++) {
        Serial.print(' ');
        Serial.print(v[i], digits);
    }
    Serial.println();
}

/* ---- the session ------------------------------------------------------------------------------ */

static void show_next()
{
    invcal_guidance next;
    char words[INVCAL_GUIDANCE_WORDS];

    if (invcal_session_next(&session, &next) == INVCAL_OK) {
        invcal_guidance_words(next.up, words);
        Serial.print(F("next: "));
        Serial.println(words);
    }
}

static void begin_session()
{
    const float zero[3] = {0, 0, 0};
    const float scale[3] = {SENSOR_SCALE, SENSOR_SCALE, SENSOR_SCALE};
    invcal_session_setup wanted = {};

    wanted.settings.field = 1;       /* g */
    wanted.settings.noise = 0.0003f; /* g, of the mean of a position */
    wanted.target[0] = 0.0002f;      /* sigma of offsets, g, */
    wanted.target[1] = 0.0003f;      /* of scale errors, */
    wanted.target[2] = 0.0005f;      /* of cross terms, rad: that is enough */
    wanted.rate = SENSOR_RATE;
    wanted.low = SENSOR_LOW;
    wanted.high = SENSOR_HIGH;
    invcal_status status = invcal_calibration_nominal(zero, scale, &wanted.settings.nominal);
    if (status == INVCAL_OK) {
        status = invcal_session_init(&session, &wanted);
    }
    if (status != INVCAL_OK) {
        stop(invcal_status_text(status));
    }
    is_calibrated = false;
    Serial.println(F("calibration begins"));
    show_next();
}

static void show_event(const invcal_event &event)
{
    switch (event.what) {
    case INVCAL_SESSION_SETTLING:
        if (event.progress > 0 && event.progress < 100) {
            Serial.print(F("hold still, percent: "));
            Serial.println(event.progress);
        }
        break;
    case INVCAL_SESSION_READY:
        Serial.println(F("good: move on"));
        show_next();
        break;
    case INVCAL_SESSION_REFUSED:
        Serial.print(F("refused: "));
        Serial.println(event.reason != INVCAL_REST_GOOD ? invcal_rest_reason_text(event.reason)
                                                        : invcal_status_text(event.status));
        show_next();
        break;
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
        Serial.print(F("positions taken: "));
        Serial.println(event.positions);
        break;
    default:
        break; /* moving */
    }
}

/* Without positions that contradict the others. */
static void solve()
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;
    const invcal_status status = invcal_session_solve(&session, &solution, &quality, &outliers);

    if (status != INVCAL_OK) {
        Serial.print(F("not calibrated: "));
        Serial.println(invcal_status_text(status));
        begin_session();
        return;
    }
    Serial.print(F("verdict: "));
    Serial.println(invcal_verdict_text(quality.verdict));
    show(F("offset, counts:"), solution.calibration.offset, 2);
    show(F("sigma:"), quality.sigma_offset, 2);
    show(F("scale errors:"), solution.dk, 5);
    show(F("sigma:"), quality.sigma_dk, 5);
    show(F("cross terms, rad:"), solution.gamma, 5);
    show(F("sigma:"), quality.sigma_gamma, 5);
    if (quality.verdict != INVCAL_GOOD) {
        begin_session();
        return;
    }
    calibration = solution.calibration;
    is_calibrated = true;
    const invcal_status kept = storage_save(session, solution, quality);
    Serial.println(kept == INVCAL_OK ? "calibration stored" : invcal_status_text(kept));
}

static void calibrate(const int32_t raw[3], float temperature)
{
    invcal_event event;

    if (invcal_session_feed(&session, raw, temperature, &event) == INVCAL_SESSION_NOTHING) {
        return;
    }
    show_event(event);
    if (session.is_enough || session.normal.count >= MOST) {
        solve();
    }
}

/* ---- from then on ----------------------------------------------------------------------------- */

/* What your device does with it. */
static void measure(const int32_t raw[3])
{
    static unsigned n;
    float a[3] = {(float)raw[0], (float)raw[1], (float)raw[2]};

    invcal_apply(&calibration, a, a);
    if (++n % SHOWN == 0) {
        show(F("a, g:"), a, 4);
    }
}

void setup()
{
    Serial.begin(115200);
    if (!sensor_begin()) {
        stop("sensor: no answer, or another chip");
    }
    const invcal_status status = storage_load(calibration);
    is_calibrated = status == INVCAL_OK;
    Serial.print(F("stored calibration: "));
    Serial.println(is_calibrated ? "found" : invcal_status_text(status));
    if (!is_calibrated) {
        begin_session();
    }
}

void loop()
{
    int32_t raw[3];
    float temperature = 0;

    const sensor_status status = sensor_next(raw, temperature);
    if (status == SENSOR_SILENT) {
        stop("sensor: no sample in due time");
    }
    if (is_calibrated) {
        measure(raw);
    } else {
        if (status == SENSOR_LOST) { /* while text was printed, or a position was solved */
            invcal_session_gap(&session);
        }
        calibrate(raw, temperature);
    }
    if (Serial.read() == 'c') {
        begin_session();
    }
}
