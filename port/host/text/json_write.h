/* SPDX-License-Identifier: MIT
 *
 * text/json_write.h: JSON, laid out for people too: a member on each line, a list of numbers on one.
 *
 * Numbers read back as the same double. Write errors show in ferror(file) at the end.
 */
#ifndef JSON_WRITE_H
#define JSON_WRITE_H

#include <stdint.h>
#include <stdio.h>

#include "invcal/invcal.h"

typedef struct {
    FILE *file;
    unsigned depth; /* of objects that are open */
    int is_line;    /* all of it on one line */
    int is_first;   /* nothing stands in the innermost one yet */
} json_writer;

/* Opens the outermost object; the caller keeps the file. */
void json_begin(json_writer *w, FILE *file);

/* From now on what goes to the standard output is one line for each object, for pipes; its first member,
 * "file", says what it is about. Null: no more. The text stays the caller's. */
void json_lines(const char *about);

/* Closes it, and ends the line. */
void json_end(json_writer *w);

/* Members of the object that is open; a name that is null makes an element of a list. A number
 * that is not finite becomes null. In texts quotes, backslashes and control characters are
 * escaped, and bytes that are no UTF-8 become U+FFFD. */
void json_object(json_writer *w, const char *name);
void json_object_end(json_writer *w);
void json_list(json_writer *w, const char *name);
void json_list_end(json_writer *w);
void json_text(json_writer *w, const char *name, const char *text);
void json_number(json_writer *w, const char *name, double x);
void json_numbers(json_writer *w, const char *name, const double *x, unsigned n);
void json_vector(json_writer *w, const char *name, const double x[3]);
void json_matrix(json_writer *w, const char *name, const double (*m)[3]);

/* A symmetric matrix that is stored packed (INVCAL_PACKED), n at most INVCAL_PARAMETERS, as
 * a list of its rows. */
void json_symmetric(json_writer *w, const char *name, const double *packed, unsigned n);

/* The names of the bits that are set, of `count`, as a list. */
void json_names(json_writer *w, const char *name, unsigned bits, unsigned count,
                const char *(*name_of)(unsigned));
void json_parameters(json_writer *w, const char *name, uint16_t bits);

/* Nine numbers, one of each parameter: an object of delta, dk and gamma. */
void json_nine(json_writer *w, const char *name, const double x[INVCAL_PARAMETERS]);

#endif
