/* SPDX-License-Identifier: MIT
 *
 * design/optimal.h: the best directions for a given number of positions, found by descent.
 */
#ifndef OPTIMAL_H
#define OPTIMAL_H

#define OPTIMAL_MIN 9u
#define OPTIMAL_MAX 144u
#define OPTIMAL_AXES 6u /* directions of the axes, up and down */

/* Both find n unit vectors (n from OPTIMAL_MIN to OPTIMAL_MAX), in an order that is short to
 * travel. They are deterministic: the same everywhere up to rounding. The descent is local, from
 * several starts (the paper's program among them where it has that size), so "best" means best
 * found; the tests hold it to the bound of a spherical 4-design. */

/* D-optimal: the largest det H'H. Turning the set does not change that; it is turned so that its
 * first direction is +z.
 *
 * with_axes  the axes, up and down, are among them; then the set is not turned. */
void optimal_directions(unsigned n, int with_axes, double (*direction)[3]);

/* The smallest worst ratio of sigma to limit over the nine parameters: from the A-optimal set, the
 * least mean square of the ratios, by norms of higher and higher power.
 *
 * limits     of the sigma of delta, dk, gamma; within 1e-9 ... 1e9 of each other.
 * with_axes  the axes, up and down, are among them.
 *
 * Returns that ratio. */
double optimal_within(unsigned n, const double limits[3], int with_axes, double (*direction)[3]);

#endif
