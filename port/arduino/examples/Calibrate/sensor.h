/* SPDX-License-Identifier: MIT
 *
 * sensor.h: the accelerometer, an MPU-6050, 6500, 9250 or 9255 on the I2C bus.
 */
#ifndef SENSOR_H
#define SENSOR_H

#include <Arduino.h>

const unsigned SENSOR_RATE = 100;  /* samples per second */
const float SENSOR_COUNTS = 16384; /* counts for 1 g, by the data sheet: range 2 g */
const int32_t SENSOR_LOW = -32768; /* counts at which it clips */
const int32_t SENSOR_HIGH = 32767;

enum sensor_status {
    SENSOR_OK,
    SENSOR_LOST,  /* a sample, but others were lost before it */
    SENSOR_SILENT /* no sample in time */
};

/* Sets the chip up. False if there is no answer, or another chip. */
bool sensor_begin();

/* Waits for the next sample, counts. */
sensor_status sensor_next(int32_t raw[3]);

#endif
