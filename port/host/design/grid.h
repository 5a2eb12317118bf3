/* SPDX-License-Identifier: MIT
 *
 * design/grid.h: the best positions on a stand that stops at multiples of a step only.
 */
#ifndef GRID_H
#define GRID_H

#include "design/optimal.h"

/* Finds n directions (n from OPTIMAL_MIN to OPTIMAL_MAX) whose alpha and beta are multiples of `step`
 * degrees (15, 30, 45), with the largest det H'H: by exchanges, from several starts, so that "largest"
 * means largest found. None is taken a second time before all have been taken once. Deterministic.
 *
 * with_axes  the first six are the axes, up and down. */
void grid_directions(unsigned n, unsigned step, int with_axes, double (*direction)[3]);

#endif
