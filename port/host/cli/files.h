/* SPDX-License-Identifier: MIT
 *
 * cli/files.h: no file that a command reads is written by it, and none is written twice.
 */
#ifndef FILES_H
#define FILES_H

typedef struct {
    const char *name; /* the option or operand that names it, as help does: "--out", "LOG" */
    const char *path; /* null: it is not there. "-" is the standard input */
} named_file;

/* Looks at all that a command line names, before anything is read.
 *
 * Returns EXIT_GOOD; EXIT_USAGE if two inputs are the standard input, or an output is one of the
 * inputs or of the other outputs; EXIT_FILE if an output cannot be written. */
int files_check(const char *command, const named_file *inputs, unsigned input_count,
                const named_file *outputs, unsigned output_count);

#endif
