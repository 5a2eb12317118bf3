/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "figure.h"
#include "paint.h"
#include "parameters.h"
#include "plan_labour.h"
#include "plan_words.h"
#include "series.h"

static void print_positions(FILE *file, const design *d)
{
    char alpha[PLAN_WORDS_MAX];
    char beta[PLAN_WORDS_MAX];

    fprintf(file, "%s%15s%20s   %27s\n", paint_on(file, PAINT_BOLD), "", "stand, degrees",
            "up in the case's frame");
    fprintf(file, "%8s%7s%10s%10s   %9s%9s%9s%s\n", "position", d->plan.per_group ? "group" : "",
            "alpha", "beta", "x", "y", "z", paint_off(file));
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
        putc('\n', file);
    }
    putc('\n', file);
}

/* One sigma: over the noise, and in units if the noise is told. */
static void print_sigma(FILE *file, const char *what, double sigma, const char *unit, double scale)
{
    fprintf(file, "  %-15s%9.4f", what, sigma);
    if (scale > 0) {
        fprintf(file, "%12.4g %s", scale * sigma, unit);
    }
    putc('\n', file);
}

static void print_sigmas(FILE *file, const design *d, const design_cost *cost)
{
    const double noise = cost->noise > 0 ? design_noise(cost) : 0;
    const criteria *c = &d->criteria;

    fprintf(file, "%ssigma%s, times the noise of a position mean", paint_on(file, PAINT_BOLD),
            paint_off(file));
    if (noise > 0) {
        fprintf(file, ", which is %.4g mg", 1e3 * noise);
    }
    fprintf(file, "\n");
    print_sigma(file, "offsets", c->sigma_delta, "mg", 1e3 * noise);
    print_sigma(file, "scale errors", c->sigma_dk, "%", 1e2 * noise);
    print_sigma(file, "angles", c->sigma_gamma, "degrees", FIGURE_DEGREES * noise);
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

    fprintf(file, "%-24.24s%10u%10.6g%10.4f%10.4f%10.4f", d->name, d->count,
            design_seconds(d->count, &request->cost), c->sigma_delta, c->sigma_dk, c->sigma_gamma);
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
            "seconds", "offsets", "scales", "angles", request->limits ? "   worst/limit" : "",
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
    fprintf(file, "%sChosen:%s %s, %s\n\n", paint_on(file, PAINT_GREEN), paint_off(file),
            c->set[c->chosen]->name,
            request->limits ? "the smallest within the limits"
                            : "the largest determinant in the time");
}

void plan_print(FILE *file, const design *d, const choice_request *request, const choice *c)
{
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
    fprintf(file, "\n%.6g s, with %.6g s in each position and %.6g s between two",
            design_seconds(d->count, &request->cost), request->cost.dwell, request->cost.move);
    if (request->cost.settle > 0) {
        fprintf(file, ", and %.6g s to settle in each", request->cost.settle);
    }
    fprintf(file, "\n\n");
    print_positions(file, d);
    if (d->is_solvable) {
        print_sigmas(file, d, &request->cost);
        print_verdict(file, d, request);
    }
    print_coverage(file, d);
    if (d->plan.per_group > 0) {
        print_groups(file, &d->plan);
    }
}

void plan_print_sweep(FILE *file, const plan_row *rows, unsigned count)
{
    char text[PLAN_WORDS_MAX];

    fprintf(file, "The paper's programs; sigma times the noise of a position mean\n\n");
    fprintf(file, "%s%9s%11s%10s%10s%10s%11s%12s   %s%s\n", paint_on(file, PAINT_BOLD), "per group",
            "positions", "offsets", "scales", "angles", "condition", "ln det H'H",
            "axes along gravity", paint_off(file));
    for (unsigned i = 0; i < count; i++) {
        const criteria *c = &rows[i].criteria;
        fprintf(file, "%9u%11u%10.6f%10.6f%10.6f%11.4f%12.4f   %s\n", rows[i].per_group,
                c->positions, c->sigma_delta, c->sigma_dk, c->sigma_gamma, c->condition, c->log_det,
                plan_missing(rows[i].axes) ? plan_axes_text(rows[i].axes, text) : "all six");
    }
}

static void print_pair(FILE *file, const char *what, double a, double b)
{
    fprintf(file, "%-16s%24.6g%24.6g%12.4f\n", what, a, b, b / a);
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
    print_pair(file, "seconds", design_seconds(a->count, cost), design_seconds(b->count, cost));
    print_pair(file, "sigma offsets", p->sigma_delta, q->sigma_delta);
    print_pair(file, "sigma scales", p->sigma_dk, q->sigma_dk);
    print_pair(file, "sigma angles", p->sigma_gamma, q->sigma_gamma);
    if (cost->noise > 0) {
        const double noise = design_noise(cost);
        print_pair(file, "offsets, mg", 1e3 * noise * p->sigma_delta, 1e3 * noise * q->sigma_delta);
        print_pair(file, "scales, %", 1e2 * noise * p->sigma_dk, 1e2 * noise * q->sigma_dk);
        print_pair(file, "angles, degrees", FIGURE_DEGREES * noise * p->sigma_gamma,
                   FIGURE_DEGREES * noise * q->sigma_gamma);
    }
    print_pair(file, "condition", p->condition, q->condition);
    fprintf(file, "%-16s%24.6g%24.6g\n", "ln det H'H", p->log_det, q->log_det);
    print_axes_pair(file, a, b);
}
