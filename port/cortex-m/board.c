/* SPDX-License-Identifier: MIT
 *
 * A Cortex-M on an MPS2 board: its breakpoint for semihosting, timer 0, memory.
 */
#include "board.h"

#include "semihosting.h"

void semihosting_call(uint32_t operation, uint32_t argument)
{
    register uint32_t r0 __asm("r0") = operation;
    register uint32_t r1 __asm("r1") = argument;

    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory", "cc");
}

/* Timer 0 of the MPS2 boards counts down, at 25 MHz unless target.mk defines TIMER_NS. */
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

/* With qemu's -icount shift=6 an instruction takes 64 ns. */
uint32_t board_count(void)
{
    const uint32_t ticks = UINT32_MAX - TIMER[VALUE];

    return (uint32_t)((uint64_t)ticks * TIMER_NS / 64);
}

/* Memory for malloc, which some tests use: from the end of .noinit to the stack. */
void *_sbrk(int more); /* NOLINT(bugprone-reserved-identifier): newlib calls it so */
void *_sbrk(int more)
{
    extern char heap_start[];
    static char *end = heap_start;
    char *const begin = end;

    end += more;
    return begin;
}
