/* SPDX-License-Identifier: MIT
 *
 * watch/interrupt.h: Ctrl-C ends the stream, since a serial port has no end, and the result
 * follows. A second Ctrl-C ends the program.
 */
#ifndef WATCH_INTERRUPT_H
#define WATCH_INTERRUPT_H

#include <stdio.h>

/* From now on, for the stream of this name ("-": standard input). */
void interrupt_catch(const char *path);

/* The file of this stream; null once it is closed. */
void interrupt_stream(FILE *file);

#endif
