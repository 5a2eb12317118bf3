/* SPDX-License-Identifier: MIT
 *
 * design/weights.h: the optimal distribution of the time over given positions.
 *
 * With shares p_i of the dwell, which add up to 1, M = sum p_i h_i'h_i. The D-optimal shares
 * maximise det M. For them d_i = h_i M^-1 h_i' is 9 at each position with a share, and 9 or less at
 * the others (Kiefer and Wolfowitz); mathematics_programs.md.
 */
#ifndef WEIGHTS_H
#define WEIGHTS_H

/* Finds the D-optimal shares of `count` directions that determine the nine parameters, times count:
 * 1 each if they are equal. Equal directions have equal shares. A share below 1e-6 of an equal one
 * becomes 0. ln det M is within 1e-9 of the maximum, unless 20,000 steps are not enough. */
void weights_find(const double (*direction)[3], unsigned count, double *share);

/* The upper bound of ln det H'H for any n directions and any shares. */
double weights_bound(unsigned n);

#endif
