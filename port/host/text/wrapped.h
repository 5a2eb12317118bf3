/* SPDX-License-Identifier: MIT
 *
 * text/wrapped.h: the line width of a stream, and texts wrapped to it.
 *
 * Columns are counted as a terminal shows them (utf8.h). A word that is longer than a line, such as
 * a path, is not broken; nor is a line after U+00A0, between an option and its value, or between a
 * number and ± or %.
 */
#ifndef WRAPPED_H
#define WRAPPED_H

#include <stddef.h>
#include <stdio.h>

#if defined(__GNUC__)
#define WRAPPED_FORMAT __attribute__((format(printf, 3, 4)))
#else
#define WRAPPED_FORMAT
#endif

#define WRAPPED_MIN 60u /* columns, even if the terminal has fewer */

/* COLUMNS if it is set to a number, else the width of the terminal, else 80. */
size_t wrapped_width(FILE *file);

/* Prints a text without an end of line. `at` columns of the first line are used already; the other
 * lines are indented by `indent`. Returns the columns used of the last line. */
size_t wrapped_words(FILE *file, size_t at, size_t indent, const char *text);

/* The same with an end of line. */
void wrapped_line(FILE *file, size_t at, size_t indent, const char *text);

/* A paragraph, with an end of line. */
void wrapped_printf(FILE *file, size_t indent, const char *format, ...) WRAPPED_FORMAT;

/* A shell command, to be copied: whole on this line after a blank, or on the next one, indented, or
 * else continued with backslashes. With an end of line. */
void wrapped_command(FILE *file, size_t at, size_t indent, const char *command);

#endif
