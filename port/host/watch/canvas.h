/* SPDX-License-Identifier: MIT
 *
 * watch/canvas.h: a screen of character cells of fixed size; what does not fit is cut off.
 */
#ifndef WATCH_CANVAS_H
#define WATCH_CANVAS_H

#include <stddef.h>
#include <stdio.h>

#include "text/paint.h"

/* Of 24 lines, one is for the cursor, and one for the status bar of a terminal multiplexer. Of 80
 * columns, the last is unused, since terminals differ in where the cursor is after it. */
#define CANVAS_LINES 22u
#define CANVAS_COLUMNS 79u

/* Largest size as text: each cell a glyph of four bytes, with its colour set and reset. */
#define CANVAS_BYTES (CANVAS_LINES * (CANVAS_COLUMNS * 20u + 8u))

#define CANVAS_PLAIN (-1) /* no colour */

typedef struct {
    struct {
        char glyph[5]; /* UTF-8; empty: a space */
        signed char colour;
    } cell[CANVAS_LINES][CANVAS_COLUMNS];
} canvas;

void canvas_clear(canvas *c);

/* Puts one character, of width one; ignored outside of the canvas. `colour` is a paint of paint.h,
 * or CANVAS_PLAIN. */
void canvas_put(canvas *c, unsigned line, unsigned column, int colour, const char *glyph);

/* Writes UTF-8 text up to column `end`. Characters that may not be one column wide, all but Latin,
 * Greek and Cyrillic letters and signs, are shown as '?'. Returns the column after the text. */
unsigned canvas_text(canvas *c, unsigned line, unsigned column, unsigned end, int colour,
                     const char *text);

/* The same in up to `lines` lines, broken at spaces. */
void canvas_wrapped(canvas *c, unsigned line, unsigned lines, unsigned column, int colour,
                    const char *text);

/* The number of columns of a text. */
unsigned canvas_width(const char *text);

/* The canvas as text: lines without trailing spaces, each followed by `line_end`. Colours are those
 * of paint.h for `out`. */
const char *canvas_print(const canvas *c, FILE *out, const char *line_end, char text[CANVAS_BYTES]);

#endif
