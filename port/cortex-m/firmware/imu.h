/* SPDX-License-Identifier: MIT
 *
 * imu.h: the driver of a chip with both sensors.
 */
#ifndef IMU_H
#define IMU_H

#include <stdint.h>

#define IMU_RATE 100u           /* samples per second of the accelerometer, */
#define IMU_GYRO_RATE 200.0f    /* and of the gyroscope */
#define IMU_COUNTS 8192.0f      /* counts for 1 g, by the data sheet */
#define IMU_GYRO_UNIT 2.665e-4f /* rad/s for 1 count, by the data sheet */
#define IMU_LOW INT32_C(-32768) /* counts at which either clips */
#define IMU_HIGH INT32_C(32767)

typedef enum {
    IMU_ACCELEROMETER, /* a sample of it */
    IMU_GYRO,          /* a sample of it */
    IMU_LOST,          /* no sample: some were lost here */
    IMU_SILENT,        /* no sample, or no end of its reset, in time */
    IMU_ABSENT,        /* no answer, or another chip */
    IMU_CONFIG_FAILED  /* it does not keep its settings */
} imu_status;

/* Resets the chip and sets it up, the gyroscope too if asked. Returns IMU_ACCELEROMETER on success;
 * IMU_SILENT, IMU_ABSENT or IMU_CONFIG_FAILED. */
imu_status imu_begin(int with_gyro);

/* Waits for the next sample, in counts; samples of both sensors come in the order of their
 * times. */
imu_status imu_next(int32_t raw[3]);

/* A sentence for a status. */
const char *imu_status_text(imu_status status);

#endif
