/* SPDX-License-Identifier: MIT
 *
 * plan.h: what `invcal plan` has found, and the ways of telling it.
 */
#ifndef PLAN_H
#define PLAN_H

#include <stdio.h>

#include "design.h"

/* One of the paper's programs in a sweep over N. */
typedef struct {
    unsigned per_group;
    invcal_criteria criteria;
    uint8_t axes;
} plan_row;

/* What one position mean is worth, if the user tells. */
typedef struct {
    double noise; /* standard deviation of a mean over one second, over the field; 0: not told */
    double dwell; /* seconds in a position */
    double move;  /* seconds between two */
} plan_cost;

/* Standard deviation of a position mean: noise / sqrt(dwell). */
double plan_mean_noise(const plan_cost *cost);

/* Pictures, as a whole SVG document: the paper's Fig. 2, sigma against the number of positions;
 * and the directions of a set on the two halves of the sphere. */
void plan_svg_sweep(FILE *file, const plan_row *rows, unsigned count);
void plan_svg_directions(FILE *file, const design *d);

#endif
