/* SPDX-License-Identifier: MIT
 *
 * Start-up of a Cortex-M: vector table and FPU.
 */
#include <stdint.h>

#include "bare.h"

extern uint32_t stack_top[]; /* from sections.ld */

void start(void);
void start(void)
{
#ifdef __ARM_FP
    volatile uint32_t *const cpacr = (volatile uint32_t *)0xE000ED88u;
    *cpacr |= UINT32_C(0xF) << 20; /* coprocessors 10 and 11: the FPU, before its first use */
    __asm volatile("dsb\n isb");
#endif
    bare_start();
}

typedef union {
    void *pointer;
    void (*handler)(void);
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    {.pointer = stack_top},  {.handler = start},      {.handler = bare_fault},
    {.handler = bare_fault}, {.handler = bare_fault}, {.handler = bare_fault},
    {.handler = bare_fault}, {.handler = bare_fault}, {.handler = bare_fault},
    {.handler = bare_fault}, {.handler = bare_fault}, {.handler = bare_fault},
    {.handler = bare_fault}, {.handler = bare_fault}, {.handler = bare_fault},
    {.handler = bare_fault},
};
