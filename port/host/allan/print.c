/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "allan/allan.h"
#include "text/figure.h"
#include "text/paint.h"
#include "text/plain.h"
#include "text/tabular.h"
#include "text/wrapped.h"

static void print_source(FILE *file, const allan_result *r, const allan_settings *settings)
{
    char seen[COLUMNS_TEXT_MAX];
    char name[PLAIN_MAX];

    wrapped_printf(file, 0, "%s: %s", plain_copy(r->name, name),
                   columns_describe(&r->seen, seen, sizeof seen));
    wrapped_printf(file, 0, "%lu samples, %.6g s at %.6g samples per second, %lu gap%s", r->samples,
                   (double)r->samples / r->rate, r->rate, r->gaps, r->gaps == 1 ? "" : "s");
    wrapped_printf(file, 0, "Allan deviation, %s, %s",
                   settings->is_apart ? "non-overlapping" : "overlapping", r->unit);
    putc('\n', file);
}

static void print_rows(FILE *file, const allan_result *r)
{
    char text[FIGURE_MAX];

    tabular_begin(file, "rrrrrr");
    tabular_heading("tau, s|x|y|z|+- %|differences");
    for (unsigned k = 0; k < r->rows; k++) {
        const allan_row *row = &r->row[k];
        tabular_cell("%.6g", row->seconds);
        for (unsigned i = 0; i < 3; i++) {
            tabular_cell("%s", figure_digits(row->adev[i], 5, text));
        }
        tabular_cell("%s", figure_digits(100 * row->relative, 3, text));
        tabular_cell("%lu", (unsigned long)row->count);
        tabular_row();
    }
    tabular_end();
    putc('\n', file);
}

/* The three values of a coefficient, and the largest relative sigma of those that are visible. */
static void add_line(const allan_result *r, const allan_line *line)
{
    char text[ALLAN_WORDS_MAX];
    double relative = 0;

    tabular_cell("%s", allan_label(r, line, text));
    for (unsigned i = 0; i < 3; i++) {
        const invcal_noise *n = &r->noise[i];
        if (n->visible >> line->kind & 1u) {
            tabular_cell("%s", figure_digits(n->coefficient[line->kind] / line->scale, 4, text));
            relative = fmax(relative, n->relative[line->kind]);
        } else {
            tabular_cell("not visible");
        }
    }
    tabular_cell("%s", relative > 0 ? figure_digits(100 * relative, 2, text) : "");
    tabular_row();
}

static void add_minimum(const allan_result *r)
{
    char text[FIGURE_MAX];

    tabular_cell("smallest deviation, %s", r->is_ms2 ? "µg" : r->unit);
    for (unsigned i = 0; i < 3; i++) {
        const double deviation = r->noise[i].minimum / (r->is_ms2 ? ALLAN_MICRO_G : 1);
        tabular_cell("%s", figure_digits(deviation, 3, text));
    }
    tabular_row();
    tabular_cell("at tau, s");
    for (unsigned i = 0; i < 3; i++) {
        tabular_cell("%.4g", r->noise[i].best);
    }
    tabular_row();
}

static void print_noise(FILE *file, const allan_result *r)
{
    tabular_begin(file, "lrrrr");
    tabular_heading("|x|y|z|+- %");
    for (unsigned k = 0; k < ALLAN_LINES; k++) {
        if (allan_has_line(r, &allan_lines[k])) {
            add_line(r, &allan_lines[k]);
        }
    }
    add_minimum(r);
    tabular_end();
    putc('\n', file);
}

void allan_print(FILE *file, const allan_result *r, const allan_settings *settings)
{
    char text[ALLAN_WORDS_MAX];

    print_source(file, r, settings);
    print_rows(file, r);
    print_noise(file, r);
    if (*allan_misfits(r, text)) {
        wrapped_printf(file, 0, "%sNot only this noise:%s on %s %s", paint_on(file, PAINT_YELLOW),
                       paint_off(file), text, allan_misfit_words);
    }
    wrapped_printf(file, 0, "%s%s%s", paint_on(file, PAINT_GREEN), allan_advice(r, settings, text),
                   paint_off(file));
    wrapped_printf(file, 0, "Next: %s", allan_next(r, text));
}
