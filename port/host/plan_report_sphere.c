/* SPDX-License-Identifier: MIT
 *
 * Where the positions point, how exactly every direction will be known, and what the axes feel.
 */
#include "chart.h"
#include "plan_facts.h"
#include "plan_map.h"

#define TEXT_MAX 600
#define GROUPS 28.0 /* height of their legend */

static void draw_half(FILE *file, const design *d, const sphere *map, unsigned half)
{
    unsigned here = 0;
    char text[TEXT_MAX];
    char title[TEXT_MAX];

    for (unsigned n = 0; n < d->count; n++) {
        here += (d->position[n].vertical[2] < -SPHERE_EQUATOR) == half;
    }
    snprintf(title, sizeof title, "%s: positions with z %s", d->name, half ? "down" : "up");
    snprintf(text, sizeof text,
             "A disc: the half of all directions with z %s, seen from +z. %u of %u positions lie "
             "in it. Shaded by the uncertainty of |a| that is to be expected.",
             half ? "down" : "up or level", here, d->count);
    svg_begin_inline(file, SPHERE_WIDTH, SPHERE_HEIGHT, title, text);
    sphere_draw(file, map, half);
    svg_end(file);
}

void plan_draw_halves(FILE *file, const design *d, const sphere_shading *shading)
{
    const sphere *map = plan_map(d, shading);

    draw_half(file, d, map, 0);
    draw_half(file, d, map, 1);
}

void plan_draw_legend(FILE *file, const sphere_shading *shading, const char *unit, int has_groups)
{
    char text[TEXT_MAX];

    svg_begin_inline(file, SPHERE_WIDTH, UNCERTAINTY_LEGEND + (has_groups ? GROUPS : 0), "Legend",
                     "What the colours and markers mean.");
    snprintf(text, sizeof text, "σ of |a|, %s", unit);
    uncertainty_legend(file, shading, text);
    if (has_groups) {
        plan_map_legend(file, 14, UNCERTAINTY_LEGEND + 18);
    }
    svg_end(file);
}

static void say_uncertainty(page *p, const plan_facts *f)
{
    const uncertainty *u = &f->length_sigma;
    char least[FIGURE_MAX];
    char most[FIGURE_MAX];

    figure_digits(u->least, 3, least);
    figure_digits(u->most, 3, most);
    if (uncertainty_shading(u, u->least, u->most).classes == 1) {
        page_say(p,
                 "The length |a| of a corrected reading will be known equally well in every "
                 "direction: ±%s %s (one standard deviation).",
                 most, plan_length_unit(f));
    } else {
        page_say(p,
                 "The length |a| of a corrected reading will be known to ±%s %s where the "
                 "positions tell most, and to ±%s %s where they tell least, %s (one standard "
                 "deviation).",
                 least, plan_length_unit(f), most, plan_length_unit(f), u->worst_words);
    }
}

void plan_report_sphere(page *p, const plan_facts *f)
{
    const uncertainty *u = &f->length_sigma;
    const sphere_shading shading = uncertainty_shading(u, u->least, u->most);

    page_section(p, "Where the positions point");
    say_uncertainty(p, f);
    page_row_begin(p);
    plan_draw_halves(p->file, f->set, &shading);
    plan_draw_legend(p->file, &shading, plan_length_unit(f), f->set->plan.per_group > 0);
    page_row_end(p, f->set->count > SPHERE_NUMBERED
                        ? "Where up points in the axes of the device."
                        : "Where up points in the axes of the device; numbers as in the work "
                          "sheet.");
}

/* ---- coverage ---------------------------------------------------------------------------------- */

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

    snprintf(text, sizeof text,
             "What the axes feel, in units of g: x from %.2f to %.2f, y from %.2f to %.2f, z from "
             "%.2f to %.2f.",
             range[0][0], range[0][1], range[1][0], range[1][1], range[2][0], range[2][1]);
    svg_begin_inline(file, width, TOP + 3 * ROW + 42, "The range that each axis feels", text);
    svg_marker(file, "c3 full", SVG_CIRCLE, LEFT + 10, 12, 5);
    svg_text(file, "ink small", SVG_START, LEFT + 22, 16, "along gravity");
    svg_marker(file, "c2 hollow", SVG_SQUARE, LEFT + 126, 12, 5);
    svg_text(file, "ink small", SVG_START, LEFT + 138, 16, "never along gravity");
    chart_ticks_x(file, &x, &y);
    for (unsigned i = 0; i < 3; i++) {
        draw_range(file, f->set, i, &x);
    }
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width) / 2, TOP + 3 * ROW + 36,
             "what the axis feels, g");
    svg_end(file);
}

void plan_report_coverage(page *p, const plan_facts *f)
{
    const unsigned missing = plan_missing(f->set->axes);
    char text[PLAN_WORDS_MAX];

    page_section(p, "What the axes feel");
    if (missing) {
        page_say(p, "Never along gravity: %s; %s.", plan_axes_text(missing, text),
                 plan_missing_reason(f->set));
    } else {
        page_say(p, "All six of +x, -x, +y, -y, +z, -z stand along gravity.");
    }
    page_picture(p,
                 "From the least to the greatest that each axis feels. Readings beyond it rest "
                 "on the sensor being linear.",
                 draw_coverage, f);
}
