/* SPDX-License-Identifier: MIT
 *
 * The range of the axes, and which of them are along gravity in some position.
 */
#include "draw/chart.h"
#include "plan/facts.h"

#define TEXT_MAX 200
#define LEFT 24.0
#define RIGHT 16.0
#define TOP 34.0
#define ROW 26.0

static void draw_range(FILE *file, const design *d, unsigned i, const ruler *x)
{
    const double y = TOP + (i + 0.5) * ROW;
    const double low = chart_pixel(x, d->range[i][0]);
    const char name[2] = {(char)('x' + i), '\0'};

    svg_text(file, "ink", SVG_END, LEFT - 10, y + 5, name);
    svg_rectangle(file, "c1 bar", low, y - 6, chart_pixel(x, d->range[i][1]) - low, 12);
    for (unsigned side = 0; side < 2; side++) { /* +, - */
        const int is_there = d->axes >> (2 * i + side) & 1;
        svg_marker(file, is_there ? "c3 over" : "c2 hollow", is_there ? SVG_CIRCLE : SVG_SQUARE,
                   chart_pixel(x, side == 0 ? 1 : -1), y, 5);
    }
}

static void draw_coverage(FILE *file, const void *data, double width)
{
    const plan_facts *f = data;
    const ruler x = chart_ruler_exact(-1, 1, LEFT + 10, width - RIGHT, width > PAGE_NARROW ? 8 : 4);
    const ruler y = {0, 1, TOP + 3 * ROW, TOP, 0, 0};
    char text[TEXT_MAX];
    const double(*range)[2] = f->set->range;

    snprintf(
        text, sizeof text,
        "Range of each axis in g: x from %.2f to %.2f, y from %.2f to %.2f, z from %.2f to %.2f.",
        range[0][0], range[0][1], range[1][0], range[1][1], range[2][0], range[2][1]);
    svg_begin_inline(file, width, TOP + 3 * ROW + 42, "The range of each axis", text);
    svg_marker(file, "c3 full", SVG_CIRCLE, LEFT + 10, 12, 5);
    svg_text(file, "ink small", SVG_START, LEFT + 22, 16, "along gravity");
    svg_marker(file, "c2 hollow", SVG_SQUARE, LEFT + 126, 12, 5);
    svg_text(file, "ink small", SVG_START, LEFT + 138, 16, "never along gravity");
    chart_ticks_x(file, &x, &y);
    for (unsigned i = 0; i < 3; i++) {
        draw_range(file, f->set, i, &x);
    }
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width) / 2, TOP + 3 * ROW + 36,
             "acceleration along the axis, g");
    svg_end(file);
}

void plan_report_coverage(page *p, const plan_facts *f)
{
    const unsigned missing = plan_missing_axes(f->set->axes);
    char text[PLAN_WORDS_MAX];

    page_section(p, "Range of the axes");
    if (missing) {
        page_say(p, "Never along gravity: %s; %s.", plan_axes_text(missing, text),
                 plan_missing_reason(f->set));
    } else {
        page_say(p, "All six of +x, -x, +y, -y, +z, -z point along gravity.");
    }
    page_picture(
        p, "Minimum and maximum along each axis. Readings beyond them rely on a linear sensor.",
        draw_coverage, f);
}
