/* SPDX-License-Identifier: MIT
 *
 * plan/map.h: a set of positions on the two halves of the sphere.
 */
#ifndef PLAN_MAP_H
#define PLAN_MAP_H

#include "design/design.h"
#include "draw/sphere.h"

/* Arranges the positions of a set. The result is valid until the next call, and as long as the
 * shading (or null) is. */
const sphere *plan_map(const design *d, const sphere_shading *shading);

/* The markers of the groups from x on; y is the base line of their names. */
void plan_map_legend(FILE *file, double x, double y);

#endif
