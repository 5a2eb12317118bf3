/* SPDX-License-Identifier: MIT
 *
 * In place of the header of this name of ESP-IDF: what the example uses of it, as its documentation
 * says.
 */
#ifndef MOCK_TASK_H
#define MOCK_TASK_H

#include "freertos/FreeRTOS.h"

TickType_t xTaskGetTickCount(void);

/* pdFALSE if it came too late to wait. */
BaseType_t xTaskDelayUntil(TickType_t *previous, TickType_t increment);

#endif
