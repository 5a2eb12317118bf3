/* SPDX-License-Identifier: MIT
 *
 * The page of a log at rest: how long to hold a position, and why.
 */
#include <string.h>

#include "allan/allan.h"
#include "cli/command.h"
#include "cli/input.h"
#include "text/figure.h"
#include "draw/page.h"
#include "plan/words.h"

#define COLUMNS 4u
#define ROW_COLUMNS 7u

static void write_verdict(page *p, const allan_result *r, const allan_settings *settings)
{
    const allan_dwell *d = &r->dwell[r->worst];
    const int is_short = d->end == ALLAN_FLOOR && settings->sigma > 0;
    char sentence[ALLAN_WORDS_MAX];
    char next[ALLAN_WORDS_MAX];
    char axes[ALLAN_WORDS_MAX];

    allan_advice(r, settings, sentence);
    allan_next(r, next);
    if (is_short) {
        page_verdict(p, PAGE_BAD, "✗ Not reached", sentence, next);
    } else if (*allan_misfits(r, axes) || d->end == ALLAN_BEYOND) {
        page_verdict(p, PAGE_CAUTION, "! Caution", sentence, next);
    } else {
        page_verdict(p, PAGE_GOOD, "✓ Good", sentence, next);
    }
}

static void write_figures(page *p, const allan_result *r)
{
    const allan_dwell *d = &r->dwell[r->worst];
    const invcal_noise *n = &r->noise[r->worst];
    char time[PLAN_WORDS_MAX];
    char text[ALLAN_WORDS_MAX];

    page_figures_begin(p);
    page_figure(p, plan_time_text(d->seconds, time), "in each position");
    page_figure(p, allan_deviation(r, d->sigma, text), "σ of its mean, worst axis");
    page_figure(p, allan_deviation(r, invcali_noise_sigma(n, 1), text), "after one second");
    page_figure(p, allan_deviation(r, n->minimum, text), "minimum");
    page_figures_end(p);
}

static void draw(FILE *file, const void *data, double width)
{
    allan_chart(file, data, width);
}

static void write_chart(page *p, const allan_result *r)
{
    char axes[ALLAN_WORDS_MAX];

    page_section(p, "Accuracy of a mean");
    page_picture(p,
                 "Markers: measured, with one standard deviation. Curves: the model with three "
                 "components. Dashed: each component alone, for the axis that sets the dwell; "
                 "white noise falls, bias instability is flat, a random walk rises.",
                 draw, r);
    if (*allan_misfits(r, axes)) {
        page_say(p, "The model does not explain %s: %s.", axes, allan_misfit_words);
    }
}

/* ---- components of the noise ------------------------------------------------------------------- */

static void write_line(page *p, const page_table *sheet, const allan_result *r,
                       const allan_line *line)
{
    char text[COLUMNS][ALLAN_WORDS_MAX];
    const char *const cells[COLUMNS] = {text[0], text[1], text[2], text[3]};

    allan_label(r, line, text[0]);
    for (unsigned i = 0; i < 3; i++) {
        allan_coefficient(r, line, i, text[1 + i]);
    }
    page_cells(p, sheet, cells);
}

static void write_noise(page *p, const allan_result *r)
{
    static const char *const headings[COLUMNS] = {"", "x", "y", "z"};
    const page_table sheet = {"Coefficients of the model, ± one standard deviation.", headings,
                              COLUMNS, 0};
    page_section(p, "Components of the noise");
    page_table_begin(p, &sheet);
    for (unsigned k = 0; k < ALLAN_LINES; k++) {
        if (allan_has_line(r, &allan_lines[k])) {
            write_line(p, &sheet, r, &allan_lines[k]);
        }
    }
    page_table_end(p);
    page_note(p, "σ² of a mean over τ is N²/τ + 0.441 B² + K² τ/3. Over a session of many "
                 "positions, B and K contribute more; invcal plan --allan accounts for that.");
}

/* ---- numbers and origin ------------------------------------------------------------------------ */

static void write_rows(page *p, const allan_result *r)
{
    static const char *const headings[ROW_COLUMNS] = {"τ, s", "x",   "y",          "z",
                                                      "± %",  "edf", "differences"};
    char caption[ALLAN_WORDS_MAX];
    const page_table sheet = {caption, headings, ROW_COLUMNS, 0};
    char text[ROW_COLUMNS][FIGURE_MAX];
    const char *cells[ROW_COLUMNS];

    snprintf(caption, sizeof caption,
             "Allan deviation, %s; edf: equivalent degrees of freedom for white noise.", r->unit);
    page_section(p, "In numbers");
    page_fold_begin(p, "All averaging times", 1);
    page_table_begin(p, &sheet);
    for (unsigned k = 0; k < r->rows; k++) {
        const allan_row *row = &r->row[k];
        snprintf(text[0], FIGURE_MAX, "%.6g", row->seconds);
        for (unsigned i = 0; i < 3; i++) {
            figure_digits(row->adev[i], 5, text[1 + i]);
        }
        figure_digits(100 * row->relative, 2, text[4]);
        figure_digits(row->edf, 3, text[5]);
        snprintf(text[6], FIGURE_MAX, "%lu", (unsigned long)row->count);
        for (unsigned i = 0; i < ROW_COLUMNS; i++) {
            cells[i] = text[i];
        }
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
    page_fold_end(p);
}

static void write_origin(page *p, const allan_result *r, const allan_settings *settings)
{
    char seen[COLUMNS_TEXT_MAX];

    page_section(p, "How it was made");
    page_facts_begin(p);
    page_fact(p, "file", "%s, %llu bytes, CRC-32 %08lx", r->name, (unsigned long long)r->bytes,
              (unsigned long)r->crc);
    page_fact(p, "read as", "%s", columns_describe(&r->seen, seen, sizeof seen));
    page_literal(p, "command", settings->command);
    page_fact(p, "invcal", "%s", INVCAL_VERSION);
    page_fact(p, "samples", "%lu from %.6g s to %.6g s, at %.6g per second, %lu gaps", r->samples,
              r->from, r->to, r->rate, r->gaps);
    page_fact(p, "estimator", "%s",
              settings->is_apart
                  ? "non-overlapping (NIST SP 1065, 5.2.2)"
                  : "overlapping (NIST SP 1065, 5.2.4); above 4096 samples 2048 times or more");
    if (r->gravity > 0) {
        page_fact(p, "field", "%.9g %s", r->gravity, r->unit);
    }
    page_facts_end(p);
}

void allan_report(FILE *file, const allan_result *r, const allan_settings *settings)
{
    char title[ALLAN_WORDS_MAX];
    page p;

    snprintf(title, sizeof title, "Noise of %.300s", input_file_name(r->name));
    page_begin(&p, file, title);
    write_verdict(&p, r, settings);
    write_figures(&p, r);
    write_chart(&p, r);
    write_noise(&p, r);
    write_rows(&p, r);
    write_origin(&p, r, settings);
    page_end(&p);
}
