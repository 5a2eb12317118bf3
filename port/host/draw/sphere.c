/* SPDX-License-Identifier: MIT */
#include "draw/sphere.h"

#include <math.h>
#include <string.h>

#define TURN 6.2831853071795865
#define RADIUS 136.0
#define CENTRE_X (SPHERE_WIDTH / 2)
#define CENTRE_Y (REACH + 2)
#define REACH (RADIUS + 26) /* of labels, up and down */
#define CAPTION_Y (SPHERE_HEIGHT - 6)
#define AXES 6u
#define DIGIT 7.6    /* width in a label, at most */
#define PERIOD 4.2   /* of other characters */
#define TOGETHER 3.0 /* pixels: drawn as one spot */
#define MARKER 4.5
#define WIDER 1.3  /* times that, of what is left out or next */
#define CELL 2     /* pixels of shading */
#define CELLS 136u /* in the diameter */
#define PLACE 4    /* pixels that a small marker takes */
#define PLACES 69u

static unsigned half_of(const double v[3])
{
    return v[2] < -SPHERE_EQUATOR;
}

/* x to the right, y up, the lower half as if the sphere were of glass. */
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

/* The direction of a point of the disc, given from its centre, y down. */
static void unproject(double x, double y, unsigned half, double v[3])
{
    const double radius = hypot(x, y) / RADIUS;
    const double height = 1 - radius * radius;
    const double stretch = radius > 0 ? sqrt(1 - height * height) / (radius * RADIUS) : 0;

    v[0] = x * stretch;
    v[1] = -y * stretch;
    v[2] = half ? -height : height;
}

/* ---- where everything goes --------------------------------------------------------------------- */

static void find_spots(sphere *s)
{
    for (unsigned n = 0; n < s->count; n++) {
        const sphere_mark *m = &s->mark[n];
        sphere_spot here = {.half = half_of(m->up), .radius = MARKER, .kind = m->kind};
        unsigned i = 0;
        project(m->up, &here.x, &here.y);
        while (i < s->spots && (s->spot[i].half != here.half ||
                                hypot(here.x - s->spot[i].x, here.y - s->spot[i].y) >= TOGETHER)) {
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

/* Where there are several to take next, they bear letters. */
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
            s->spot[spot].radius = fmax(s->spot[spot].radius, WIDER * MARKER);
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

static void take(sphere *s, sphere_box b)
{
    s->taken[s->taken_count++] = b;
}

static int is_free(const sphere *s, sphere_box b)
{
    for (unsigned i = 0; i < s->taken_count; i++) {
        const sphere_box *t = &s->taken[i];
        if (fabs(b.x - t->x) < b.w + t->w && fabs(b.y - t->y) < b.h + t->h) {
            return 0;
        }
    }
    return fabs(b.x - CENTRE_X) + b.w < CENTRE_X - 2 && fabs(b.y - CENTRE_Y) + b.h < REACH;
}

/* What speaks against a place for a label: lines that run through it. */
static double blemish(sphere_box b)
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
        width += (*c >= '0' && *c <= '9') || *c >= 'a' ? DIGIT : PERIOD;
    }
    return width;
}

/* Looks for a free place around a spot, near ones and the upper right first. */
static void place_label(const sphere *s, sphere_spot *at)
{
    static const int side[8][2] = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1},
                                   {1, 0}, {-1, 0}, {0, 1},  {0, -1}};
    const double w = label_width(at->label) / 2;
    const double h = 6;
    double least = HUGE_VAL;

    for (unsigned ring = 0; ring < 4; ring++) {
        for (unsigned k = 0; k < 8; k++) {
            const double away = at->radius + (k < 4 ? 1.6 + 7 * ring : 3.5 + 10 * ring);
            const sphere_box b = {at->x + side[k][0] * (away + w), at->y - side[k][1] * (away + h),
                                  w, h};
            const double cost = 7 * ring + 0.25 * k + blemish(b);
            if (cost < least && is_free(s, b)) {
                least = cost;
                at->place = b;
                at->anchor = side[k][0] > 0 ? SVG_START : side[k][0] < 0 ? SVG_END : SVG_MIDDLE;
                at->is_labelled = 1;
            }
        }
    }
}

/* The axes pierce the sphere at four places of the rim, seen in both halves, and in the middle. */
static const struct {
    const char *name;
    double x, y; /* of the middle of its name, from the centre */
} axis_names[2][AXES - 1] = {
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
    s->taken_count = 0;
    for (unsigned i = 0; i < AXES - 1; i++) {
        take(s, (sphere_box){CENTRE_X + axis_names[half][i].x, CENTRE_Y + axis_names[half][i].y, 11,
                             7});
    }
    for (unsigned i = 0; i < s->spots; i++) {
        const sphere_spot *at = &s->spot[i];
        if (at->half == half) {
            take(s, (sphere_box){at->x, at->y, at->radius + 1.5, at->radius + 1.5});
        }
    }
    for (unsigned i = 0; i < s->spots; i++) {
        sphere_spot *at = &s->spot[i];
        if (at->half != half || *at->label == '\0') {
            continue;
        }
        place_label(s, at);
        if (at->is_labelled) { /* with a margin, so that two do not read as one */
            take(s, (sphere_box){at->place.x, at->place.y, at->place.w + 4, at->place.h + 5});
        }
        s->homeless[half] += !at->is_labelled;
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

/* Where row y, counted from the top, begins and ends on the disc. */
static void row_extent(unsigned y, unsigned *begin, unsigned *end)
{
    const double from_centre = (y + 0.5) * CELL - RADIUS;
    const double reach = sqrt(RADIUS * RADIUS - from_centre * from_centre);

    *begin = (unsigned)((RADIUS - reach) / CELL + 0.5);
    *end = (unsigned)((RADIUS + reach) / CELL + 0.5);
}

/* Cells of equal class in a row make one rectangle, those of one class one path. */
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
            const double shrink = fmin(1, RADIUS / hypot(dx, dy)); /* cells that jut out */
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
    for (unsigned i = 0; i < AXES - 1; i++) {
        svg_text(file, "soft halo", SVG_MIDDLE, CENTRE_X + axis_names[half][i].x,
                 CENTRE_Y + axis_names[half][i].y + 5, axis_names[half][i].name);
    }
}

/* A label that is far off is tied to its spot. */
static void draw_tie(FILE *file, const sphere_spot *s)
{
    const sphere_box *b = &s->place;
    const double x = b->x + fmax(-b->w, fmin(b->w, s->x - b->x)); /* of its edge, the nearest */
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

/* Ties first: no label lies below one. */
static void draw_labels(FILE *file, const sphere *s, unsigned half)
{
    for (unsigned way = 0; way < 2; way++) {
        for (unsigned i = 0; i < s->spots; i++) {
            if (s->spot[i].half == half && s->spot[i].is_labelled) {
                (way == 0 ? draw_tie : draw_label)(file, &s->spot[i]);
            }
        }
    }
}

/* Colour and shape of each kind. */
static const struct {
    const char *colour;
    svg_shape shape;
} looks[SPHERE_KINDS] = {
    [SPHERE_POSITION] = {"c1", SVG_CIRCLE},  [SPHERE_GROUP_2] = {"c2", SVG_SQUARE},
    [SPHERE_GROUP_3] = {"c3", SVG_TRIANGLE}, [SPHERE_LEFT_OUT] = {"c2", SVG_CROSS},
    [SPHERE_NEXT] = {"c3", SVG_TARGET},
};

static void draw_marker(FILE *file, sphere_kind kind, const char *way, double x, double y,
                        double radius)
{
    char style[16];

    snprintf(style, sizeof style, "%s %s", looks[kind].colour, way);
    svg_marker(file, style, looks[kind].shape, x, y, radius);
}

void sphere_marker(FILE *file, sphere_kind kind, double x, double y)
{
    draw_marker(file, kind, "full", x, y, MARKER);
}

/* Marks without numbers may be a million: of equal ones at a place of the disc one is enough. */
static int is_hidden(const sphere *s, sphere_kind kind, double x, double y,
                     unsigned char (*seen)[PLACES])
{
    unsigned char *cell = &seen[(unsigned)((y - CENTRE_Y + RADIUS) / PLACE)]
                               [(unsigned)((x - CENTRE_X + RADIUS) / PLACE)];
    const unsigned char bit = (unsigned char)(1u << kind);
    const int hidden = s->spots == 0 && (*cell & bit);

    *cell |= bit;
    return hidden;
}

/* A mark of another kind at the same spot is drawn smaller than the marker that it lies on. */
static void draw_marks(FILE *file, const sphere *s, unsigned half)
{
    const double alone = s->count <= SPHERE_NUMBERED ? MARKER : s->count <= 300 ? 3 : 1.8;

    unsigned char seen[PLACES][PLACES] = {{0}};

    for (unsigned n = 0; n < s->count; n++) {
        const sphere_mark *m = &s->mark[n];
        const sphere_spot *spot = s->spots > 0 ? &s->spot[s->spot_of[n]] : NULL;
        const int is_upon = spot && spot->kind != m->kind;
        const double radius = m->kind == SPHERE_LEFT_OUT || m->kind == SPHERE_NEXT ? WIDER * MARKER
                              : spot && !is_upon                                   ? spot->radius
                                                                                   : alone;
        double x;
        double y;
        if (half_of(m->up) != half) {
            continue;
        }
        project(m->up, &x, &y);
        if (is_hidden(s, m->kind, x, y, seen)) {
            continue;
        }
        draw_marker(file, m->kind, is_upon || s->shading ? "over" : "full", x, y, radius);
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
