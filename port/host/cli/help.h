/* SPDX-License-Identifier: MIT
 *
 * cli/help.h: prints the help of a command in the width of the terminal.
 *
 * The source of a help text has lines of any length: `usage:` first; paragraphs, from the first
 * column; options (or other words, indented by four blanks) with their meaning from column 23;
 * other indented paragraphs, which keep their indent; last, after a line `example:`, commands,
 * which a backslash continues. port/host/man.sh and port/host/invcal.bash parse what is printed.
 */
#ifndef HELP_H
#define HELP_H

#include <stdio.h>

/* Prints the parts of a text up to a null pointer. Each part ends with a complete line. */
void help_print(FILE *file, const char *const *parts);

#endif
