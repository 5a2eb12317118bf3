/* SPDX-License-Identifier: MIT
 *
 * bare.h: what start-up does on every machine without an operating system.
 */
#ifndef BARE_H
#define BARE_H

/* Fills .data, clears .bss, and runs main. Does not return. */
void bare_start(void);

/* A fault, or an interrupt that nobody has asked for: says so and ends the run. */
void bare_fault(void);

#endif
