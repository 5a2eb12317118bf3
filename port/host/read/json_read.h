/* SPDX-License-Identifier: MIT
 *
 * read/json_read.h: reads JSON from a file, strictly, piece by piece, in fixed memory.
 *
 * The caller asks for what it expects next. Anything else is an error: a message names file and
 * line, and the function returns EXIT_FILE (or -1 where stated). After an error the reader cannot
 * be used any more.
 */
#ifndef JSON_READ_H
#define JSON_READ_H

#include <stddef.h>
#include <stdio.h>

/* Nesting of objects and lists, and depth of the recursion. */
#define JSON_DEPTH_MAX 32u

typedef struct {
    FILE *file;
    const char *name;   /* of the file, for messages */
    unsigned long line; /* of the next character, from 1 */
    int next;           /* the next character, or EOF */
    unsigned depth;
} json_reader;

/* Starts at the beginning of a file, which the caller closes. */
void json_start(json_reader *r, FILE *file, const char *name);

/* Enters an object ('{') or a list ('['). */
int json_enter(json_reader *r, char bracket);

/* Goes to the value of the next member of the object; the caller counts `index` from 0. The name is
 * truncated to fit into `name`. Returns 1; 0 at the end of the object; -1. */
int json_member(json_reader *r, unsigned index, char *name, size_t size);

/* The same for a list. */
int json_element(json_reader *r, unsigned index);

int json_read_number(json_reader *r, double *out);

/* A text, truncated to size - 1 bytes. Escaped characters beyond ASCII become '?'. */
int json_read_text(json_reader *r, char *out, size_t size);

/* The first character of the next value, or EOF; nothing is consumed. */
int json_peek(json_reader *r);

/* Skips a value of any kind, and checks it. */
int json_skip(json_reader *r);

/* Checks that only white space follows. */
int json_finish(json_reader *r);

/* Reports an error at the current line. Returns EXIT_FILE. */
int json_error(const json_reader *r, const char *what);

#endif
