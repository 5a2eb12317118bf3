/* SPDX-License-Identifier: MIT
 *
 * text/wrapped.h: how wide a stream shows its lines, and texts broken between words to fit.
 *
 * Columns are counted as a terminal shows them (utf8.h). A word that is longer than a line stays whole,
 * as a path must; U+00A0 joins two words, an option is not parted from its value, nor ± or %
 * from its number.
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

#define WRAPPED_LEAST 60u /* columns; fewer are not asked of any text */

/* COLUMNS if it is set to a number, else what the terminal has, else 80. */
size_t wrapped_width(FILE *file);

/* Prints a text without an end of the line. `at` columns of the first line are taken, further lines begin
 * behind `indent` blanks. Returns how many columns of the last line are taken. */
size_t wrapped_words(FILE *file, size_t at, size_t indent, const char *text);

/* The same with an end of the line. */
void wrapped_line(FILE *file, size_t at, size_t indent, const char *text);

/* A paragraph, with an end of the line. */
void wrapped_printf(FILE *file, size_t indent, const char *format, ...) WRAPPED_FORMAT;

/* A command for a shell, to be copied: whole on this line after a blank, or on the next after `indent`
 * blanks, or else with a backslash where it goes on. With an end of the line. */
void wrapped_command(FILE *file, size_t at, size_t indent, const char *command);

#endif
