/* SPDX-License-Identifier: MIT
 *
 * text/tabular.h: prints a table whose columns are as wide as their widest cells.
 *
 * If it is too wide for the stream (wrapped.h), the notes are printed above their rows instead of
 * after them, and columns that do not fit form a second table, which repeats the first column. One
 * table at a time.
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

#define TABULAR_ROWS 128u /* after which heading and widths are renewed */
#define TABULAR_COLUMNS 10u
#define TABULAR_CELL 48u /* bytes of a cell or note; longer ones are truncated */

/* Begins a table. Each letter is a column: r is right-aligned; l is left-aligned, directly after
 * the column before it, from which it is not separated. */
void tabular_begin(FILE *file, const char *alignment);

/* The next cell of the row; the note after the row. */
void tabular_cell(const char *format, ...) TABULAR_FORMAT;
void tabular_note(const char *format, ...) TABULAR_FORMAT;

/* Ends the row. A first row in bold is the heading. */
void tabular_row(void);
void tabular_row_in(paint colour);

/* The heading: column names separated by |. */
void tabular_heading(const char *names);

/* Prints the remaining rows; nothing if there is only a heading. */
void tabular_end(void);

#endif
