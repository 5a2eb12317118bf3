/* SPDX-License-Identifier: MIT */
#include "report/facts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/plan.h"
#include "invcal/positions.h"
#include "cli/command.h"
#include "result/need.h"
#include "text/number.h"
#include "plan/guidance.h"

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Lengths before and after, and up directions. */
static void find_positions(report_facts *f)
{
    const calibrate_result *r = f->result;

    for (unsigned n = 0; n < f->count; n++) {
        report_position *at = &f->position[n];
        double v[3];
        invcal_apply(&r->settings.nominal, r->data->mean[3 * (size_t)n],
                     r->data->mean[3 * (size_t)n + 1], r->data->mean[3 * (size_t)n + 2], v);
        at->before = f->scale * (length(v) - 1);
        const invcal_calibration here = calibrate_at_position(r, n);
        calibrate_linear_reading(r, n, v);
        invcal_apply(&here, v[0], v[1], v[2], v);
        at->after = f->scale * calibrate_excess(r, n);
        for (unsigned i = 0; i < 3; i++) {
            at->up[i] = length(v) > 0 ? v[i] / length(v) : i == 2;
        }
    }
    for (unsigned k = 0; k < r->rejected.count; k++) {
        f->position[r->rejected.list[k].position].is_left_out = 1;
    }
}

/* For a magnetometer: the direction to point along the field. North of the magnetic equator the
 * field points down, so the opposite direction is up. */
static void find_next_along(report_facts *f)
{
    const double *along = f->result->magnetometer->next;
    const double up[3] = {-along[0], -along[1], -along[2]};

    memcpy(f->next, along, sizeof f->next);
    (void)invcal_direction_text(up, f->next_words);
}

/* The direction to measure next, given the positions kept. Returns 0 without memory. */
static int find_next(report_facts *f)
{
    const unsigned kept = f->result->rejected.kept_count;

    if (f->result->magnetometer) {
        find_next_along(f);
        return 1;
    }
    double *raw = calloc(3 * (size_t)kept + 1, sizeof *raw);
    if (!raw) {
        return 0;
    }
    for (unsigned n = 0; n < kept; n++) {
        calibrate_reference_reading(f->result, n, &raw[3 * (size_t)n]);
    }
    const invcal_positions given = fit_positions(raw, kept, &f->result->solution.symmetric, 0);
    invcali_next(&given, f->next);
    (void)invcal_direction_text(f->next, f->next_words);
    free(raw);
    return 1;
}

static void set_marks(report_facts *f)
{
    for (unsigned n = 0; n < f->count; n++) {
        memcpy(f->mark[n].up, f->position[n].up, sizeof f->mark[n].up);
        f->mark[n].kind = f->position[n].is_left_out ? SPHERE_LEFT_OUT : SPHERE_POSITION;
    }
    memcpy(f->mark[f->count].up, f->next, sizeof f->next);
    f->mark[f->count].kind = SPHERE_NEXT;
}

/* For parameters from a prior, the ± is 1.96 sigma. */
static double worst_length(const report_facts *f)
{
    const fit_quality *q = &f->result->quality;
    uncertainty one;

    calibrate_uncertainty(f->result, f->noise, &one);
    return f->knows_noise ? uncertainty_half_width(&one, one.worst, q->coverage, q->from_prior)
                          : f->length_spread.max;
}

int report_facts_find(report_facts *f, const calibrate_result *result,
                      const calibrate_invocation *invocation)
{
    *f = (report_facts){
        .result = result, .invocation = invocation, .count = result->data->count, .has_up = 1};
    f->outcome = pass_judge(result);
    f->is_gravity = calibrate_is_gravity(result);
    f->scale = unit_style_page_field(result->units, f->is_gravity).scale;
    f->unit = unit_style_page_field(result->units, f->is_gravity).unit;
    f->length = f->is_gravity ? "|a|" : "length";
    f->has_before = !nominal_is_guess(&result->nominal);
    f->knows_noise = calibrate_knows_noise(result);
    f->coverage = f->knows_noise ? result->quality.coverage : NUMBER_UNKNOWN;
    f->noise = f->knows_noise ? f->scale * result->quality.noise : 1;
    f->position = calloc(f->count, sizeof *f->position);
    f->mark = calloc((size_t)f->count + 1, sizeof *f->mark);
    if (!f->position || !f->mark || !find_next(f)) {
        message("%s: not enough memory for a report of %u positions", result->data->name, f->count);
        return EXIT_FILE;
    }
    find_positions(f);
    calibrate_uncertainty(result, f->knows_noise ? f->coverage * f->noise : REPORT_NORMAL,
                          &f->length_spread);
    f->length_worst = worst_length(f);
    f->field_spread = f->knows_noise ? f->scale * need_field_part(result) : 0;
    set_marks(f);
    return EXIT_GOOD;
}

display_unit report_unit(const report_facts *f, unsigned kind)
{
    const unit_style style = f->result->units;
    const display_unit degrees = {FIGURE_DEGREES, "°"};

    return kind == 0                 ? unit_style_page_field(style, f->is_gravity)
           : kind == 1               ? unit_style_scale(style)
           : style == UNIT_STYLE_INS ? unit_style_angle(style)
                                     : degrees;
}

void report_facts_release(report_facts *f)
{
    free(f->position);
    free(f->mark);
    f->position = NULL;
    f->mark = NULL;
}
