/* SPDX-License-Identifier: MIT
 *
 * The page of a sweep: sigma against the number of positions.
 */
#include <math.h>

#include "plan/facts.h"

#define COLUMNS 8u
#define TEXT_MAX 600
#define UNFOLDED_MAX 48u /* a table of more rows is folded */

/* The factor of sigma for twice the positions, from first and last row. */
static double factor_of_doubling(const plan_sweep *s)
{
    const plan_row *first = &s->rows[0];
    const plan_row *last = &s->rows[s->count - 1];
    const double power =
        log(plan_sigma_largest(&last->criteria) / plan_sigma_largest(&first->criteria)) /
        log((double)last->per_group / first->per_group);

    return pow(2, power);
}

static void write_verdict(page *p, const plan_sweep *s)
{
    static const char next[] =
        "choose the smallest program whose σ is sufficient, here or with invcal plan --limits. "
        "Even numbers per group point all six axes along gravity.";
    const plan_row *first = &s->rows[0];
    const plan_row *last = &s->rows[s->count - 1];
    char sentence[TEXT_MAX];
    char number[2][FIGURE_MAX];

    figure_digits(plan_sigma_largest(&first->criteria), 3, number[0]);
    if (s->count == 1) {
        snprintf(sentence, sizeof sentence,
                 "%u positions: the largest σ, of the angles, is %s times the noise of a position "
                 "mean. Give a range of two or more to compare.",
                 first->criteria.positions, number[0]);
        page_verdict(p, PAGE_GOOD, "One program", sentence, next);
        return;
    }
    snprintf(
        sentence, sizeof sentence,
        "Twice the positions, in twice the time, multiply every σ by %.2f. From %u to %u positions "
        "the largest, of the angles, falls from %s to %s times the noise of a position mean.",
        factor_of_doubling(s), first->criteria.positions, last->criteria.positions, number[0],
        figure_digits(plan_sigma_largest(&last->criteria), 3, number[1]));
    page_verdict(p, PAGE_GOOD, "Benefit of more positions", sentence, next);
}

static void draw(FILE *file, const void *data, double width)
{
    const plan_sweep *s = data;

    plan_svg_sweep_inline(file, s, width);
}

static void write_row(page *p, const page_table *sheet, const plan_row *row)
{
    const criteria *c = &row->criteria;
    char text[COLUMNS][PLAN_WORDS_MAX];
    const char *cells[COLUMNS];
    char number[FIGURE_MAX];

    snprintf(text[0], PLAN_WORDS_MAX, "3 x %u", row->per_group);
    snprintf(text[1], PLAN_WORDS_MAX, "%u", c->positions);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        snprintf(text[2 + k], PLAN_WORDS_MAX, "%s",
                 figure_fixed(plan_sigma(c, k), 4, FIGURE_PLAIN, number));
    }
    snprintf(text[5], PLAN_WORDS_MAX, "%.4g", c->condition);
    snprintf(text[6], PLAN_WORDS_MAX, "%s", figure_fixed(c->log_det, 2, FIGURE_PLAIN, number));
    if (plan_missing_axes(row->axes)) {
        plan_axes_text(row->axes, text[7]);
    } else {
        snprintf(text[7], PLAN_WORDS_MAX, "all six");
    }
    for (unsigned k = 0; k < COLUMNS; k++) {
        cells[k] = text[k];
    }
    page_cells(p, sheet, cells);
}

static void write_table(page *p, const plan_sweep *s)
{
    static const char *const heading[COLUMNS] = {"program",      "positions",    "offsets",
                                                 "scale errors", "angles",       "condition",
                                                 "ln det H'H",   "along gravity"};
    const page_table sheet = {"σ, times the noise of a position mean (offsets over the field, "
                              "angles in rad); the largest of three each.",
                              heading, COLUMNS, 1u << 7};
    char summary[PLAN_WORDS_MAX];

    snprintf(summary, sizeof summary, "All %u programs", s->count);
    page_section(p, "In numbers");
    page_fold_begin(p, summary, s->count <= UNFOLDED_MAX);
    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < s->count; i++) {
        write_row(p, &sheet, &s->rows[i]);
    }
    page_table_end(p);
    page_fold_end(p);
}

void plan_report_sweep(FILE *file, const plan_sweep *s, const char *command)
{
    char title[TEXT_MAX];
    page p;

    snprintf(title, sizeof title, "Programs of %u to %u positions", s->rows[0].criteria.positions,
             s->rows[s->count - 1].criteria.positions);
    page_begin(&p, file, title);
    write_verdict(&p, s);
    page_section(&p, "σ against the number of positions");
    page_picture(&p,
                 "Curves: programs of three groups of N positions; single markers: those of invcal "
                 "plan --programs. Each value is the largest of three. 1 means, with a noise of "
                 "1e-6 of the field: 1e-6 of the field, 1e-6, 1 µrad.",
                 draw, s);
    write_table(&p, s);
    plan_report_origin(&p, command);
    page_facts_end(&p);
    page_end(&p);
}
