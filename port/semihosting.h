/* SPDX-License-Identifier: MIT
 *
 * semihosting.h: the emulator, or a debugger, does what the program asks for at a breakpoint.
 */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stdint.h>

/* Each family's own instructions. */
void semihosting_call(uint32_t operation, uint32_t argument);

#endif
