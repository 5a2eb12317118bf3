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

static void print_positions(FILE *file, const design *d)
{
    char alpha[PLAN_WORDS_MAX];
    char beta[PLAN_WORDS_MAX];

    fprintf(file, "%s%15s%20s   %27s\n", paint_on(file, PAINT_BOLD), "", "stand, degrees",
            "up in the case's frame");
    fprintf(file, "%8s%7s%10s%10s   %9s%9s%9s%s%s\n", "position",
            design_has_groups(d) ? "group" : "", "alpha", "beta", "x", "y", "z",
            d->has_shares ? "     share" : "", paint_off(file));
    for (unsigned i = 0; i < d->count; i++) {
        const design_position *p = &d->position[i];
        char group[16] = "";
        if (p->group > 0) {
            snprintf(group, sizeof group, "%u", p->group);
        }
        fprintf(file, "%8u%7s%10s%10s   ", i + 1, group, plan_angle_text(p->alpha, alpha),
                plan_angle_text(p->beta, beta));
        for (unsigned k = 0; k < 3; k++) {
            fprintf(file, "%9.4f", nearbyint(1e4 * p->vertical[k]) / 1e4 + 0.0);
        }
        if (d->has_shares) {
            fprintf(file, "%10.6f", p->share / d->count);
        }
        putc('\n', file);
    }
    putc('\n', file);
}

/* One sigma: over the noise, and in units if the noise is told. */
static void print_sigma(FILE *file, const char *what, double sigma, double noise, told_unit unit)
{
    fprintf(file, "  %-15s%9.4f", what, sigma);
    if (noise > 0) {
        fprintf(file, "%12.4g %s", unit.scale * noise * sigma, unit.unit);
    }
    putc('\n', file);
}

static void print_sigmas(FILE *file, const design *d, double noise, told_style told)
{
    const told_unit field = told_field(told, 1);
    const criteria *c = &d->criteria;

    fprintf(file, "%ssigma%s, times the noise of a position mean", paint_on(file, PAINT_BOLD),
            paint_off(file));
    if (noise > 0) {
        fprintf(file, ", which is %.4g %s", field.scale * noise, field.unit);
    }
    fprintf(file, "\n");
    print_sigma(file, "offsets", c->sigma_delta, noise, field);
    print_sigma(file, "scale errors", c->sigma_dk, noise, told_scale(told));
    print_sigma(file, "angles", c->sigma_gamma, noise, told_angle(told));
    fprintf(file, "condition %.4f (1 is the best), ln det H'H %.4f (more is better)\n",
            c->condition, c->log_det);
    if (isfinite(d->hidden)) {
        fprintf(file,
                "visited in this order, to tell a drift apart costs %.2f times sigma at most\n",
                d->hidden);
    } else {
        fprintf(file, "visited in this order, a drift cannot be told from the nine parameters\n");
    }
}

/* How the time is shared, and what that makes of the determinant. */
static void print_shares(FILE *file, const design *d)
{
    unsigned unused = 0;

    for (unsigned i = 0; i < d->count; i++) {
        unused += !(d->position[i].share > 0);
    }
    fprintf(file,
            "with these shares of the time; with equal ones ln det H'H is %.4f, and %u positions\n"
            "anywhere have %.4f at most\n",
            d->equal_log_det, d->count, weights_bound(d->count));
    if (unused > 0) {
        fprintf(file,
                "%u position%s no share: det H'H is larger without; take %s for the whole\n"
                "range and for nonlinearity\n",
                unused, unused == 1 ? " has" : "s have", unused == 1 ? "it" : "them");
    }
}

/* The most that each parameter can be wrong by: the three of a kind, and the largest in units. */
static void print_bound(FILE *file, const design *d, double error, told_style told)
{
    const told_unit units[PLAN_KINDS] = {told_field(told, 1), told_scale(told), told_angle(told)};
    double bound[INVCAL_PARAMETERS];

    bound_find(d, bound);
    fprintf(file, "%sguaranteed%s, if no position mean is off by more than %.4g %s; times that\n",
            paint_on(file, PAINT_BOLD), paint_off(file), units[0].scale * error, units[0].unit);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        const double *b = &bound[3 * (size_t)k];
        fprintf(file, "  %-15s%9.4f%9.4f%9.4f   at most %.4g %s\n", plan_kinds[k], b[0], b[1], b[2],
                units[k].scale * error * bound_largest(bound, k), units[k].unit);
    }
}

/* What invcal calibrate would say of such a set, and how it stands to the limits. */
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
        fprintf(file,
                "nine positions for nine parameters: nothing checks the result; three more are "
                "good\n");
    }
    if (!(plan_sigma_largest(c) <= PLAN_WEAK)) {
        fprintf(file, "%sweak:%s a sigma above %g times the noise is of little use\n",
                paint_on(file, PAINT_RED), paint_off(file), PLAN_WEAK);
    }
}

/* What each axis feels, and which stand along gravity. */
static void print_coverage(FILE *file, const design *d)
{
    const unsigned missing = plan_missing(d->axes);
    char text[PLAN_WORDS_MAX];

    fprintf(file, "range used: ");
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%s%c %+.2f ... %+.2f g", i > 0 ? ", " : "", "xyz"[i], d -> range[i][0],
                d -> range[i][1]);
    }
    if (missing == 0) {
        fprintf(file, "\naxes along gravity: all six\n");
        return;
    }
    fprintf(file, "\naxes along gravity: %s; missing: ",
            d->axes ? plan_axes_text(d->axes, text) : "none");
    fprintf(file, "%s\n", plan_axes_text(missing, text));
    if (d->plan.per_group > 0) {
        fprintf(file, "%s\n", plan_missing_reason(d));
    }
}

static void print_groups(FILE *file, const invcal_plan *plan)
{
    const double half = plan->per_group / 2.0;
    const double bound = plan->per_group * half * half * half * half;
    double sums[INVCAL_PACKED_SIZE(SERIES_TERMS)];

    fprintf(file, "det H5'H5 of the groups over %.8g, the most of %u positions on a circle:", bound,
            plan->per_group);
    for (unsigned g = 1; g <= INVCAL_PLAN_GROUPS; g++) {
        (void)series_information(plan, g, sums); /* the plan is usable */
        fprintf(file, " %.4f", series_efficiency(sums));
    }
    putc('\n', file);
}

static void print_candidate(FILE *file, const design *d, const choice_request *request)
{
    const criteria *c = &d->criteria;

    fprintf(file, "%-24.24s%10u%10.4g%10.4f%10.4f%10.4f", d->name, d->count,
            design_seconds(d->count, &request->cost) / 60, c->sigma_delta, c->sigma_dk,
            c->sigma_gamma);
    if (request->limits) {
        fprintf(file, "%14.4f", choice_worst(c, request->limits));
    }
    putc('\n', file);
}

static void print_choice(FILE *file, const choice *c, const choice_request *request)
{
    static const char *const families[] = {"stand program", "free directions"};

    fprintf(file, "sigma, times the noise of a position mean\n\n");
    fprintf(file, "%s%-24s%10s%10s%10s%10s%10s%s%s\n", paint_on(file, PAINT_BOLD), "", "positions",
            "minutes", "offsets", "scales", "angles", request->limits ? "   worst/limit" : "",
            paint_off(file));
    if (request->limits) {
        fprintf(file, "%-24s%10s%10s%10.4f%10.4f%10.4f%14.4f\n", "limits", "", "",
                request->limits[0], request->limits[1], request->limits[2], 1.0);
    }
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        if (c->is_found[f]) {
            print_candidate(file, c->set[f], request);
        } else {
            fprintf(file, "%-24s%10s\n", families[f], "none");
        }
    }
    fprintf(file, "%sChosen:%s %s, %s,\nwith %u position%s to spare or more%s\n\n",
            paint_on(file, PAINT_GREEN), paint_off(file), c->set[c->chosen]->name,
            request->limits ? "the smallest within the limits"
                            : "the largest determinant in the time",
            request->spare, request->spare == 1 ? "" : "s",
            request->needs_axes ? " and each axis up and down" : "");
}

/* The time, as the paper counts it. */
static void print_labour(FILE *file, const design *d, const design_cost *cost)
{
    const design_labour l = design_labour_of(d->count, cost);
    const unsigned distinct = design_distinct(d);

    fprintf(file, "%.4g minutes: %.4g to warm up, %.4g to settle, %.4g to turn, %.4g to record\n",
            design_seconds(d->count, cost) / 60, l.warm_up / 60, l.settling / 60, l.turning / 60,
            l.recording / 60);
    fprintf(file, "%.6g s in each position%s and %.6g s between two", cost->dwell,
            d->has_shares ? " on the average" : "", cost->move);
    if (cost->settle > 0) {
        fprintf(file, ", and %.6g s to settle in each", cost->settle);
    }
    putc('\n', file);
    if (distinct < d->count) {
        fprintf(file, "%u positions in %u directions\n", d->count, distinct);
    }
    putc('\n', file);
}

void plan_print(FILE *file, const design *d, const choice_request *request, const choice *c)
{
    const double noise = request->cost.noise > 0 ? design_noise(&request->cost) : 0;
    char start[INVCAL_PLAN_GROUPS][PLAN_WORDS_MAX];

    if (c) {
        print_choice(file, c, request);
    }
    if (request->labour) {
        labour_print(file, request->labour);
    }
    fprintf(file, "%s%s:%s %u positions", paint_on(file, PAINT_BOLD), d->name, paint_off(file),
            d->count);
    if (d->plan.per_group > 0) {
        for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
            plan_angle_text(d->plan.start[g], start[g]);
        }
        fprintf(file, " in 3 groups of %u, starting at %s, %s, %s degrees", d->plan.per_group,
                start[0], start[1], start[2]);
    }
    putc('\n', file);
    print_labour(file, d, &request->cost);
    print_positions(file, d);
    if (d->is_solvable) {
        print_sigmas(file, d, noise, request->told);
        plan_nonlinear_print(file, d, noise, request->told);
        if (d->has_shares) {
            print_shares(file, d);
        }
        if (request->bound > 0) {
            print_bound(file, d, request->bound, request->told);
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

    fprintf(file, "The paper's programs; sigma times the noise of a position mean\n\n");
    fprintf(file, "%s%9s%11s%10s%10s%10s%11s%12s   %s%s\n", paint_on(file, PAINT_BOLD), "per group",
            "positions", "offsets", "scales", "angles", "condition", "ln det H'H",
            "axes along gravity", paint_off(file));
    for (unsigned i = 0; i < s->count; i++) {
        const criteria *c = &s->rows[i].criteria;
        fprintf(file, "%9u%11u%10.6f%10.6f%10.6f%11.4f%12.4f   %s\n", s->rows[i].per_group,
                c->positions, c->sigma_delta, c->sigma_dk, c->sigma_gamma, c->condition, c->log_det,
                plan_missing(s->rows[i].axes) ? plan_axes_text(s->rows[i].axes, text) : "all six");
    }
}

static void print_pair(FILE *file, const char *what, double a, double b)
{
    fprintf(file, "%-*s%24.6g%24.6g%12.4f\n", paint_width(what, 16), what, a, b, b / a);
}

static void print_in_units(FILE *file, const char *what, told_unit unit, const design_cost *cost,
                           double a, double b)
{
    const double noise = design_noise(cost);
    char text[PLAN_WORDS_MAX];

    snprintf(text, sizeof text, "%s, %s", what, unit.unit);
    print_pair(file, text, unit.scale * noise * a, unit.scale * noise * b);
}

static void print_axes_pair(FILE *file, const design *a, const design *b)
{
    char text[2][PLAN_WORDS_MAX];

    fprintf(file, "%-16s%24s%24s\n", "axes missing",
            plan_missing(a->axes) ? plan_axes_text(plan_missing(a->axes), text[0]) : "none",
            plan_missing(b->axes) ? plan_axes_text(plan_missing(b->axes), text[1]) : "none");
    for (unsigned i = 0; i < 3; i++) {
        snprintf(text[0], PLAN_WORDS_MAX, "%+.3f ... %+.3f", a->range[i][0], a->range[i][1]);
        snprintf(text[1], PLAN_WORDS_MAX, "%+.3f ... %+.3f", b->range[i][0], b->range[i][1]);
        fprintf(file, "range of %c, g    %23s%24s\n", "xyz"[i], text[0], text[1]);
    }
}

void plan_print_comparison(FILE *file, const design *a, const design *b,
                           const choice_request *request)
{
    const design_cost *cost = &request->cost;
    const criteria *p = &a->criteria;
    const criteria *q = &b->criteria;

    fprintf(file, "Two sets; sigma times the noise of a position mean; ratio of the second to the "
                  "first\n\n");
    fprintf(file, "%s%-16s%24.23s%24.23s%12s%s\n", paint_on(file, PAINT_BOLD), "", a->name, b->name,
            "ratio", paint_off(file));
    print_pair(file, "positions", a->count, b->count);
    print_pair(file, "minutes", design_seconds(a->count, cost) / 60,
               design_seconds(b->count, cost) / 60);
    print_pair(file, "sigma offsets", p->sigma_delta, q->sigma_delta);
    print_pair(file, "sigma scales", p->sigma_dk, q->sigma_dk);
    print_pair(file, "sigma angles", p->sigma_gamma, q->sigma_gamma);
    if (cost->noise > 0) {
        const told_style told = request->told;
        print_in_units(file, "offsets", told_field(told, 1), cost, p->sigma_delta, q->sigma_delta);
        print_in_units(file, "scales", told_scale(told), cost, p->sigma_dk, q->sigma_dk);
        print_in_units(file, "angles", told_angle(told), cost, p->sigma_gamma, q->sigma_gamma);
    }
    print_pair(file, "condition", p->condition, q->condition);
    fprintf(file, "%-16s%24.6g%24.6g\n", "ln det H'H", p->log_det, q->log_det);
    print_axes_pair(file, a, b);
}
