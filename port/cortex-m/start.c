/* SPDX-License-Identifier: MIT
 *
 * Start-up of a Cortex-M: vector table, FPU, memory, main.
 */
#include <stdint.h>

#include "board.h"

/* From sections.ld. */
extern uint32_t stack_top[], data_load[], data_start[], data_end[], bss_start[], bss_end[];

int main(void);

void start(void);
void start(void)
{
#ifdef __ARM_FP
    volatile uint32_t *const cpacr = (volatile uint32_t *)0xE000ED88u;
    *cpacr |= UINT32_C(0xF) << 20; /* coprocessors 10 and 11: the FPU, before its first use */
    __asm volatile("dsb\n isb");
#endif
    for (uint32_t *to = data_start, *from = data_load; to < data_end;) {
        *to++ = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end;) {
        *to++ = 0;
    }
    board_begin();
    board_exit(main());
}

/* A fault, or an interrupt that nobody has asked for. */
static void fault(void)
{
    for (const char *text = "\nstopped by a processor fault\n"; *text;) {
        board_put(*text++);
    }
    board_exit(1);
}

typedef union {
    void *pointer;
    void (*handler)(void);
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    {.pointer = stack_top}, {.handler = start}, {.handler = fault}, {.handler = fault},
    {.handler = fault},     {.handler = fault}, {.handler = fault}, {.handler = fault},
    {.handler = fault},     {.handler = fault}, {.handler = fault}, {.handler = fault},
    {.handler = fault},     {.handler = fault}, {.handler = fault}, {.handler = fault},
};
