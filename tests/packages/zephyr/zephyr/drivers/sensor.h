/* SPDX-License-Identifier: MIT
 *
 * In place of Zephyr's header of this name: what the sample uses of it, as its documentation says.
 */
#ifndef MOCK_SENSOR_H
#define MOCK_SENSOR_H

#include <stdint.h>

#include <zephyr/device.h>

/* val1 + val2 / 1000000, both of the same sign. */
struct sensor_value {
    int32_t val1;
    int32_t val2;
};

enum sensor_channel { SENSOR_CHAN_ACCEL_X, SENSOR_CHAN_ACCEL_XYZ };
enum sensor_attribute { SENSOR_ATTR_SAMPLING_FREQUENCY, SENSOR_ATTR_FULL_SCALE };

int sensor_attr_set(const struct device *dev, enum sensor_channel chan, enum sensor_attribute attr,
                    const struct sensor_value *val);
int sensor_sample_fetch(const struct device *dev);
int sensor_channel_get(const struct device *dev, enum sensor_channel chan,
                       struct sensor_value *val);

#endif
