/* SPDX-License-Identifier: MIT
 *
 * watch/interrupt.h: a serial port has no end: Ctrl-C ends the stream and asks for the result. A second Ctrl-C ends
 * the program.
 */
#ifndef WATCH_INTERRUPT_H
#define WATCH_INTERRUPT_H

#include <stdio.h>

/* From now on, for the stream with this name ("-": standard input); */
void interrupt_catch(const char *path);

/* which is this file, or null: none any more. */
void interrupt_stream(FILE *file);

#endif
