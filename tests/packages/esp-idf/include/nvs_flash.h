/* SPDX-License-Identifier: MIT
 *
 * In place of the header of this name of ESP-IDF: what the example uses of it, as its documentation
 * says.
 */
#ifndef MOCK_NVS_FLASH_H
#define MOCK_NVS_FLASH_H

#include "esp_err.h"

esp_err_t nvs_flash_init(void);
esp_err_t nvs_flash_erase(void);

#endif
