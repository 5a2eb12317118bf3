/* SPDX-License-Identifier: MIT
 *
 * Internal: one round of the search for positions that contradict the others.
 */
#ifndef INVCAL_OUTLIERS_H
#define INVCAL_OUTLIERS_H

#include "fit.h"

enum { INVCAL_GROUP = 3 }; /* max group tested together, so that none masks another */

/* Is more than one of six left out? That is not by chance. */
static inline int invcal_are_many(unsigned left, unsigned count)
{
    return 6 * (count - left) > count;
}

/* A group of them. */
typedef struct {
    invcal_set group;     /* to be left out; 0: none is clear */
    invcal_set suspected; /* the two of the largest undecided contest, or 0 */
    unsigned size;
    invcal_real squares; /* the rest of fit->squares */
    invcal_real chance;  /* of the group, or else of the suspected, by invcal_chance;
                            INVCAL_REAL_MAX: neither */
} invcal_group;

void invcal_outliers_search(const invcal_fit *fit, invcal_group *found);

#endif
