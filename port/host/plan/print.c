/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "design/bound.h"
#include "text/figure.h"
#include "text/paint.h"
#include "design/parameters.h"
#include "plan/labour.h"
#include "plan/nonlinear.h"
#include "plan/words.h"
#include "design/series.h"
#include "design/weights.h"
#include "text/tabular.h"
#include "text/wrapped.h"

static void print_positions(FILE *file, const design *d)
{
    const int has_groups = design_has_groups(d);
    char text[PLAN_WORDS_MAX];

    wrapped_printf(file, 0, "alpha, beta: the stand, degrees; x y z: up in the case's frame");
    tabular_begin(file, d->has_shares ? "rrrrrrrr" : "rrrrrrr");
    tabular_heading(has_groups ? "position|group|alpha|beta|x|y|z|share"
                               : "position||alpha|beta|x|y|z|share");
    for (unsigned i = 0; i < d->count; i++) {
        const design_position *p = &d->position[i];
        tabular_cell("%u", i + 1);
        snprintf(text, sizeof text, "%u", p->group);
        tabular_cell("%s", p->group > 0 ? text : "");
        tabular_cell("%s", plan_angle_text(p->alpha, text));
        tabular_cell("%s", plan_angle_text(p->beta, text));
        for (unsigned k = 0; k < 3; k++) {
            tabular_cell("%.4f", nearbyint(1e4 * p->vertical[k]) / 1e4 + 0.0);
        }
        tabular_cell("%.6f", p->share / d->count);
        tabular_row();
    }
    tabular_end();
    putc('\n', file);
}

/* One sigma: over the noise, and in units if the noise is known. */
static void print_sigma(FILE *file, const char *what, double sigma, double noise, display_unit unit)
{
    fprintf(file, "  %-15s%9.4f", what, sigma);
    if (noise > 0) {
        fprintf(file, "%12.4g %s", unit.scale * noise * sigma, unit.unit);
    }
    putc('\n', file);
}

static void print_sigmas(FILE *file, const design *d, double noise, unit_style style)
{
    const display_unit field = unit_style_field(style, 1);
    const criteria *c = &d->criteria;

    char size[PLAN_WORDS_MAX] = "";

    if (noise > 0) {
        snprintf(size, sizeof size, ", which is %.4g %s", field.scale * noise, field.unit);
    }
    wrapped_printf(file, 0, "%ssigma%s, times the noise of a position mean%s",
                   paint_on(file, PAINT_BOLD), paint_off(file), size);
    print_sigma(file, "offsets", c->sigma_delta, noise, field);
    print_sigma(file, "scale errors", c->sigma_dk, noise, unit_style_scale(style));
    print_sigma(file, "angles", c->sigma_gamma, noise, unit_style_angle(style));
    wrapped_printf(file, 0, "condition %.4f (1 is best), ln det H'H %.4f (larger is better)",
                   c->condition, c->log_det);
    if (isfinite(d->drift_factor)) {
        wrapped_printf(file, 0, "fitting a drift in this order multiplies sigma by at most %.2f",
                       d->drift_factor);
    } else {
        wrapped_printf(file, 0,
                       "in this order, a drift cannot be distinguished from the nine parameters");
    }
}

/* The determinant with these shares of the time, with equal ones, and its bound. */
static void print_shares(FILE *file, const design *d)
{
    unsigned unused = 0;

    for (unsigned i = 0; i < d->count; i++) {
        unused += !(d->position[i].share > 0);
    }
    wrapped_printf(file, 0,
                   "with these shares of the time; with equal ones ln det H'H is %.4f, and for any "
                   "%u positions at most %.4f",
                   d->equal_log_det, d->count, weights_bound(d->count));
    if (unused > 0) {
        wrapped_printf(file, 0,
                       "%u position%s no share, since det H'H is larger without; visit %s to cover "
                       "the whole range and to check linearity",
                       unused, unused == 1 ? " has" : "s have", unused == 1 ? "it" : "them");
    }
}

/* The worst-case error of each parameter: factors of the three of a kind, and the largest in
 * units. */
static void print_bound(FILE *file, const design *d, double error, unit_style style)
{
    const display_unit units[PLAN_KINDS] = {unit_style_field(style, 1), unit_style_scale(style),
                                            unit_style_angle(style)};
    double bound[INVCAL_PARAMETERS];

    bound_find(d, bound);
    wrapped_printf(
        file, 0, "%sguaranteed%s, if no position mean is off by more than %.4g %s; factors of that",
        paint_on(file, PAINT_BOLD), paint_off(file), units[0].scale * error, units[0].unit);
    tabular_begin(file, "lrrrr");
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        const double *b = &bound[3 * (size_t)k];
        tabular_cell("  %s", plan_kinds[k]);
        for (unsigned i = 0; i < 3; i++) {
            tabular_cell("%.4f", b[i]);
        }
        tabular_cell("at most %.4g %s", units[k].scale * error * bound_largest(bound, k),
                     units[k].unit);
        tabular_row();
    }
    tabular_end();
}

/* Comparison with the limits; what invcal calibrate would say about such a set. */
static void print_verdict(FILE *file, const design *d, const choice_request *request)
{
    const criteria *c = &d->criteria;

    if (request->limits) {
        const double worst = choice_worst(c, request->limits);
        fprintf(file, "worst sigma / limit: %.4f", worst);
        if (worst > 1 + 1e-9) {
            fprintf(file, ": %sthe limits are not met%s", paint_on(file, PAINT_RED),
                    paint_off(file));
        }
        putc('\n', file);
    }
    if (d->count == INVCAL_PARAMETERS) {
        wrapped_printf(
            file, 0,
            "nine positions for nine parameters: no redundancy to check the fit; add three");
    }
    if (!(plan_sigma_largest(c) <= PLAN_WEAK)) {
        wrapped_printf(file, 0, "%sweak:%s a sigma above %g times the noise is of little use",
                       paint_on(file, PAINT_RED), paint_off(file), PLAN_WEAK);
    }
}

/* The range of each axis, and which axes are along gravity. */
static void print_coverage(FILE *file, const design *d)
{
    const unsigned missing = plan_missing_axes(d->axes);
    char text[2][PLAN_WORDS_MAX];
    size_t at = wrapped_words(file, 0, 0, "range used:");

    for (unsigned i = 0; i < 3; i++) {
        snprintf(text[0], PLAN_WORDS_MAX, " %c %+.2f ... %+.2f g%s", "xyz"[i], d -> range[i][0],
                 d -> range[i][1], i < 2 ? "," : "");
        at = wrapped_words(file, at, 0, text[0]);
    }
    putc('\n', file);
    if (missing == 0) {
        fprintf(file, "axes along gravity: all six\n");
        return;
    }
    wrapped_printf(file, 0, "axes along gravity: %s; missing: %s",
                   d->axes ? plan_axes_text(d->axes, text[0]) : "none",
                   plan_axes_text(missing, text[1]));
    if (d->plan.per_group > 0) {
        wrapped_line(file, 0, 0, plan_missing_reason(d));
    }
}

static void print_groups(FILE *file, const invcal_plan *plan)
{
    const double half = plan->per_group / 2.0;
    const double bound = plan->per_group * half * half * half * half;
    double sums[INVCAL_PACKED_SIZE(SERIES_TERMS)];
    double efficiency[INVCAL_PLAN_GROUPS];

    for (unsigned g = 1; g <= INVCAL_PLAN_GROUPS; g++) {
        (void)series_information(plan, g, sums); /* the plan is usable */
        efficiency[g - 1] = series_efficiency(sums);
    }
    wrapped_printf(file, 0,
                   "det H5'H5 of the groups over %.8g, the maximum for %u positions on a circle: "
                   "%.4f %.4f %.4f",
                   bound, plan->per_group, efficiency[0], efficiency[1], efficiency[2]);
}

static void add_candidate(const design *d, const choice_request *request)
{
    tabular_cell("%s", d->name);
    tabular_cell("%u", d->count);
    tabular_cell("%.4g", design_seconds(d->count, &request->cost) / 60);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        tabular_cell("%.4f", plan_sigma(&d->criteria, k));
    }
    if (request->limits) {
        tabular_cell("%.4f", choice_worst(&d->criteria, request->limits));
    }
    tabular_row();
}

static void add_limits(const double limits[PLAN_KINDS])
{
    tabular_cell("limits");
    tabular_cell("%s", "");
    tabular_cell("%s", "");
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        tabular_cell("%.4f", limits[k]);
    }
    tabular_cell("%.4f", 1.0);
    tabular_row();
}

static void print_choice(FILE *file, const choice *c, const choice_request *request)
{
    static const char *const families[] = {"stand program", "free directions"};

    fprintf(file, "sigma, times the noise of a position mean\n\n");
    tabular_begin(file, request->limits ? "lrrrrrr" : "lrrrrr");
    tabular_heading("|positions|minutes|offsets|scales|angles|worst/limit");
    if (request->limits) {
        add_limits(request->limits);
    }
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        if (c->is_found[f]) {
            add_candidate(c->set[f], request);
        } else {
            tabular_cell("%s", families[f]);
            tabular_cell("none");
            tabular_row();
        }
    }
    tabular_end();
    wrapped_printf(file, 0, "%sChosen:%s %s, %s, with %u redundant position%s or more%s",
                   paint_on(file, PAINT_GREEN), paint_off(file), c->set[c->chosen]->name,
                   request->limits ? "the smallest within the limits"
                                   : "the largest determinant in the time",
                   request->spare, request->spare == 1 ? "" : "s",
                   request->needs_axes ? " and each axis up and down" : "");
    putc('\n', file);
}

/* The time, as the paper counts it. */
static void print_labour(FILE *file, const design *d, const design_cost *cost)
{
    const design_labour l = design_labour_of(d->count, cost);
    const unsigned distinct = design_distinct(d);

    char settle[PLAN_WORDS_MAX] = "";

    wrapped_printf(file, 0,
                   "%.4g minutes: %.4g to warm up, %.4g to settle, %.4g to turn, %.4g to record",
                   design_seconds(d->count, cost) / 60, l.warm_up / 60, l.settling / 60,
                   l.turning / 60, l.recording / 60);
    if (cost->settle > 0) {
        snprintf(settle, sizeof settle, ", and %.6g s to settle in each", cost->settle);
    }
    wrapped_printf(file, 0, "%.6g s in each position%s and %.6g s between positions%s", cost->dwell,
                   d->has_shares ? " on average" : "", cost->move, settle);
    if (distinct < d->count) {
        fprintf(file, "%u positions in %u directions\n", d->count, distinct);
    }
    putc('\n', file);
}

static void print_title(FILE *file, const design *d)
{
    char start[INVCAL_PLAN_GROUPS][PLAN_WORDS_MAX];
    char groups[4 * PLAN_WORDS_MAX] = "";

    if (d->plan.per_group > 0) {
        for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
            plan_angle_text(d->plan.start_deg[g], start[g]);
        }
        snprintf(groups, sizeof groups, " in 3 groups of %u, starting at %s, %s, %s degrees",
                 d->plan.per_group, start[0], start[1], start[2]);
    }
    wrapped_printf(file, 0, "%s%s:%s %u positions%s", paint_on(file, PAINT_BOLD), d->name,
                   paint_off(file), d->count, groups);
}

void plan_print(FILE *file, const design *d, const choice_request *request, const choice *c)
{
    const double noise = request->cost.noise > 0 ? design_noise(&request->cost) : 0;

    if (c) {
        print_choice(file, c, request);
    }
    if (request->labour) {
        labour_print(file, request->labour);
    }
    print_title(file, d);
    print_labour(file, d, &request->cost);
    print_positions(file, d);
    if (d->is_solvable) {
        print_sigmas(file, d, noise, request->units);
        plan_nonlinear_print(file, d, noise, request->units);
        if (d->has_shares) {
            print_shares(file, d);
        }
        if (request->bound > 0) {
            print_bound(file, d, request->bound, request->units);
        }
        print_verdict(file, d, request);
    }
    print_coverage(file, d);
    if (d->plan.per_group > 0) {
        print_groups(file, &d->plan);
    }
}

void plan_print_sweep(FILE *file, const plan_sweep *s)
{
    char text[PLAN_WORDS_MAX];

    wrapped_printf(file, 0, "The paper's programs; sigma times the noise of a position mean");
    putc('\n', file);
    tabular_begin(file, "rrrrrrrr");
    tabular_heading("N|positions|offsets|scales|angles|condition|ln det H'H|axes up");
    for (unsigned i = 0; i < s->count; i++) {
        const criteria *c = &s->rows[i].criteria;
        tabular_cell("%u", s->rows[i].per_group);
        tabular_cell("%u", c->positions);
        for (unsigned k = 0; k < PLAN_KINDS; k++) {
            tabular_cell("%.6f", plan_sigma(c, k));
        }
        tabular_cell("%.4f", c->condition);
        tabular_cell("%.4f", c->log_det);
        tabular_cell("%s", plan_missing_axes(s->rows[i].axes)
                               ? plan_axes_text(s->rows[i].axes, text)
                               : "all six");
        tabular_row();
    }
    tabular_end();
}

/* A figure of two sets, and their ratio. */
static void add_pair(const char *what, double a, double b)
{
    tabular_cell("%s", what);
    tabular_cell("%.6g", a);
    tabular_cell("%.6g", b);
    tabular_cell("%.4f", b / a);
    tabular_row();
}

static void add_in_units(const char *what, display_unit unit, const design_cost *cost, double a,
                         double b)
{
    const double noise = design_noise(cost);
    char text[PLAN_WORDS_MAX];

    snprintf(text, sizeof text, "%s, %s", what, unit.unit);
    add_pair(text, unit.scale * noise * a, unit.scale * noise * b);
}

static void add_axes(const design *a, const design *b)
{
    const design *const sets[] = {a, b};
    char text[PLAN_WORDS_MAX];

    tabular_cell("axes missing");
    for (unsigned s = 0; s < 2; s++) {
        const unsigned missing = plan_missing_axes(sets[s]->axes);
        tabular_cell("%s", missing ? plan_axes_text(missing, text) : "none");
    }
    tabular_row();
    for (unsigned i = 0; i < 3; i++) {
        tabular_cell("range of %c, g", "xyz"[i]);
        for (unsigned s = 0; s < 2; s++) {
            tabular_cell("%+.3f ... %+.3f", sets[s]->range[i][0], sets[s]->range[i][1]);
        }
        tabular_row();
    }
}

void plan_print_comparison(FILE *file, const design *a, const design *b,
                           const choice_request *request)
{
    const design_cost *cost = &request->cost;
    const criteria *p = &a->criteria;
    const criteria *q = &b->criteria;

    wrapped_printf(file, 0,
                   "Two sets; sigma times the noise of a position mean; ratio of the second to the "
                   "first");
    putc('\n', file);
    tabular_begin(file, "lrrr");
    tabular_cell("%s", "");
    tabular_cell("%.23s", a->name);
    tabular_cell("%.23s", b->name);
    tabular_cell("ratio");
    tabular_row_in(PAINT_BOLD);
    add_pair("positions", a->count, b->count);
    add_pair("minutes", design_seconds(a->count, cost) / 60, design_seconds(b->count, cost) / 60);
    add_pair("sigma offsets", p->sigma_delta, q->sigma_delta);
    add_pair("sigma scales", p->sigma_dk, q->sigma_dk);
    add_pair("sigma angles", p->sigma_gamma, q->sigma_gamma);
    if (cost->noise > 0) {
        const unit_style style = request->units;
        add_in_units("offsets", unit_style_field(style, 1), cost, p->sigma_delta, q->sigma_delta);
        add_in_units("scales", unit_style_scale(style), cost, p->sigma_dk, q->sigma_dk);
        add_in_units("angles", unit_style_angle(style), cost, p->sigma_gamma, q->sigma_gamma);
    }
    add_pair("condition", p->condition, q->condition);
    tabular_cell("ln det H'H");
    tabular_cell("%.6g", p->log_det);
    tabular_cell("%.6g", q->log_det);
    tabular_row();
    add_axes(a, b);
    tabular_end();
}
