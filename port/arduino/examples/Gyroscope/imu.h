/* SPDX-License-Identifier: MIT
 *
 * imu.h: accelerometer and gyroscope of an MPU-6050, 6500, 9250 or 9255 on the I2C bus.
 */
#ifndef IMU_H
#define IMU_H

#include <Arduino.h>

const unsigned IMU_RATE = 100;  /* samples per second of both */
const float IMU_COUNTS = 16384; /* counts for 1 g, by the data sheet: range 2 g */
const float IMU_GYRO_COUNTS =
    65.5;                       /* counts for 1 degree/s, by the data sheet: range 500 degrees/s */
const int32_t IMU_LOW = -32768; /* counts at which either clips */
const int32_t IMU_HIGH = 32767;

enum imu_status {
    IMU_OK,
    IMU_LOST,  /* no sample: the queue has overflowed */
    IMU_SILENT /* no sample in time */
};

/* Sets the chip up. Returns false if there is no answer, or another chip. */
bool imu_begin();

/* Waits for the next sample of both, counts. The chip's queue holds 0.8 s of them. */
imu_status imu_next(int32_t accelerometer[3], int32_t gyro[3]);

#endif
