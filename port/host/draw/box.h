/* SPDX-License-Identifier: MIT
 *
 * draw/box.h: a device as a box, turned so that a given direction of it points up.
 *
 * The box is flat, longest along x, and seen from the front, a little from the right and from
 * above. Each visible side has the name of the axis that points out of it.
 */
#ifndef BOX_H
#define BOX_H

#include <stdio.h>

#define BOX_WIDTH 84.0
#define BOX_HEIGHT 72.0

/* The shortest rotation that brings `up`, a unit vector of the device, to the world's z: world =
 * turn device. If `up` is -z, half a turn about x. */
void box_turn(const double up[3], double turn[3][3]);

/* Draws the box into BOX_WIDTH by BOX_HEIGHT pixels whose upper left corner is at x, y. */
void box_draw(FILE *file, double x, double y, const double up[3]);

#endif
