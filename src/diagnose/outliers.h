/* SPDX-License-Identifier: MIT
 *
 * Internal: one round of the search for positions that contradict the others.
 */
#ifndef INVCAL_OUTLIERS_H
#define INVCAL_OUTLIERS_H

#include "fit.h"

enum { INVCAL_GROUP = 3 }; /* max group tested together, so that none masks another */

/* Is more than one of six left out? That is not by chance. */
static inline int invcali_are_many(unsigned left, unsigned count)
{
    return 6 * (count - left) > count;
}

/* A group of them. */
typedef struct {
    invcali_set group;     /* to be left out; 0: none is clear */
    invcali_set suspected; /* the two of the largest undecided contest, or 0 */
    unsigned size;
    invcal_real squares; /* the rest of fit->squares */
    invcal_real chance;  /* of the group, or else of the suspected, by invcali_chance;
                            INVCAL_REAL_MAX: neither */
} invcali_group;

void invcali_outliers_search(const invcali_fit *fit, invcali_group *found);

#endif
