/* SPDX-License-Identifier: MIT */
#include "plan/programs.h"

#include "text/paint.h"
#include "plan/words.h"

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

/* What a program is worth; below it the ratios to the paper's. */
static void print_program(FILE *file, const design *d, const design *paper, const design_cost *cost)
{
    const criteria *c = &d->criteria;
    const criteria *of = &paper->criteria;
    const double minutes[2] = {design_seconds(d->count, cost) / 60,
                               design_seconds(paper->count, cost) / 60};
    char text[PLAN_WORDS_MAX];

    fprintf(file, "%s%-14s%s%10u%10.2f%10.4f%10.4f%10.4f%11.4f%12.4f   %s\n",
            paint_on(file, PAINT_BOLD), d->name, paint_off(file), d->count, minutes[0],
            c->sigma_delta, c->sigma_dk, c->sigma_gamma, c->condition, c->log_det,
            plan_missing(d->axes) ? plan_axes_text(plan_missing(d->axes), text) : "none");
    fprintf(file, "%-14s%10.4f%10.4f%10.4f%10.4f%10.4f%11.4f\n", "  over 3 x 6",
            (double)d->count / paper->count, minutes[0] / minutes[1],
            c->sigma_delta / of->sigma_delta, c->sigma_dk / of->sigma_dk,
            c->sigma_gamma / of->sigma_gamma, c->condition / of->condition);
}

/* In units, if the noise is told. */
static void print_expected(FILE *file, const plan_programs *p, const choice_request *request)
{
    char text[PLAN_KINDS][PLAN_WORDS_MAX];
    const double noise = design_noise(&request->cost);
    const told_unit unit = told_field(request->told, 1);

    fprintf(file, "\nwith %.4g %s of noise in a position mean\n", unit.scale * noise, unit.unit);
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        fprintf(file, "%-14s%10s", p->set[i].name, "");
        for (unsigned k = 0; k < PLAN_KINDS; k++) {
            plan_sigma_text(k, plan_sigma(&p->set[i].criteria, k), noise, request->told, text[k]);
            fprintf(file, "   %s", text[k]);
        }
        putc('\n', file);
    }
}

void plan_programs_print(FILE *file, const plan_programs *p, const choice_request *request)
{
    fprintf(file, "The programs; sigma times the noise of a position mean\n\n");
    fprintf(file, "%s%-14s%10s%10s%10s%10s%10s%11s%12s   %s%s\n", paint_on(file, PAINT_BOLD), "",
            "positions", "minutes", "offsets", "scales", "angles", "condition", "ln det H'H",
            "axes missing", paint_off(file));
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        print_program(file, &p->set[i], p->paper, &request->cost);
    }
    if (request->cost.noise > 0) {
        print_expected(file, p, request);
    }
    fprintf(file, "\nstand-24 is 24 positions in %u directions\n",
            design_distinct(&p->set[PLAN_STAND_24]));
}
