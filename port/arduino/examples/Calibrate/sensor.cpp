/* SPDX-License-Identifier: MIT */
#include "sensor.h"

#include "i2c.h"

/* From the register maps of the MPU-6000/6050, MPU-6500, MPU-9250 and MPU-9255. */
enum {
    ADDRESS = 0x68, /* pin AD0 low; 0x69 if it is high */
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* not in the MPU-6050 */
    INT_STATUS = 0x3A,
    ACCEL_XOUT_H = 0x3B, /* x, y, z: 2 bytes each, the high one first */
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
    MPU6050 = 0x68, /* value of WHO_AM_I; the others have the same accelerometer */
    MPU6500 = 0x70,
    MPU9250 = 0x71,
    MPU9255 = 0x73
};

const unsigned TIMEOUT = 100; /* milliseconds */

static uint8_t chip;
static unsigned latest; /* milliseconds, of the latest sample */

static bool set(uint8_t address, uint8_t value)
{
    return i2c_set(ADDRESS, address, value);
}

static bool get(uint8_t address, uint8_t *bytes, uint8_t size)
{
    return i2c_get(ADDRESS, address, bytes, size);
}

static bool is_known()
{
    return chip == MPU6050 || chip == MPU6500 || chip == MPU9250 || chip == MPU9255;
}

bool sensor_begin()
{
    i2c_begin();
    if (!get(WHO_AM_I, &chip, 1) || !is_known()) {
        return false;
    }
    /* Awake; low-pass filter of 44 Hz; 1 kHz / (1 + 9); 2 g. */
    return set(PWR_MGMT_1, 1) && set(CONFIG, 3) && set(SMPLRT_DIV, 9) && set(ACCEL_CONFIG, 0) &&
           (chip == MPU6050 || set(ACCEL_CONFIG2, 3));
}

static int32_t count_of(const uint8_t bytes[2])
{
    return (int16_t)((uint16_t)bytes[0] << 8 | bytes[1]);
}

sensor_status sensor_next(int32_t raw[3])
{
    const unsigned begin = millis();
    uint8_t bytes[6];

    do {
        if ((unsigned)millis() - begin > TIMEOUT || !get(INT_STATUS, bytes, 1)) {
            return SENSOR_SILENT;
        }
    } while (!(bytes[0] & 1));
    const unsigned now = millis();
    const bool is_lost = now - latest > 1500 / SENSOR_RATE;
    latest = now;
    if (!get(ACCEL_XOUT_H, bytes, sizeof bytes)) {
        return SENSOR_SILENT;
    }
    for (int i = 0; i < 3; i++) {
        raw[i] = count_of(&bytes[2 * i]);
    }
    return is_lost ? SENSOR_LOST : SENSOR_OK;
}
