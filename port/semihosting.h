/* SPDX-License-Identifier: MIT
 *
 * semihosting.h: at a breakpoint, the emulator or a debugger serves a request of the program.
 */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stdint.h>

/* Each family's own instructions. */
void semihosting_call(uint32_t operation, uint32_t argument);

#endif
