/* SPDX-License-Identifier: MIT
 *
 * watch/map.h: the two halves of the sphere in character cells: Lambert's equal-area projection,
 * both halves seen from +z, as on a page (draw/sphere.h).
 */
#ifndef WATCH_MAP_H
#define WATCH_MAP_H

#include "watch/canvas.h"

#define MAP_LINES 11u /* of a disc; a cell is twice as high as it is wide */
#define MAP_COLUMNS 22u

/* The cell of a direction. */
typedef struct {
    unsigned half;   /* 0: z up, and the equator; 1: z down */
    unsigned line;   /* from the top of the disc, */
    unsigned column; /* and from its left */
} map_place;

map_place map_find(const double up[3]);

/* Covered: all directions whose cosine with one of these is `reach` or more. */
typedef struct {
    const double (*direction)[3];
    unsigned count;
    double reach;
} map_covered;

/* Draws one half, its upper left corner at (line, column): the rim, and dots where it is
 * covered. */
void map_draw(canvas *c, unsigned line, unsigned column, unsigned half, const map_covered *covered);

#endif
