/* SPDX-License-Identifier: MIT
 *
 * design/order.h: the order in which positions are visited: a drift must show, and turns are short.
 */
#ifndef ORDER_H
#define ORDER_H

/* The factor by which sigma of a parameter grows, at most, if a drift of the offsets is fitted too:
 * the largest sqrt(K12(r,r) / K9(r,r)), where K12 has three more columns tau eta, tau from -1/2 at
 * the first position to 1/2 at the last. Near 1 the order shows a drift; it is infinite if the
 * order hides one.
 *
 * weight  of each direction; or null: all are 1. */
double order_drift_factor(const double (*direction)[3], const double *weight, unsigned count);

/* Sorts unit vectors so that a drift shows and turns are short; the first one stays first.
 * Exchanges two, or reverses a part, as long as that helps. Deterministic. */
void order_directions(double (*direction)[3], unsigned count);

#endif
