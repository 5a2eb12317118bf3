/* SPDX-License-Identifier: MIT
 *
 * The picture of a sweep: sigma against the number of positions.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "invcal/plan.h"
#include "plan/programs.h"
#include "plan/words.h"
#include "draw/svg.h"

#define TEXT_MAX 2000
#define ALL_AXES ((1u << INVCAL_AXES) - 1)

#define STANDALONE_WIDTH 560.0 /* in a file */
#define LEFT 52.0
#define RIGHT 14.0
#define PLOT_HEIGHT 254.0  /* without labels */
#define BOTTOM_HEIGHT 46.0 /* of the labels below it */
#define TITLE_HEIGHT 36.0  /* only in a separate file */
#define NOTES_HEIGHT 40.0
#define LEGEND_ROW 22.0
#define MARKER 4.5    /* radius */
#define CHARACTER 6.0 /* width in a legend, about */
#define RING {"c0 curve", "c0 curve", "c0 curve", "c0 curve"}
#define FULL {"c0 over", "c1 over", "c2 over", "c3 over"}
#define HOLLOW {"c0 hollow", "c1 hollow", "c2 hollow", "c3 hollow"}
#define LOGARITHMIC_RATIO 20.0 /* of last to first, from which on the axis is logarithmic */

typedef struct {
    const char *name;
    const char *style[3]; /* of the curve, of full and hollow markers */
    svg_shape shape;
} curve;

static const curve curves[PLAN_KINDS] = {
    {"offsets (over the field)", {"c1 curve", "c1 full", "c1 hollow"}, SVG_CIRCLE},
    {"scale errors", {"c2 curve", "c2 full", "c2 hollow"}, SVG_SQUARE},
    {"angles (rad)", {"c3 curve", "c3 full", "c3 hollow"}, SVG_TRIANGLE},
};

/* The known programs: those on the curves have a ring, and one entry in the legend together. */
static const struct {
    const char *name;
    const char *style[1 + PLAN_KINDS]; /* in the legend; of each kind */
    svg_shape shape;
    double radius;
} marks[PLAN_PROGRAMS] = {
    [PLAN_15] = {"3 x 5, 3 x 6, stand-24", RING, SVG_CIRCLE, 8},
    [PLAN_18] = {NULL, RING, SVG_CIRCLE, 8},
    [PLAN_STAND_24] = {NULL, RING, SVG_CIRCLE, 8},
    [PLAN_EDGES] = {"faces and edges", FULL, SVG_DIAMOND, 5},
    [PLAN_STAND_12] = {"stand-12", FULL, SVG_CROSS, 5},
    [PLAN_ICOSAHEDRON] = {"icosahedron", HOLLOW, SVG_DIAMOND, 6},
};

typedef struct {
    const plan_row *rows;
    unsigned count;
    const design *set; /* of the known programs */
    double width;
    ruler x;
    ruler y;
} plot;

static double row_positions(const plan_row *row)
{
    return INVCAL_PLAN_GROUPS * row->per_group;
}

/* A sweep from the smallest program on also shows the known ones of fewer positions. */
static double first_of(const plot *p)
{
    double first = row_positions(&p->rows[0]);

    for (unsigned i = 0; p->rows[0].per_group == INVCAL_PLAN_PER_GROUP_MIN && i < PLAN_PROGRAMS;
         i++) {
        first = fmin(first, p->set[i].count);
    }
    return first;
}

static double last_of(const plot *p)
{
    return row_positions(&p->rows[p->count - 1]);
}

static int is_shown(const plot *p, unsigned program)
{
    return p->set[program].count >= first_of(p) && p->set[program].count <= last_of(p);
}

static int is_any_on_curve(const plot *p)
{
    return is_shown(p, PLAN_15) || is_shown(p, PLAN_18) || is_shown(p, PLAN_STAND_24);
}

static ruler positions_axis(const plot *p)
{
    ruler a = {first_of(p), last_of(p), LEFT, p->width - RIGHT, 0, 0};

    a.is_logarithmic = a.last >= LOGARITHMIC_RATIO * a.first;
    if (a.is_logarithmic) {
        a.first = log(a.first);
        a.last = log(a.last);
    }
    const double margin = a.last > a.first ? 0.03 * (a.last - a.first) : INVCAL_PLAN_GROUPS;
    a.first -= margin;
    a.last += margin;
    return a;
}

/* From 0 to a round number above the highest point. */
static ruler sigma_axis(const plot *p, double top)
{
    double highest = 0;

    for (unsigned i = 0; i < p->count; i++) {
        highest = fmax(highest, plan_sigma_largest(&p->rows[i].criteria));
    }
    return chart_ruler(0, highest, top + PLOT_HEIGHT, top, 8);
}

static void draw_tick_x(FILE *file, const plot *p, double value)
{
    char text[SVG_NUMBER_MAX];
    const double at = chart_pixel(&p->x, value);

    svg_line(file, "grid", at, p->y.to, at, p->y.from);
    svg_text(file, "ink small", SVG_MIDDLE, at, p->y.from + 17, svg_fixed(value, 0, text));
}

/* Ticks are at programs that exist, multiples of 3: 3 times 1, 2, 5, 10 ... on a logarithmic axis,
 * multiples of one of these on a linear one. */
static void draw_ticks_x(FILE *file, const plot *p)
{
    const double first = first_of(p);
    const double last = last_of(p);
    const double ticks = floor(p->width / 50);

    if (p->x.is_logarithmic) {
        for (double v = chart_round_step(first / 3); 3 * v <= last; v = chart_round_step(1.5 * v)) {
            draw_tick_x(file, p, 3 * v);
        }
        return;
    }
    const double step = 3 * fmax(1, chart_round_step(fmax(1, last - first) / (3 * ticks)));
    for (double k = ceil(first / step); k * step <= last; k++) {
        draw_tick_x(file, p, k * step);
    }
}

static double height_of(const plot *p, unsigned i, unsigned kind)
{
    return chart_pixel(&p->y, plan_sigma(&p->rows[i].criteria, kind));
}

static void draw_curve(FILE *file, const plot *p, unsigned kind)
{
    svg_polyline_begin(file, curves[kind].style[0]);
    for (unsigned i = 0; i < p->count; i++) {
        svg_polyline_point(file, chart_pixel(&p->x, row_positions(&p->rows[i])),
                           height_of(p, i, kind));
    }
    svg_polyline_end(file);
}

/* Marks programs at least 8 pixels apart. Markers are full for even N and hollow for odd N: an odd
 * number of steps from one marked program to the next shows both. Returns the number of marked
 * programs. */
static unsigned draw_markers(FILE *file, const plot *p)
{
    const double distance = (p->x.to - p->x.from) / p->count;
    const double radius = distance > 16 && !p->x.is_logarithmic ? MARKER : 3.2;
    unsigned marked = 0;
    unsigned last = 0;

    for (unsigned i = 0; i < p->count; i++) {
        const double at = chart_pixel(&p->x, row_positions(&p->rows[i]));
        const double gap = at - chart_pixel(&p->x, row_positions(&p->rows[last]));
        if (marked > 0 && (gap < 8 || (i - last) % 2 == 0)) {
            continue;
        }
        for (unsigned k = 0; k < PLAN_KINDS; k++) {
            const char *style = curves[k].style[p->rows[i].axes == ALL_AXES ? 1 : 2];
            svg_marker(file, style, curves[k].shape, at, height_of(p, i, k), radius);
        }
        marked++;
        last = i;
    }
    return marked;
}

/* The icosahedron first: stand-12 is nearly at the same place, and its cross is visible on a
 * diamond. */
static void draw_known(FILE *file, const plot *p)
{
    for (unsigned i = PLAN_PROGRAMS; i-- > 0;) {
        const criteria *c = &p->set[i].criteria;
        for (unsigned k = 0; k < PLAN_KINDS && is_shown(p, i); k++) {
            svg_marker(file, marks[i].style[1 + k], marks[i].shape,
                       chart_pixel(&p->x, p->set[i].count), chart_pixel(&p->y, plan_sigma(c, k)),
                       marks[i].radius);
        }
    }
}

/* Reserves the space of one more entry, in this row or the next. */
static void reserve_entry(double *x, double *y, const char *words, double width)
{
    const double needed = 34 + CHARACTER * (double)strlen(words);

    if (*x + needed > width) {
        *x = 0;
        *y += LEGEND_ROW;
    }
    *x += needed;
}

/* One entry of the legend. */
typedef struct {
    const char *line; /* null: a marker only */
    const char *style;
    svg_shape shape;
    double radius;
    const char *words;
} entry;

/* All of them, in order. Returns their number. */
static unsigned list_entries(const plot *p, entry list[PLAN_KINDS + 2 + PLAN_PROGRAMS])
{
    unsigned count = 0;

    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        list[count++] = (entry){curves[k].style[0], curves[k].style[1], curves[k].shape, MARKER,
                                curves[k].name};
    }
    list[count++] = (entry){NULL, "c0 full", SVG_CIRCLE, MARKER, "all six axes along gravity"};
    list[count++] = (entry){NULL, "c0 hollow", SVG_CIRCLE, MARKER, "not all six"};
    for (unsigned i = 0; i < PLAN_PROGRAMS; i++) {
        const int is_on_curve = i <= PLAN_STAND_24;
        if (marks[i].name && (is_shown(p, i) || (is_on_curve && is_any_on_curve(p)))) {
            list[count++] =
                (entry){NULL, marks[i].style[0], marks[i].shape, marks[i].radius, marks[i].name};
        }
    }
    return count;
}

/* The legend from `top` on; returns where it ends. If file is null it is only measured. */
static double draw_legend(FILE *file, const plot *p, double top)
{
    entry list[PLAN_KINDS + 2 + PLAN_PROGRAMS];
    const unsigned count = list_entries(p, list);
    double right = 0;
    double y = top + 10;

    for (unsigned i = 0; i < count; i++) {
        const entry *e = &list[i];
        reserve_entry(&right, &y, e->words, p->width);
        const double x = right - CHARACTER * (double)strlen(e->words) - 34;
        if (!file) {
            continue;
        }
        if (e->line) {
            svg_line(file, e->line, x, y, x + 24, y);
        }
        svg_marker(file, e->style, e->shape, x + 12, y, e->radius);
        svg_text(file, "ink small", SVG_START, x + (e->line ? 29 : 24), y + 4, e->words);
    }
    return y + LEGEND_ROW / 2;
}

static void describe_set(const char *name, const criteria *c, char *text, size_t size)
{
    char figures[PLAN_KINDS][SVG_NUMBER_MAX];
    const size_t length = strlen(text);

    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        svg_fixed(plan_sigma(c, k), 3, figures[k]);
    }
    snprintf(text + length, size - length,
             " %s %u positions: offsets %s, scale errors %s, angles %s.", name, c->positions,
             figures[0], figures[1], figures[2]);
}

static void describe_sweep(const plot *p, char *text, size_t size)
{
    const plan_row *rows = p->rows;
    const unsigned count = p->count;
    unsigned all = 0;

    for (unsigned i = 0; i < count; i++) {
        all += rows[i].axes == ALL_AXES;
    }
    snprintf(text, size,
             "Standard deviations over the noise of a position mean, for programs of three groups "
             "of N positions; the largest of the three axes each. They fall as 1 over the square "
             "root of N.");
    describe_set("With", &rows[0].criteria, text, size);
    if (count > 2) {
        describe_set("With", &rows[count / 2].criteria, text, size);
    }
    if (count > 1) {
        describe_set("With", &rows[count - 1].criteria, text, size);
    }
    const size_t length = strlen(text);
    snprintf(text + length, size - length,
             " All six of +x, -x, +y, -y, +z, -z point up in some position of %u of %u programs.",
             all, count);
    for (unsigned i = PLAN_EDGES; i < PLAN_PROGRAMS; i++) {
        if (is_shown(p, i)) {
            char name[PLAN_WORDS_MAX];
            snprintf(name, sizeof name, "Next to the curves, %s,", marks[i].name);
            describe_set(name, &p->set[i].criteria, text, size);
        }
    }
}

/* The chart with its legend, from `top` on. Returns the number of programs with a marker. */
static unsigned draw_chart(FILE *file, const plot *p, double top)
{
    draw_legend(file, p, top);
    svg_text(file, "ink heading", SVG_START, 0, p->y.to - 12,
             "σ, times the noise of a position mean");
    draw_ticks_x(file, p);
    chart_ticks_y(file, &p->y, &p->x);
    svg_line(file, "rule", p->x.from, p->y.to, p->x.from, p->y.from);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        draw_curve(file, p, k);
    }
    svg_text(file, "ink small", SVG_MIDDLE, (p->x.from + p->x.to) / 2, p->y.from + 38,
             p->x.is_logarithmic ? "number of positions (logarithmic)" : "number of positions");
    const unsigned marked = draw_markers(file, p);
    draw_known(file, p);
    return marked;
}

static plot begin_plot(const plan_sweep *s, double width, double top)
{
    plot p = {.rows = s->rows, .count = s->count, .set = s->programs->set, .width = width};

    p.x = positions_axis(&p);
    p.y = sigma_axis(&p, draw_legend(NULL, &p, top) + 32);
    return p;
}

static const char title[] = "Standard deviations against number of positions";

void plan_svg_sweep(FILE *file, const plan_sweep *s)
{
    char description[TEXT_MAX];
    const plot p = begin_plot(s, STANDALONE_WIDTH - 24, TITLE_HEIGHT);

    describe_sweep(&p, description, sizeof description);
    svg_begin(file, STANDALONE_WIDTH, p.y.from + BOTTOM_HEIGHT + NOTES_HEIGHT, title, description);
    svg_group_begin(file, 12, 0);
    svg_text(file, "ink title", SVG_START, 0, 27, "Standard deviations of the 3 x N programs");
    const unsigned marked = draw_chart(file, &p, TITLE_HEIGHT);
    svg_text(file, "soft small", SVG_START, 0, p.y.from + BOTTOM_HEIGHT + 12,
             "1 means, with a noise of 1e-6 of the field: 1e-6 of the field, 1e-6, 1 µrad.");
    svg_text(file, "soft small", SVG_START, 0, p.y.from + BOTTOM_HEIGHT + 29,
             marked < p.count
                 ? "Each value is the largest of three. Not every program has a marker."
                 : "Each value is the largest of three.");
    svg_group_end(file);
    svg_end(file);
}

void plan_svg_sweep_inline(FILE *file, const plan_sweep *s, double width)
{
    char description[TEXT_MAX];
    const plot p = begin_plot(s, width, 0);

    describe_sweep(&p, description, sizeof description);
    svg_begin_inline(file, width, p.y.from + BOTTOM_HEIGHT, title, description);
    (void)draw_chart(file, &p, 0);
    svg_end(file);
}
