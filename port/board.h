/* SPDX-License-Identifier: MIT
 *
 * What tests, benchmarks and the example firmware need from a target. Each family has its board.c.
 */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Before anything else; start-up calls it. */
void board_begin(void);

/* Prints one character, on a debugger's console or a UART. */
void board_put(int c);

/* Ends the run: 0 for success. Does not return. */
void board_exit(int code);

/* Instructions executed so far, modulo 2^32; on AVR cycles. */
uint32_t board_count(void);

#endif
