/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself. Turn the sensor as the console says, and hold it still
 * until it says "good". At the end the calibration is stored; from then on, and after every reset,
 * calibrated readings are printed. The sensor is in sensor.c.
 */
#include <stdio.h>

#include "nvs.h"
#include "nvs_flash.h"

#include "invcal/result.h"
#include "invcal/store.h"
#include "sensor.h"

#define SHOW_EVERY 50u  /* calibrated samples */
#define PRINT_SAMPLES 0 /* 1: each sample of the session as x,y,z, for the page of make web */

static invcal_session session;
static float temperature; /* degrees Celsius, of the latest sample */

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
        return 0; /* nothing is stored yet */
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

static void save(const invcal_calibration *calibration, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    invcal_record_init(&record, calibration, quality);
    record.temperature = temperature;
    record.temperature_known = 1;
    if (invcal_record_encode(&record, bytes) == INVCAL_OK && write_record(bytes) == ESP_OK) {
        printf("calibration stored\n");
    } else {
        printf("calibration not stored\n");
    }
}

/* ---- the session ------------------------------------------------------------------------------ */

static void print_next(void)
{
    char text[INVCAL_TEXT_SIZE];

    printf("next: %s\n", invcal_session_next_text(&session, text));
}

static invcal_status begin_session(void)
{
    invcal_status status =
        invcal_session_init(&session, sizeof session, SENSOR_COUNTS, SENSOR_RATE);

    if (status == INVCAL_OK) {
        status = invcal_session_set_limits(&session, SENSOR_LOW, SENSOR_HIGH);
    }
    if (status == INVCAL_OK) {
        status = invcal_session_set_noise(&session, 0.0003f); /* g, of the mean of a position */
    }
    if (status != INVCAL_OK) {
        printf("session: %s\n", invcal_status_text(status));
        return status;
    }
    printf("calibration begins\n");
    print_next();
    return status;
}

static void print_event(invcal_event event)
{
    const unsigned progress = invcal_session_progress(&session);

    switch (event) {
    case INVCAL_SETTLING:
        if (progress > 0 && progress < 100) {
            printf("hold still, percent: %u\n", progress);
        }
        break;
    case INVCAL_READY:
        printf("good: move on\n");
        print_next();
        break;
    case INVCAL_REFUSED:
        printf("refused: %s\n", invcal_session_reason_text(&session));
        print_next();
        break;
    case INVCAL_TAKEN:
        printf("positions taken: %u\n", (unsigned)session.count);
        break;
    default:
        break; /* moving */
    }
}

static void print_vector(const char *name, const invcal_real v[3])
{
    printf("%s %.5f %.5f %.5f\n", name, (double)v[0], (double)v[1], (double)v[2]);
}

/* Leaves out positions that contradict the others. Stores the result if it is good, and returns 1
 * then. */
static int solve(invcal_calibration *calibration)
{
    invcal_quality quality;
    invcal_real sigma[3];
    invcal_real x[INVCAL_PARAMETERS];
    const invcal_status status = invcal_session_solve(&session, calibration, &quality);

    if (status != INVCAL_OK) {
        printf("not calibrated: %s\n", invcal_status_text(status));
        return 0;
    }
    for (unsigned i = 0; i < session.count; i++) {
        if (quality.left_out >> i & 1u) {
            printf("left out, for it contradicts the others: position %u\n", i + 1);
        }
    }
    invcal_sigma_offset(&quality, &session.nominal, sigma);
    invcal_deviation(calibration, &session.nominal, x);
    printf("verdict: %s\n", invcal_verdict_text(quality.verdict));
    print_vector("offset, counts:", calibration->offset);
    print_vector("sigma:", sigma);
    print_vector("scale errors:", &x[INVCAL_DK_X]);
    print_vector("sigma:", &quality.sigma[INVCAL_DK_X]);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    save(calibration, &quality);
    return 1;
}

/* Repeats the session until the result is good. Returns 0 if sensor or setup fail. */
static int calibrate(invcal_calibration *calibration)
{
    int32_t raw[3];

    do {
        if (begin_session() != INVCAL_OK) {
            return 0;
        }
        while (!invcal_session_is_good(&session)) {
            const sensor_status status = sensor_next(raw, &temperature);
            if (status == SENSOR_SILENT) {
                printf("sensor: no answer\n");
                return 0;
            }
            if (status == SENSOR_LOST) { /* while text was printed, or a position was solved */
                invcal_session_gap(&session);
            }
            if (PRINT_SAMPLES) {
                printf("%d,%d,%d\n", (int)raw[0], (int)raw[1], (int)raw[2]);
            }
            print_event(invcal_session_feed(&session, raw[0], raw[1], raw[2]));
        }
    } while (!solve(calibration));
    return 1;
}

/* Your application. It returns only if the sensor stops responding. */
static void measure(const invcal_calibration *calibration)
{
    int32_t raw[3];

    for (unsigned n = 1; sensor_next(raw, &temperature) != SENSOR_SILENT; n++) {
        invcal_real a[3];
        invcal_apply(calibration, raw[0], raw[1], raw[2], a);
        if (n % SHOW_EVERY == 0) {
            print_vector("a, g:", a);
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
