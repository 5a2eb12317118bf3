/* SPDX-License-Identifier: MIT
 *
 * cli/output.h: writing so that a failure leaves everything as it was.
 *
 * A file is written next to its place under another name, and put there by renaming once all else
 * has succeeded. What is no regular file (a device, a pipe) is written directly.
 */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdio.h>

typedef struct {
    FILE *file;      /* to write into, between output_begin and output_finish */
    char *path;      /* where it is to go, symbolic links followed */
    char *temporary; /* its name meanwhile; null if it is written directly */
} output;

/* Can the file be written? To be asked before any work, which would be lost. EXIT_GOOD; EXIT_FILE,
 * with a message: for a folder, a file that is read-only, a folder that nothing can be put into. */
int output_check(const char *path);

/* 1 if it would be written over what is read: both are one regular file. `input` may be "-". */
int output_is_same(const char *path, const char *input);

/* 1 if both go into one regular file, which need not exist yet. */
int output_collide(const char *path, const char *other);

/* Begins a file. EXIT_GOOD; EXIT_FILE, with a message. In either case end with output_commit or
 * output_discard. */
int output_begin(output *o, const char *path);

/* Everything has been written: brings it to the disk. EXIT_GOOD; EXIT_FILE, with a message. */
int output_finish(output *o);

/* Puts it in its place and releases o. EXIT_GOOD; EXIT_FILE, with a message, then as if
 * discarded. */
int output_commit(output *o);

/* Removes it and releases o. */
void output_discard(output *o);

/* Ends several: puts all in their places if nothing has failed so far, else removes them. Those
 * that were never begun, all zero, count for nothing. Returns the first failure. */
int output_end(output *files, unsigned count, int failure);

/* Brings the standard output on its way. EXIT_GOOD; EXIT_FILE, with a message, if a write has
 * failed since the start. */
int output_flush(void);

/* Copies a file, from where it stands, to the standard output. Returns as output_flush. */
int output_copy(FILE *file);

#endif
