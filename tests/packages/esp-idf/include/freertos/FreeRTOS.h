/* SPDX-License-Identifier: MIT
 *
 * In place of the header of this name of ESP-IDF: what the example uses of it, as its documentation
 * says.
 */
#ifndef MOCK_FREERTOS_H
#define MOCK_FREERTOS_H

#include <stdint.h>

typedef uint32_t TickType_t;
typedef int BaseType_t;
#define pdFALSE 0
#define pdTRUE 1
#define pdMS_TO_TICKS(milliseconds) ((TickType_t)(milliseconds) / 10) /* CONFIG_FREERTOS_HZ=100 */

#endif
