/* SPDX-License-Identifier: MIT */
#include "imu.h"

#include "imu_registers.h"
#include "spi.h"

#define POLLS_MAX 100000u /* of a register; at 8 MHz, some 0.2 s */

static uint8_t get(uint8_t address)
{
    uint8_t bytes[2] = {address | IMU_READ, 0};

    spi_transfer(bytes, sizeof bytes);
    return bytes[1];
}

static void set(uint8_t address, uint8_t value)
{
    uint8_t bytes[2] = {address, value};

    spi_transfer(bytes, sizeof bytes);
}

static int set_and_check(uint8_t address, uint8_t value)
{
    set(address, value);
    return get(address) == value;
}

/* The chip is not reset with the processor, so it may be in any state. Returns 1 if it is done. */
static int reset(void)
{
    set(IMU_CTRL3, IMU_CTRL3_RESET);
    for (unsigned poll = 0; poll < POLLS_MAX; poll++) {
        if (!(get(IMU_CTRL3) & IMU_CTRL3_RESET)) {
            return 1;
        }
    }
    return 0;
}

imu_status imu_begin(int with_gyro)
{
    if (get(IMU_WHO_AM_I) != IMU_NAME) {
        return IMU_ABSENT;
    }
    if (!reset()) {
        return IMU_SILENT;
    }
    const int is_set_up =
        set_and_check(IMU_CTRL1, IMU_CTRL1_100_HZ | IMU_CTRL1_4_G) &&
        (!with_gyro || set_and_check(IMU_CTRL2, IMU_CTRL2_200_HZ | IMU_CTRL2_500_DPS)) &&
        set_and_check(IMU_FIFO_CTRL, IMU_FIFO_CTRL_ON);
    return is_set_up ? IMU_ACCELEROMETER : IMU_CONFIG_FAILED;
}

/* Low byte first, two's complement. */
static int32_t count_of(const uint8_t bytes[2])
{
    const int32_t value = bytes[0] | bytes[1] << 8;

    return value < 0x8000 ? value : value - 0x10000;
}

static imu_status read_sample(int32_t raw[3])
{
    uint8_t bytes[8] = {IMU_FIFO_TAG | IMU_READ};

    spi_transfer(bytes, sizeof bytes);
    for (unsigned i = 0; i < 3; i++) {
        raw[i] = count_of(&bytes[2 + 2 * i]);
    }
    return bytes[1] == IMU_TAG_GYRO ? IMU_GYRO : IMU_ACCELEROMETER;
}

/* On your board: sleep until the interrupt of the queue. */
imu_status imu_next(int32_t raw[3])
{
    for (unsigned poll = 0; poll < POLLS_MAX; poll++) {
        uint8_t bytes[3] = {IMU_FIFO_STATUS1 | IMU_READ};
        spi_transfer(bytes, sizeof bytes);
        if (bytes[2] & IMU_FIFO_STATUS2_OVERRUN) {
            return IMU_LOST;
        }
        if (bytes[1] > 0 || bytes[2] & IMU_FIFO_STATUS2_MORE) {
            return read_sample(raw);
        }
    }
    return IMU_SILENT;
}

const char *imu_status_text(imu_status status)
{
    switch (status) {
    case IMU_ACCELEROMETER:
    case IMU_GYRO:
        return "ready";
    case IMU_LOST:
        return "samples were lost";
    case IMU_ABSENT:
        return "not there, or another chip";
    case IMU_CONFIG_FAILED:
        return "does not keep its settings";
    default:
        return "no answer in time";
    }
}
