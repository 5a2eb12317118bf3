/* SPDX-License-Identifier: MIT
 *
 * Semihosting: the emulator, or a debugger, does what the program asks for at a breakpoint.
 */
#include "board.h"

enum { SYS_WRITEC = 0x03, SYS_EXIT = 0x18 };
#define APPLICATION_EXIT UINT32_C(0x20026)
#define RUN_TIME_ERROR UINT32_C(0x20023)

static void call(uint32_t operation, uint32_t argument)
{
    register uint32_t r0 __asm("r0") = operation;
    register uint32_t r1 __asm("r1") = argument;

    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory", "cc");
}

/* Timer 0 of the MPS2 boards counts downwards, at 25 MHz unless target.mk says else. */
#ifndef TIMER_NS
#define TIMER_NS 40
#endif
#define TIMER ((volatile uint32_t *)0x40000000u)
enum { CONTROL, VALUE, RELOAD };

void board_begin(void)
{
    TIMER[RELOAD] = UINT32_MAX;
    TIMER[VALUE] = UINT32_MAX;
    TIMER[CONTROL] = 1;
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

/* With qemu's -icount shift=6 an instruction takes 64 ns. */
uint32_t board_count(void)
{
    const uint32_t ticks = UINT32_MAX - TIMER[VALUE];

    return (uint32_t)((uint64_t)ticks * TIMER_NS / 64);
}

/* Memory for malloc, which some tests use: what lies between .noinit and the stack. */
void *_sbrk(int more);
void *_sbrk(int more)
{
    extern char heap_start[];
    static char *end = heap_start;
    char *const begin = end;

    end += more;
    return begin;
}
