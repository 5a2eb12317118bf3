/* SPDX-License-Identifier: MIT
 *
 * UART 0 of the MPS2 board, an Arm CMSDK UART.
 */
#include "uart.h"

#include <stdint.h>

typedef struct {
    uint32_t data;
    uint32_t state;
    uint32_t control;
    uint32_t interrupt;
    uint32_t divider;
} cmsdk_uart;

#define UART ((volatile cmsdk_uart *)0x40004000u)
#define STATE_TX_FULL 1u
#define CONTROL_TX_ENABLE 1u
#define DIVIDER_115200 217u /* of 25 MHz */

void uart_begin(void)
{
    UART->divider = DIVIDER_115200;
    UART->control = CONTROL_TX_ENABLE;
}

void uart_flush(void)
{
    while (UART->state & STATE_TX_FULL) {
    }
}

void uart_put(char c)
{
    uart_flush();
    UART->data = (uint8_t)c;
}
