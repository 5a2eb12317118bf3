/* SPDX-License-Identifier: MIT
 *
 * text/paint.h: colours on a terminal.
 *
 * They are on if the stream is a terminal, TERM is set and not dumb, and NO_COLOR is unset or empty.
 * printf counts an escape sequence as characters: keep it out of padded fields.
 */
#ifndef PAINT_H
#define PAINT_H

#include <stdio.h>

typedef enum { PAINT_BOLD, PAINT_GREEN, PAINT_YELLOW, PAINT_RED } paint;

/* The escape sequences that begin and end a colour on this stream; empty if colours are off. */
const char *paint_on(FILE *file, paint which);
const char *paint_off(FILE *file);

#endif
