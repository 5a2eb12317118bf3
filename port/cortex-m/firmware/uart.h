/* SPDX-License-Identifier: MIT
 *
 * uart.h: the serial line to the user.
 */
#ifndef UART_H
#define UART_H

void uart_begin(void);

/* Sends a character, once the previous one has been sent. */
void uart_put(char c);

/* Waits until all has been sent. */
void uart_flush(void);

#endif
