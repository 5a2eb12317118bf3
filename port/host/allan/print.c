/* SPDX-License-Identifier: MIT */
#include "allan/allan.h"
#include "text/figure.h"
#include "text/paint.h"
#include "text/plain.h"

#define LABEL 36
#define CELL 20
#define TEXT_MAX 200

static void print_source(FILE *file, const allan_result *r, const allan_wish *wish)
{
    char seen[COLUMNS_TEXT_MAX];
    char name[PLAIN_MAX];

    fprintf(file, "%s: %s\n", plain_copy(r->name, name),
            columns_describe(&r->seen, seen, sizeof seen));
    fprintf(file, "%lu samples, %.6g s at %.6g samples a second, %lu gap%s\n", r->samples,
            (double)r->samples / r->rate, r->rate, r->gaps, r->gaps == 1 ? "" : "s");
    fprintf(file, "Allan deviation, %s, %s\n\n",
            wish->is_apart ? "of windows apart" : "overlapping", r->unit);
}

static void print_rows(FILE *file, const allan_result *r)
{
    char text[FIGURE_MAX];

    fprintf(file, "%s%12s%14s%14s%14s%10s%14s%s\n", paint_on(file, PAINT_BOLD), "tau, s", "x", "y",
            "z", "+- %", "differences", paint_off(file));
    for (unsigned k = 0; k < r->rows; k++) {
        const allan_row *row = &r->row[k];
        fprintf(file, "%12.6g", row->seconds);
        for (unsigned i = 0; i < 3; i++) {
            fprintf(file, "%14s", figure_digits(row->adev[i], 5, text));
        }
        fprintf(file, "%10s%14lu\n", figure_digits(100 * row->relative, 3, text),
                (unsigned long)row->count);
    }
    putc('\n', file);
}

static void print_line(FILE *file, const allan_result *r, const allan_line *line)
{
    char text[ALLAN_WORDS_MAX];

    allan_label(r, line, text);
    fprintf(file, "%-*s", paint_width(text, LABEL), text);
    for (unsigned i = 0; i < 3; i++) {
        allan_coefficient(r, line, i, text);
        fprintf(file, "%*s", paint_width(text, CELL), text);
    }
    putc('\n', file);
}

static void print_minimum(FILE *file, const allan_result *r)
{
    char number[FIGURE_MAX];
    char text[TEXT_MAX];

    snprintf(text, sizeof text, "smallest deviation, %s", r->is_ms2 ? "µg" : r->unit);
    fprintf(file, "%-*s", paint_width(text, LABEL), text);
    for (unsigned i = 0; i < 3; i++) {
        figure_digits(r->noise[i].minimum / (r->is_ms2 ? ALLAN_MICRO_G : 1), 3, number);
        snprintf(text, sizeof text, "%s at %.4g s", number, r->noise[i].best);
        fprintf(file, "%*s", CELL, text);
    }
    putc('\n', file);
}

static void print_noise(FILE *file, const allan_result *r)
{
    fprintf(file, "%s%*s%*s%*s%s\n", paint_on(file, PAINT_BOLD), LABEL + CELL, "x", CELL, "y", CELL,
            "z", paint_off(file));
    for (unsigned k = 0; k < ALLAN_LINES; k++) {
        if (allan_has_line(r, &allan_lines[k])) {
            print_line(file, r, &allan_lines[k]);
        }
    }
    print_minimum(file, r);
    putc('\n', file);
}

void allan_print(FILE *file, const allan_result *r, const allan_wish *wish)
{
    char text[ALLAN_WORDS_MAX];

    print_source(file, r, wish);
    print_rows(file, r);
    print_noise(file, r);
    if (*allan_misfits(r, text)) {
        fprintf(file, "%sMore than this noise:%s on %s %s\n", paint_on(file, PAINT_YELLOW),
                paint_off(file), text, allan_misfit_words);
    }
    fprintf(file, "%s%s%s\n", paint_on(file, PAINT_GREEN), allan_advice(r, wish, text),
            paint_off(file));
    fprintf(file, "Next: %s\n", allan_next(r, text));
}
