/* SPDX-License-Identifier: MIT
 *
 * read/json_read.h: reads JSON from a file, strictly, piece by piece, in fixed memory.
 *
 * The caller asks for what it expects next. Whatever is not there is an error: a message that
 * names file and line, and the function returns EXIT_FILE (or -1 where it says so). After an
 * error the reader is of no more use.
 */
#ifndef JSON_READ_H
#define JSON_READ_H

#include <stddef.h>
#include <stdio.h>

/* Objects and lists inside each other; also the depth of recursion. */
#define JSON_DEPTH_MAX 32u

typedef struct {
    FILE *file;
    const char *name;   /* of the file, for messages */
    unsigned long line; /* of the next character, from 1 */
    int next;           /* the next character, or EOF */
    unsigned depth;
} json_reader;

/* Starts at the beginning of a file, which stays the caller's. */
void json_start(json_reader *r, FILE *file, const char *name);

/* Enters an object ('{') or a list ('['). */
int json_enter(json_reader *r, char bracket);

/* Goes to the next member of the object, `index` counted from 0 by the caller; its value comes
 * next. The name is cut to fit into `name`. 1; 0: the object has ended; -1. */
int json_member(json_reader *r, unsigned index, char *name, size_t size);

/* The same for a list. */
int json_element(json_reader *r, unsigned index);

int json_read_number(json_reader *r, double *out);

/* A text, cut to size - 1 bytes. Characters that are escaped and beyond ASCII become '?'. */
int json_read_text(json_reader *r, char *out, size_t size);

/* The first character of the value that comes next, or EOF; nothing is taken. */
int json_peek(json_reader *r);

/* Passes over a value of any kind, checking it. */
int json_skip(json_reader *r);

/* Nothing but white space may follow. */
int json_finish(json_reader *r);

/* An error at the current line. Returns EXIT_FILE. */
int json_error(const json_reader *r, const char *what);

#endif
