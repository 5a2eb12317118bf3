/* SPDX-License-Identifier: MIT
 *
 * Output, and the end of the run, by semihosting.
 */
#include "semihosting.h"

#include "board.h"

enum { SYS_WRITEC = 0x03, SYS_EXIT = 0x18 };
#define APPLICATION_EXIT UINT32_C(0x20026)
#define RUN_TIME_ERROR UINT32_C(0x20023)

void board_put(int c)
{
    const char text = (char)c;

    semihosting_call(SYS_WRITEC, (uint32_t)&text);
}

void board_exit(int code)
{
    semihosting_call(SYS_EXIT, code == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
    for (;;) {
    }
}
