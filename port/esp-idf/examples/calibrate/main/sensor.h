/* SPDX-License-Identifier: MIT
 *
 * sensor.h: the accelerometer, an MPU-6050, 6500, 9250 or 9255 on the I2C bus.
 */
#ifndef SENSOR_H
#define SENSOR_H

#include <stdint.h>

#define SENSOR_RATE 100            /* samples per second */
#define SENSOR_COUNTS 16384.0f     /* counts for 1 g, by the data sheet: range 2 g */
#define SENSOR_LOW INT32_C(-32768) /* counts at which it clips */
#define SENSOR_HIGH INT32_C(32767)

typedef enum {
    SENSOR_OK,
    SENSOR_LOST,  /* a sample, but it came late: others were lost before it */
    SENSOR_SILENT /* no answer, or another chip */
} sensor_status;

/* Sets bus and chip up. Returns SENSOR_OK or SENSOR_SILENT. */
sensor_status sensor_begin(void);

/* Waits for the next sample: counts, and degrees Celsius. */
sensor_status sensor_next(int32_t raw[3], float *temperature);

#endif
