/* SPDX-License-Identifier: MIT
 *
 * What programs on a target print, by board_put: no stdio.
 */
#ifndef REPORT_H
#define REPORT_H

#include "board.h"

static inline void report_text(const char *text)
{
    while (*text) {
        board_put(*text++);
    }
}

/* A line: name and number. */
static inline void report(const char *name, uint32_t number)
{
    char digits[10];
    unsigned n = 0;

    report_text(name);
    board_put(' ');
    do {
        digits[n++] = (char)('0' + number % 10);
        number /= 10;
    } while (number);
    while (n) {
        board_put(digits[--n]);
    }
    board_put('\n');
}

#endif
