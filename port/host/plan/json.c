/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "design/bound.h"
#include "cli/command.h"
#include "text/json_write.h"
#include "maths/matrix.h"
#include "text/number.h"
#include "plan/results.h"
#include "plan/labour.h"
#include "plan/nonlinear.h"
#include "plan/programs.h"
#include "design/series.h"
#include "design/weights.h"

unsigned plan_missing_axes(uint8_t axes)
{
    return ~(unsigned)axes & ((1u << INVCAL_AXES) - 1);
}

static void write_criteria(json_writer *w, const criteria *c, int is_solvable)
{
    json_number(w, "sigma_delta", is_solvable ? c->sigma_delta : NUMBER_UNKNOWN);
    json_number(w, "sigma_dk", is_solvable ? c->sigma_dk : NUMBER_UNKNOWN);
    json_number(w, "sigma_gamma", is_solvable ? c->sigma_gamma : NUMBER_UNKNOWN);
    json_number(w, "condition", is_solvable ? c->condition : NUMBER_UNKNOWN);
    json_number(w, "log_det", is_solvable ? c->log_det : NUMBER_UNKNOWN);
}

static void write_axes(json_writer *w, uint8_t axes)
{
    json_names(w, "axes_covered", axes, INVCAL_AXES, design_axis_name);
    json_names(w, "missing", plan_missing_axes(axes), INVCAL_AXES, design_axis_name);
}

/* det(H5'H5) of the three groups, and its upper bound for positions on a circle. */
static void write_groups(json_writer *w, const invcal_plan *plan)
{
    const double half = plan->per_group / 2.0;
    const double bound = plan->per_group * half * half * half * half;
    double sums[INVCAL_PACKED_SIZE(SERIES_TERMS)];
    double det[INVCAL_PLAN_GROUPS];

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        (void)series_information(plan, g + 1, sums); /* the plan is usable */
        det[g] = bound * series_efficiency(sums);
    }
    json_vector(w, "group_det", det);
    json_number(w, "group_det_bound", bound);
}

static void write_positions(json_writer *w, const design *d)
{
    json_list(w, "positions");
    for (unsigned i = 0; i < d->count; i++) {
        const design_position *p = &d->position[i];
        json_object(w, NULL);
        if (p->group > 0) {
            json_number(w, "group", p->group);
        }
        json_number(w, "alpha", p->alpha);
        json_number(w, "beta", p->beta);
        json_vector(w, "vertical", p->vertical);
        if (d->has_shares) {
            json_number(w, "share", p->share / d->count);
        }
        json_object_end(w);
    }
    json_list_end(w);
}

/* K = (H'H)^-1, packed; the set is solvable. */
static void write_covariance(json_writer *w, const design *d)
{
    double work[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    criteria_information(&d->sums, work);
    json_symmetric(w, "hth", work, INVCAL_PARAMETERS);
    (void)matrix_invert_packed(work, INVCAL_PARAMETERS);
    json_symmetric(w, "covariance", work, INVCAL_PARAMETERS);
}

/* Time; sigma in units, if the noise is known; worst ratio of sigma to its limit. */
static void write_cost(json_writer *w, const design *d, const choice_request *request)
{
    const design_cost *cost = &request->cost;

    const design_labour l = design_labour_of(d->count, cost);

    json_number(w, "seconds", design_seconds(d->count, cost));
    json_object(w, "minutes");
    json_number(w, "warm_up", l.warm_up / 60);
    json_number(w, "settling", l.settling / 60);
    json_number(w, "turning", l.turning / 60);
    json_number(w, "recording", l.recording / 60);
    json_number(w, "total", design_seconds(d->count, cost) / 60);
    json_object_end(w);
    if (cost->noise > 0 && d->is_solvable) {
        const double noise = design_noise(cost);
        json_object(w, "expected");
        json_number(w, "delta", noise * d->criteria.sigma_delta);
        json_number(w, "dk", noise * d->criteria.sigma_dk);
        json_number(w, "gamma", noise * d->criteria.sigma_gamma);
        json_object_end(w);
    }
    if (request->limits && d->is_solvable) {
        json_vector(w, "limits", request->limits);
        json_number(w, "worst_ratio", choice_worst(&d->criteria, request->limits));
    }
}

/* Worst-case errors of the parameters. */
static void write_bound(json_writer *w, const design *d, double error)
{
    double bound[INVCAL_PARAMETERS];

    bound_find(d, bound);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        bound[r] *= error;
    }
    json_object(w, "bound");
    json_number(w, "error", error);
    json_vector(w, "delta", &bound[INVCAL_DELTA_X]);
    json_vector(w, "dk", &bound[INVCAL_DK_X]);
    json_vector(w, "gamma", &bound[INVCAL_GAMMA_XY]);
    json_object_end(w);
}

/* Only in the output of a single set. */
static void write_details(json_writer *w, const design *d, const choice_request *request)
{
    json_number(w, "directions", design_distinct(d));
    if (d->has_shares && d->is_solvable) {
        json_number(w, "equal_log_det", d->equal_log_det);
        json_number(w, "most_log_det", weights_bound(d->count));
    }
    if (d->is_solvable) {
        plan_nonlinear_json(w, d);
    }
    if (request->bound > 0 && d->is_solvable) {
        write_bound(w, d, request->bound);
    }
}

/* A set without its positions. */
static void write_summary(json_writer *w, const design *d, const choice_request *request)
{
    json_text(w, "name", d->name);
    if (d->plan.per_group > 0) {
        json_number(w, "per_group", d->plan.per_group);
        json_vector(w, "start", d->plan.start_deg);
    }
    json_number(w, "labour", d->count);
    json_number(w, "redundancy", (double)d->count - (double)INVCAL_PARAMETERS);
    write_criteria(w, &d->criteria, d->is_solvable);
    json_number(w, "drift_factor", isfinite(d->drift_factor) ? d->drift_factor : NUMBER_UNKNOWN);
    write_axes(w, d->axes);
    json_list(w, "range");
    for (unsigned i = 0; i < 3; i++) {
        json_numbers(w, NULL, d->range[i], 2);
    }
    json_list_end(w);
    if (d->plan.per_group > 0) {
        write_groups(w, &d->plan);
    }
    write_cost(w, d, request);
}

static void write_refusal(json_writer *w, const char *reason, uint16_t undetermined)
{
    json_text(w, "error", undetermined ? "undetermined" : "no program");
    json_text(w, "reason", reason);
    json_parameters(w, "undetermined", undetermined);
}

static void begin(json_writer *w, FILE *file)
{
    json_begin(w, file);
    json_text(w, "invcal", INVCAL_VERSION);
}

void plan_json(FILE *file, const design *d, const choice_request *request, const choice *c)
{
    json_writer w;

    begin(&w, file);
    if (!d->is_solvable) {
        write_refusal(&w, d->refusal, d->undetermined);
    }
    write_summary(&w, d, request);
    write_details(&w, d, request);
    write_positions(&w, d);
    if (d->is_solvable) {
        write_covariance(&w, d);
    }
    if (c) {
        json_list(&w, "candidates");
        for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
            if (c->is_found[f]) {
                json_object(&w, NULL);
                write_summary(&w, c->set[f], request);
                json_object_end(&w);
            }
        }
        json_list_end(&w);
    }
    if (request->labour) {
        labour_json(&w, request->labour);
    }
    json_end(&w);
}

void plan_json_sweep(FILE *file, const plan_sweep *s)
{
    json_writer w;

    begin(&w, file);
    json_list(&w, "rows");
    for (unsigned i = 0; i < s->count; i++) {
        json_object(&w, NULL);
        json_number(&w, "per_group", s->rows[i].per_group);
        json_number(&w, "positions", s->rows[i].criteria.positions);
        write_criteria(&w, &s->rows[i].criteria, 1);
        write_axes(&w, s->rows[i].axes);
        json_object_end(&w);
    }
    json_list_end(&w);
    json_end(&w);
}

/* Of b to a. */
static void write_ratio(json_writer *w, const design *a, const design *b,
                        const choice_request *request)
{
    json_object(w, "ratio");
    json_number(w, "labour", (double)b->count / a->count);
    json_number(w, "time",
                design_seconds(b->count, &request->cost) /
                    design_seconds(a->count, &request->cost));
    json_number(w, "sigma_delta", b->criteria.sigma_delta / a->criteria.sigma_delta);
    json_number(w, "sigma_dk", b->criteria.sigma_dk / a->criteria.sigma_dk);
    json_number(w, "sigma_gamma", b->criteria.sigma_gamma / a->criteria.sigma_gamma);
    json_object_end(w);
}

void plan_json_comparison(FILE *file, const design *a, const design *b,
                          const choice_request *request)
{
    json_writer w;

    begin(&w, file);
    json_list(&w, "plans");
    for (unsigned i = 0; i < 2; i++) {
        json_object(&w, NULL);
        write_summary(&w, i == 0 ? a : b, request);
        json_object_end(&w);
    }
    json_list_end(&w);
    write_ratio(&w, a, b, request);
    json_end(&w);
}

void plan_programs_json(FILE *file, const plan_programs *p, const choice_request *request)
{
    json_writer w;

    begin(&w, file);
    json_list(&w, "programs");
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        json_object(&w, NULL);
        write_summary(&w, &p->set[i], request);
        write_ratio(&w, p->paper, &p->set[i], request);
        json_object_end(&w);
    }
    json_list_end(&w);
    json_end(&w);
}

void plan_json_refusal(FILE *file, const char *reason, uint16_t undetermined)
{
    json_writer w;

    begin(&w, file);
    write_refusal(&w, reason, undetermined);
    json_end(&w);
}
