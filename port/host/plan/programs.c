/* SPDX-License-Identifier: MIT */
#include "plan/programs.h"

#include "plan/words.h"
#include "text/tabular.h"
#include "text/wrapped.h"

void plan_programs_make(plan_programs *p)
{
    static const char *const words[PLAN_PROGRAMS] = {
        [PLAN_15] = "per-group:5",    [PLAN_18] = "per-group:6",
        [PLAN_STAND_24] = "stand-24", [PLAN_EDGES] = "edges",
        [PLAN_STAND_12] = "stand-12", [PLAN_ICOSAHEDRON] = "icosahedron"};

    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        (void)design_make(&p->set[i], "plan", words[i]); /* known, and solvable */
    }
    p->paper = &p->set[PLAN_18];
}

/* The figures of a program, and below them their ratios to those of the paper's. */
static void add_program(const design *d, const design *paper, const design_cost *cost)
{
    const criteria *c = &d->criteria;
    const criteria *of = &paper->criteria;
    const double minutes[2] = {design_seconds(d->count, cost) / 60,
                               design_seconds(paper->count, cost) / 60};
    char text[PLAN_WORDS_MAX];

    tabular_cell("%s", d->name);
    tabular_cell("%u", d->count);
    tabular_cell("%.2f", minutes[0]);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        tabular_cell("%.4f", plan_sigma(c, k));
    }
    tabular_cell("%.4f", c->condition);
    tabular_cell("%.4f", c->log_det);
    tabular_cell("%s", plan_missing_axes(d->axes) ? plan_axes_text(plan_missing_axes(d->axes), text)
                                                  : "none");
    tabular_row();
    tabular_cell("  over 3 x 6");
    tabular_cell("%.4f", (double)d->count / paper->count);
    tabular_cell("%.4f", minutes[0] / minutes[1]);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        tabular_cell("%.4f", plan_sigma(c, k) / plan_sigma(of, k));
    }
    tabular_cell("%.4f", c->condition / of->condition);
    tabular_row();
}

/* In units, if the noise is known. */
static void print_expected(FILE *file, const plan_programs *p, const choice_request *request)
{
    char text[PLAN_WORDS_MAX];
    const double noise = design_noise(&request->cost);
    const display_unit unit = unit_style_field(request->units, 1);

    putc('\n', file);
    wrapped_printf(file, 0, "noise of a position mean: %.4g %s", unit.scale * noise, unit.unit);
    tabular_begin(file, "lrrr");
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        tabular_cell("%s", p->set[i].name);
        for (unsigned k = 0; k < PLAN_KINDS; k++) {
            tabular_cell("%s", plan_sigma_text(k, plan_sigma(&p->set[i].criteria, k), noise,
                                               request->units, text));
        }
        tabular_row();
    }
    tabular_end();
}

void plan_programs_print(FILE *file, const plan_programs *p, const choice_request *request)
{
    fprintf(file, "The programs; sigma times the noise of a position mean\n\n");
    tabular_begin(file, "lrrrrrrrr");
    tabular_heading("|positions|minutes|offsets|scales|angles|condition|ln det H'H|axes missing");
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        add_program(&p->set[i], p->paper, &request->cost);
    }
    tabular_end();
    if (request->cost.noise > 0) {
        print_expected(file, p, request);
    }
    fprintf(file, "\nstand-24 has 24 positions in %u directions\n",
            design_distinct(&p->set[PLAN_STAND_24]));
}
