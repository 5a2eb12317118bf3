/* SPDX-License-Identifier: MIT
 *
 * sensor.h: the accelerometer, an MPU-6050, 6500, 9250 or 9255 on the I2C bus.
 */
#ifndef SENSOR_H
#define SENSOR_H

#include <Arduino.h>

const float SENSOR_RATE = 100;           /* samples per second */
const float SENSOR_SCALE = 1.0f / 16384; /* g for one count, by the data sheet: range 2 g */
const int32_t SENSOR_LOW = -32768;       /* counts at which it clips */
const int32_t SENSOR_HIGH = 32767;

enum sensor_status {
    SENSOR_OK,
    SENSOR_LOST,  /* a sample, but others were lost before it */
    SENSOR_SILENT /* no sample in due time */
};

/* Sets the chip up. False if nobody answers, or another chip. */
bool sensor_begin();

/* Waits for the next sample: counts, and degrees Celsius. */
sensor_status sensor_next(int32_t raw[3], float &temperature);

#endif
