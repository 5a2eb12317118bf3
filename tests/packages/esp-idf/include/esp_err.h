/* SPDX-License-Identifier: MIT
 *
 * In place of the header of this name of ESP-IDF: what the example uses of it, as its documentation
 * says.
 */
#ifndef MOCK_ESP_ERR_H
#define MOCK_ESP_ERR_H

typedef int esp_err_t;
#define ESP_OK 0
#define ESP_FAIL (-1)

#endif
