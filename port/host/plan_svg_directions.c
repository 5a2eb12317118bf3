/* SPDX-License-Identifier: MIT
 *
 * The picture of a set: its directions on the two halves of the sphere.
 */
#include "plan.h"

#include <math.h>
#include <string.h>

#include "svg.h"

#define TEXT_MAX 1000
#define TURN 6.2831853071795865
#define MAP_WIDTH 680.0
#define MAP_HEIGHT 424.0
#define MAP_HEIGHT_LEGEND 450.0
#define RADIUS 136.0
#define MARGIN 32.0
#define CENTRE_Y 234.0
#define REACH (RADIUS + 26) /* of labels, up and down */
#define CAPTION_Y 412.0
#define LEGEND_Y 438.0
#define NUMBERED 48u /* more positions than this bear no numbers */
#define NAME_SHOWN 36u
#define LABEL_MAX 24
#define DIGIT 7.6    /* width in a label, at most */
#define PERIOD 4.2   /* of other characters */
#define EQUATOR 1e-9 /* |z| */
#define TOGETHER 3.0 /* pixels: drawn as one spot */
#define MARKER 4.5
#define TAKEN_MAX (2 * NUMBERED + 16)

static const double centre_x[2] = {MARGIN + RADIUS, MAP_WIDTH - MARGIN - RADIUS};

/* A place in the picture: middle and half of the sides. */
typedef struct {
    double x, y;
    double w, h;
} box;

/* Positions that share a spot share a label. */
typedef struct {
    double x, y;
    double centre; /* of its half */
    double radius; /* of its marker */
    unsigned group;
    char label[LABEL_MAX];
    box place; /* of the label */
    svg_anchor anchor;
    int is_labelled; /* there is room */
} spot;

typedef struct {
    const design *d;
    unsigned spots;
    unsigned spot_of[NUMBERED]; /* each position's */
    spot spot[NUMBERED];
    unsigned taken_count;
    box taken[TAKEN_MAX]; /* by markers and words */
} map;

static int is_lower(const double v[3])
{
    return v[2] < -EQUATOR;
}

/* Lambert's azimuthal equal-area projection of a half onto a disc, seen from +z: x to the right,
 * y up, the lower half as if the sphere were of glass. */
static void project(const double v[3], double *x, double *y)
{
    const double across = hypot(v[0], v[1]);
    const double radius = RADIUS * sqrt(fmax(0, 1 - fabs(v[2])));

    *x = centre_x[is_lower(v)];
    *y = CENTRE_Y;
    if (across > 0) {
        *x += radius * v[0] / across;
        *y -= radius * v[1] / across;
    }
}

static svg_shape group_shape(unsigned group)
{
    return group == 3 ? SVG_TRIANGLE : group == 2 ? SVG_SQUARE : SVG_CIRCLE;
}

static void find_spots(map *m)
{
    for (unsigned n = 0; n < m->d->count; n++) {
        const design_position *p = &m->d->position[n];
        spot s = {.centre = centre_x[is_lower(p->vertical)], .radius = MARKER, .group = p->group};
        unsigned i = 0;
        project(p->vertical, &s.x, &s.y);
        while (i < m->spots && hypot(s.x - m->spot[i].x, s.y - m->spot[i].y) >= TOGETHER) {
            i++;
        }
        if (i == m->spots) {
            m->spot[m->spots++] = s;
        } else if (m->spot[i].group != p->group) {
            m->spot[i].radius = MARKER + 3;
        }
        m->spot_of[n] = i;
    }
}

/* The numbers of a spot's positions: "2, 15", "1-8", "1, 7, 13 ...". */
static void set_label(map *m, unsigned i)
{
    char *label = m->spot[i].label;
    size_t length = 0;

    for (unsigned n = 0; n < m->d->count; n++) {
        char item[LABEL_MAX];
        unsigned end = n;
        if (m->spot_of[n] != i) {
            continue;
        }
        while (end + 1 < m->d->count && m->spot_of[end + 1] == i) {
            end++;
        }
        end = end > n + 1 ? end : n; /* two in a row: one by one */
        const char *comma = length > 0 ? ", " : "";
        const int size = end > n ? snprintf(item, sizeof item, "%s%u-%u", comma, n + 1, end + 1)
                                 : snprintf(item, sizeof item, "%s%u", comma, n + 1);
        if (length + (size_t)size + 5 > LABEL_MAX) {
            memcpy(label + length, " ...", 5);
            return;
        }
        memcpy(label + length, item, (size_t)size + 1);
        length += (size_t)size;
        n = end;
    }
}

static void take(map *m, box b)
{
    m->taken[m->taken_count++] = b;
}

static int is_free(const map *m, box b)
{
    for (unsigned i = 0; i < m->taken_count; i++) {
        const box *t = &m->taken[i];
        if (fabs(b.x - t->x) < b.w + t->w && fabs(b.y - t->y) < b.h + t->h) {
            return 0;
        }
    }
    return fabs(b.x - MAP_WIDTH / 2) + b.w < MAP_WIDTH / 2 - 4 &&
           fabs(b.y - CENTRE_Y) + b.h < REACH;
}

/* What speaks against a place for a label: lines that run through it. */
static double blemish(box b, double centre)
{
    const double dx = fabs(b.x - centre);
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
        width += *c >= '0' && *c <= '9' ? DIGIT : PERIOD;
    }
    return width;
}

/* Looks for a free place around a spot, near ones and the upper right first. */
static void place_label(const map *m, spot *s)
{
    static const int side[8][2] = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1},
                                   {1, 0}, {-1, 0}, {0, 1},  {0, -1}};
    const double w = label_width(s->label) / 2;
    const double h = 6;
    double least = HUGE_VAL;

    for (unsigned ring = 0; ring < 4; ring++) {
        for (unsigned k = 0; k < 8; k++) {
            const double away = s->radius + (k < 4 ? 1.6 + 7 * ring : 3.5 + 10 * ring);
            const box b = {s->x + side[k][0] * (away + w), s->y - side[k][1] * (away + h), w, h};
            const double cost = 7 * ring + 0.25 * k + blemish(b, s->centre);
            if (cost < least && is_free(m, b)) {
                least = cost;
                s->place = b;
                s->anchor = side[k][0] > 0 ? SVG_START : side[k][0] < 0 ? SVG_END : SVG_MIDDLE;
                s->is_labelled = 1;
            }
        }
    }
}

/* Returns how many spots remain without a label. */
static unsigned place_labels(map *m)
{
    unsigned homeless = 0;

    for (unsigned i = 0; i < m->spots; i++) {
        const spot *s = &m->spot[i];
        take(m, (box){s->x, s->y, s->radius + 1.5, s->radius + 1.5});
    }
    for (unsigned i = 0; i < m->spots; i++) {
        spot *s = &m->spot[i];
        set_label(m, i);
        place_label(m, s);
        if (s->is_labelled) { /* with some room about it, lest two read as one */
            take(m, (box){s->place.x, s->place.y, s->place.w + 4, s->place.h + 5});
        }
        homeless += !s->is_labelled;
    }
    return homeless;
}

static void draw_label(FILE *file, const spot *s)
{
    const box *b = &s->place;
    const double x = b->x + fmax(-b->w, fmin(b->w, s->x - b->x)); /* of its edge, the nearest */
    const double y = b->y + fmax(-b->h, fmin(b->h, s->y - b->y));
    const double end = s->anchor == SVG_START ? -b->w : s->anchor == SVG_END ? b->w : 0;

    if (hypot(x - s->x, y - s->y) > s->radius + 7) { /* far off: tie it to its spot */
        svg_line(file, "rule", s->x, s->y, x, y);
    }
    svg_text(file, "ink small", s->anchor, b->x + end, b->y + 4.3, s->label);
}

/* The axes pierce the sphere at four places of the rim, seen in both halves, and in the middle. */
static box axis_name_place(unsigned axis, unsigned half)
{
    static const double place[INVCAL_AXES][2] = {
        {RADIUS + 19, 0}, {-RADIUS - 19, 0}, {0, -RADIUS - 18},
        {0, RADIUS + 18}, {-15, 13},         {-15, 13},
    };

    return (box){centre_x[half] + place[axis][0], CENTRE_Y + place[axis][1], 13, 10};
}

static int is_shown(unsigned axis, unsigned half)
{
    return axis < INVCAL_AXIS_PLUS_Z || axis == INVCAL_AXIS_PLUS_Z + half;
}

static void take_axis_names(map *m)
{
    for (unsigned i = 0; i < 2 * INVCAL_AXES; i++) {
        if (is_shown(i / 2, i % 2)) {
            take(m, axis_name_place(i / 2, i % 2));
        }
    }
}

static void draw_axis_names(FILE *file)
{
    for (unsigned i = 0; i < 2 * INVCAL_AXES; i++) {
        if (is_shown(i / 2, i % 2)) {
            const box b = axis_name_place(i / 2, i % 2);
            svg_text(file, "soft", SVG_MIDDLE, b.x, b.y + 5, design_axis_name(i / 2));
        }
    }
}

/* Parallels and meridians every 30 degrees. */
static void draw_graticule(FILE *file, double x)
{
    for (unsigned i = 0; i < 12; i++) {
        const double c = cos(i * TURN / 12);
        const double s = sin(i * TURN / 12);
        svg_line(file, "grid", x, CENTRE_Y, x + RADIUS * c, CENTRE_Y - RADIUS * s);
    }
    for (unsigned i = 1; i < 3; i++) {
        svg_circle(file, "grid", x, CENTRE_Y, RADIUS * sqrt(1 - sin(i * TURN / 12)));
    }
    svg_circle(file, "rule", x, CENTRE_Y, RADIUS);
}

/* A position of a later group at the same spot is drawn smaller than the marker that it lies on. */
static void draw_positions(FILE *file, const map *m)
{
    static const char *const full[] = {"c1 full", "c1 full", "c2 full", "c3 full"};
    static const char *const over[] = {"c1 over", "c1 over", "c2 over", "c3 over"};
    const unsigned count = m->d->count;

    for (unsigned n = 0; n < count; n++) {
        const unsigned group = m->d->position[n].group;
        const spot *s = m->spots > 0 ? &m->spot[m->spot_of[n]] : NULL;
        const double alone = count <= NUMBERED ? MARKER : count <= 300 ? 3 : 1.8;
        const int is_upon = s && s->group != group;
        double x;
        double y;
        project(m->d->position[n].vertical, &x, &y);
        svg_marker(file, is_upon ? over[group] : full[group], group_shape(group), x, y,
                   s && !is_upon ? s->radius : alone);
    }
}

/* The end of a name of any length, in characters; it may be a path, whose end tells most. */
static const char *shorten(const char *name, char text[TEXT_MAX])
{
    size_t start[NAME_SHOWN]; /* of the last NAME_SHOWN characters, in turns */
    size_t characters = 0;

    for (size_t i = 0; name[i] != '\0'; characters++) {
        const unsigned length = svg_character(name + i);
        start[characters % NAME_SHOWN] = i;
        i += length > 0 ? length : 1;
    }
    if (characters <= NAME_SHOWN) {
        return name;
    }
    snprintf(text, TEXT_MAX, "...%s", name + start[characters % NAME_SHOWN]);
    return text;
}

static void draw_group_legend(FILE *file)
{
    for (unsigned group = 1; group <= INVCAL_PLAN_GROUPS; group++) {
        static const char *const styles[] = {"c1 full", "c2 full", "c3 full"};
        char text[TEXT_MAX];
        const double x = 20 + 110 * (group - 1);
        snprintf(text, sizeof text, "group %u", group);
        svg_marker(file, styles[group - 1], group_shape(group), x, LEGEND_Y - 5, MARKER);
        svg_text(file, "ink", SVG_START, x + 12, LEGEND_Y, text);
    }
}

static void draw_map_words(FILE *file, const map *m, unsigned homeless)
{
    char text[TEXT_MAX];

    svg_text(file, "ink title", SVG_START, 12, 27, shorten(m->d->name, text));
    snprintf(text, sizeof text, "%u position%s: where up points in the axes of the instrument",
             m->d->count, m->d->count == 1 ? "" : "s");
    svg_text(file, "ink", SVG_START, 12, 48, text);
    svg_text(file, "soft small", SVG_MIDDLE, centre_x[0], CAPTION_Y,
             "z up, and the equator, seen from +z");
    svg_text(file, "soft small", SVG_MIDDLE, centre_x[1], CAPTION_Y,
             "z down, seen from +z through the sphere");
    if (m->d->plan.per_group > 0) {
        draw_group_legend(file);
    }
    if (homeless > 0) {
        snprintf(text, sizeof text, "without a number for want of room: %u spots", homeless);
        svg_text(file, "soft small", SVG_END, MAP_WIDTH - 12, LEGEND_Y, text);
    }
}

static void describe_map(const design *d, char *text, size_t size)
{
    unsigned upper = 0;
    unsigned lower = 0;

    for (unsigned n = 0; n < d->count; n++) {
        lower += is_lower(d->position[n].vertical) != 0;
        upper += d->position[n].vertical[2] > EQUATOR;
    }
    snprintf(text, size,
             "Two discs, the halves of the sphere of directions in equal-area projection, z up and "
             "z down, both seen from +z, with a grid of 30 degrees. Of %u positions %u have z up, "
             "%u z down, %u z level. Axes that point straight up in some position:",
             d->count, upper, lower, d->count - upper - lower);
    for (unsigned i = 0; i < INVCAL_AXES; i++) {
        if ((unsigned)d->axes >> i & 1u) {
            const size_t length = strlen(text);
            snprintf(text + length, size - length, " %s", design_axis_name(i));
        }
    }
    const size_t length = strlen(text);
    snprintf(text + length, size - length, d->axes ? "." : " none.");
}

void plan_svg_directions(FILE *file, const design *d)
{
    map m = {.d = d};
    char text[TEXT_MAX];
    char title[TEXT_MAX];

    describe_map(d, text, sizeof text);
    snprintf(title, sizeof title, "%s: directions of %u positions", d->name, d->count);
    if (d->count <= NUMBERED) {
        find_spots(&m);
    }
    take_axis_names(&m);
    const unsigned homeless = place_labels(&m);
    svg_begin(file, MAP_WIDTH,
              d->plan.per_group > 0 || homeless > 0 ? MAP_HEIGHT_LEGEND : MAP_HEIGHT, title, text);
    draw_graticule(file, centre_x[0]);
    draw_graticule(file, centre_x[1]);
    draw_axis_names(file);
    for (unsigned i = 0; i < m.spots; i++) {
        if (m.spot[i].is_labelled) {
            draw_label(file, &m.spot[i]);
        }
    }
    draw_positions(file, &m);
    draw_map_words(file, &m, homeless);
    svg_end(file);
}
