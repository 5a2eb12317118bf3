/* SPDX-License-Identifier: MIT
 *
 * Semihosting: the emulator, or a debugger, does what the program asks for at a breakpoint.
 */
#include "board.h"

enum { SYS_WRITEC = 0x03, SYS_EXIT = 0x18 };
#define APPLICATION_EXIT UINT32_C(0x20026)
#define RUN_TIME_ERROR UINT32_C(0x20023)

/* The two shifts, which do nothing, tell this breakpoint from others. All three must be of 32 bits,
 * in one page of memory. */
static void call(uint32_t operation, uint32_t argument)
{
    register uint32_t a0 __asm("a0") = operation;
    register uint32_t a1 __asm("a1") = argument;

    __asm volatile(".option push\n"
                   ".option norvc\n"
                   ".balign 16\n"
                   "slli zero, zero, 0x1f\n"
                   "ebreak\n"
                   "srai zero, zero, 7\n"
                   ".option pop"
                   : "+r"(a0)
                   : "r"(a1)
                   : "memory");
}

void board_begin(void)
{
}

void board_put(int c)
{
    const char text = (char)c;

    call(SYS_WRITEC, (uint32_t)&text);
}

void board_exit(int code)
{
    call(SYS_EXIT, code == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
    for (;;) {
    }
}

/* Every RISC-V counts its instructions; qemu counts them exactly under -icount. */
uint32_t board_count(void)
{
    uint32_t count;

    __asm volatile(".option push\n"
                   ".option arch, +zicsr\n"
                   "csrr %0, minstret\n"
                   ".option pop"
                   : "=r"(count));
    return count;
}
