/* SPDX-License-Identifier: MIT
 *
 * watch/interrupt.h: a serial port has no end, and whoever presses Ctrl-C wants the result: the stream ends then,
 * as if it had come to its end. A second one ends everything.
 */
#ifndef WATCH_INTERRUPT_H
#define WATCH_INTERRUPT_H

#include <stdio.h>

/* From now on, for the stream with this name ("-": standard input); */
void interrupt_catch(const char *path);

/* which is this file, or null: none any more. */
void interrupt_stream(FILE *file);

#endif
