/* SPDX-License-Identifier: MIT
 *
 * text/paint.h: colour, only where a person sees it.
 *
 * That is a terminal which is not dumb (TERM), unless NO_COLOR is set and not empty. An escape
 * sequence takes no column: paint whole words outside of padded fields.
 */
#ifndef PAINT_H
#define PAINT_H

#include <stdio.h>

typedef enum { PAINT_BOLD, PAINT_GREEN, PAINT_YELLOW, PAINT_RED } paint;

/* What begins the paint on this stream, and what ends it; empty where there is to be none. */
const char *paint_on(FILE *file, paint which);
const char *paint_off(FILE *file);

#endif
