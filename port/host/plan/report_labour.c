/* SPDX-License-Identifier: MIT
 *
 * The section of a program's page about the choice of number and dwell.
 */
#include "text/figure.h"
#include "plan/labour.h"
#include "plan/words.h"

#define COLUMNS 6u

static void write_row(page *p, const page_table *sheet, const labour *l, unsigned family,
                      const labour_row *row)
{
    char text[COLUMNS][PLAN_WORDS_MAX] = {"", "", "none", "", "", ""};
    const char *cells[COLUMNS];

    snprintf(text[0], PLAN_WORDS_MAX, "%s%s", labour_families[family],
             row == l->best[l->chosen] ? ", chosen" : "");
    snprintf(text[1], PLAN_WORDS_MAX, "%u", row->count);
    if (row->is_possible) {
        plan_time_text(row->dwell, text[2]);
        plan_time_text(row->seconds, text[4]);
        snprintf(text[5], PLAN_WORDS_MAX, "%s%s", plan_kinds[row->binds],
                 row->is_beyond ? "; dwell not measured" : "");
    }
    figure_digits(unit_style_field(l->units, 1).scale * row->sigma, 3, text[3]);
    for (unsigned k = 0; k < COLUMNS; k++) {
        cells[k] = text[k];
    }
    page_cells(p, sheet, cells);
}

void labour_report(page *p, const labour *l)
{
    static const char *const headings[COLUMNS] = {"family",      "positions", "in each",
                                                  "σ of a mean", "time",      "limited by"};
    char caption[PLAN_WORDS_MAX];
    const page_table sheet = {caption, headings, COLUMNS, 1u << 5};
    const labour_row *row = l->best[l->chosen];

    snprintf(caption, sizeof caption, "Around the best of each family; σ of a position mean in %s.",
             unit_style_field(l->units, 1).unit);
    page_section(p, "Number and dwell");
    page_say(p,
             "%u positions of %.4g s take the least total time with the noise of %s. The limit of "
             "the %s decides.",
             row->count, row->dwell, l->noise_name, plan_kinds[row->binds]);
    if (row->is_beyond) {
        page_say(p, "That is longer than the averaging times of the measured noise: log longer to "
                    "be sure.");
    }
    labour_picture(p, l);
    page_table_begin(p, &sheet);
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        unsigned first;
        unsigned end;
        labour_near_best(l, f, &first, &end);
        for (unsigned i = first; i < end; i++) {
            write_row(p, &sheet, l, f, &l->row[f][i]);
        }
    }
    page_table_end(p);
    page_note(p, "σ of a mean is that of the worst axis over the whole session: the longer it "
                 "lasts, the more slow noise separates the positions.");
}
