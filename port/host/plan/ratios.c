/* SPDX-License-Identifier: MIT */
#include "plan/ratios.h"

#include <math.h>

#include "text/figure.h"

static double noise_of(const choice_request *request)
{
    return request->cost.noise > 0 ? design_noise(&request->cost) : 0;
}

static void write_sigmas(const design *d, const choice_request *request, plan_ratio *ratio,
                         int is_b)
{
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        plan_ratio *r = &ratio[PLAN_RATIO_SIGMA + k];
        plan_sigma_text(k, plan_sigma(&d->criteria, k), noise_of(request), request->units,
                        is_b ? r->b : r->a);
    }
}

/* The volume of the nine-dimensional error ellipsoid is proportional to the root of 1 / det H'H;
 * its ninth root to the geometric mean of sigma along the principal axes. */
static double mean_sigma(const design *d)
{
    return exp(-d->criteria.log_det / (2 * INVCAL_PARAMETERS));
}

static void write_number(char text[PLAN_WORDS_MAX], double x)
{
    char number[FIGURE_MAX];

    snprintf(text, PLAN_WORDS_MAX, "%s", figure_digits(x, 3, number));
}

void plan_ratios(const design *a, const design *b, const choice_request *request,
                 plan_ratio ratio[PLAN_RATIOS])
{
    static const char *const names[PLAN_RATIOS] = {
        "positions",       "time",      "σ of offsets", "σ of scale errors", "σ of angles",
        "mean σ, × noise", "condition",
    };
    const double time[2] = {design_seconds(a->count, &request->cost),
                            design_seconds(b->count, &request->cost)};

    for (unsigned i = 0; i < PLAN_RATIOS; i++) {
        const int is_sigma = i >= PLAN_RATIO_SIGMA && i < PLAN_RATIO_MEAN;
        snprintf(ratio[i].name, PLAN_WORDS_MAX, "%s%s", names[i],
                 is_sigma ? plan_noise_suffix(noise_of(request)) : "");
    }
    snprintf(ratio[PLAN_RATIO_POSITIONS].a, PLAN_WORDS_MAX, "%u", a->count);
    snprintf(ratio[PLAN_RATIO_POSITIONS].b, PLAN_WORDS_MAX, "%u", b->count);
    ratio[PLAN_RATIO_POSITIONS].ratio = (double)b->count / a->count;
    plan_time_text(time[0], ratio[PLAN_RATIO_TIME].a);
    plan_time_text(time[1], ratio[PLAN_RATIO_TIME].b);
    ratio[PLAN_RATIO_TIME].ratio = time[1] / time[0];
    write_sigmas(a, request, ratio, 0);
    write_sigmas(b, request, ratio, 1);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        ratio[PLAN_RATIO_SIGMA + k].ratio =
            plan_sigma(&b->criteria, k) / plan_sigma(&a->criteria, k);
    }
    write_number(ratio[PLAN_RATIO_MEAN].a, mean_sigma(a));
    write_number(ratio[PLAN_RATIO_MEAN].b, mean_sigma(b));
    ratio[PLAN_RATIO_MEAN].ratio = mean_sigma(b) / mean_sigma(a);
    write_number(ratio[PLAN_RATIO_CONDITION].a, a->criteria.condition);
    write_number(ratio[PLAN_RATIO_CONDITION].b, b->criteria.condition);
    ratio[PLAN_RATIO_CONDITION].ratio = b->criteria.condition / a->criteria.condition;
}
