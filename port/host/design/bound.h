/* SPDX-License-Identifier: MIT
 *
 * design/bound.h: the worst-case error of each parameter.
 *
 * If no position mean is off by more than E of the field, for any reason, least squares determines
 * parameter r to within E times the sum of |H+| over its row, where H+ = K H' is the pseudoinverse.
 */
#ifndef BOUND_H
#define BOUND_H

#include "design/design.h"

/* These sums. The set is solvable. */
void bound_find(const design *d, double bound[INVCAL_PARAMETERS]);

/* The largest of a kind: 0 offsets, 1 scale errors, 2 angles. */
double bound_largest(const double bound[INVCAL_PARAMETERS], unsigned kind);

#endif
