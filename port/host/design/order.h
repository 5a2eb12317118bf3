/* SPDX-License-Identifier: MIT
 *
 * design/order.h: the order in which positions are visited, so that a drift shows and the way is short.
 */
#ifndef ORDER_H
#define ORDER_H

/* By how much sigma of the nine parameters grows, at most, if a drift of the offsets is to be separated
 * from them: the largest sqrt(K12(r,r) / K9(r,r)), K12 with three columns tau eta more, tau from -1/2 at the
 * first position to 1/2 at the last. Near 1 the order shows a drift; infinite where it hides one.
 *
 * weight  of each direction; or null: all are 1. */
double order_hides_drift(const double (*direction)[3], const double *weight, unsigned count);

/* Puts unit vectors into an order in which a drift shows and turns are short, beginning with the first.
 * By exchanges and reversals, as long as they make it better: the same on every machine. */
void order_directions(double (*direction)[3], unsigned count);

#endif
