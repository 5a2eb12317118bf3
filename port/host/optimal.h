/* SPDX-License-Identifier: MIT
 *
 * optimal.h: the best directions for a given number of positions, found by exchange.
 */
#ifndef OPTIMAL_H
#define OPTIMAL_H

#define OPTIMAL_MIN 9u
#define OPTIMAL_MAX 48u

/* Both find n unit vectors (n from OPTIMAL_MIN to OPTIMAL_MAX), in an order that is short to
 * travel. They are deterministic: the same everywhere up to rounding. The search is local, from
 * several starts (the paper's program among them where it has that size), so "best" means best
 * found; the tests hold it to the bound of design section 3. */

/* D-optimal: the largest det H'H. Turning the set does not change that; it is turned so that its
 * first direction is +z. */
void optimal_directions(unsigned n, double (*direction)[3]);

/* The smallest worst ratio of sigma to limit over the nine parameters: A-optimal sets, the least
 * sum of weighted sigma squares, under weights that are moved until the ratios are even.
 *
 * limits  of the sigma of delta, dk, gamma; each above 0.
 *
 * enough  0; or a ratio with which the search may end, and above which it may give up.
 *
 * Returns that ratio; if it gave up a larger one than `enough`, and the directions are lost. */
double optimal_within(unsigned n, const double limits[3], double enough, double (*direction)[3]);

#endif
