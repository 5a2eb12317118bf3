/* SPDX-License-Identifier: MIT */
#include "print.h"

#include "uart.h"

void print(const char *text)
{
    while (*text) {
        uart_put(*text++);
    }
}

/* At least `least` digits, with a point before the last `decimals`. */
static void print_digits(uint32_t value, unsigned least, unsigned decimals)
{
    char digits[10];
    unsigned n = 0;

    while (value > 0 || n < least) {
        digits[n++] = (char)('0' + value % 10);
        value /= 10;
    }
    while (n-- > 0) {
        uart_put(digits[n]);
        if (n == decimals && n > 0) {
            uart_put('.');
        }
    }
}

void print_integer(int32_t value)
{
    if (value < 0) {
        uart_put('-');
    }
    print_digits(value < 0 ? 0u - (uint32_t)value : (uint32_t)value, 1, 0);
}

void print_fixed(float value, unsigned digits)
{
    float size = value < 0 ? -value : value;

    for (unsigned i = 0; i < digits; i++) {
        size *= 10;
    }
    if (!(size < 2e9f)) {
        uart_put('?');
        return;
    }
    const uint32_t rounded = (uint32_t)(size + 0.5f);
    if (value < 0 && rounded > 0) {
        uart_put('-');
    }
    print_digits(rounded, digits + 1, digits);
}
