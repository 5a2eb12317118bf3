/* SPDX-License-Identifier: MIT
 *
 * fit/rejection.h: finds outliers, positions that contradict the others, to be left out before the
 * calibration.
 */
#ifndef REJECTION_H
#define REJECTION_H

#include "fit/fit.h"
#include "read/positions.h"

/* Relative to the field. A reading beyond it cannot be printed, and the data are refused; one
 * within is left out if it cannot be of this field. */
#define REJECTION_LENGTH_MAX 1e100

typedef struct {
    unsigned position; /* from 0 */
    double drift;      /* K in the rest, if that is the reason; else 0 */
} rejected_position;

typedef struct {
    unsigned count;
    rejected_position *list;    /* ascending */
    rejected_position *scratch; /* of the same size */
    double *number;             /* of the rejected positions, from 1 */
    unsigned suspected;  /* positions some of which are wrong; the residuals do not show which */
    double *kept;        /* the means of the others, 3 numbers each */
    double *temperature; /* of the others */
    unsigned kept_count;
    invcal_quality found; /* the quality of the first subset, */
    int is_judged;        /* if it could be judged */
} rejection;

/* Looks for outliers (invcal_calibrate). If there are more positions than
 * INVCAL_MAX_POSITIONS, it judges subsets, then rejects the positions that contradict all others,
 * with a chance of 0.007 of any false alarm, and suspects none. The time is proportional to the
 * number of positions. Sets that cannot be judged, because they are too few or undetermined, lose
 * none: the calibration reports why.
 *
 * none  1: keeps all.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if memory is short. Release it with rejection_free
 * in either case. */
int rejection_find(rejection *r, const positions *p, const fit_settings *settings, int none);

/* The same in steps, for callers that reject positions for reasons of their own. rejection_begin
 * rejects readings that cannot be of this field, rejection_search uses nine parameters, and
 * rejection_finish, which may be called repeatedly, fills the members about the others. */
int rejection_begin(rejection *r, const positions *p, const fit_settings *settings, int none);
void rejection_add(rejection *r, rejected_position one);
void rejection_remove(rejection *r, unsigned position);
void rejection_search(rejection *r, const positions *p, const fit_settings *settings);
void rejection_finish(rejection *r, const positions *p);

/* 1 if a position is among the first `count` of the list, which must be ascending. */
int rejection_has(const rejection *r, unsigned count, unsigned position);

/* The number of positions left out because the temperature drifted. */
unsigned rejection_drifting(const rejection *r);

void rejection_free(rejection *r);

/* The number of a kept position among all positions; both from 0. */
unsigned rejection_original(const rejection *r, unsigned kept);

#endif
