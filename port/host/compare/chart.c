/* SPDX-License-Identifier: MIT
 *
 * Pictures of a comparison: the history of a device's parameters, and their spread in a fleet.
 */
#include <math.h>
#include <string.h>

#include "compare/compare.h"
#include "invcal/result.h"
#include "design/parameters.h"
#include "draw/chart.h"
#include "draw/page.h"
#include "draw/svg.h"
#include "text/figure.h"

#define LEFT 62.0
#define RIGHT 16.0
#define TOP 30.0
#define PLOT_HEIGHT 130.0
#define PANEL_HEIGHT (TOP + PLOT_HEIGHT + 46)
#define ROW 26.0
#define SPREADS_MAX 10.0 /* the axis, to either side */

static const char *const styles[3] = {"c1", "c2", "c3"};
static const svg_shape shapes[3] = {SVG_CIRCLE, SVG_SQUARE, SVG_TRIANGLE};

/* ---- history ----------------------------------------------------------------------------------- */

/* Change of parameter q from the device's first calibration to its calibration k. */
static double since_first(const compare_picture *c, unsigned k, unsigned q)
{
    const compare_result *r = c->result;
    const compare_item *first = &r->item[r->device[c->device].first];

    return compare_page_unit(r, q).scale * (first[k].x[q] - first->x[q]) /
           compare_divisor(first->x, r->field, q);
}

/* Half the 95 % interval of calibration k alone; 0 if it is unknown. */
static double spread_of(const compare_picture *c, unsigned k, unsigned q)
{
    const compare_result *r = c->result;
    const compare_item *first = &r->item[r->device[c->device].first];
    const double spread = invcal_coverage(first[k].dof) * compare_page_unit(r, q).scale *
                          first[k].sigma[q] / fabs(compare_divisor(first->x, r->field, q));

    return isfinite(spread) ? spread : 0;
}

static ruler value_ruler(const compare_picture *c, unsigned kind)
{
    double min = 0;
    double max = 0;

    for (unsigned k = 0; k < c->result->device[c->device].count; k++) {
        for (unsigned q = 3 * kind; q < 3 * kind + 3; q++) {
            min = fmin(min, since_first(c, k, q) - spread_of(c, k, q));
            max = fmax(max, since_first(c, k, q) + spread_of(c, k, q));
        }
    }
    return chart_ruler(min, max, TOP + PLOT_HEIGHT, TOP, 5);
}

/* The three of a kind are drawn slightly apart. */
static double pixel_of(const ruler *x, unsigned k, unsigned axis)
{
    return chart_pixel(x, k + 1.0) + 5 * (axis - 1.0);
}

static void draw_parameter(FILE *file, const compare_picture *c, unsigned q, const ruler *x,
                           const ruler *y)
{
    const unsigned axis = q % 3;
    const unsigned count = c->result->device[c->device].count;
    char style[16];

    snprintf(style, sizeof style, "%s curve", styles[axis]);
    svg_polyline_begin(file, style);
    for (unsigned k = 0; k < count; k++) {
        svg_polyline_point(file, pixel_of(x, k, axis), chart_pixel(y, since_first(c, k, q)));
    }
    svg_polyline_end(file);
    snprintf(style, sizeof style, "%s full", styles[axis]);
    for (unsigned k = 0; k < count; k++) {
        const double at = pixel_of(x, k, axis);
        const double value = since_first(c, k, q);
        const double spread = spread_of(c, k, q);
        svg_line(file, "whisker", at, chart_pixel(y, value - spread), at,
                 chart_pixel(y, value + spread));
        svg_marker(file, style, shapes[axis], at, chart_pixel(y, value), 4);
    }
}

/* The names of the three parameters, to the right of the title. */
static void draw_legend(FILE *file, unsigned kind, double width)
{
    char style[16];

    for (unsigned axis = 0; axis < 3; axis++) {
        const double at = width - RIGHT - 38 * (3.0 - axis);
        const char *name = parameter_words(3 * kind + axis);
        snprintf(style, sizeof style, "%s full", styles[axis]);
        svg_marker(file, style, shapes[axis], at, 11, 4);
        svg_text(file, "ink small", SVG_START, at + 8, 15, strchr(name, ' ') + 1);
    }
}

static void draw_panel(FILE *file, const compare_picture *c, unsigned kind, double width)
{
    static const char *const titles[3] = {"offset", "scale", "angle"};
    const unsigned count = c->result->device[c->device].count;
    const ruler y = value_ruler(c, kind);
    ruler x =
        chart_ruler_exact(0.5, count + 0.5, LEFT, width - RIGHT, width > PAGE_NARROW ? 12 : 6);
    char title[COMPARE_NAME_MAX];

    x.step = fmax(1, x.step);
    snprintf(title, sizeof title, "%s, %s", titles[kind],
             compare_page_unit(c->result, 3 * kind).unit);
    svg_text(file, "ink heading", SVG_START, 0, 16, title);
    draw_legend(file, kind, width);
    chart_ticks_x(file, &x, &y);
    chart_ticks_y(file, &y, &x);
    for (unsigned q = 3 * kind; q < 3 * kind + 3; q++) {
        draw_parameter(file, c, q, &x, &y);
    }
    svg_text(file, "soft small", SVG_MIDDLE, (x.from + x.to) / 2, TOP + PLOT_HEIGHT + 34,
             "calibration");
}

void compare_draw_history(FILE *file, const void *picture, double width)
{
    static const char *const titles[3] = {"Offsets by calibration", "Scales by calibration",
                                          "Angles by calibration"};
    const compare_picture *c = picture;
    const unsigned last = c->result->device[c->device].count - 1;
    char text[500] = "From the first calibration to the last:";

    for (unsigned q = 3 * c->kind; q < 3 * c->kind + 3; q++) {
        const size_t length = strlen(text);
        char number[FIGURE_MAX];
        snprintf(text + length, sizeof text - length, " %s %s %s%s", parameter_words(q),
                 figure_with_sigma(since_first(c, last, q), spread_of(c, last, q), FIGURE_SIGNED,
                                   number),
                 compare_page_unit(c->result, q).unit, q % 3 < 2 ? ";" : ".");
    }
    svg_begin_inline(file, width, PANEL_HEIGHT, titles[c->kind], text);
    draw_panel(file, c, c->kind, width);
    svg_end(file);
}

/* ---- fleet ------------------------------------------------------------------------------------- */

static double spreads(const compare_result *r, unsigned device, unsigned q)
{
    const double x = (compare_newest(r, device)->x[q] - r->fleet.median[q]) / r->fleet.spread[q];

    return x > SPREADS_MAX ? SPREADS_MAX : x < -SPREADS_MAX ? -SPREADS_MAX : x;
}

/* One row, with outliers on top. */
static void draw_row(FILE *file, const compare_result *r, unsigned q, const ruler *x)
{
    const double y = TOP + (q + 0.5) * ROW;

    svg_text(file, "ink small", SVG_END, LEFT - 8, y + 4, parameter_words(q));
    svg_line(file, "grid", x->from, y, x->to, y);
    for (unsigned pass = 0; pass < 2; pass++) {
        for (unsigned k = 0; k < r->devices; k++) {
            const double at = spreads(r, k, q);
            const unsigned is_outlier = (unsigned)r->fleet.outliers[k] >> q & 1u;
            if (is_outlier == pass && isfinite(at)) {
                svg_marker(file, pass ? "c2 full over" : "c1 hollow", pass ? SVG_CROSS : SVG_CIRCLE,
                           chart_pixel(x, at), y, pass ? 6 : 4);
            }
        }
    }
}

void compare_draw_fleet(FILE *file, const void *picture, double width)
{
    const compare_picture *c = picture;
    const compare_result *r = c->result;
    const double bottom = TOP + ROW * (double)INVCAL_PARAMETERS;
    const ruler x = chart_ruler_exact(-SPREADS_MAX, SPREADS_MAX, LEFT, width - RIGHT,
                                      width > PAGE_NARROW ? 10 : 4);
    const ruler y = {0, 1, bottom, TOP, 0, 0};
    char text[COMPARE_TEXT_MAX];

    svg_begin_inline(file, width, bottom + 42,
                     "Distance of the devices from the median, by parameter",
                     compare_sentence(r, text));
    svg_text(file, "ink heading", SVG_START, 0, 16, "from the median, in spreads");
    chart_ticks_x(file, &x, &y);
    svg_line(file, "rule", chart_pixel(&x, 0), TOP, chart_pixel(&x, 0), bottom);
    for (unsigned q = 0; q < INVCAL_PARAMETERS; q++) {
        draw_row(file, r, q, &x);
    }
    svg_end(file);
}
