/* SPDX-License-Identifier: MIT
 *
 * cli/output.h: writes files so that a failure changes nothing.
 *
 * A file is written under a temporary name in the same folder, and renamed once everything else has
 * succeeded. A device or pipe is written directly.
 */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdio.h>

typedef struct {
    FILE *file;      /* valid between output_begin and output_finish */
    char *path;      /* final path, symbolic links followed */
    char *temporary; /* path until output_commit; null if written directly */
} output;

/* Checks that the file can be written, before any work that would be lost. EXIT_GOOD; EXIT_FILE,
 * with a message: for a folder, a read-only file, or a file in a folder that is not writable. */
int output_check(const char *path);

/* 1 if both are the same regular file, so that the input would be overwritten. `input` may be
 * "-". */
int output_is_same(const char *path, const char *input);

/* 1 if both are the same regular file, which need not exist yet. */
int output_collide(const char *path, const char *other);

/* Begins a file. EXIT_GOOD; EXIT_FILE, with a message. In either case, end it with output_commit or
 * output_discard. */
int output_begin(output *o, const char *path);

/* Flushes what has been written to the disk, and closes it. EXIT_GOOD; EXIT_FILE, with a
 * message. */
int output_finish(output *o);

/* Renames the file to its final path and releases o. EXIT_GOOD; EXIT_FILE, with a message; the file
 * is then discarded. */
int output_commit(output *o);

/* Removes the file and releases o. */
void output_discard(output *o);

/* Ends several: commits all of them if `failure` is EXIT_GOOD, else discards them. Elements that
 * were never begun, all zero, are skipped. Returns the first failure. */
int output_end(output *files, unsigned count, int failure);

/* Flushes the standard output. EXIT_GOOD; EXIT_FILE, with a message, if any write to it has
 * failed. */
int output_flush(void);

/* Copies a file, from its current position, to the standard output. Returns as output_flush. */
int output_copy(FILE *file);

#endif
