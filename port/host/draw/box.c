/* SPDX-License-Identifier: MIT */
#include "draw/box.h"

#include <math.h>

#include "draw/svg.h"

#define SCALE 27.0    /* pixels per unit */
#define NAME_MIN 0.35 /* visibility of a side below which it is too narrow for its name */

/* Half of the sides along x, y and z. */
static const double half[3] = {1.0, 0.7, 0.35};

/* World axes on the screen: seen from 25 degrees to the right and 30 above. */
static const double right[3] = {0.9063, 0.4226, 0};
static const double above[3] = {-0.2113, 0.4532, 0.8660};
static const double viewer[3] = {0.3660, -0.7849, 0.5};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Rodrigues about up x z: with v = up x z and c = up . z, turn = 1 + [v] + [v]^2 / (1 + c). */
void box_turn(const double up[3], double turn[3][3])
{
    const double v[3] = {up[1], -up[0], 0};
    const double c = up[2];
    const double k = 1 / (1 + c);

    if (!(c > -1 + 1e-9)) {
        for (unsigned i = 0; i < 9; i++) {
            turn[i / 3][i % 3] = i == 0 ? 1 : i % 4 == 0 ? -1 : 0;
        }
        return;
    }
    const double rows[3][3] = {
        {1 - k * v[1] * v[1], k * v[0] * v[1], v[1]},
        {k * v[0] * v[1], 1 - k * v[0] * v[0], -v[0]},
        {-v[1], v[0], c},
    };
    for (unsigned i = 0; i < 9; i++) {
        turn[i / 3][i % 3] = rows[i / 3][i % 3];
    }
}

/* The position of a point of the device on the screen. */
static void project(const double turn[3][3], const double device[3], double at[2])
{
    const double world[3] = {dot(turn[0], device), dot(turn[1], device), dot(turn[2], device)};

    at[0] = BOX_WIDTH / 2 + SCALE * dot(right, world);
    at[1] = BOX_HEIGHT / 2 - SCALE * dot(above, world);
}

/* How far the side at an axis, or the opposite one (sign -1), faces the viewer: 1 fully; not
 * visible at 0 or below. */
static double visibility(const double turn[3][3], unsigned axis, double sign)
{
    const double normal[3] = {sign * turn[0][axis], sign * turn[1][axis], sign * turn[2][axis]};

    return dot(normal, viewer);
}

static void draw_side(FILE *file, const double turn[3][3], unsigned axis, double sign)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double device[3];
    double at[2];

    svg_polygon_begin(file, axis == 2 && sign > 0 ? "c1 side" : "c0 side");
    device[axis] = sign * half[axis];
    for (unsigned k = 0; k < 4; k++) {
        device[(axis + 1) % 3] = corner[k][0] * half[(axis + 1) % 3];
        device[(axis + 2) % 3] = corner[k][1] * half[(axis + 2) % 3];
        project(turn, device, at);
        svg_polyline_point(file, at[0], at[1]);
    }
    svg_polyline_end(file);
}

static void name_side(FILE *file, const double turn[3][3], unsigned axis, double sign)
{
    const char name[3] = {sign > 0 ? "xyz"[axis] : '-', sign > 0 ? '\0' : "xyz"[axis], '\0'};
    double device[3] = {0, 0, 0};
    double at[2];

    device[axis] = sign * half[axis];
    project(turn, device, at);
    svg_text(file, "ink small halo", SVG_MIDDLE, at[0], at[1] + 4, name);
}

void box_draw(FILE *file, double x, double y, const double up[3])
{
    double turn[3][3];

    box_turn(up, turn);
    svg_group_begin(file, x, y);
    for (unsigned k = 0; k < 12; k++) { /* six sides, then their names on top */
        const unsigned axis = k % 3;
        const double sign = k / 3 % 2 == 0 ? 1 : -1;
        const double seen = visibility((const double(*)[3])turn, axis, sign);
        if (k < 6 && seen > 0) {
            draw_side(file, (const double(*)[3])turn, axis, sign);
        } else if (k >= 6 && seen > NAME_MIN) {
            name_side(file, (const double(*)[3])turn, axis, sign);
        }
    }
    svg_group_end(file);
}
