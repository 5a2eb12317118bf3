/* SPDX-License-Identifier: MIT
 *
 * cli/help.h: the help of a command, as wide as the terminal.
 *
 * How a help is written, in lines of any length: `usage:` first; paragraphs from the first column on;
 * options, and words in their place behind four blanks, with what they mean from column 23 on; what is
 * indented otherwise keeps that; commands behind a line `example:`, last, with a backslash where a line
 * goes on. port/host/man.sh and port/host/invcal.bash read what is printed.
 */
#ifndef HELP_H
#define HELP_H

#include <stdio.h>

/* Prints a text in parts, ended by null. Each part ends a line. */
void help_print(FILE *file, const char *const *parts);

#endif
