/* SPDX-License-Identifier: MIT
 *
 * print.h: text and numbers on the UART, without printf, and so without heap and double.
 */
#ifndef PRINT_H
#define PRINT_H

#include <stdint.h>

void print(const char *text);

void print_integer(int32_t value);

/* With 0 ... 6 digits after the point. Prints "?" for NaN, and for a number that is 2e9 or more
 * without the point. */
void print_fixed(float value, unsigned digits);

#endif
