/* SPDX-License-Identifier: MIT */
#include "watch/map.h"

#include <math.h>

#include "draw/sphere.h"

#define CELL_COLUMNS 2u /* dots of a Braille cell */
#define CELL_ROWS 4u
#define DIAMETER_DOTS (CELL_COLUMNS * MAP_COLUMNS) /* across and down */
#define RIM_RADIUS (1 - 2.0 / DIAMETER_DOTS)       /* radius: the outermost dots */

/* The index of x in `count` equal parts of -1 ... 1; 0 for a NaN. */
static unsigned cell_of(double x, unsigned count)
{
    const double part = floor((x + 1) / 2 * count);

    return part >= 1 ? (unsigned)fmin(part, count - 1) : 0;
}

map_place map_find(const double up[3])
{
    const double across = hypot(up[0], up[1]);
    const double radius = sqrt(fmax(0, 1 - fabs(up[2])));
    const double share = across > 0 ? radius / across : 0;

    return (map_place){.half = up[2] < -SPHERE_EQUATOR,
                       .line = cell_of(-share * up[1], MAP_LINES),
                       .column = cell_of(share * up[0], MAP_COLUMNS)};
}

static int is_covered(const double up[3], const map_covered *covered)
{
    for (unsigned n = 0; n < covered->count; n++) {
        const double *d = covered->direction[n];
        if (d[0] * up[0] + d[1] * up[1] + d[2] * up[2] >= covered->reach) {
            return 1;
        }
    }
    return 0;
}

/* A dot of the disc, x to the right and y up from its centre, -1 ... 1. */
static int is_lit(double x, double y, unsigned half, const map_covered *covered)
{
    const double square = x * x + y * y;
    const double stretch = sqrt(fmax(0, 2 - square));
    const double up[3] = {x * stretch, y * stretch, half ? square - 1 : 1 - square};

    return square <= 1 && (square > RIM_RADIUS * RIM_RADIUS || is_covered(up, covered));
}

/* The dots of a Braille character are the bits of its code from U+2800 on; left then right, from the top. */
static const unsigned char bit_of[CELL_COLUMNS][CELL_ROWS] = {{0x01, 0x02, 0x04, 0x40},
                                                              {0x08, 0x10, 0x20, 0x80}};

static void put_braille(canvas *c, unsigned line, unsigned column, unsigned dots)
{
    const char glyph[4] = {(char)0xE2, (char)(0xA0 | dots >> 6), (char)(0x80 | (dots & 0x3Fu)),
                           '\0'};

    if (dots != 0) {
        canvas_put(c, line, column, CANVAS_PLAIN, glyph);
    }
}

void map_draw(canvas *c, unsigned line, unsigned column, unsigned half, const map_covered *covered)
{
    unsigned char dots[MAP_LINES][MAP_COLUMNS] = {{0}};

    for (unsigned j = 0; j < DIAMETER_DOTS; j++) {
        for (unsigned i = 0; i < DIAMETER_DOTS; i++) {
            const double x = (2.0 * i + 1) / DIAMETER_DOTS - 1;
            const double y = 1 - (2.0 * j + 1) / DIAMETER_DOTS;
            if (is_lit(x, y, half, covered)) {
                dots[j / CELL_ROWS][i / CELL_COLUMNS] |= bit_of[i % CELL_COLUMNS][j % CELL_ROWS];
            }
        }
    }
    for (unsigned j = 0; j < MAP_LINES; j++) {
        for (unsigned i = 0; i < MAP_COLUMNS; i++) {
            put_braille(c, line + j, column + i, dots[j][i]);
        }
    }
}
