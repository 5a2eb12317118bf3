/* SPDX-License-Identifier: MIT
 *
 * A mock of Zephyr, for the sample: the sensor is a log on standard input (time, and counts of
 * 10 um/s^2), whose end ends the run; the settings are a file. What passes here may still be wrong
 * on Zephyr itself: these functions do what we understand its documentation to say.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <zephyr/drivers/sensor.h>
#include <zephyr/kernel.h>
#include <zephyr/settings/settings.h>
#include <zephyr/sys/printk.h>

#define UNITS 100000

const struct device mock_accel0 = {"accel0"};
static long counts[3];

bool device_is_ready(const struct device *dev)
{
    return dev == &mock_accel0;
}

int sensor_attr_set(const struct device *dev, enum sensor_channel chan, enum sensor_attribute attr,
                    const struct sensor_value *val)
{
    return dev == &mock_accel0 && chan == SENSOR_CHAN_ACCEL_XYZ &&
                   attr == SENSOR_ATTR_SAMPLING_FREQUENCY && val->val1 == 100 && val->val2 == 0
               ? 0
               : -1;
}

int sensor_sample_fetch(const struct device *dev)
{
    char line[128];

    do {
        if (fgets(line, sizeof line, stdin) == NULL) {
            exit(0);
        }
    } while (sscanf(line, "%*f,%ld,%ld,%ld", &counts[0], &counts[1], &counts[2]) != 3);
    return dev == &mock_accel0 ? 0 : -1;
}

int sensor_channel_get(const struct device *dev, enum sensor_channel chan, struct sensor_value *val)
{
    for (int i = 0; i < 3; i++) {
        val[i].val1 = (int32_t)(counts[i] / UNITS);
        val[i].val2 = (int32_t)(counts[i] % UNITS) * (1000000 / UNITS);
    }
    return dev == &mock_accel0 && chan == SENSOR_CHAN_ACCEL_XYZ ? 0 : -1;
}

void k_timer_start(struct k_timer *timer, k_timeout_t duration, k_timeout_t period)
{
    timer->period = period;
    if (duration.ticks != period.ticks) {
        abort();
    }
}

uint32_t k_timer_status_sync(struct k_timer *timer)
{
    if (timer->period.ticks != 10000) { /* not started, or not 100 Hz */
        abort();
    }
    return 1;
}

void printk(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
}

/* ---- one setting, in the file `settings`: its name, a line end, its bytes --------------------- */

static ssize_t read_rest(void *file, void *data, size_t len)
{
    return (ssize_t)fread(data, 1, len, file);
}

int settings_subsys_init(void)
{
    return 0;
}

int settings_load_subtree_direct(const char *subtree, settings_load_direct_cb cb, void *param)
{
    char name[64];
    FILE *file = fopen("settings", "rb");

    if (file == NULL) {
        return 0;
    }
    if (fgets(name, sizeof name, file) != NULL) {
        const long begin = ftell(file);
        name[strcspn(name, "\n")] = '\0';
        fseek(file, 0, SEEK_END);
        const size_t size = (size_t)(ftell(file) - begin);
        fseek(file, begin, SEEK_SET);
        if (strncmp(name, subtree, strlen(subtree)) == 0 && name[strlen(subtree)] == '/') {
            (void)cb(name + strlen(subtree) + 1, size, read_rest, file, param);
        }
    }
    fclose(file);
    return 0;
}

int settings_save_one(const char *name, const void *value, size_t val_len)
{
    FILE *file = fopen("settings", "wb");

    if (file == NULL) {
        return -1;
    }
    fprintf(file, "%s\n", name);
    fwrite(value, 1, val_len, file);
    return fclose(file);
}
