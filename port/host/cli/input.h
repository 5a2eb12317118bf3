/* SPDX-License-Identifier: MIT
 *
 * cli/input.h: opens input files.
 */
#ifndef INPUT_H
#define INPUT_H

#include <stdio.h>

/* 1 for "-", the standard input. */
int input_is_stdin(const char *path);

/* The path, or "standard input", for messages. */
const char *input_name(const char *path);

/* The file name without its folders, for titles. */
const char *input_file_name(const char *path);

/* Opens a file; "-" is the standard input. Returns null, with a message, if it cannot be read or is
 * a directory. Close it with input_close. */
FILE *input_open(const char *path);

/* Closes a file other than the standard input. Null is allowed. */
void input_close(FILE *file);

#endif
