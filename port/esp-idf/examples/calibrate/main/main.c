/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself. Turn the sensor as the console says, and hold it still
 * until it says "good". At the end the calibration is stored; from then on, and after every reset,
 * calibrated readings are printed. The sensor is in sensor.c.
 */
#include <stdio.h>
#include <string.h>

#include "nvs.h"
#include "nvs_flash.h"

#include "invcal/invcal.h"
#include "sensor.h"

#define MOST 20u  /* positions; then it is solved, were the target not reached */
#define SHOWN 50u /* one calibrated sample in so many is shown */

static invcal_session session;

/* ---- the calibration in the flash ------------------------------------------------------------- */

static esp_err_t open_flash(void)
{
    esp_err_t error = nvs_flash_init();

    if (error == ESP_ERR_NVS_NO_FREE_PAGES || error == ESP_ERR_NVS_NEW_VERSION_FOUND) {
        error = nvs_flash_erase();
        if (error == ESP_OK) {
            error = nvs_flash_init();
        }
    }
    return error;
}

/* Returns 1 if one was stored. */
static int load(invcal_calibration *calibration)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    size_t size = sizeof bytes;
    invcal_record record;
    nvs_handle_t flash;

    if (open_flash() != ESP_OK || nvs_open("invcal", NVS_READONLY, &flash) != ESP_OK) {
        return 0; /* there is nothing yet */
    }
    const int is_found = nvs_get_blob(flash, "record", bytes, &size) == ESP_OK &&
                         invcal_record_decode(bytes, (uint32_t)size, &record) == INVCAL_OK;
    nvs_close(flash);
    if (is_found) {
        *calibration = record.calibration;
    }
    return is_found;
}

static esp_err_t write_record(const uint8_t bytes[INVCAL_RECORD_SIZE])
{
    nvs_handle_t flash;
    esp_err_t error = nvs_open("invcal", NVS_READWRITE, &flash);

    if (error == ESP_OK) {
        error = nvs_set_blob(flash, "record", bytes, INVCAL_RECORD_SIZE);
        if (error == ESP_OK) {
            error = nvs_commit(flash);
        }
        nvs_close(flash);
    }
    return error;
}

static void save(const invcal_solution *solution, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record = {
        .calibration = solution->calibration,
        .field = session.setup.settings.field,
        .temperature = session.temperature,
        .temperature_known = 1,
        .noise = quality->noise,
        .residual_rms = quality->residual_rms,
        .condition = quality->condition,
        .verdict = quality->verdict,
        .positions = (uint16_t)session.normal.count,
        .undetermined = quality->undetermined,
    };

    memcpy(record.delta, solution->delta, sizeof record.delta);
    memcpy(record.dk, solution->dk, sizeof record.dk);
    memcpy(record.gamma, solution->gamma, sizeof record.gamma);
    memcpy(record.sigma_offset, quality->sigma_offset, sizeof record.sigma_offset);
    memcpy(record.sigma_delta, quality->sigma_delta, sizeof record.sigma_delta);
    memcpy(record.sigma_dk, quality->sigma_dk, sizeof record.sigma_dk);
    memcpy(record.sigma_gamma, quality->sigma_gamma, sizeof record.sigma_gamma);
    if (invcal_record_encode(&record, bytes) == INVCAL_OK && write_record(bytes) == ESP_OK) {
        printf("calibration stored\n");
    } else {
        printf("calibration not stored\n");
    }
}

/* ---- the session ------------------------------------------------------------------------------ */

static void tell_next(void)
{
    invcal_guidance next;
    char words[INVCAL_GUIDANCE_WORDS];

    if (invcal_session_next(&session, &next) == INVCAL_OK) {
        invcal_guidance_words(next.up, words);
        printf("next: %s\n", words);
    }
}

static invcal_status begin_session(void)
{
    static const invcal_real zero[3] = {0, 0, 0};
    static const invcal_real scale[3] = {SENSOR_SCALE, SENSOR_SCALE, SENSOR_SCALE};
    invcal_session_setup setup = {
        .settings = {.field = 1, .noise = 0.0003f}, /* g; of the mean of a position */
        .target = {0.0002f, 0.0003f, 0.0005f},      /* g; 1; rad: sigma that is enough */
        .rate = SENSOR_RATE,
        .low = SENSOR_LOW,
        .high = SENSOR_HIGH,
    };
    invcal_status status = invcal_calibration_nominal(zero, scale, &setup.settings.nominal);

    if (status == INVCAL_OK) {
        status = invcal_session_init(&session, &setup);
    }
    if (status != INVCAL_OK) {
        printf("session: %s\n", invcal_status_text(status));
        return status;
    }
    printf("calibration begins\n");
    tell_next();
    return status;
}

static void tell(const invcal_event *event)
{
    switch (event->what) {
    case INVCAL_SESSION_SETTLING:
        if (event->progress > 0 && event->progress < 100) {
            printf("hold still, percent: %u\n", event->progress);
        }
        break;
    case INVCAL_SESSION_READY:
        printf("good: move on\n");
        tell_next();
        break;
    case INVCAL_SESSION_REFUSED:
        printf("refused: %s\n", event->reason != INVCAL_REST_GOOD
                                    ? invcal_rest_reason_text(event->reason)
                                    : invcal_status_text(event->status));
        tell_next();
        break;
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
        printf("positions taken: %u\n", event->positions);
        break;
    default:
        break; /* moving */
    }
}

static void tell_vector(const char *name, const invcal_real v[3])
{
    printf("%s %.5f %.5f %.5f\n", name, (double)v[0], (double)v[1], (double)v[2]);
}

/* Without positions that contradict the others. Returns 1 and stores it if it is good. */
static int solve(invcal_calibration *calibration)
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;
    const invcal_status status = invcal_session_solve(&session, &solution, &quality, &outliers);

    if (status != INVCAL_OK) {
        printf("not calibrated: %s\n", invcal_status_text(status));
        return 0;
    }
    printf("verdict: %s\n", invcal_verdict_text(quality.verdict));
    tell_vector("offset, counts:", solution.calibration.offset);
    tell_vector("sigma:", quality.sigma_offset);
    tell_vector("scale errors:", solution.dk);
    tell_vector("sigma:", quality.sigma_dk);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    *calibration = solution.calibration;
    save(&solution, &quality);
    return 1;
}

/* Begins anew until the result is good. Returns 0 if the sensor or the setup is of no use. */
static int calibrate(invcal_calibration *calibration)
{
    int32_t raw[3];
    float temperature;
    invcal_event event;

    do {
        if (begin_session() != INVCAL_OK) {
            return 0;
        }
        while (!session.is_enough && session.normal.count < MOST) {
            const sensor_status status = sensor_next(raw, &temperature);
            if (status == SENSOR_SILENT) {
                printf("sensor: no answer\n");
                return 0;
            }
            if (status == SENSOR_LOST) { /* while text was printed, or a position was solved */
                invcal_session_gap(&session);
            }
            if (invcal_session_feed(&session, raw, temperature, &event) != INVCAL_SESSION_NOTHING) {
                tell(&event);
            }
        }
    } while (!solve(calibration));
    return 1;
}

/* What your device does with it. Comes back only if the sensor falls silent. */
static void measure(const invcal_calibration *calibration)
{
    int32_t raw[3];
    float temperature;

    for (unsigned n = 1; sensor_next(raw, &temperature) != SENSOR_SILENT; n++) {
        invcal_real a[3] = {(invcal_real)raw[0], (invcal_real)raw[1], (invcal_real)raw[2]};
        invcal_apply(calibration, a, a);
        if (n % SHOWN == 0) {
            tell_vector("a, g:", a);
        }
    }
}

void app_main(void)
{
    invcal_calibration calibration;

    if (sensor_begin() != SENSOR_OK) {
        printf("sensor: no answer, or another chip\n");
        return;
    }
    const int is_found = load(&calibration);
    printf("stored calibration: %s\n", is_found ? "found" : "none");
    if (is_found || calibrate(&calibration)) {
        measure(&calibration);
    }
}
