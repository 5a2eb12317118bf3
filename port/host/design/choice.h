/* SPDX-License-Identifier: MIT
 *
 * design/choice.h: the smallest set of positions that meets limits, or the best one that fits into
 * a given time.
 *
 * "Smallest" and "best" are among two families: the paper's programs for a stand, of up to 3000
 * positions, and free directions, of up to OPTIMAL_MAX.
 */
#ifndef CHOICE_H
#define CHOICE_H

#include "design/design.h"
#include "cli/unit_style.h"

#define CHOICE_SPARE 3u /* default of choice_request.spare */

struct labour;

typedef struct {
    const double *limits; /* of the sigma of delta, dk, gamma, over the noise of a position mean;
                             or null */
    double budget;        /* seconds; 0: no limit */
    unsigned spare;       /* minimum redundancy: positions beyond the nine that are needed */
    int needs_axes;       /* each axis must point up and down along gravity in some position */
    double bound;         /* largest error of a position mean, over the field; 0: no bound */
    design_cost cost;
    unit_style units;            /* the units of sigma, if the noise is known */
    const struct labour *labour; /* how number and dwell were chosen (plan/labour.h), or null */
} choice_request;

enum { CHOICE_STAND, CHOICE_FREE, CHOICE_FAMILIES };

typedef struct {
    design *set[CHOICE_FAMILIES];  /* the best of each family; meaningless unless is_found */
    int is_found[CHOICE_FAMILIES]; /* the family has a set within limits and budget */
    double worst[CHOICE_FAMILIES]; /* with limits: its largest sigma / limit */
    unsigned chosen;               /* CHOICE_STAND or CHOICE_FREE */
    char refusal[300];             /* why neither is found */
} choice;

/* Chooses a set. With limits: the smallest one within them; of two of the same size, the more
 * accurate. Without: the largest det H'H among the sets that fit into the budget.
 *
 * c->set points to memory for both.
 *
 * Returns EXIT_GOOD; EXIT_DATA, without a message, if neither family has one. */
int choice_make(choice *c, const choice_request *request);

/* The smallest number of positions that may be chosen. */
unsigned choice_min_count(const choice_request *request);

/* N of a stand program must be a multiple of this: 2 with needs_axes, since with an odd N no axis
 * points both up and down. */
unsigned choice_stand_step(int needs_axes);

/* The largest sigma / limit of a set. */
double choice_worst(const criteria *c, const double limits[3]);

#endif
