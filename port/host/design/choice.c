/* SPDX-License-Identifier: MIT */
#include "design/choice.h"

#include <math.h>
#include <stdio.h>

#include "invcal/plan.h"
#include "cli/command.h"
#include "design/optimal.h"
#include "design/order.h"

#define LIMIT_TOLERANCE (1 + 1e-9) /* so that rounding does not refuse a limit that is just met */

double choice_worst(const criteria *c, const double limits[3])
{
    return fmax(c->sigma_delta / limits[0],
                fmax(c->sigma_dk / limits[1], c->sigma_gamma / limits[2]));
}

unsigned choice_min_count(const choice_request *request)
{
    return INVCAL_PARAMETERS + request->spare;
}

unsigned choice_stand_step(int needs_axes)
{
    return needs_axes ? 2 : 1;
}

/* The positions that fit into the budget, at most DESIGN_MAX. */
static unsigned positions_allowed(const choice_request *request)
{
    const design_cost *cost = &request->cost;

    if (!(request->budget > 0)) {
        return DESIGN_MAX;
    }
    /* n rests and n - 1 moves; plus 1e-9 of one, so that rounding keeps the last one */
    const double period = cost->settle + cost->dwell + cost->move;
    const double n = floor((request->budget - cost->warm_up + cost->move) / period + 1e-9);
    return n < DESIGN_MAX ? (unsigned)fmax(n, 0) : DESIGN_MAX; /* never a NaN: all are in range */
}

static int stand(design *d, unsigned per_group)
{
    const invcal_plan plan = stand_plan_make(per_group);

    design_stand(d, &plan);
    return 1;
}

/* Sigma falls with N, so bisection finds the smallest program within the limits. */
static int choose_stand(design *d, const choice_request *request, unsigned allowed)
{
    const unsigned step = choice_stand_step(request->needs_axes);
    const unsigned spared =
        (choice_min_count(request) + INVCAL_PLAN_GROUPS - 1) / INVCAL_PLAN_GROUPS;
    const unsigned min = spared > INVCAL_PLAN_PER_GROUP_MIN ? spared : INVCAL_PLAN_PER_GROUP_MIN;
    unsigned low = (min + step - 1) / step; /* N over step */
    unsigned high = allowed / INVCAL_PLAN_GROUPS / step;

    if (high < low) {
        return 0;
    }
    stand(d, step * high);
    if (!request->limits) {
        return 1;
    }
    if (!(choice_worst(&d->criteria, request->limits) <= LIMIT_TOLERANCE)) {
        return 0;
    }
    while (low < high) {
        const unsigned middle = (low + high) / 2;
        stand(d, step * middle);
        if (choice_worst(&d->criteria, request->limits) <= LIMIT_TOLERANCE) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return stand(d, step * high);
}

/* One more position can only reduce the worst ratio, so bisection finds the smallest number between
 * the minimum and `high`, which meets the limits. */
static void choose_smallest(design *d, const choice_request *request, unsigned high)
{
    double direction[OPTIMAL_MAX][3];
    unsigned low = choice_min_count(request);

    while (low < high) {
        const unsigned middle = (low + high) / 2;
        if (optimal_within(middle, request->limits, request->needs_axes, direction) <=
            LIMIT_TOLERANCE) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    design_balanced(d, high, request->limits, request->needs_axes);
}

static int choose_free(design *d, const choice_request *request, unsigned allowed)
{
    const unsigned max = allowed < OPTIMAL_MAX ? allowed : OPTIMAL_MAX;
    double direction[OPTIMAL_MAX][3];

    if (max < choice_min_count(request)) {
        return 0;
    }
    if (!request->limits) {
        optimal_directions(max, request->needs_axes, direction);
        order_directions(direction, max);
        design_directions(d, "free directions", direction, max);
        return 1;
    }
    if (!(optimal_within(max, request->limits, request->needs_axes, direction) <=
          LIMIT_TOLERANCE)) {
        return 0;
    }
    choose_smallest(d, request, max);
    return d->is_solvable && choice_worst(&d->criteria, request->limits) <= LIMIT_TOLERANCE;
}

static void refuse(choice *c, const choice_request *request, unsigned allowed)
{
    if (allowed < choice_min_count(request)) {
        snprintf(c->refusal, sizeof c->refusal,
                 "only %u position%s into %.6g s with %.6g s in each and %.6g s between; the "
                 "minimum is %u, nine and a redundancy of %u",
                 allowed, allowed == 1 ? " fits" : "s fit", request->budget, request->cost.dwell,
                 request->cost.move, choice_min_count(request), request->spare);
    } else {
        snprintf(c->refusal, sizeof c->refusal,
                 "no program of up to %u positions%s meets the limits: dwell longer, use a quieter "
                 "sensor, or relax the limits",
                 allowed, request->budget > 0 ? "within the budget" : "");
    }
}

/* The better of two sets that are both found. */
static unsigned better_set(const choice *c, const choice_request *request)
{
    const criteria *stand_set = &c->set[CHOICE_STAND]->criteria;
    const criteria *free_set = &c->set[CHOICE_FREE]->criteria;

    if (!request->limits) {
        return free_set->log_det > stand_set->log_det ? CHOICE_FREE : CHOICE_STAND;
    }
    if (free_set->positions != stand_set->positions) {
        return free_set->positions < stand_set->positions ? CHOICE_FREE : CHOICE_STAND;
    }
    return c->worst[CHOICE_FREE] < c->worst[CHOICE_STAND] ? CHOICE_FREE : CHOICE_STAND;
}

int choice_make(choice *c, const choice_request *request)
{
    const unsigned allowed = positions_allowed(request);

    c->is_found[CHOICE_STAND] = choose_stand(c->set[CHOICE_STAND], request, allowed);
    c->is_found[CHOICE_FREE] = choose_free(c->set[CHOICE_FREE], request, allowed);
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        if (c->is_found[f] && request->limits) {
            c->worst[f] = choice_worst(&c->set[f]->criteria, request->limits);
        }
    }
    if (c->is_found[CHOICE_STAND] && c->is_found[CHOICE_FREE]) {
        c->chosen = better_set(c, request);
    } else {
        c->chosen = c->is_found[CHOICE_STAND] ? CHOICE_STAND : CHOICE_FREE;
    }
    if (!c->is_found[c->chosen]) {
        refuse(c, request, allowed);
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}
