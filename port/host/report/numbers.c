/* SPDX-License-Identifier: MIT
 *
 * The table of all positions.
 */
#include <math.h>

#include "report/facts.h"

#define CELL 160
#define LISTED_MAX 1000u /* with more positions, only those left out and the worst are listed */
#define LENGTH_MAX 1e3   /* over the mean length; beyond it no figure is printed */
#define UNFOLDED_MAX 48u /* with more positions, the table is folded */

enum {
    NUMBER,
    LINE,
    BEGIN,
    DURATION,
    TEMPERATURE,
    X,
    Y,
    Z,
    UP,
    LENGTH, /* of refused data only: relative to the mean of all */
    BEFORE,
    AFTER,
    REMARK,
    COLUMNS
};

/* Whether a column is shown: rests of a log have times, position means have lines. */
static int is_shown(const report_facts *f, unsigned which)
{
    switch (which) {
    case LINE:
        return !f->result->log;
    case BEGIN:
    case DURATION:
        return f->result->log != NULL;
    case TEMPERATURE:
        return f->result->data->has_temperature;
    case UP:
        return f->has_up;
    case LENGTH:
        return f->has_up && f->result->refused.word;
    case BEFORE:
        return f->has_before && !f->result->refused.word;
    case AFTER:
        return !f->result->refused.word;
    case REMARK:
        return f->result->rejected.count > 0 || f->result->refused.is_of_position;
    default:
        return 1;
    }
}

static void write_row(page *p, const page_table *sheet, const report_facts *f, unsigned n)
{
    const position_origin *from = &f->result->data->origin[n];
    const report_position *at = &f->position[n];
    const double *mean = &f->result->data->mean[3 * (size_t)n];
    char text[COLUMNS][CELL];
    char number[3][FIGURE_MAX];
    const char *cells[COLUMNS];
    const int is_ins = f->result->units == UNIT_STYLE_INS;
    unsigned count = 0;

    snprintf(text[NUMBER], CELL, "%u", n + 1);
    snprintf(text[LINE], CELL, "%lu", from->line);
    snprintf(text[BEGIN], CELL, "%.2f", from->begin);
    snprintf(text[DURATION], CELL, "%.2f", from->end - from->begin);
    snprintf(text[TEMPERATURE], CELL, "%.2f", from->temperature);
    for (unsigned i = 0; i < 3; i++) {
        const double sigma = f->knows_noise ? f->result->quality.sigma_offset[i] : 0;
        figure_fixed(mean[i], figure_places(mean[i], sigma), FIGURE_PLAIN, text[X + i]);
    }
    for (unsigned i = 0; i < 3; i++) {
        figure_fixed(at->up[i], 2, FIGURE_SIGNED, number[i]);
    }
    snprintf(text[UP], CELL, "%.9s %.9s %.9s", number[0], number[1], number[2]);
    figure_fixed(at->before, is_ins ? 1 : 3, FIGURE_SIGNED, text[BEFORE]);
    figure_fixed(at->after, is_ins ? 2 : 4, FIGURE_SIGNED, text[AFTER]);
    snprintf(text[LENGTH], CELL, at->length < LENGTH_MAX ? "%.3f" : "far off", at->length);
    snprintf(text[REMARK], CELL, "%s",
             !at->is_left_out          ? ""
             : f->result->refused.word ? "refused"
                                       : "left out");
    for (unsigned k = 0; k < COLUMNS; k++) {
        if (is_shown(f, k)) {
            cells[count++] = text[k];
        }
    }
    page_cells(p, sheet, cells);
}

/* Whether a position is listed. */
static int is_listed(const report_facts *f, unsigned n)
{
    const report_position *at = &f->position[n];

    return f->count <= LISTED_MAX || at->is_left_out ||
           (!f->result->refused.word && fabs(at->after) >= 0.7 * f->scale * f->result->quality.max);
}

void report_numbers(page *p, const report_facts *f)
{
    if (f->count == 0) {
        return;
    }
    static const char *const all[COLUMNS] = {"no.",    "line",  "from, s", "for, s", "°C",
                                             "x",      "y",     "z",       "up",     "length",
                                             "before", "after", "remark"};
    const char *titles[COLUMNS];
    char summary[CELL];
    char caption[CELL];
    page_table sheet = {caption, titles, 0, 0};

    for (unsigned k = 0; k < COLUMNS; k++) {
        if (is_shown(f, k)) {
            titles[sheet.count++] = all[k];
        }
    }
    snprintf(summary, sizeof summary,
             f->count <= LISTED_MAX    ? "All %u positions"
             : f->result->refused.word ? "The refused ones of %u positions"
                                       : "The positions left out and the worst, of %u",
             f->count);
    snprintf(caption, sizeof caption,
             f->result->refused.word
                 ? "x y z: mean reading, %s. Up: as in the picture above. Length: relative to the "
                   "mean of all; an outlier may be wrong."
             : f->has_before ? "x y z: mean reading, %s. Up: in the calibrated axes. Before and "
                               "after: deviation of %s, %s."
                             : "x y z: mean reading, %s. Up: in the calibrated axes. After: "
                               "deviation of %s, %s.",
             calibrate_input_unit(f->result), f->length, f->unit);
    page_section(p, "The positions in numbers");
    page_fold_begin(p, summary, f->count <= UNFOLDED_MAX);
    page_table_begin(p, &sheet);
    for (unsigned n = 0; n < f->count; n++) {
        if (is_listed(f, n)) {
            write_row(p, &sheet, f, n);
        }
    }
    page_table_end(p);
    page_fold_end(p);
}
