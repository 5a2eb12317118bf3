/* SPDX-License-Identifier: MIT */
#include "sensor.h"

#include "driver/i2c_master.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"

#define SDA 21 /* pins of your board */
#define SCL 22
#define TIMEOUT 100 /* milliseconds */

/* From the register maps of the MPU-6000/6050, MPU-6500, MPU-9250 and MPU-9255. */
enum {
    ADDRESS = 0x68, /* pin AD0 low; 0x69 if it is high */
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* not in the MPU-6050 */
    ACCEL_XOUT_H = 0x3B,  /* x, y, z, temperature: 2 bytes each, the high one first */
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
    MPU6050 = 0x68, /* value of WHO_AM_I; the others have the same accelerometer */
    MPU6500 = 0x70,
    MPU9250 = 0x71,
    MPU9255 = 0x73
};

static i2c_master_dev_handle_t device;
static uint8_t chip;
static TickType_t due;

static int set(uint8_t address, uint8_t value)
{
    const uint8_t bytes[2] = {address, value};

    return i2c_master_transmit(device, bytes, sizeof bytes, TIMEOUT) == ESP_OK;
}

static int get(uint8_t address, uint8_t *bytes, size_t size)
{
    return i2c_master_transmit_receive(device, &address, 1, bytes, size, TIMEOUT) == ESP_OK;
}

static int open_bus(void)
{
    const i2c_master_bus_config_t bus_config = {
        .i2c_port = -1,
        .sda_io_num = SDA,
        .scl_io_num = SCL,
        .clk_source = I2C_CLK_SRC_DEFAULT,
        .glitch_ignore_cnt = 7,
        .flags.enable_internal_pullup = 1,
    };
    const i2c_device_config_t device_config = {
        .dev_addr_length = I2C_ADDR_BIT_LEN_7,
        .device_address = ADDRESS,
        .scl_speed_hz = 400000,
    };
    i2c_master_bus_handle_t bus;

    return i2c_new_master_bus(&bus_config, &bus) == ESP_OK &&
           i2c_master_bus_add_device(bus, &device_config, &device) == ESP_OK;
}

static int is_known(void)
{
    return chip == MPU6050 || chip == MPU6500 || chip == MPU9250 || chip == MPU9255;
}

/* The chip samples at twice the rate, so that no sample is read twice, as its clock is
 * independent. */
sensor_status sensor_begin(void)
{
    const int is_there = open_bus() && get(WHO_AM_I, &chip, 1) && is_known();

    due = xTaskGetTickCount();
    /* Awake; low-pass filter of 44 Hz; 1 kHz / (1 + 4); 2 g. */
    return is_there && set(PWR_MGMT_1, 1) && set(CONFIG, 3) && set(SMPLRT_DIV, 4) &&
                   set(ACCEL_CONFIG, 0) && (chip == MPU6050 || set(ACCEL_CONFIG2, 3))
               ? SENSOR_OK
               : SENSOR_SILENT;
}

static int32_t count_of(const uint8_t bytes[2])
{
    return (int16_t)(uint16_t)(bytes[0] << 8 | bytes[1]);
}

sensor_status sensor_next(int32_t raw[3], float *temperature)
{
    uint8_t bytes[8];
    const int is_late = xTaskDelayUntil(&due, pdMS_TO_TICKS(1000 / SENSOR_RATE)) == pdFALSE;

    if (is_late) {
        due = xTaskGetTickCount();
    }
    if (!get(ACCEL_XOUT_H, bytes, sizeof bytes)) {
        return SENSOR_SILENT;
    }
    for (unsigned i = 0; i < 3; i++) {
        raw[i] = count_of(&bytes[2 * i]);
    }
    *temperature = chip == MPU6050 ? (float)count_of(&bytes[6]) / 340.0f + 36.53f
                                   : (float)count_of(&bytes[6]) / 333.87f + 21.0f;
    return is_late ? SENSOR_LOST : SENSOR_OK;
}
