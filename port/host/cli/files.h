/* SPDX-License-Identifier: MIT
 *
 * cli/files.h: checks that a command does not overwrite its inputs, and writes no file twice.
 */
#ifndef FILES_H
#define FILES_H

typedef struct {
    const char *name; /* of the option or operand, as in the help: "--out", "LOG" */
    const char *path; /* null: not given; "-": standard input */
} named_file;

/* Checks all files that a command line names, before anything is read.
 *
 * Returns EXIT_GOOD; EXIT_USAGE if two inputs are the standard input, or an output is one of the
 * inputs or of the other outputs; EXIT_FILE if an output cannot be written. */
int files_check(const char *command, const named_file *inputs, unsigned input_count,
                const named_file *outputs, unsigned output_count);

#endif
