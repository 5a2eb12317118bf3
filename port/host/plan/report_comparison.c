/* SPDX-License-Identifier: MIT
 *
 * The page of a comparison: cost and accuracy of B against A.
 */
#include <math.h>
#include <string.h>

#include "plan/facts.h"
#include "plan/ratios.h"

#define TEXT_MAX 1000
#define EQUAL 5e-4 /* ratios within this of 1 are shown as equal */

typedef struct {
    plan_facts of[2]; /* A, B */
    plan_ratio ratio[PLAN_RATIOS];
} comparison;

/* ---- the verdict ------------------------------------------------------------------------------- */

static int is_less(double ratio)
{
    return ratio < 1 - EQUAL;
}

static int is_more(double ratio)
{
    return ratio > 1 + EQUAL;
}

/* "B needs 0.7447 of the time of A, with 18 positions instead of 24" */
static void time_text(const comparison *c, char text[TEXT_MAX])
{
    const double ratio = c->ratio[PLAN_RATIO_TIME].ratio;
    char number[FIGURE_MAX];

    figure_digits(ratio, 4, number);
    if (is_less(ratio) || is_more(ratio)) {
        snprintf(text, TEXT_MAX, "B needs %s%s the time of A, with %u positions instead of %u",
                 number, is_less(ratio) ? " of" : " times", c->of[1].set->count,
                 c->of[0].set->count);
    } else {
        snprintf(text, TEXT_MAX, "B takes the same time as A");
    }
}

/* "its σ are 1.155 times as large", or the ratio of each kind. */
static void sigma_text(const comparison *c, char text[TEXT_MAX])
{
    const plan_ratio *r = &c->ratio[PLAN_RATIO_SIGMA];
    char number[PLAN_KINDS][FIGURE_MAX];

    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        figure_digits(r[k].ratio, 4, number[k]);
    }
    if (fabs(r[1].ratio / r[0].ratio - 1) < EQUAL && fabs(r[2].ratio / r[0].ratio - 1) < EQUAL) {
        if (is_less(r[0].ratio) || is_more(r[0].ratio)) {
            snprintf(text, TEXT_MAX, "its σ are %s times as large", number[0]);
        } else {
            snprintf(text, TEXT_MAX, "its σ are the same");
        }
    } else {
        snprintf(text, TEXT_MAX,
                 "its σ of offsets is %s, of scale errors %s, of angles %s times as large",
                 number[0], number[1], number[2]);
    }
}

/* Appends what is wrong with a set, if anything is. */
static void add_fault(const design *d, char name, char *text, size_t size)
{
    const size_t length = strlen(text);

    if (!(plan_sigma_largest(&d->criteria) <= PLAN_WEAK)) {
        snprintf(text + length, size - length, " %c is weak: σ above %g times the noise.", name,
                 PLAN_WEAK);
    } else if (d->count == INVCAL_PARAMETERS) {
        snprintf(text + length, size - length,
                 " %c has no redundancy: nine positions for nine parameters.", name);
    }
}

/* -1: B is better, or equal, in time and every sigma; 1: A is; 0: neither is. */
static int better_set(const comparison *c, int *is_equal)
{
    int less = is_less(c->ratio[PLAN_RATIO_TIME].ratio);
    int more = is_more(c->ratio[PLAN_RATIO_TIME].ratio);

    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        less |= is_less(c->ratio[PLAN_RATIO_SIGMA + k].ratio);
        more |= is_more(c->ratio[PLAN_RATIO_SIGMA + k].ratio);
    }
    *is_equal = !less && !more;
    return more - less;
}

static void write_verdict(page *p, const comparison *c)
{
    int is_equal;
    const int side = better_set(c, &is_equal);
    char time[TEXT_MAX];
    char sigma[TEXT_MAX];
    char sentence[3 * TEXT_MAX];
    char faults[TEXT_MAX / 4] = "";

    time_text(c, time);
    sigma_text(c, sigma);
    add_fault(c->of[0].set, 'A', faults, sizeof faults);
    add_fault(c->of[1].set, 'B', faults, sizeof faults);
    snprintf(sentence, sizeof sentence, "%s; %s.%s", time, sigma, faults);
    page_verdict(p, *faults ? PAGE_CAUTION : PAGE_GOOD,
                 is_equal    ? "A and B are equally good"
                 : side == 0 ? "One is faster, the other more accurate"
                 : side < 0  ? "B is better"
                             : "A is better",
                 sentence,
                 is_equal    ? "take the one that is easier to follow."
                 : side == 0 ? "take the faster one if its σ are small enough, else the other."
                 : side < 0  ? "take B."
                             : "take A.");
}

static void write_figures(page *p, const comparison *c)
{
    static const char *const names[2] = {"A", "B"};

    page_figures_begin(p);
    for (unsigned i = 0; i < 2; i++) {
        page_figure(p, c->of[i].set->name, names[i]);
    }
    page_figures_end(p);
}

/* ---- the sections ------------------------------------------------------------------------------ */

static void draw(FILE *file, const void *data, double width)
{
    const comparison *c = data;

    plan_svg_comparison_inline(file, c->of[0].set, c->of[1].set, c->of[0].request, width);
}

static void write_pair(page *p, const page_table *sheet, const char *name, const char *a,
                       const char *b, const char *ratio)
{
    const char *const cells[] = {name, a, b, ratio};

    page_cells(p, sheet, cells);
}

static void write_coverage(page *p, const page_table *sheet, const comparison *c)
{
    char text[2][PLAN_WORDS_MAX];

    for (unsigned k = 0; k < 2; k++) {
        const unsigned missing = plan_missing_axes(c->of[k].set->axes);
        snprintf(text[k], PLAN_WORDS_MAX, "none");
        if (missing) {
            plan_axes_text(missing, text[k]);
        }
    }
    write_pair(p, sheet, "never along gravity", text[0], text[1], "");
    for (unsigned i = 0; i < 3; i++) {
        char name[PLAN_WORDS_MAX];
        snprintf(name, sizeof name, "range of %c, g", "xyz"[i]);
        for (unsigned k = 0; k < 2; k++) {
            const double *range = c->of[k].set->range[i];
            snprintf(text[k], PLAN_WORDS_MAX, "%+.2f ... %+.2f", range[0], range[1]);
        }
        write_pair(p, sheet, name, text[0], text[1], "");
    }
}

static void write_table(page *p, const comparison *c)
{
    static const char *const heading[] = {"", "A", "B", "B / A"};
    const page_table sheet = {"Mean σ: geometric mean of all nine along their principal axes, (det "
                              "H'H) to the power -1/18.",
                              heading, 4, 0};
    char number[2][FIGURE_MAX];

    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < PLAN_RATIOS; i++) {
        const plan_ratio *r = &c->ratio[i];
        write_pair(p, &sheet, r->name, r->a, r->b, figure_digits(r->ratio, 4, number[0]));
    }
    for (unsigned k = 0; k < 2; k++) {
        figure_fixed(c->of[k].set->criteria.log_det, 3, FIGURE_PLAIN, number[k]);
    }
    write_pair(p, &sheet, "ln det H'H", number[0], number[1], "");
    write_coverage(p, &sheet, c);
    page_table_end(p);
}

/* Both sets with the same scale of shades. */
static void write_spheres(page *p, const comparison *c)
{
    const uncertainty *a = &c->of[0].length_sigma;
    const uncertainty *b = &c->of[1].length_sigma;
    const double min = fmin(a->min, b->min);
    const double max = fmax(a->max, b->max);
    sphere_shading shading = {.classes = 1};

    page_section(p, "Where the positions point");
    for (unsigned k = 0; k < 2; k++) {
        const design *d = c->of[k].set;
        char caption[TEXT_MAX / 4];
        shading = uncertainty_shading(&c->of[k].length_sigma, min, max);
        page_row_begin(p);
        plan_draw_halves(p->file, d, &shading);
        snprintf(caption, sizeof caption, "%c: %s, %u positions.", k == 0 ? 'A' : 'B', d->name,
                 d->count);
        page_row_end(p, caption);
    }
    page_row_begin(p);
    plan_draw_legend(p->file, &shading, plan_length_unit(&c->of[0]),
                     design_has_groups(c->of[0].set) || design_has_groups(c->of[1].set));
    page_row_end(p, "Up in the axes of the device, and the expected uncertainty of the length |a| "
                    "of a corrected reading in every direction.");
}

static void write_origin(page *p, const comparison *c, const char *command)
{
    const design_cost *cost = &c->of[0].request->cost;
    char text[2][PLAN_WORDS_MAX];

    plan_report_origin(p, command);
    page_fact(p, "time", "%s in each position, %s between positions",
              plan_time_text(cost->dwell, text[0]), plan_time_text(cost->move, text[1]));
    page_facts_end(p);
}

void plan_report_comparison(FILE *file, const design *a, const design *b,
                            const choice_request *request, const char *command)
{
    comparison c;
    page p;

    plan_facts_find(&c.of[0], a, request, NULL);
    plan_facts_find(&c.of[1], b, request, NULL);
    plan_ratios(a, b, request, c.ratio);
    page_begin(&p, file, "Two programs compared");
    write_verdict(&p, &c);
    write_figures(&p, &c);
    page_section(&p, "B against A");
    page_picture(&p, "Time and σ of B over those of A: less is better.", draw, &c);
    write_table(&p, &c);
    write_spheres(&p, &c);
    write_origin(&p, &c, command);
    page_end(&p);
}
