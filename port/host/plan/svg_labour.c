/* SPDX-License-Identifier: MIT
 *
 * The picture of total time against number of positions.
 */
#include <math.h>

#include "draw/chart.h"
#include "plan/labour.h"
#include "plan/words.h"
#include "draw/svg.h"

#define TEXT_MAX 1000
#define STANDALONE_WIDTH 560.0 /* in a file */
#define TITLE_HEIGHT 36.0
#define LEFT 52.0
#define RIGHT 14.0
#define TOP 62.0 /* legend and heading */
#define PLOT_HEIGHT 254.0
#define BOTTOM_HEIGHT 46.0
#define SHOWN_TIME 2.5 /* times the least time, at most */

static const struct {
    const char *curve;
    const char *full;
    svg_shape shape;
} styles[CHOICE_FAMILIES] = {
    {"c1 curve", "c1 full", SVG_SQUARE},
    {"c2 curve", "c2 full", SVG_CIRCLE},
};

typedef struct {
    const labour *l;
    ruler x;
    ruler y;
    const char *unit; /* of time, */
    double scale;     /* seconds in it */
} plot;

static const labour_row *chosen(const labour *l)
{
    return l->best[l->chosen];
}

static int is_shown(const labour *l, const labour_row *row)
{
    return row->is_possible && row->seconds <= SHOWN_TIME * chosen(l)->seconds &&
           row->count <= LABOUR_RANGE * chosen(l)->count;
}

static plot begin_plot(const labour *l, double width, double top)
{
    plot p = {.l = l, .unit = "s", .scale = 1};
    double min = HUGE_VAL;
    double max = 0;
    double highest = 0;

    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        for (unsigned i = 0; i < l->rows[f]; i++) {
            const labour_row *row = &l->row[f][i];
            if (is_shown(l, row)) {
                min = fmin(min, row->count);
                max = fmax(max, row->count);
                highest = fmax(highest, row->seconds);
            }
        }
    }
    if (highest >= 3 * 3600) {
        p.unit = "hours";
        p.scale = 3600;
    } else if (highest >= 3 * 60) {
        p.unit = "minutes";
        p.scale = 60;
    }
    p.x = chart_ruler_exact(min - 1, max + 1, LEFT, width - RIGHT, (unsigned)(width / 60));
    p.x.step = fmax(1, p.x.step);
    p.y = chart_ruler(0, highest / p.scale, top + TOP + PLOT_HEIGHT, top + TOP, 6);
    return p;
}

static void draw_family(FILE *file, const plot *p, unsigned family)
{
    const labour *l = p->l;

    svg_polyline_begin(file, styles[family].curve);
    for (unsigned i = 0; i < l->rows[family]; i++) {
        const labour_row *row = &l->row[family][i];
        if (is_shown(l, row)) {
            svg_polyline_point(file, chart_pixel(&p->x, row->count),
                               chart_pixel(&p->y, row->seconds / p->scale));
        }
    }
    svg_polyline_end(file);
    for (unsigned i = 0; i < l->rows[family]; i++) {
        const labour_row *row = &l->row[family][i];
        if (is_shown(l, row)) {
            svg_marker(file, styles[family].full, styles[family].shape,
                       chart_pixel(&p->x, row->count), chart_pixel(&p->y, row->seconds / p->scale),
                       2.6);
        }
    }
}

static void draw_legend(FILE *file, double top)
{
    double x = 0;

    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        svg_line(file, styles[f].curve, x, top + 10, x + 24, top + 10);
        svg_marker(file, styles[f].full, styles[f].shape, x + 12, top + 10, 3.6);
        svg_text(file, "ink small", SVG_START, x + 29, top + 14, labour_families[f]);
        x += 128;
    }
    svg_marker(file, "c0 hollow", SVG_TARGET, x + 10, top + 12, 6);
    svg_text(file, "ink small", SVG_START, x + 25, top + 14, "chosen");
}

static void describe(const labour *l, char *text, size_t size)
{
    const labour_row *row = chosen(l);
    char time[PLAN_WORDS_MAX];

    snprintf(text, size,
             "Total time against number of positions, for programs of a stand and for free "
             "directions, each with the shortest dwell that meets the limits. Chosen: %u "
             "positions of %.4g seconds, %s in all.",
             row->count, row->dwell, plan_time_text(row->seconds, time));
}

static void draw_chart(FILE *file, const plot *p, double top)
{
    const labour_row *row = chosen(p->l);
    char text[TEXT_MAX];

    draw_legend(file, top);
    snprintf(text, sizeof text, "total time, %s", p->unit);
    svg_text(file, "ink heading", SVG_START, 0, p->y.to - 16, text);
    chart_ticks_x(file, &p->x, &p->y);
    chart_ticks_y(file, &p->y, &p->x);
    svg_line(file, "rule", p->x.from, p->y.to, p->x.from, p->y.from);
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        draw_family(file, p, f);
    }
    svg_marker(file, "c0 hollow", SVG_TARGET, chart_pixel(&p->x, row->count),
               chart_pixel(&p->y, row->seconds / p->scale), 7);
    svg_text(file, "soft small", SVG_MIDDLE, (p->x.from + p->x.to) / 2, p->y.from + 38,
             "number of positions");
}

static const char title[] = "Total time against number of positions";

void labour_svg(FILE *file, const labour *l)
{
    const plot p = begin_plot(l, STANDALONE_WIDTH - 24, TITLE_HEIGHT);
    char description[TEXT_MAX];

    describe(l, description, sizeof description);
    svg_begin(file, STANDALONE_WIDTH, p.y.from + BOTTOM_HEIGHT, title, description);
    svg_group_begin(file, 12, 0);
    svg_text(file, "ink title", SVG_START, 0, 27, title);
    draw_chart(file, &p, TITLE_HEIGHT);
    svg_group_end(file);
    svg_end(file);
}

static void draw_inline(FILE *file, const void *data, double width)
{
    const labour *l = data;
    const plot p = begin_plot(l, width, 0);
    char description[TEXT_MAX];

    describe(l, description, sizeof description);
    svg_begin_inline(file, width, p.y.from + BOTTOM_HEIGHT, title, description);
    draw_chart(file, &p, 0);
    svg_end(file);
}

void labour_picture(page *p, const labour *l)
{
    page_picture(p,
                 "Total time, settling and moving included, with the shortest dwell that meets the "
                 "limits. Fewer positions need longer rests; more positions need more moves.",
                 draw_inline, l);
}
