/* SPDX-License-Identifier: MIT
 *
 * fit/rejection.h: positions that contradict the others, left out before the calibration.
 */
#ifndef REJECTION_H
#define REJECTION_H

#include "fit/fit.h"
#include "read/positions.h"

/* Times the field: what is beyond is no reading, and no figure is printed for it. One that is within is
 * left out if it cannot be one of this field; beyond, the data are refused. */
#define REJECTION_TELLABLE 1e100

typedef struct {
    unsigned position; /* from 0 */
    double drift;      /* K in the rest, if it is left out for that; else 0 */
} rejected_position;

typedef struct {
    unsigned count;
    rejected_position *list;    /* ascending */
    rejected_position *scratch; /* room for as many */
    double *number;             /* their numbers, from 1 */
    unsigned suspected;  /* positions of which some are wrong, the residuals do not show which */
    double *kept;        /* the others: 3 numbers each, */
    double *temperature; /* and one */
    unsigned kept_count;
    invcal_quality found; /* what the first turn was judged to be, */
    int is_judged;        /* if it was */
} rejection;

/* Looks for outliers (invcal_calibrate_judged), in turns if there are more positions than
 * INVCAL_MAX_POSITIONS; then those stay out that contradict all others, too, by a chance of 0.007 of all
 * together, and none is only suspected. The time it takes is that of a position times their number. Sets that cannot be
 * judged, because they are too few or undetermined, lose none: calibrating them shows why.
 *
 * none  1: looks for none.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. To be released with
 * rejection_free in either case. */
int rejection_find(rejection *r, const positions *p, const fit_settings *settings, int none);

/* The same in steps, for those who have reasons of their own: begins with readings that are none of
 * this field, adds, removes, searches (nine parameters), and finishes as often as kept ones are
 * wanted. */
int rejection_begin(rejection *r, const positions *p, const fit_settings *settings, int none);
void rejection_add(rejection *r, rejected_position one);
void rejection_remove(rejection *r, unsigned position);
void rejection_search(rejection *r, const positions *p, const fit_settings *settings);
void rejection_finish(rejection *r, const positions *p);

/* Is it among the first `count` of the list, which must ascend? */
int rejection_has(const rejection *r, unsigned count, unsigned position);

/* How many are left out because the temperature drifted. */
unsigned rejection_drifting(const rejection *r);

void rejection_free(rejection *r);

/* The number, from 0, of the position that is kept as number `kept`. */
unsigned rejection_original(const rejection *r, unsigned kept);

#endif
