/* SPDX-License-Identifier: MIT
 *
 * text/json_write.h: writes JSON that people can read, too: one member per line, a list of numbers
 * on one line.
 *
 * Numbers read back as the same double. Check ferror(file) at the end.
 */
#ifndef JSON_WRITE_H
#define JSON_WRITE_H

#include <stdint.h>
#include <stdio.h>

#include "invcal/invcal.h"

typedef struct {
    FILE *file;
    unsigned depth; /* open objects and lists */
    int is_line;    /* everything on one line */
    int is_first;   /* the innermost one is still empty */
} json_writer;

/* Opens the outermost object; the caller keeps the file. */
void json_begin(json_writer *w, FILE *file);

/* Makes the following objects on the standard output one line each, for pipes, with `about` as the
 * first member, "file". Null switches it off. The caller keeps the text. */
void json_lines(const char *about);

/* Closes the outermost object, and ends the line. */
void json_end(json_writer *w);

/* Members of the innermost object, or, with a null name, elements of a list. A number that is not
 * finite becomes null. In texts, quotes, backslashes and control characters are escaped, and bytes
 * that are not UTF-8 become U+FFFD. */
void json_object(json_writer *w, const char *name);
void json_object_end(json_writer *w);
void json_list(json_writer *w, const char *name);
void json_list_end(json_writer *w);
void json_text(json_writer *w, const char *name, const char *text);
void json_number(json_writer *w, const char *name, double x);
void json_numbers(json_writer *w, const char *name, const double *x, unsigned n);
void json_vector(json_writer *w, const char *name, const double x[3]);
void json_matrix(json_writer *w, const char *name, const double (*m)[3]);

/* A packed symmetric matrix (INVCAL_PACKED), n at most INVCAL_PARAMETERS, as a list of its rows. */
void json_symmetric(json_writer *w, const char *name, const double *packed, unsigned n);

/* The names of those of `count` bits that are set, as a list. */
void json_names(json_writer *w, const char *name, unsigned bits, unsigned count,
                const char *(*name_of)(unsigned));
void json_parameters(json_writer *w, const char *name, uint16_t bits);

/* One number for each of the nine parameters: an object with delta, dk and gamma. */
void json_nine(json_writer *w, const char *name, const double x[INVCAL_PARAMETERS]);

#endif
