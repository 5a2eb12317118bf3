/* SPDX-License-Identifier: MIT */
#include "text/json_write.h"

#include <float.h>
#include <math.h>

#include "invcal/result.h"
#include "text/number.h"
#include "text/utf8.h"
#include "core/system.h"

static const char *line_about; /* null: objects are indented over several lines */

static void write_text(FILE *file, const char *text)
{
    putc('"', file);
    while (*text != '\0') {
        const unsigned length = utf8_length(text);
        const unsigned char *byte = (const unsigned char *)text;
        if (length == 0) {
            fputs("\\ufffd", file);
        } else if (*byte < ' ' || *byte == 0x7f) {
            fprintf(file, "\\u%04x", (unsigned)*byte);
        } else if (length == 2 && byte[0] == 0xC2 &&
                   byte[1] < 0xA0) { /* C1: commands of a terminal */
            fprintf(file, "\\u%04x", (unsigned)byte[1]);
        } else {
            fputs(*text == '"' || *text == '\\' ? "\\" : "", file);
            fwrite(text, 1, length, file);
        }
        text += length > 0 ? length : 1;
    }
    putc('"', file);
}

static void write_number(FILE *file, double x)
{
    char text[NUMBER_TEXT_MAX];

    /* no minus zero */
    fputs(fabs(x) <= DBL_MAX ? number_text(fabs(x) > 0 ? x : 0, text) : "null", file);
}

static void write_numbers(FILE *file, const double *x, unsigned n)
{
    putc('[', file);
    for (unsigned i = 0; i < n; i++) {
        fputs(i == 0 ? "" : ", ", file);
        write_number(file, x[i]);
    }
    putc(']', file);
}

static void new_line(const json_writer *w)
{
    if (!w->is_line) {
        fprintf(w->file, "\n%*s", (int)(2 * w->depth), "");
    }
}

static void begin_member(json_writer *w, const char *name)
{
    if (!w->is_first) {
        fputs(w->is_line ? ", " : ",", w->file);
    }
    w->is_first = 0;
    new_line(w);
    if (name) {
        write_text(w->file, name);
        fputs(": ", w->file);
    }
}

static void open_bracket(json_writer *w, int bracket)
{
    putc(bracket, w->file);
    w->depth++;
    w->is_first = 1;
}

static void close_bracket(json_writer *w, int bracket)
{
    w->depth--;
    if (!w->is_first) { /* an empty object or list stays on one line */
        new_line(w);
    }
    putc(bracket, w->file);
    w->is_first = 0;
}

void json_begin(json_writer *w, FILE *file)
{
    w->file = file;
    w->depth = 0;
    w->is_line = line_about && file == stdout;
    open_bracket(w, '{');
    if (w->is_line) {
        json_text(w, "file", line_about);
    }
}

void json_lines(const char *about)
{
    line_about = about;
}

void json_end(json_writer *w)
{
    json_object_end(w);
    putc('\n', w->file);
}

void json_object(json_writer *w, const char *name)
{
    begin_member(w, name);
    open_bracket(w, '{');
}

void json_object_end(json_writer *w)
{
    close_bracket(w, '}');
}

void json_list(json_writer *w, const char *name)
{
    begin_member(w, name);
    open_bracket(w, '[');
}

void json_list_end(json_writer *w)
{
    close_bracket(w, ']');
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

void json_numbers(json_writer *w, const char *name, const double *x, unsigned n)
{
    begin_member(w, name);
    write_numbers(w->file, x, n);
}

void json_vector(json_writer *w, const char *name, const double x[3])
{
    json_numbers(w, name, x, 3);
}

void json_matrix(json_writer *w, const char *name, const double (*m)[3])
{
    json_list(w, name);
    for (unsigned i = 0; i < 3; i++) {
        json_vector(w, NULL, m[i]);
    }
    json_list_end(w);
}

void json_symmetric(json_writer *w, const char *name, const double *packed, unsigned n)
{
    json_list(w, name);
    for (unsigned r = 0; r < n; r++) {
        double row[INVCAL_PARAMETERS];
        for (unsigned c = 0; c < n; c++) {
            row[c] = packed[c <= r ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)];
        }
        json_numbers(w, NULL, row, n);
    }
    json_list_end(w);
}

void json_names(json_writer *w, const char *name, unsigned bits, unsigned count,
                const char *(*name_of)(unsigned))
{
    const char *comma = "";

    begin_member(w, name);
    putc('[', w->file);
    for (unsigned i = 0; i < count; i++) {
        if (bits >> i & 1u) {
            fputs(comma, w->file);
            write_text(w->file, name_of(i));
            comma = ", ";
        }
    }
    putc(']', w->file);
}

void json_parameters(json_writer *w, const char *name, uint16_t bits)
{
    json_names(w, name, bits, INVCAL_PARAMETERS, invcal_parameter_text);
}

void json_nine(json_writer *w, const char *name, const double x[INVCAL_PARAMETERS])
{
    json_object(w, name);
    json_vector(w, "delta", &x[INVCAL_DELTA_X]);
    json_vector(w, "dk", &x[INVCAL_DK_X]);
    json_vector(w, "gamma", &x[INVCAL_GAMMA_XY]);
    json_object_end(w);
}
