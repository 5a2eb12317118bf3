/* SPDX-License-Identifier: MIT
 *
 * imu.h: the driver of the accelerometer.
 */
#ifndef IMU_H
#define IMU_H

#include <stdint.h>

#define IMU_RATE 100u           /* samples per second */
#define IMU_COUNTS 8192.0f      /* counts for 1 g, by the data sheet */
#define IMU_LOW INT32_C(-32768) /* counts at which it clips */
#define IMU_HIGH INT32_C(32767)

typedef enum {
    IMU_OK,
    IMU_LOST,   /* a sample, but others were lost before it */
    IMU_ABSENT, /* nobody answers, or another chip */
    IMU_DEAF,   /* it does not keep its settings */
    IMU_SILENT  /* no sample, no end of its reset in due time */
} imu_status;

typedef struct {
    int32_t raw[3];    /* counts */
    float temperature; /* degrees Celsius */
} imu_sample;

/* Resets the chip and sets it up. Returns IMU_OK, IMU_ABSENT, IMU_DEAF or IMU_SILENT. */
imu_status imu_begin(void);

/* Waits for the next sample. Returns IMU_OK or IMU_LOST with it; IMU_SILENT without. */
imu_status imu_next(imu_sample *sample);

/* A sentence for a status. */
const char *imu_status_text(imu_status status);

#endif
