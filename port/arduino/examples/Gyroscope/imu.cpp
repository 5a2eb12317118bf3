/* SPDX-License-Identifier: MIT */
#include "imu.h"

#include "i2c.h"

/* From the register maps of the MPU-6000/6050, MPU-6500, MPU-9250 and MPU-9255. */
enum {
    ADDRESS = 0x68, /* pin AD0 low; 0x69 if it is high */
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    GYRO_CONFIG = 0x1B,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* not in the MPU-6050 */
    FIFO_EN = 0x23,
    INT_STATUS = 0x3A,
    USER_CTRL = 0x6A,
    PWR_MGMT_1 = 0x6B,
    FIFO_COUNTH = 0x72, /* 2 bytes, the high one first */
    FIFO_R_W = 0x74,
    WHO_AM_I = 0x75,
    MPU6050 = 0x68, /* value of WHO_AM_I; the same for the others */
    MPU6500 = 0x70,
    MPU9250 = 0x71,
    MPU9255 = 0x73
};

const uint8_t BOTH = 0x78;      /* FIFO_EN: gyroscope x, y, z, and accelerometer, which comes first */
const uint8_t RESTART = 0x44;   /* USER_CTRL: the queue on, and emptied */
const uint8_t OVERFLOW = 0x10;  /* INT_STATUS */
const uint8_t SAMPLE = 12;      /* bytes */
const unsigned TIMEOUT = 100;  /* milliseconds */

static bool set(uint8_t address, uint8_t value)
{
    return i2c_set(ADDRESS, address, value);
}

static bool get(uint8_t address, uint8_t *bytes, uint8_t size)
{
    return i2c_get(ADDRESS, address, bytes, size);
}

static bool is_known(uint8_t chip)
{
    return chip == MPU6050 || chip == MPU6500 || chip == MPU9250 || chip == MPU9255;
}

bool imu_begin()
{
    uint8_t chip;

    i2c_begin();
    if (!get(WHO_AM_I, &chip, 1) || !is_known(chip)) {
        return false;
    }
    /* Awake; low-pass filter of 42 Hz; 1 kHz / (1 + 9); 500 degrees/s; 2 g. */
    return set(PWR_MGMT_1, 1) && set(CONFIG, 3) && set(SMPLRT_DIV, 9) && set(GYRO_CONFIG, 8) &&
           set(ACCEL_CONFIG, 0) && (chip == MPU6050 || set(ACCEL_CONFIG2, 3)) &&
           set(FIFO_EN, BOTH) && set(USER_CTRL, RESTART);
}

static int32_t count_of(const uint8_t bytes[2])
{
    return (int16_t)((uint16_t)bytes[0] << 8 | bytes[1]);
}

imu_status imu_next(int32_t accelerometer[3], int32_t gyro[3])
{
    const unsigned begin = millis();
    uint8_t bytes[SAMPLE];

    do {
        if ((unsigned)millis() - begin > TIMEOUT || !get(INT_STATUS, bytes, 1)) {
            return IMU_SILENT;
        }
        if (bytes[0] & OVERFLOW) { /* the rest of it may begin anywhere in a sample */
            return set(USER_CTRL, RESTART) ? IMU_LOST : IMU_SILENT;
        }
        if (!get(FIFO_COUNTH, bytes, 2)) {
            return IMU_SILENT;
        }
    } while (count_of(bytes) < SAMPLE);
    if (!get(FIFO_R_W, bytes, SAMPLE)) {
        return IMU_SILENT;
    }
    for (int i = 0; i < 3; i++) {
        accelerometer[i] = count_of(&bytes[2 * i]);
        gyro[i] = count_of(&bytes[6 + 2 * i]);
    }
    return IMU_OK;
}
