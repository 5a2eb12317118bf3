/* SPDX-License-Identifier: MIT
 *
 * A mock of ESP-IDF, for the example: on the bus there is an MPU-6050 that reads a log on standard
 * input (time, and counts), whose end ends the run; the flash is a file. What passes here may still
 * be wrong on ESP-IDF itself: these functions do what we understand its documentation to say.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "driver/i2c_master.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"
#include "nvs.h"
#include "nvs_flash.h"

/* ---- an MPU-6050 ------------------------------------------------------------------------------ */

enum {
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    ACCEL_CONFIG = 0x1C,
    ACCEL_XOUT_H = 0x3B,
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
    REGISTERS = 0x76
};

struct mock_bus {
    int is_open;
} bus;
struct mock_device {
    uint8_t registers[REGISTERS];
} chip = {{[WHO_AM_I] = 0x68, [PWR_MGMT_1] = 0x40}};

esp_err_t i2c_new_master_bus(const i2c_master_bus_config_t *bus_config,
                             i2c_master_bus_handle_t *ret_bus_handle)
{
    bus.is_open = bus_config->sda_io_num != bus_config->scl_io_num &&
                  bus_config->clk_source == I2C_CLK_SRC_DEFAULT;
    *ret_bus_handle = &bus;
    return bus.is_open ? ESP_OK : ESP_FAIL;
}

esp_err_t i2c_master_bus_add_device(i2c_master_bus_handle_t bus_handle,
                                    const i2c_device_config_t *dev_config,
                                    i2c_master_dev_handle_t *ret_handle)
{
    *ret_handle = &chip;
    return bus_handle == &bus && bus.is_open && dev_config->device_address == 0x68 ? ESP_OK
                                                                                   : ESP_FAIL;
}

esp_err_t i2c_master_transmit(i2c_master_dev_handle_t i2c_dev, const uint8_t *write_buffer,
                              size_t write_size, int xfer_timeout_ms)
{
    if (xfer_timeout_ms <= 0 || write_size != 2 || write_buffer[0] >= REGISTERS) {
        return ESP_FAIL;
    }
    i2c_dev->registers[write_buffer[0]] = write_buffer[1];
    return ESP_OK;
}

/* Awake, 2 g, the filter on, and 200 samples a second: otherwise its readings stay zero. */
static int is_set_up(const uint8_t *registers)
{
    const unsigned filter = registers[CONFIG] & 7u;

    return !(registers[PWR_MGMT_1] & 0x40) && registers[ACCEL_CONFIG] == 0 && filter > 0 &&
           filter < 7 && registers[SMPLRT_DIV] == 4;
}

static void convert(uint8_t *registers)
{
    char line[128];
    long counts[3];

    do {
        if (fgets(line, sizeof line, stdin) == NULL) {
            exit(0);
        }
    } while (sscanf(line, "%*f,%ld,%ld,%ld", &counts[0], &counts[1], &counts[2]) != 3);
    for (int i = 0; i < 3 && is_set_up(registers); i++) {
        registers[ACCEL_XOUT_H + 2 * i] = (uint8_t)((uint16_t)counts[i] >> 8);
        registers[ACCEL_XOUT_H + 2 * i + 1] = (uint8_t)counts[i];
    }
}

esp_err_t i2c_master_transmit_receive(i2c_master_dev_handle_t i2c_dev, const uint8_t *write_buffer,
                                      size_t write_size, uint8_t *read_buffer, size_t read_size,
                                      int xfer_timeout_ms)
{
    if (xfer_timeout_ms <= 0 || write_size != 1 || write_buffer[0] + read_size > REGISTERS) {
        return ESP_FAIL;
    }
    if (write_buffer[0] == ACCEL_XOUT_H) {
        convert(i2c_dev->registers);
    }
    memcpy(read_buffer, &i2c_dev->registers[write_buffer[0]], read_size);
    return ESP_OK;
}

/* ---- time: no task is ever late --------------------------------------------------------------- */

static TickType_t now;

TickType_t xTaskGetTickCount(void)
{
    return now;
}

BaseType_t xTaskDelayUntil(TickType_t *previous, TickType_t increment)
{
    *previous += increment;
    now = *previous;
    return pdTRUE;
}

/* ---- flash: one entry, in the file `nvs`: NAMESPACE KEY, a line end, its bytes ----------------- */

static char space[16];
static nvs_open_mode_t mode;

esp_err_t nvs_flash_init(void)
{
    return ESP_OK;
}

esp_err_t nvs_flash_erase(void)
{
    return ESP_OK;
}

esp_err_t nvs_open(const char *namespace_name, nvs_open_mode_t open_mode, nvs_handle_t *out_handle)
{
    FILE *file = fopen("nvs", "rb");

    if (file == NULL && open_mode == NVS_READONLY) {
        return ESP_ERR_NVS_NOT_FOUND;
    }
    if (file != NULL) {
        fclose(file);
    }
    snprintf(space, sizeof space, "%s", namespace_name);
    mode = open_mode;
    *out_handle = 1;
    return ESP_OK;
}

void nvs_close(nvs_handle_t handle)
{
    (void)handle;
}

esp_err_t nvs_get_blob(nvs_handle_t handle, const char *key, void *out_value, size_t *length)
{
    char wanted[64], name[64];
    esp_err_t error = ESP_ERR_NVS_NOT_FOUND;
    FILE *file = fopen("nvs", "rb");

    (void)handle;
    snprintf(wanted, sizeof wanted, "%s %s\n", space, key);
    if (file == NULL) {
        return error;
    }
    if (fgets(name, sizeof name, file) != NULL && strcmp(name, wanted) == 0) {
        *length = fread(out_value, 1, *length, file);
        error = ESP_OK;
    }
    fclose(file);
    return error;
}

esp_err_t nvs_set_blob(nvs_handle_t handle, const char *key, const void *value, size_t length)
{
    FILE *file = mode == NVS_READWRITE ? fopen("nvs", "wb") : NULL;

    (void)handle;
    if (file == NULL) {
        return ESP_FAIL;
    }
    fprintf(file, "%s %s\n", space, key);
    fwrite(value, 1, length, file);
    return fclose(file) == 0 ? ESP_OK : ESP_FAIL;
}

esp_err_t nvs_commit(nvs_handle_t handle)
{
    return handle == 1 ? ESP_OK : ESP_FAIL;
}
