/* SPDX-License-Identifier: MIT
 *
 * design/optimal.h: the best directions for a given number of positions, found by descent.
 */
#ifndef OPTIMAL_H
#define OPTIMAL_H

#define OPTIMAL_MIN 9u
#define OPTIMAL_MAX 144u
#define OPTIMAL_AXES 6u /* directions of the axes, up and down */

/* Both find n unit vectors (n from OPTIMAL_MIN to OPTIMAL_MAX), each followed by a near one. They
 * are deterministic up to rounding. The descent is local, from several starts (one of them the
 * paper's program of that size, if there is one), so "best" means best found; the tests compare it
 * with the bound of a spherical 4-design. */

/* D-optimal: the largest det H'H. Rotating the set does not change that; it is rotated so that its
 * first direction is +z.
 *
 * with_axes  the axes, up and down, are among them; the set is then not rotated. */
void optimal_directions(unsigned n, int with_axes, double (*direction)[3]);

/* Minimax: the smallest worst ratio of sigma to limit over the nine parameters. Begins with the
 * smallest mean square of the ratios (A-optimal), and continues with norms of increasing power.
 *
 * limits     of the sigma of delta, dk, gamma; their ratios within 1e-9 ... 1e9.
 * with_axes  the axes, up and down, are among them.
 *
 * Returns that ratio. */
double optimal_within(unsigned n, const double limits[3], int with_axes, double (*direction)[3]);

#endif
