/* SPDX-License-Identifier: MIT
 *
 * Start-up of a RISC-V machine: registers, FPU, memory, main.
 */
#include <stdint.h>

#include "board.h"

/* From sections.ld. */
extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[];

int main(void);

/* The first instructions. There is no stack yet, so this is no C function. */
__asm(".pushsection .text.start, \"ax\"\n"
      ".option arch, +zicsr\n"
      ".global start\n"
      "start:\n"
      ".option push\n"
      ".option norelax\n" /* relaxed, this would compute gp from gp */
      "    la   gp, __global_pointer$\n"
      ".option pop\n"
      "    la   tp, thread_start\n"
      "    la   sp, stack_top\n"
      "    la   t0, fault\n"
      "    csrw mtvec, t0\n"
#ifdef __riscv_flen
      "    li   t0, 0x2000\n" /* the FPU, before its first use */
      "    csrs mstatus, t0\n"
      "    csrw fcsr, zero\n"
#endif
      "    j    begin\n"
      ".popsection\n");

void begin(void);
void begin(void)
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

/* A trap, or an interrupt that nobody has asked for. Aligned, as mtvec demands. */
void fault(void);
__attribute__((aligned(4))) void fault(void)
{
    for (const char *text = "\nstopped by a processor fault\n"; *text;) {
        board_put(*text++);
    }
    board_exit(1);
}
