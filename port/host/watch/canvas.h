/* SPDX-License-Identifier: MIT
 *
 * watch/canvas.h: a sheet of character cells, which is never wider or higher than it should be, whatever is
 * written on it.
 */
#ifndef WATCH_CANVAS_H
#define WATCH_CANVAS_H

#include <stddef.h>
#include <stdio.h>

#include "text/paint.h"

/* One line is left for the cursor, and one for the bar of a terminal multiplexer, of 24; one column, since a
 * cursor behind the last one is somewhere else on each terminal. */
#define CANVAS_LINES 22u
#define CANVAS_COLUMNS 79u

/* Bytes that it takes at most: each cell a glyph of four, painted and unpainted. */
#define CANVAS_BYTES (CANVAS_LINES * (CANVAS_COLUMNS * 20u + 8u))

#define CANVAS_PLAIN (-1) /* no paint */

typedef struct {
    struct {
        char glyph[5]; /* UTF-8; empty: a space */
        signed char colour;
    } cell[CANVAS_LINES][CANVAS_COLUMNS];
} canvas;

void canvas_clear(canvas *c);

/* Puts one character, of width one. What is outside is left out. `colour` is a paint of paint.h, or CANVAS_PLAIN. */
void canvas_put(canvas *c, unsigned line, unsigned column, int colour, const char *glyph);

/* Writes a text of UTF-8 up to column `end`. What is no Latin, Greek or Cyrillic letter or sign, and may be of any
 * width, is shown as '?'. Returns the column after it. */
unsigned canvas_text(canvas *c, unsigned line, unsigned column, unsigned end, int colour,
                     const char *text);

/* The same in up to `lines` lines, broken at spaces. */
void canvas_wrapped(canvas *c, unsigned line, unsigned lines, unsigned column, int colour,
                    const char *text);

/* How many columns a text takes. */
unsigned canvas_width(const char *text);

/* As text, each line but for spaces at its end, and `line_end` after it. Paint is that of paint.h for
 * `talk`. */
const char *canvas_print(const canvas *c, FILE *talk, const char *line_end,
                         char text[CANVAS_BYTES]);

#endif
