/* SPDX-License-Identifier: MIT
 *
 * design/bound.h: how wrong a parameter can be at most.
 *
 * If no position mean is off by more than E of the field, whatever the reason, least squares leave
 * parameter r within E times the sum of |H+| over its row, H+ = K H' the pseudoinverse.
 */
#ifndef BOUND_H
#define BOUND_H

#include "design/design.h"

/* These sums, of a set that is solvable. */
void bound_find(const design *d, double bound[INVCAL_PARAMETERS]);

/* The largest of a kind: 0 offsets, 1 scale errors, 2 angles. */
double bound_largest(const double bound[INVCAL_PARAMETERS], unsigned kind);

#endif
