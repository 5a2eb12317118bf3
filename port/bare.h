/* SPDX-License-Identifier: MIT
 *
 * bare.h: the common part of start-up without an operating system.
 */
#ifndef BARE_H
#define BARE_H

/* Fills .data, clears .bss, and runs main. Does not return. */
void bare_start(void);

/* A fault, or an unexpected interrupt: prints a message and ends the run. */
void bare_fault(void);

#endif
