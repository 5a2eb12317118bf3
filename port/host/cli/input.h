/* SPDX-License-Identifier: MIT
 *
 * cli/input.h: opening what is to be read.
 */
#ifndef INPUT_H
#define INPUT_H

#include <stdio.h>

/* 1 for "-", which stands for the standard input. */
int input_is_stdin(const char *path);

/* The path as people should see it in messages. */
const char *input_name(const char *path);

/* The path without the folders before the file, for titles. */
const char *input_file_name(const char *path);

/* Opens a file, "-" is the standard input. Null, with a message, if it cannot be read or is a
 * directory. To be closed with input_close. */
FILE *input_open(const char *path);

/* Closes it, but leaves the standard input open. Null is allowed. */
void input_close(FILE *file);

#endif
