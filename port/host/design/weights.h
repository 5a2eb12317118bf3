/* SPDX-License-Identifier: MIT
 *
 * design/weights.h: how to share the time among positions that are given.
 *
 * With shares p_i of the dwell, which add up to 1, M = sum p_i h_i'h_i. The D-optimal shares make det M
 * the largest. They are those with which d_i = h_i M^-1 h_i' is 9 wherever there is a share, and nowhere
 * more (Kiefer and Wolfowitz); mathematics_programs.md.
 */
#ifndef WEIGHTS_H
#define WEIGHTS_H

/* Finds the D-optimal shares of `count` directions that determine the nine parameters, times count: 1
 * each if they are equal. Directions that are the same have the same. A share below 1e-6 of an equal one
 * becomes 0. ln det M is within 1e-9 of the largest, unless 20,000 steps do not do. */
void weights_find(const double (*direction)[3], unsigned count, double *share);

/* The largest ln det H'H of n directions, whatever they are and however the time is shared. */
double weights_bound(unsigned n);

#endif
