/* SPDX-License-Identifier: MIT */
#include "bare.h"

#include <stdint.h>

#include "board.h"

/* From sections.ld. */
extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[];

int main(void);

void bare_start(void)
{
    for (uint32_t *to = data_start, *from = data_load; to < data_end;) {
        *to++ = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end;) {
        *to++ = 0;
    }
    board_begin();
    board_exit(main());
}

/* Aligned, as RISC-V's mtvec demands. */
__attribute__((aligned(4))) void bare_fault(void)
{
    for (const char *text = "\nstopped by a processor fault\n"; *text;) {
        board_put(*text++);
    }
    board_exit(1);
}
