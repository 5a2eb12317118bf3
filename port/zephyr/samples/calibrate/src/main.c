/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that calibrates itself: any sensor behind the alias accel0. Turn it as the
 * console says, and hold it still until it says "good". At the end the calibration is stored; from
 * then on, and after every reset, calibrated readings are printed.
 *
 * The session takes samples as integers. Sensors here deliver m/s^2 and millionths; what is fed are
 * units of 10 um/s^2, fine against the noise, and wide enough for 16 g.
 */
#include <errno.h>
#include <string.h>

#include <zephyr/device.h>
#include <zephyr/drivers/sensor.h>
#include <zephyr/kernel.h>
#include <zephyr/settings/settings.h>
#include <zephyr/sys/printk.h>

#include "invcal/invcal.h"

#define RATE 100u    /* samples per second */
#define UNITS 100000 /* for 1 m/s^2 */
#define MOST 20u     /* positions; then it is solved, were the target not reached */
#define SHOWN 50u    /* one calibrated sample in so many is shown */

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
    /* Not every driver can; then the devicetree has to say it. */
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
        (void)invcal_record_decode(bytes, sizeof bytes, record); /* else it stays as it is */
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
    return record.field > 0;
}

static void save(const invcal_solution *solution, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record = {
        .calibration = solution->calibration,
        .field = session.setup.settings.field,
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
    if (invcal_record_encode(&record, bytes) == INVCAL_OK &&
        settings_save_one("invcal/record", bytes, sizeof bytes) == 0) {
        printk("calibration stored\n");
    } else {
        printk("calibration not stored\n");
    }
}

/* ---- the session ------------------------------------------------------------------------------ */

static void tell_next(void)
{
    invcal_guidance next;
    char words[INVCAL_GUIDANCE_WORDS];

    if (invcal_session_next(&session, &next) == INVCAL_OK) {
        invcal_guidance_words(next.up, words);
        printk("next: %s\n", words);
    }
}

static invcal_status begin_session(void)
{
    static const invcal_real zero[3] = {0, 0, 0};
    static const invcal_real scale[3] = {INVCAL_REAL(1.0) / UNITS, INVCAL_REAL(1.0) / UNITS,
                                         INVCAL_REAL(1.0) / UNITS};
    invcal_session_setup setup = {
        .settings = {.field = INVCAL_REAL(9.80665),
                     .noise = INVCAL_REAL(0.003)}, /* m/s^2; of the mean of a position */
        .target = {INVCAL_REAL(0.0002), INVCAL_REAL(0.0003),
                   INVCAL_REAL(0.0005)}, /* sigma in g, 1 and rad: that is enough */
        .rate = RATE,
    };
    invcal_status status = invcal_calibration_nominal(zero, scale, &setup.settings.nominal);

    if (status == INVCAL_OK) {
        status = invcal_session_init(&session, &setup);
    }
    if (status != INVCAL_OK) {
        printk("session: %s\n", invcal_status_text(status));
        return status;
    }
    printk("calibration begins\n");
    tell_next();
    return status;
}

static void tell(const invcal_event *event)
{
    switch (event->what) {
    case INVCAL_SESSION_SETTLING:
        if (event->progress > 0 && event->progress < 100) {
            printk("hold still, percent: %u\n", event->progress);
        }
        break;
    case INVCAL_SESSION_READY:
        printk("good: move on\n");
        tell_next();
        break;
    case INVCAL_SESSION_REFUSED:
        printk("refused: %s\n", event->reason != INVCAL_REST_GOOD
                                    ? invcal_rest_reason_text(event->reason)
                                    : invcal_status_text(event->status));
        tell_next();
        break;
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
        printk("positions taken: %u\n", event->positions);
        break;
    default:
        break; /* moving */
    }
}

static void tell_vector(const char *name, const invcal_real v[3])
{
    printk("%s %.5f %.5f %.5f\n", name, (double)v[0], (double)v[1], (double)v[2]);
}

/* Without positions that contradict the others. Returns 1 and stores it if it is good. */
static int solve(invcal_calibration *calibration)
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_outliers outliers;
    const invcal_status status = invcal_session_solve(&session, &solution, &quality, &outliers);

    if (status != INVCAL_OK) {
        printk("not calibrated: %s\n", invcal_status_text(status));
        return 0;
    }
    printk("verdict: %s\n", invcal_verdict_text(quality.verdict));
    tell_vector("offset, 10 um/s^2:", solution.calibration.offset);
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

/* Begins anew until the result is good. Returns an error of the sensor, or 0. */
static int calibrate(invcal_calibration *calibration)
{
    int32_t raw[3];
    invcal_event event;

    do {
        if (begin_session() != INVCAL_OK) {
            return -EINVAL;
        }
        while (!session.is_enough && session.normal.count < MOST) {
            const int due = next_sample(raw);
            if (due < 0) {
                return due;
            }
            if (due > 1) {
                invcal_session_gap(&session);
            }
            if (invcal_session_feed(&session, raw, 0, &event) != INVCAL_SESSION_NOTHING) {
                tell(&event);
            }
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
    for (unsigned n = 1; error == 0; n++) { /* what your device does with it */
        const int due = next_sample(raw);
        invcal_real a[3] = {(invcal_real)raw[0], (invcal_real)raw[1], (invcal_real)raw[2]};
        error = due < 0 ? due : 0;
        invcal_apply(&calibration, a, a);
        if (error == 0 && n % SHOWN == 0) {
            tell_vector("a, m/s^2:", a);
        }
    }
    return error;
}
