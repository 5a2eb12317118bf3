/* SPDX-License-Identifier: MIT
 *
 * The unit on the two axes of a stand, with the senses of its angles: seen from the front, a little
 * from the right and from above.
 */
#include <math.h>

#include "maths/angles.h"
#include "report/facts.h"

#define HEIGHT_BESIDE 275.0 /* height of the picture with the three poses at its right */
#define HEIGHT_BELOW 420.0  /* the same with the poses below */
#define DEPTH_X 0.42        /* shift to the left for each unit towards the viewer */
#define DEPTH_Y 0.30        /* shift down */
#define HALF_EDGE 30.0      /* half an edge of the unit */
#define FRAME 84.0          /* from the centre to the sides of the outer frame */
#define FRAME_TOP 72.0      /* to its top and bottom */
#define POST 122.0          /* to the posts that hold the outer axis */
#define FLOOR 112.0         /* to the floor */
#define ARC 27.0            /* radius of the arrows of rotation */

typedef struct {
    FILE *file;
    double x, y;  /* pixel of the centre of the unit */
    double scale; /* 1: the stand at the size above */
} view;

typedef struct {
    double x, y;
} point;

static point project(const view *v, const double at[3])
{
    return (point){v->x + v->scale * (at[0] - DEPTH_X * at[2]),
                   v->y - v->scale * (at[1] - DEPTH_Y * at[2])};
}

static void draw_line(const view *v, const char *style, const double from[3], const double to[3])
{
    const point a = project(v, from);
    const point b = project(v, to);

    svg_line(v->file, style, a.x, a.y, b.x, b.y);
}

/* The head of an arrow from a to b. */
static void draw_arrow_head(const view *v, const char *colour, point a, point b)
{
    const double length = hypot(b.x - a.x, b.y - a.y);
    const double along[2] = {(b.x - a.x) / length, (b.y - a.y) / length};
    char style[16];

    snprintf(style, sizeof style, "%s full", colour);
    svg_polygon_begin(v->file, style);
    svg_polyline_point(v->file, b.x + 3 * along[0], b.y + 3 * along[1]);
    svg_polyline_point(v->file, b.x - 6 * along[0] - 4 * along[1],
                       b.y - 6 * along[1] + 4 * along[0]);
    svg_polyline_point(v->file, b.x - 6 * along[0] + 4 * along[1],
                       b.y - 6 * along[1] - 4 * along[0]);
    svg_polyline_end(v->file);
}

/* ---- the unit ---------------------------------------------------------------------------------- */

/* 1 if a side with this normal is visible. */
static int faces_viewer(const double d[3])
{
    return DEPTH_X * d[0] + DEPTH_Y * d[1] + d[2] > 1e-9;
}

/* A side of the cube, along axis i. */
static void draw_side(const view *v, const double (*axis)[3], unsigned i, double sign)
{
    static const double corners[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
    const double *j = axis[(i + 1) % 3];
    const double *k = axis[(i + 2) % 3];
    const double out[3] = {sign * axis[i][0], sign * axis[i][1], sign * axis[i][2]};

    if (!faces_viewer(out)) {
        return;
    }
    svg_polygon_begin(v->file, "c0 hollow");
    for (unsigned n = 0; n < 4; n++) {
        double at[3];
        for (unsigned c = 0; c < 3; c++) {
            at[c] = HALF_EDGE * (out[c] + corners[n][0] * j[c] + corners[n][1] * k[c]);
        }
        const point s = project(v, at);
        svg_polyline_point(v->file, s.x, s.y);
    }
    svg_polyline_end(v->file);
}

/* An axis of the unit, from its side to `length`, with its name. */
static void draw_axis(const view *v, const double axis[3], const char *name, double length)
{
    double from[3];
    double to[3];

    for (unsigned c = 0; c < 3; c++) {
        from[c] = HALF_EDGE * axis[c];
        to[c] = length * axis[c];
    }
    const point a = project(v, from);
    const point b = project(v, to);
    const double along = hypot(b.x - a.x, b.y - a.y);
    svg_line(v->file, "c1 curve", a.x, a.y, b.x, b.y);
    draw_arrow_head(v, "c1", a, b);
    svg_text(v->file, "ink halo", SVG_MIDDLE, b.x + 13 * (b.x - a.x) / along,
             b.y + 5 + 13 * (b.y - a.y) / along, name);
}

/* The unit at the angles alpha and beta, degrees; axes behind it first. */
static void draw_unit(const view *v, double alpha, double beta, const double length[3])
{
    static const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const char *const names[] = {"x", "y", "z"};
    double axis[3][3];

    for (unsigned i = 0; i < 3; i++) {
        angles_vector(alpha, beta, unit[i], axis[i]);
        if (!faces_viewer(axis[i])) {
            draw_axis(v, axis[i], names[i], length[i]);
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        draw_side(v, (const double(*)[3])axis, i, 1);
        draw_side(v, (const double(*)[3])axis, i, -1);
    }
    for (unsigned i = 0; i < 3; i++) {
        if (faces_viewer(axis[i])) {
            draw_axis(v, axis[i], names[i], length[i]);
        }
    }
}

/* ---- the stand ---------------------------------------------------------------------------------- */

/* Posts and frame. The shaft of the outer axis lies along x, that of the inner one along y. */
static void draw_stand(const view *v)
{
    static const double frame[][3] = {{-FRAME, -FRAME_TOP, 0},
                                      {FRAME, -FRAME_TOP, 0},
                                      {FRAME, FRAME_TOP, 0},
                                      {-FRAME, FRAME_TOP, 0}};

    svg_line(v->file, "rule", v->x - POST - 18, v->y + FLOOR, v->x + POST + 18, v->y + FLOOR);
    for (int side = -1; side <= 1; side += 2) {
        const double foot[3] = {side * POST, -FLOOR, 0};
        const double top[3] = {side * POST, 0, 0};
        const double outer[3] = {side * FRAME, 0, 0};
        const double upper[3] = {0, side * FRAME_TOP, 0};
        const double unit[3] = {0, side * HALF_EDGE, 0};
        draw_line(v, "rule", foot, top);
        draw_line(v, "rule", outer, top);
        draw_line(v, "rule", upper, unit);
    }
    for (unsigned i = 0; i < 4; i++) {
        draw_line(v, "rule", frame[i], frame[(i + 1) % 4]);
    }
}

/* An arrow along the path of a mark on the unit as alpha or beta increases. */
static void draw_rotation(const view *v, const double mark[3], const double centre[3], int is_beta)
{
    point last = {0, 0};
    point now = {0, 0};

    svg_polyline_begin(v->file, "c2 curve");
    for (unsigned n = 0; n <= 60; n++) {
        const double degrees = 4.0 * n;
        double at[3];
        angles_vector(is_beta ? 0 : degrees, is_beta ? degrees : 0, mark, at);
        for (unsigned c = 0; c < 3; c++) {
            at[c] += centre[c];
        }
        last = now;
        now = project(v, at);
        svg_polyline_point(v->file, now.x, now.y);
    }
    svg_polyline_end(v->file);
    draw_arrow_head(v, "c2", last, now);
}

static void draw_angles(const view *v)
{
    static const double on_outer[3] = {(FRAME + POST) / 2, 0, 0};
    static const double on_inner[3] = {0, FRAME_TOP + 18, 0};
    static const double outer_mark[3] = {0, -ARC * 0.6, ARC * 0.8};
    static const double inner_mark[3] = {ARC, 0, 0};

    draw_rotation(v, outer_mark, on_outer, 0);
    draw_rotation(v, inner_mark, on_inner, 1);
    svg_text(v->file, "ink halo", SVG_START, v->x + on_outer[0] + 13, v->y - 22, "α");
    svg_text(v->file, "ink halo", SVG_START, v->x + ARC + 8, v->y - on_inner[1] + 2, "β");
}

/* ---- the picture -------------------------------------------------------------------------------- */

/* The poses that define the senses of the angles: y, z and x point up. */
static void draw_poses(FILE *file, double x, double y, double step)
{
    static const double angles[3][2] = {{0, 0}, {90, 0}, {90, 90}};
    static const char *const names[] = {"α 0°, β 0°", "α 90°, β 0°", "α 90°, β 90°"};
    static const double length[3][3] = {{60, 60, 104}, {60, 136, 60}, {60, 136, 60}};

    for (unsigned i = 0; i < 3; i++) {
        const view v = {file, x + i * step, y, 0.62};
        draw_unit(&v, angles[i][0], angles[i][1], length[i]);
        svg_text(file, "soft small", SVG_MIDDLE, v.x, v.y + 58, names[i]);
    }
}

void report_stand_figure(FILE *file, const void *data, double width)
{
    static const double length[3] = {POST + 26, FRAME_TOP + 52, 110};
    const int is_wide = width > PAGE_NARROW;
    const view v = {file, 156, 152, 1};

    (void)data;
    svg_begin_inline(
        file, width, is_wide ? HEIGHT_BESIDE : HEIGHT_BELOW,
        "The unit on the two axes of the stand",
        "A cube, the unit, in a frame. The frame turns by alpha about the outer axis, which lies "
        "level along x; the unit turns by beta about the inner axis, its y axis, which points up "
        "at alpha 0. Increasing alpha turns the front of the unit up, increasing beta turns it to "
        "the left, seen with x to the right, y up and z to the front. Next to it, the unit at "
        "alpha 0, beta 0: y up; at alpha 90, beta 0: z up; at alpha 90, beta 90: x up.");
    draw_stand(&v);
    draw_unit(&v, 0, 0, length);
    draw_angles(&v);
    if (is_wide) {
        draw_poses(file, 400, 152, 116);
    } else {
        draw_poses(file, 50, 350, 112);
    }
    svg_end(file);
}
