/* SPDX-License-Identifier: MIT
 *
 * Internal: one round of the search for positions that contradict the others.
 */
#ifndef INVCAL_OUTLIERS_H
#define INVCAL_OUTLIERS_H

#include "fit.h"

enum { INVCAL_GROUP = INVCAL_MORE }; /* looked for together: what cannot hide one another */

/* Are more than one of six left out? Chance does not do that. */
static inline int invcal_are_many(unsigned left, unsigned count)
{
    return 6 * (count - left) > count;
}

/* A group of them. */
typedef struct {
    invcal_mask group;     /* to be left out; 0: none is clear */
    invcal_mask suspected; /* the two of the largest contest without a clear winner, or 0 */
    unsigned size;
    invcal_real squares; /* what is left of fit->squares */
    invcal_real chance;  /* of the group, or of the suspected if there is none, as
                            invcal_chance has it; INVCAL_REAL_MAX: there is neither */
} invcal_group;

void invcal_outliers_search(const invcal_fit *fit, invcal_group *found);

#endif
