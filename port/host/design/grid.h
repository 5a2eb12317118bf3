/* SPDX-License-Identifier: MIT
 *
 * design/grid.h: the best positions on a stand that stops only at multiples of a step.
 */
#ifndef GRID_H
#define GRID_H

#include "design/optimal.h"

/* Finds n directions (n from OPTIMAL_MIN to OPTIMAL_MAX) whose alpha and beta are multiples of
 * `step` degrees (15, 30, 45), with the largest det H'H: by exchanges, from several starts, so
 * "largest" means largest found. None is used twice before all have been used once. Deterministic.
 *
 * with_axes  the first six are the axes, up and down. */
void grid_directions(unsigned n, unsigned step, int with_axes, double (*direction)[3]);

#endif
