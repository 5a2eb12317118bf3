/* SPDX-License-Identifier: MIT
 *
 * The worst-case error of each parameter.
 */
#include "design/bound.h"
#include "design/parameters.h"
#include "plan/facts.h"

#define COLUMNS 3u

void plan_report_bound(page *p, const plan_facts *f)
{
    static const char *const heading[COLUMNS] = {"parameter", "factor", "at most"};
    const page_table sheet = {"Factor: the sum of |H+| over the row of each parameter; the bound "
                              "is the factor times the error.",
                              heading, COLUMNS, 0};
    const double error = f->request->bound;
    const display_unit unit = unit_style_field(f->request->units, 1);
    double bound[INVCAL_PARAMETERS];
    char text[FIGURE_MAX];

    bound_find(f->set, bound);
    page_section(p, "Guaranteed");
    figure_digits(unit.scale * error, 3, text);
    page_say(p,
             "If no position mean is off by more than %s %s, for any reason, no parameter is off "
             "by more than this.",
             text, unit.unit);
    page_table_begin(p, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        char times[FIGURE_MAX];
        char max[PLAN_WORDS_MAX];
        plan_sigma_text(r / 3, bound[r], error, f->request->units, max);
        const char *const cells[COLUMNS] = {parameter_words(r), figure_digits(bound[r], 4, times),
                                            max};
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
}
