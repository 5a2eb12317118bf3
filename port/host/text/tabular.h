/* SPDX-License-Identifier: MIT
 *
 * text/tabular.h: a table whose columns are as wide as what stands in them.
 *
 * If it is wider than the stream shows (wrapped.h), the notes after its rows stand above them, and the
 * columns that find no room make a second table, with the first column again. One table at a time.
 */
#ifndef TABULAR_H
#define TABULAR_H

#include <stdio.h>

#include "text/paint.h"

#if defined(__GNUC__)
#define TABULAR_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define TABULAR_FORMAT
#endif

#define TABULAR_ROWS 128u /* after so many the heading comes again, and widths are found again */
#define TABULAR_COLUMNS 10u
#define TABULAR_CELL 48u /* bytes of a cell or note; more are cut off */

/* Begins a table. Each letter is a column: r to the right, l to the left and directly after the one before,
 * which it stays with. */
void tabular_begin(FILE *file, const char *alignment);

/* The next cell of the row, cut off where there is no room; and a note after it. */
void tabular_cell(const char *format, ...) TABULAR_FORMAT;
void tabular_note(const char *format, ...) TABULAR_FORMAT;

/* Ends the row. The first one in bold is the heading. */
void tabular_row(void);
void tabular_row_in(paint colour);

/* That, of the names of the columns with a | between. */
void tabular_heading(const char *names);

/* Prints what has not been yet; nothing, if there is a heading only. */
void tabular_end(void);

#endif
