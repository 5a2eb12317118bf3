/* SPDX-License-Identifier: MIT
 *
 * design/choice.h: the smallest set of positions that meets limits, or the best that fits into a time.
 *
 * Two families compete: the paper's programs for a stand, of up to 3000 positions, and free
 * directions, of up to OPTIMAL_MAX. "The smallest" and "the best" are of these.
 */
#ifndef CHOICE_H
#define CHOICE_H

#include "design/design.h"
#include "cli/unit_style.h"

#define CHOICE_SPARE 3u /* positions to spare, unless something else is asked for */

struct labour;

typedef struct {
    const double *limits; /* of the sigma of delta, dk, gamma, over the noise of a position mean;
                             or null */
    double budget;        /* seconds; 0: no limit */
    unsigned spare;       /* positions beyond the nine that nine parameters need, at least */
    int needs_axes;       /* each axis is to stand along gravity, up and down */
    double bound;         /* no position mean is off by more, over the field; 0: not asked for */
    design_cost cost;
    unit_style units;            /* the units of sigma, where the noise is known */
    const struct labour *labour; /* what dwell and number were chosen by (plan/labour.h), or null */
} choice_request;

enum { CHOICE_STAND, CHOICE_FREE, CHOICE_FAMILIES };

typedef struct {
    design *set[CHOICE_FAMILIES];  /* the best of each family; where is_found is 0 without
                                         meaning */
    int is_found[CHOICE_FAMILIES]; /* the family has one that meets the limits and fits */
    double worst[CHOICE_FAMILIES]; /* with limits: its largest sigma / limit */
    unsigned chosen;               /* CHOICE_STAND or CHOICE_FREE */
    char refusal[300];             /* if neither is found: why */
} choice;

/* Chooses. With limits: the smallest set within them, of two of one size the more accurate;
 * without: the largest det H'H among the sets that fit into the budget.
 *
 * c->set are given; they are worked on.
 *
 * Returns EXIT_GOOD; EXIT_DATA, without a message, if neither family has one. */
int choice_make(choice *c, const choice_request *request);

/* The fewest positions that may be chosen. */
unsigned choice_least(const choice_request *request);

/* Programs are looked at whose N is a multiple of this: with needs_axes 2, for an odd N points no axis
 * up and down. */
unsigned choice_stand_step(int needs_axes);

/* The largest sigma / limit of a set. */
double choice_worst(const criteria *c, const double limits[3]);

#endif
