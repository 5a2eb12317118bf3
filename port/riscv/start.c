/* SPDX-License-Identifier: MIT
 *
 * Start-up of a RISC-V machine: registers and FPU.
 */
#include "bare.h"

/* The first instructions, in assembly, since there is no stack yet. */
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
      "    la   t0, bare_fault\n"
      "    csrw mtvec, t0\n"
#ifdef __riscv_flen
      "    li   t0, 0x2000\n" /* the FPU, before its first use */
      "    csrs mstatus, t0\n"
      "    csrw fcsr, zero\n"
#endif
      "    j    bare_start\n"
      ".popsection\n");
