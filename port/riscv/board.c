/* SPDX-License-Identifier: MIT
 *
 * A RISC-V machine: its breakpoint for semihosting, its counter.
 */
#include "board.h"

#include "semihosting.h"

/* The two shifts, which have no effect, distinguish this breakpoint from others. All three
 * instructions must be of 32 bits, in one page of memory. */
void semihosting_call(uint32_t operation, uint32_t argument)
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

/* minstret counts instructions; in qemu exactly, with -icount. */
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
