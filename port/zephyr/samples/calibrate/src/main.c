/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself: any sensor behind the alias accel0. Turn it as the
 * console says, and hold it still until it says "good". At the end the calibration is stored; from
 * then on, and after every reset, calibrated readings are printed.
 *
 * The session takes integers. Sensors in Zephyr deliver m/s^2 and millionths; the session gets
 * units of 10 um/s^2, which is below the noise, and enough for 16 g.
 */
#include <errno.h>
#include <string.h>

#include <zephyr/device.h>
#include <zephyr/drivers/sensor.h>
#include <zephyr/kernel.h>
#include <zephyr/settings/settings.h>
#include <zephyr/sys/printk.h>

#include "invcal/result.h"
#include "invcal/store.h"

#define RATE 100u    /* samples per second */
#define UNITS 100000 /* for 1 m/s^2 */
#define G INVCAL_REAL(9.80665)
#define COUNTS (UNITS * G) /* units for 1 g */
#define SHOW_EVERY 50u     /* calibrated samples */
#define PRINT_SAMPLES 0    /* 1: each sample of the session as x,y,z, for the page of make web */

static const struct device *const accelerometer = DEVICE_DT_GET(DT_ALIAS(accel0));
static invcal_session session;
K_TIMER_DEFINE(sampling, NULL, NULL);

/* ---- the sensor ------------------------------------------------------------------------------- */

static int begin_sensor(void)
{
    const struct sensor_value rate = {.val1 = RATE};

    if (!device_is_ready(accelerometer)) {
        printk("sensor: not ready\n");
        return -ENODEV;
    }
    /* Some drivers cannot; then state the rate in the devicetree. */
    if (sensor_attr_set(accelerometer, SENSOR_CHAN_ACCEL_XYZ, SENSOR_ATTR_SAMPLING_FREQUENCY,
                        &rate) != 0) {
        printk("sensor: rate not set\n");
    }
    k_timer_start(&sampling, K_USEC(1000000 / RATE), K_USEC(1000000 / RATE));
    return 0;
}

/* Waits for the next sample. Returns how many were due since the last one, or a negative error. */
static int next_sample(int32_t raw[3])
{
    struct sensor_value value[3];
    const uint32_t due = k_timer_status_sync(&sampling);
    int error = sensor_sample_fetch(accelerometer);

    if (error == 0) {
        error = sensor_channel_get(accelerometer, SENSOR_CHAN_ACCEL_XYZ, value);
    }
    if (error != 0) {
        printk("sensor: error %d\n", error);
        return error;
    }
    for (int i = 0; i < 3; i++) {
        raw[i] = value[i].val1 * UNITS + value[i].val2 / (1000000 / UNITS);
    }
    return (int)due;
}

/* ---- the calibration as settings -------------------------------------------------------------- */

static int load_record(const char *key, size_t size, settings_read_cb read, void *argument,
                       void *record)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];

    if (strcmp(key, "record") == 0 && size == sizeof bytes &&
        read(argument, bytes, sizeof bytes) == (ssize_t)sizeof bytes) {
        (void)invcal_record_decode(bytes, sizeof bytes, record); /* unchanged after a failure */
    }
    return 0;
}

/* Returns 1 if one was stored. */
static int load(invcal_calibration *calibration)
{
    invcal_record record = {0};

    if (settings_subsys_init() != 0 ||
        settings_load_subtree_direct("invcal", load_record, &record) != 0) {
        printk("settings: cannot be read\n");
    }
    *calibration = record.calibration;
    return record.positions > 0;
}

static void save(const invcal_calibration *calibration, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    invcal_record_init(&record, calibration, quality);
    if (invcal_record_encode(&record, bytes) == INVCAL_OK &&
        settings_save_one("invcal/record", bytes, sizeof bytes) == 0) {
        printk("calibration stored\n");
    } else {
        printk("calibration not stored\n");
    }
}

/* ---- the session ------------------------------------------------------------------------------ */

static void print_next(void)
{
    char text[INVCAL_TEXT_SIZE];

    printk("next: %s\n", invcal_session_next_text(&session, text));
}

static invcal_status begin_session(void)
{
    invcal_status status = invcal_session_init(&session, sizeof session, COUNTS, RATE);

    if (status == INVCAL_OK) { /* of the mean of a position, over g: 3 mm/s^2 */
        status = invcal_session_set_noise(&session, INVCAL_REAL(0.0003));
    }
    if (status != INVCAL_OK) {
        printk("session: %s\n", invcal_status_text(status));
        return status;
    }
    printk("calibration begins\n");
    print_next();
    return status;
}

static void print_event(invcal_event event)
{
    const unsigned progress = invcal_session_progress(&session);

    switch (event) {
    case INVCAL_SETTLING:
        if (progress > 0 && progress < 100) {
            printk("hold still, percent: %u\n", progress);
        }
        break;
    case INVCAL_READY:
        printk("good: move on\n");
        print_next();
        break;
    case INVCAL_REFUSED:
        printk("refused: %s\n", invcal_session_reason_text(&session));
        print_next();
        break;
    case INVCAL_TAKEN:
        printk("positions taken: %u\n", (unsigned)session.count);
        break;
    default:
        break; /* moving */
    }
}

static void print_vector(const char *name, const invcal_real v[3])
{
    printk("%s %.5f %.5f %.5f\n", name, (double)v[0], (double)v[1], (double)v[2]);
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
        printk("not calibrated: %s\n", invcal_status_text(status));
        return 0;
    }
    for (unsigned i = 0; i < session.count; i++) {
        if (quality.left_out >> i & 1u) {
            printk("left out, for it contradicts the others: position %u\n", i + 1);
        }
    }
    invcal_sigma_offset(&quality, &session.nominal, sigma);
    invcal_deviation(calibration, &session.nominal, x);
    printk("verdict: %s\n", invcal_verdict_text(quality.verdict));
    print_vector("offset, 10 um/s^2:", calibration->offset);
    print_vector("sigma:", sigma);
    print_vector("scale errors:", &x[INVCAL_DK_X]);
    print_vector("sigma:", &quality.sigma[INVCAL_DK_X]);
    if (quality.verdict != INVCAL_GOOD) {
        return 0;
    }
    save(calibration, &quality);
    return 1;
}

/* Repeats the session until the result is good. Returns an error of the sensor, or 0. */
static int calibrate(invcal_calibration *calibration)
{
    int32_t raw[3];

    do {
        if (begin_session() != INVCAL_OK) {
            return -EINVAL;
        }
        while (!invcal_session_is_good(&session)) {
            const int due = next_sample(raw);
            if (due < 0) {
                return due;
            }
            if (due > 1) {
                invcal_session_gap(&session);
            }
            if (PRINT_SAMPLES) {
                printk("%d,%d,%d\n", (int)raw[0], (int)raw[1], (int)raw[2]);
            }
            print_event(invcal_session_feed(&session, raw[0], raw[1], raw[2]));
        }
    } while (!solve(calibration));
    return 0;
}

int main(void)
{
    invcal_calibration calibration;
    int32_t raw[3];
    int error = begin_sensor();

    if (error != 0) {
        return error;
    }
    const int is_found = load(&calibration);
    printk("stored calibration: %s\n", is_found ? "found" : "none");
    if (!is_found) {
        error = calibrate(&calibration);
    }
    if (error == 0 && invcal_scale(&calibration, G) != INVCAL_OK) { /* to m/s^2, no sooner */
        error = -EINVAL;
    }
    for (unsigned n = 1; error == 0; n++) { /* your application */
        invcal_real a[3];
        const int due = next_sample(raw);
        if (due < 0) {
            return due;
        }
        invcal_apply(&calibration, raw[0], raw[1], raw[2], a);
        if (n % SHOW_EVERY == 0) {
            print_vector("a, m/s^2:", a);
        }
    }
    return error;
}
