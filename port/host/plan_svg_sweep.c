/* SPDX-License-Identifier: MIT
 *
 * The picture of a sweep: sigma against the number of positions.
 */
#include <math.h>
#include <string.h>

#include "chart.h"
#include "plan_words.h"
#include "svg.h"

#define TEXT_MAX 1000
#define ALL_AXES ((1u << INVCAL_AXES) - 1)

#define ALONE 560.0 /* width as a file of its own */
#define LEFT 52.0
#define RIGHT 14.0
#define PLOT 254.0 /* height of the chart proper */
#define BELOW 46.0 /* for figures and words under it */
#define TITLE 36.0 /* and what a file of its own has besides */
#define NOTES 40.0
#define LEGEND_ROW 22.0
#define CHARACTER 6.0    /* width in a legend, about */
#define LOGARITHMIC 20.0 /* from this ratio of last to first on */

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

typedef struct {
    const plan_row *rows;
    unsigned count;
    double width;
    ruler x;
    ruler y;
} plot;

static double row_positions(const plan_row *row)
{
    return INVCAL_PLAN_GROUPS * row->per_group;
}

static double first_of(const plot *p)
{
    return row_positions(&p->rows[0]);
}

static double last_of(const plot *p)
{
    return row_positions(&p->rows[p->count - 1]);
}

static ruler positions_axis(const plot *p)
{
    ruler a = {first_of(p), last_of(p), LEFT, p->width - RIGHT, 0, 0};

    a.is_logarithmic = a.last >= LOGARITHMIC * a.first;
    if (a.is_logarithmic) {
        a.first = log(a.first);
        a.last = log(a.last);
    }
    const double margin = p->count > 1 ? 0.03 * (a.last - a.first) : INVCAL_PLAN_GROUPS;
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
    return chart_ruler(0, highest, top + PLOT, top, 8);
}

static void draw_tick_x(FILE *file, const plot *p, double value)
{
    char text[SVG_NUMBER_MAX];
    const double at = chart_pixel(&p->x, value);

    svg_line(file, "grid", at, p->y.to, at, p->y.from);
    svg_text(file, "ink small", SVG_MIDDLE, at, p->y.from + 17, svg_fixed(value, 0, text));
}

/* Ticks stand at programs that exist, multiples of 3: 3 times 1, 2, 5, 10 ... on a logarithmic
 * axis, multiples of one of these on a linear one. */
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

/* Marks programs at least 8 pixels apart. Full and hollow markers take turns, as even and odd N
 * do: an odd number of steps from one marked program to the next keeps both in sight. Returns the
 * number that are marked. */
static unsigned draw_markers(FILE *file, const plot *p)
{
    const double apart = (p->x.to - p->x.from) / p->count;
    const double radius = apart > 16 && !p->x.is_logarithmic ? 4.5 : 3.2;
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

/* A place for one more entry, in this row or the next. */
static void advance(double *x, double *y, const char *words, double width)
{
    const double needed = 34 + CHARACTER * (double)strlen(words);

    if (*x + needed > width) {
        *x = 0;
        *y += LEGEND_ROW;
    }
    *x += needed;
}

/* The legend from `top` on; returns where it ends. Without a file it is only measured. */
static double draw_legend(FILE *file, double width, double top)
{
    static const struct {
        const char *style;
        const char *words;
    } marks[] = {{"c0 full", "all six axes along gravity"}, {"c0 hollow", "not all six"}};
    double right = 0;
    double y = top + 10;

    for (unsigned k = 0; k < PLAN_KINDS + 2; k++) {
        const int is_curve = k < PLAN_KINDS;
        const char *words = is_curve ? curves[k].name : marks[k - PLAN_KINDS].words;
        advance(&right, &y, words, width);
        const double x = right - CHARACTER * (double)strlen(words) - 34;
        if (!file) {
            continue;
        }
        if (is_curve) {
            svg_line(file, curves[k].style[0], x, y, x + 24, y);
        }
        svg_marker(file, is_curve ? curves[k].style[1] : marks[k - PLAN_KINDS].style,
                   is_curve ? curves[k].shape : SVG_CIRCLE, x + 12, y, 4.5);
        svg_text(file, "ink small", SVG_START, x + (is_curve ? 29 : 21), y + 4, words);
    }
    return y + LEGEND_ROW / 2;
}

static void describe_row(const plan_row *row, char *text, size_t size)
{
    char figures[PLAN_KINDS][SVG_NUMBER_MAX];
    const size_t length = strlen(text);

    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        svg_fixed(plan_sigma(&row->criteria, k), 3, figures[k]);
    }
    snprintf(text + length, size - length,
             " With %u positions: offsets %s, scale errors %s, angles %s.",
             INVCAL_PLAN_GROUPS * row->per_group, figures[0], figures[1], figures[2]);
}

static void describe_sweep(const plan_row *rows, unsigned count, char *text, size_t size)
{
    unsigned all = 0;

    for (unsigned i = 0; i < count; i++) {
        all += rows[i].axes == ALL_AXES;
    }
    snprintf(text, size,
             "Standard deviations over the noise of a position mean, for programs of three groups "
             "of N positions; the largest of the three axes each. They fall as 1 over the square "
             "root of N.");
    describe_row(&rows[0], text, size);
    if (count > 2) {
        describe_row(&rows[count / 2], text, size);
    }
    if (count > 1) {
        describe_row(&rows[count - 1], text, size);
    }
    const size_t length = strlen(text);
    snprintf(text + length, size - length,
             " All six of +x, -x, +y, -y, +z, -z point up in some position of %u of %u programs.",
             all, count);
}

/* The chart with its legend, from `top` on. Returns the number of programs with a marker. */
static unsigned draw_chart(FILE *file, const plot *p, double top)
{
    draw_legend(file, p->width, top);
    svg_text(file, "ink heading", SVG_START, 0, p->y.to - 12,
             "σ, times the noise of a position mean");
    draw_ticks_x(file, p);
    chart_ticks_y(file, &p->y, &p->x);
    svg_line(file, "rule", p->x.from, p->y.to, p->x.from, p->y.from);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        draw_curve(file, p, k);
    }
    svg_text(file, "ink small", SVG_MIDDLE, (p->x.from + p->x.to) / 2, p->y.from + 38,
             p->x.is_logarithmic ? "number of positions, 3 N (logarithmic)"
                                 : "number of positions, 3 N");
    return draw_markers(file, p);
}

static plot begin_plot(const plan_row *rows, unsigned count, double width, double top)
{
    plot p = {.rows = rows, .count = count, .width = width};

    p.x = positions_axis(&p);
    p.y = sigma_axis(&p, draw_legend(NULL, width, top) + 32);
    return p;
}

static const char title[] = "Standard deviations against number of positions";

void plan_svg_sweep(FILE *file, const plan_row *rows, unsigned count)
{
    char description[TEXT_MAX];
    const plot p = begin_plot(rows, count, ALONE - 24, TITLE);

    describe_sweep(rows, count, description, sizeof description);
    svg_begin(file, ALONE, p.y.from + BELOW + NOTES, title, description);
    svg_group_begin(file, 12, 0);
    svg_text(file, "ink title", SVG_START, 0, 27, "Standard deviations of the 3 x N programs");
    const unsigned marked = draw_chart(file, &p, TITLE);
    svg_text(file, "soft small", SVG_START, 0, p.y.from + BELOW + 12,
             "1 means, with a noise of 1e-6 of the field: 1e-6 of the field, 1e-6, 1 µrad.");
    svg_text(file, "soft small", SVG_START, 0, p.y.from + BELOW + 29,
             marked < count ? "Each value is the largest of three. Not every program has a marker."
                            : "Each value is the largest of three.");
    svg_group_end(file);
    svg_end(file);
}

void plan_svg_sweep_inline(FILE *file, const plan_row *rows, unsigned count, double width)
{
    char description[TEXT_MAX];
    const plot p = begin_plot(rows, count, width, 0);

    describe_sweep(rows, count, description, sizeof description);
    svg_begin_inline(file, width, p.y.from + BELOW, title, description);
    (void)draw_chart(file, &p, 0);
    svg_end(file);
}
