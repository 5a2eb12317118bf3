/* SPDX-License-Identifier: MIT
 *
 * A program under an operating system. It has no counter of instructions.
 */
#include "board.h"

#include <stdio.h>
#include <stdlib.h>

void board_put(int c)
{
    putchar(c);
}

void board_exit(int code)
{
    exit(code);
}
