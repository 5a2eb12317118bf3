/* SPDX-License-Identifier: MIT */
#include "json_write.h"

#include <float.h>
#include <math.h>

#include "invcal/status.h"
#include "number.h"

static void write_text(FILE *file, const char *text)
{
    putc('"', file);
    for (const char *c = text; *c != '\0'; c++) {
        if ((unsigned char)*c < ' ') {
            fprintf(file, "\\u%04x", (unsigned)*c);
        } else {
            fprintf(file, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
        }
    }
    putc('"', file);
}

static void write_number(FILE *file, double x)
{
    char text[NUMBER_TEXT_MAX];

    fputs(fabs(x) <= DBL_MAX ? number_text(x, text) : "null", file);
}

static void write_vector(FILE *file, const double x[3])
{
    for (unsigned i = 0; i < 3; i++) {
        fputs(i == 0 ? "[" : ", ", file);
        write_number(file, x[i]);
    }
    putc(']', file);
}

static void new_line(const json_writer *w)
{
    fprintf(w->file, "\n%*s", (int)(2 * w->depth), "");
}

static void begin_member(json_writer *w, const char *name)
{
    if (!w->is_first) {
        putc(',', w->file);
    }
    w->is_first = 0;
    new_line(w);
    write_text(w->file, name);
    fputs(": ", w->file);
}

static void open_object(json_writer *w)
{
    putc('{', w->file);
    w->depth++;
    w->is_first = 1;
}

void json_begin(json_writer *w, FILE *file)
{
    w->file = file;
    w->depth = 0;
    open_object(w);
}

void json_end(json_writer *w)
{
    json_object_end(w);
    putc('\n', w->file);
}

void json_object(json_writer *w, const char *name)
{
    begin_member(w, name);
    open_object(w);
}

void json_object_end(json_writer *w)
{
    w->depth--;
    new_line(w);
    putc('}', w->file);
    w->is_first = 0;
}

void json_text(json_writer *w, const char *name, const char *text)
{
    begin_member(w, name);
    write_text(w->file, text);
}

void json_number(json_writer *w, const char *name, double x)
{
    begin_member(w, name);
    write_number(w->file, x);
}

void json_vector(json_writer *w, const char *name, const double x[3])
{
    begin_member(w, name);
    write_vector(w->file, x);
}

void json_matrix(json_writer *w, const char *name, const double (*m)[3])
{
    begin_member(w, name);
    w->depth++;
    for (unsigned i = 0; i < 3; i++) {
        putc(i == 0 ? '[' : ',', w->file);
        new_line(w);
        write_vector(w->file, m[i]);
    }
    w->depth--;
    new_line(w);
    putc(']', w->file);
}

void json_parameters(json_writer *w, const char *name, uint16_t bits)
{
    const char *comma = "";

    begin_member(w, name);
    putc('[', w->file);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if ((unsigned)bits >> r & 1u) {
            fputs(comma, w->file);
            write_text(w->file, invcal_parameter_name(r));
            comma = ", ";
        }
    }
    putc(']', w->file);
}
