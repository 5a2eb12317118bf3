/* SPDX-License-Identifier: MIT */
#include "draw/sphere.h"

#include <math.h>
#include <string.h>

#define TURN 6.2831853071795865
#define RADIUS 136.0
#define CENTRE_X (SPHERE_WIDTH / 2)
#define CENTRE_Y (LABEL_RADIUS + 2)
#define LABEL_RADIUS (RADIUS + 26) /* labels lie within it */
#define CAPTION_Y (SPHERE_HEIGHT - 6)
#define AXIS_NAMES 5u      /* seen in one half */
#define DIGIT_WIDTH 7.6    /* of a digit or a letter in a label */
#define OTHER_WIDTH 4.2    /* of other characters */
#define MERGE_DISTANCE 3.0 /* pixels: marks closer than this share a spot */
#define MARKER 4.5         /* radius */
#define EMPHASIS 1.3       /* factor of the radius, for marks left out or next */
#define CELL 2             /* pixels of shading */
#define CELLS 136u         /* in the diameter */
#define HIDE_CELL 4        /* pixels in which one of many marks of a kind is drawn */
#define HIDE_CELLS 69u

static unsigned half_of(const double v[3])
{
    return v[2] < -SPHERE_EQUATOR;
}

/* x to the right, y up; the lower half is seen through the sphere. */
static void project(const double v[3], double *x, double *y)
{
    const double across = hypot(v[0], v[1]);
    const double radius = RADIUS * sqrt(fmax(0, 1 - fabs(v[2])));

    *x = CENTRE_X;
    *y = CENTRE_Y;
    if (across > 0) {
        *x += radius * v[0] / across;
        *y -= radius * v[1] / across;
    }
}

/* The direction at a point of the disc, relative to its centre, y down. */
static void unproject(double x, double y, unsigned half, double v[3])
{
    const double radius = hypot(x, y) / RADIUS;
    const double height = 1 - radius * radius;
    const double stretch = radius > 0 ? sqrt(1 - height * height) / (radius * RADIUS) : 0;

    v[0] = x * stretch;
    v[1] = -y * stretch;
    v[2] = half ? -height : height;
}

/* ---- layout ------------------------------------------------------------------------------------ */

static void find_spots(sphere *s)
{
    for (unsigned n = 0; n < s->count; n++) {
        const sphere_mark *m = &s->mark[n];
        sphere_spot here = {.half = half_of(m->up), .radius = MARKER, .kind = m->kind};
        unsigned i = 0;
        project(m->up, &here.x, &here.y);
        while (i < s->spots &&
               (s->spot[i].half != here.half ||
                hypot(here.x - s->spot[i].x, here.y - s->spot[i].y) >= MERGE_DISTANCE)) {
            i++;
        }
        if (i == s->spots) {
            s->spot[s->spots++] = here;
        } else if (s->spot[i].kind != m->kind) {
            s->spot[i].radius = MARKER + 3;
        }
        s->spot_of[n] = i;
    }
}

/* Adds the letters of SPHERE_NEXT marks. */
static void add_letters(sphere *s, unsigned spot)
{
    char *label = s->spot[spot].label;
    unsigned letter = 0;

    for (unsigned n = 0; n < s->count; n++) {
        const size_t length = strlen(label);
        if (s->mark[n].kind != SPHERE_NEXT) {
            continue;
        }
        if (s->spot_of[n] == spot && length + 4 < SPHERE_LABEL_MAX) {
            s->spot[spot].radius = fmax(s->spot[spot].radius, EMPHASIS * MARKER);
            snprintf(label + length, SPHERE_LABEL_MAX - length, "%s%c", length > 0 ? ", " : "",
                     'a' + (int)letter);
        }
        letter++;
    }
}

static int has_number(const sphere *s, unsigned n, unsigned spot)
{
    return s->spot_of[n] == spot && s->mark[n].kind != SPHERE_NEXT;
}

static unsigned count_next(const sphere *s)
{
    unsigned count = 0;

    for (unsigned n = 0; n < s->count; n++) {
        count += s->mark[n].kind == SPHERE_NEXT;
    }
    return count;
}

/* The numbers of a spot's marks: "2, 15", "1-8", "1, 7, 13 ...". */
static void set_label(sphere *s, unsigned i)
{
    char *label = s->spot[i].label;
    size_t length = 0;

    for (unsigned n = 0; n < s->count; n++) {
        char item[SPHERE_LABEL_MAX];
        unsigned end = n;
        if (!has_number(s, n, i)) {
            continue;
        }
        while (end + 1 < s->count && has_number(s, end + 1, i)) {
            end++;
        }
        end = end > n + 1 ? end : n; /* two in a row: one by one */
        const char *comma = length > 0 ? ", " : "";
        const int size = end > n ? snprintf(item, sizeof item, "%s%u-%u", comma, n + 1, end + 1)
                                 : snprintf(item, sizeof item, "%s%u", comma, n + 1);
        if (length + (size_t)size + 5 > SPHERE_LABEL_MAX) {
            memcpy(label + length, " ...", 5);
            return;
        }
        memcpy(label + length, item, (size_t)size + 1);
        length += (size_t)size;
        n = end;
    }
}

static void reserve(sphere *s, sphere_box b)
{
    s->occupied[s->occupied_count++] = b;
}

static int is_vacant(const sphere *s, sphere_box b)
{
    for (unsigned i = 0; i < s->occupied_count; i++) {
        const sphere_box *t = &s->occupied[i];
        if (fabs(b.x - t->x) < b.w + t->w && fabs(b.y - t->y) < b.h + t->h) {
            return 0;
        }
    }
    return fabs(b.x - CENTRE_X) + b.w < CENTRE_X - 2 && fabs(b.y - CENTRE_Y) + b.h < LABEL_RADIUS;
}

/* The cost of a place for a label: the rim and the axes should not run through it. */
static double placement_cost(sphere_box b)
{
    const double dx = fabs(b.x - CENTRE_X);
    const double dy = fabs(b.y - CENTRE_Y);
    const double near = hypot(fmax(0, dx - b.w), fmax(0, dy - b.h));
    const double far = hypot(dx + b.w, dy + b.h);

    return (near < RADIUS + 1 && far > RADIUS - 1 ? 6 : 0) +
           (near < RADIUS && (dx < b.w || dy < b.h) ? 3 : 0);
}

static double label_width(const char *label)
{
    double width = 0;

    for (const char *c = label; *c != '\0'; c++) {
        width += (*c >= '0' && *c <= '9') || *c >= 'a' ? DIGIT_WIDTH : OTHER_WIDTH;
    }
    return width;
}

/* Looks for a vacant place around a spot, preferably close and at the upper right. */
static void place_label(const sphere *s, sphere_spot *at)
{
    static const int side[8][2] = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1},
                                   {1, 0}, {-1, 0}, {0, 1},  {0, -1}};
    const double w = label_width(at->label) / 2;
    const double h = 6;
    double lowest = HUGE_VAL;

    for (unsigned ring = 0; ring < 4; ring++) {
        for (unsigned k = 0; k < 8; k++) {
            const double away = at->radius + (k < 4 ? 1.6 + 7 * ring : 3.5 + 10 * ring);
            const sphere_box b = {at->x + side[k][0] * (away + w), at->y - side[k][1] * (away + h),
                                  w, h};
            const double cost = 7 * ring + 0.25 * k + placement_cost(b);
            if (cost < lowest && is_vacant(s, b)) {
                lowest = cost;
                at->place = b;
                at->anchor = side[k][0] > 0 ? SVG_START : side[k][0] < 0 ? SVG_END : SVG_MIDDLE;
                at->is_labelled = 1;
            }
        }
    }
}

/* The axes meet the sphere at four points of the rim, seen in both halves, and in the centre. */
static const struct {
    const char *name;
    double x, y; /* centre of its name, relative to that of the disc */
} axis_names[2][AXIS_NAMES] = {
    {{"+x", RADIUS + 20, 0},
     {"-x", -RADIUS - 20, 0},
     {"+y", 0, -RADIUS - 17},
     {"-y", 0, RADIUS + 17},
     {"+z", -15, 13}},
    {{"+x", RADIUS + 20, 0},
     {"-x", -RADIUS - 20, 0},
     {"+y", 0, -RADIUS - 17},
     {"-y", 0, RADIUS + 17},
     {"-z", -15, 13}},
};

static void place_half(sphere *s, unsigned half)
{
    s->occupied_count = 0;
    for (unsigned i = 0; i < AXIS_NAMES; i++) {
        reserve(s, (sphere_box){CENTRE_X + axis_names[half][i].x, CENTRE_Y + axis_names[half][i].y,
                                11, 7});
    }
    for (unsigned i = 0; i < s->spots; i++) {
        const sphere_spot *at = &s->spot[i];
        if (at->half == half) {
            reserve(s, (sphere_box){at->x, at->y, at->radius + 1.5, at->radius + 1.5});
        }
    }
    for (unsigned i = 0; i < s->spots; i++) {
        sphere_spot *at = &s->spot[i];
        if (at->half != half || *at->label == '\0') {
            continue;
        }
        place_label(s, at);
        if (at->is_labelled) { /* with a margin between labels */
            reserve(s, (sphere_box){at->place.x, at->place.y, at->place.w + 4, at->place.h + 5});
        }
        s->unlabelled[half] += !at->is_labelled;
    }
}

void sphere_arrange(sphere *s, const sphere_mark *mark, unsigned count,
                    const sphere_shading *shading)
{
    *s = (sphere){.mark = mark, .count = count, .shading = shading};
    if (count > SPHERE_NUMBERED) {
        return;
    }
    find_spots(s);
    for (unsigned i = 0; i < s->spots; i++) {
        set_label(s, i);
        if (count_next(s) > 1) {
            add_letters(s, i);
        }
    }
    place_half(s, 0);
    place_half(s, 1);
}

/* ---- drawing ----------------------------------------------------------------------------------- */

static unsigned class_of(const sphere_shading *shading, const double up[3])
{
    const double value = shading->value(shading->context, up);
    unsigned k = 0;

    while (k + 1 < shading->classes && !(value < shading->threshold[k])) {
        k++;
    }
    return k;
}

/* The cells of row y, from the top, that are on the disc. */
static void row_extent(unsigned y, unsigned *begin, unsigned *end)
{
    const double from_centre = (y + 0.5) * CELL - RADIUS;
    const double reach = sqrt(RADIUS * RADIUS - from_centre * from_centre);

    *begin = (unsigned)((RADIUS - reach) / CELL + 0.5);
    *end = (unsigned)((RADIUS + reach) / CELL + 0.5);
}

/* One path for each class, with one rectangle for each run of its cells in a row. */
static void draw_class(FILE *file, const unsigned char (*cell)[CELLS], unsigned k)
{
    fprintf(file, "<path class=\"shade s%u\" d=\"", k);
    for (unsigned y = 0; y < CELLS; y++) {
        unsigned begin;
        unsigned end;
        row_extent(y, &begin, &end);
        for (unsigned x = begin; x < end; x++) {
            const unsigned start = x;
            while (x < end && cell[y][x] == k) {
                x++;
            }
            if (x > start) {
                fprintf(file, "M%u %uh%uv%uh-%uz", (unsigned)(CENTRE_X - RADIUS) + start * CELL,
                        (unsigned)(CENTRE_Y - RADIUS) + y * CELL, (x - start) * CELL, CELL,
                        (x - start) * CELL);
            }
        }
    }
    fputs("\"/>\n", file);
}

static void draw_shading(FILE *file, const sphere *s, unsigned half)
{
    unsigned char cell[CELLS][CELLS];

    for (unsigned y = 0; y < CELLS; y++) {
        unsigned begin;
        unsigned end;
        row_extent(y, &begin, &end);
        for (unsigned x = begin; x < end; x++) {
            double up[3];
            const double dx = (x + 0.5) * CELL - RADIUS;
            const double dy = (y + 0.5) * CELL - RADIUS;
            const double shrink = fmin(1, RADIUS / hypot(dx, dy)); /* cells beyond the rim */
            unproject(shrink * dx, shrink * dy, half, up);
            cell[y][x] = (unsigned char)class_of(s->shading, up);
        }
    }
    for (unsigned k = 0; k < s->shading->classes; k++) {
        draw_class(file, (const unsigned char(*)[CELLS])cell, k);
    }
}

/* Parallels and meridians every 30 degrees. */
static void draw_graticule(FILE *file)
{
    for (unsigned i = 0; i < 12; i++) {
        const double c = cos(i * TURN / 12);
        const double s = sin(i * TURN / 12);
        svg_line(file, "grid", CENTRE_X, CENTRE_Y, CENTRE_X + RADIUS * c, CENTRE_Y - RADIUS * s);
    }
    for (unsigned i = 1; i < 3; i++) {
        svg_circle(file, "grid", CENTRE_X, CENTRE_Y, RADIUS * sqrt(1 - sin(i * TURN / 12)));
    }
    svg_circle(file, "rule", CENTRE_X, CENTRE_Y, RADIUS);
}

static void draw_axis_names(FILE *file, unsigned half)
{
    for (unsigned i = 0; i < AXIS_NAMES; i++) {
        svg_text(file, "soft halo", SVG_MIDDLE, CENTRE_X + axis_names[half][i].x,
                 CENTRE_Y + axis_names[half][i].y + 5, axis_names[half][i].name);
    }
}

/* A line from a spot to its label, if that is not close. */
static void draw_leader(FILE *file, const sphere_spot *s)
{
    const sphere_box *b = &s->place;
    const double x = b->x + fmax(-b->w, fmin(b->w, s->x - b->x)); /* nearest point of its edge */
    const double y = b->y + fmax(-b->h, fmin(b->h, s->y - b->y));

    if (hypot(x - s->x, y - s->y) > s->radius + 7) {
        svg_line(file, "rule", s->x, s->y, x, y);
    }
}

static void draw_label(FILE *file, const sphere_spot *s)
{
    const sphere_box *b = &s->place;
    const double end = s->anchor == SVG_START ? -b->w : s->anchor == SVG_END ? b->w : 0;

    svg_text(file, "ink small halo", s->anchor, b->x + end, b->y + 4.3, s->label);
}

/* Leaders first, so that none covers a label. */
static void draw_labels(FILE *file, const sphere *s, unsigned half)
{
    for (unsigned pass = 0; pass < 2; pass++) {
        for (unsigned i = 0; i < s->spots; i++) {
            if (s->spot[i].half == half && s->spot[i].is_labelled) {
                (pass == 0 ? draw_leader : draw_label)(file, &s->spot[i]);
            }
        }
    }
}

/* Colour and shape of each kind. */
static const struct {
    const char *colour;
    svg_shape shape;
} marker_style[SPHERE_KINDS] = {
    [SPHERE_POSITION] = {"c1", SVG_CIRCLE},  [SPHERE_GROUP_2] = {"c2", SVG_SQUARE},
    [SPHERE_GROUP_3] = {"c3", SVG_TRIANGLE}, [SPHERE_LEFT_OUT] = {"c2", SVG_CROSS},
    [SPHERE_NEXT] = {"c3", SVG_TARGET},
};

static void draw_marker(FILE *file, sphere_kind kind, const char *fill, double x, double y,
                        double radius)
{
    char style[16];

    snprintf(style, sizeof style, "%s %s", marker_style[kind].colour, fill);
    svg_marker(file, style, marker_style[kind].shape, x, y, radius);
}

void sphere_marker(FILE *file, sphere_kind kind, double x, double y)
{
    draw_marker(file, kind, "full", x, y, MARKER);
}

/* There may be a million marks without numbers: of each kind, one in a cell of the disc is
 * enough. */
static int is_hidden(const sphere *s, sphere_kind kind, double x, double y,
                     unsigned char (*seen)[HIDE_CELLS])
{
    unsigned char *cell = &seen[(unsigned)((y - CENTRE_Y + RADIUS) / HIDE_CELL)]
                               [(unsigned)((x - CENTRE_X + RADIUS) / HIDE_CELL)];
    const unsigned char bit = (unsigned char)(1u << kind);
    const int hidden = s->spots == 0 && (*cell & bit);

    *cell |= bit;
    return hidden;
}

/* A mark of another kind at the same spot is drawn smaller, on top. */
static void draw_marks(FILE *file, const sphere *s, unsigned half)
{
    const double small = s->count <= SPHERE_NUMBERED ? MARKER : s->count <= 300 ? 3 : 1.8;

    unsigned char seen[HIDE_CELLS][HIDE_CELLS] = {{0}};

    for (unsigned n = 0; n < s->count; n++) {
        const sphere_mark *m = &s->mark[n];
        const sphere_spot *spot = s->spots > 0 ? &s->spot[s->spot_of[n]] : NULL;
        const int is_on_top = spot && spot->kind != m->kind;
        const double radius = m->kind == SPHERE_LEFT_OUT || m->kind == SPHERE_NEXT
                                  ? EMPHASIS * MARKER
                              : spot && !is_on_top ? spot->radius
                                                   : small;
        double x;
        double y;
        if (half_of(m->up) != half) {
            continue;
        }
        project(m->up, &x, &y);
        if (is_hidden(s, m->kind, x, y, seen)) {
            continue;
        }
        draw_marker(file, m->kind, is_on_top || s->shading ? "over" : "full", x, y, radius);
    }
}

void sphere_draw(FILE *file, const sphere *s, unsigned half)
{
    if (s->shading) {
        draw_shading(file, s, half);
    }
    draw_graticule(file);
    draw_labels(file, s, half);
    draw_marks(file, s, half);
    draw_axis_names(file, half);
    svg_text(file, "soft small", SVG_MIDDLE, CENTRE_X, CAPTION_Y,
             half ? "z down, seen from +z through the sphere"
                  : "z up and the equator, seen from +z");
}
