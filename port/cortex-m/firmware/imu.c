/* SPDX-License-Identifier: MIT */
#include "imu.h"

#include "imu_registers.h"
#include "spi.h"

#define PATIENCE 100000u /* looks at a register; at 8 MHz, some 0.2 s */
#define SETTINGS (IMU_CTRL1_100_HZ | IMU_CTRL1_4_G)

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

/* The chip goes on while the processor is reset: it may be in any state. */
static imu_status reset(void)
{
    set(IMU_CTRL2, IMU_CTRL2_RESET);
    for (unsigned look = 0; look < PATIENCE; look++) {
        if (!(get(IMU_CTRL2) & IMU_CTRL2_RESET)) {
            return IMU_OK;
        }
    }
    return IMU_SILENT;
}

imu_status imu_begin(void)
{
    if (get(IMU_WHO_AM_I) != IMU_NAME) {
        return IMU_ABSENT;
    }
    const imu_status status = reset();
    if (status != IMU_OK) {
        return status;
    }
    set(IMU_CTRL1, SETTINGS);
    return get(IMU_CTRL1) == SETTINGS ? IMU_OK : IMU_DEAF;
}

/* Low byte first, two's complement. */
static int32_t count_of(const uint8_t bytes[2])
{
    const int32_t value = bytes[0] | bytes[1] << 8;

    return value < 0x8000 ? value : value - 0x10000;
}

static void read_sample(imu_sample *sample)
{
    uint8_t bytes[9] = {IMU_TEMP_L | IMU_READ}; /* all in one burst, so that they belong together */

    spi_transfer(bytes, sizeof bytes);
    sample->temperature = 25.0f + (float)count_of(&bytes[1]) / 256.0f;
    for (unsigned i = 0; i < 3; i++) {
        sample->raw[i] = count_of(&bytes[3 + 2 * i]);
    }
}

/* On your board: sleep until the interrupt of the chip's data-ready pin. */
imu_status imu_next(imu_sample *sample)
{
    for (unsigned look = 0; look < PATIENCE; look++) {
        const uint8_t status = get(IMU_STATUS);
        if (status & IMU_STATUS_READY) {
            read_sample(sample);
            return status & IMU_STATUS_OVERRUN ? IMU_LOST : IMU_OK;
        }
    }
    return IMU_SILENT;
}

const char *imu_status_text(imu_status status)
{
    switch (status) {
    case IMU_OK:
        return "ready";
    case IMU_LOST:
        return "samples were lost";
    case IMU_ABSENT:
        return "not there, or another chip";
    case IMU_DEAF:
        return "does not keep its settings";
    default:
        return "no answer in time";
    }
}
