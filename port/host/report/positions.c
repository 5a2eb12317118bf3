/* SPDX-License-Identifier: MIT
 *
 * The lengths at the positions before and after calibration, and the residuals.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "report/facts.h"

#define CELL 128
#define TEXT_MAX 1000
#define LEFT 58.0
#define RIGHT 24.0 /* half of a number of seven digits */
#define TOP 56.0
#define PLOT 170.0
#define HEIGHT (TOP + PLOT + 46)
#define POINTS_MAX 2500u      /* more positions are drawn as columns from minimum to maximum */
#define LARGE_MARKERS_MAX 60u /* with more positions markers are small */
#define NAME_WIDTH 100.0      /* "999999: +0.123" */
#define NAME_HEIGHT 14.0
#define LABELLED_MAX 8u /* positions left out that are labelled in the chart */

/* A chart over position numbers. */
typedef struct {
    const report_facts *f;
    ruler x;
    ruler y;
    double radius;
} plot;

static plot begin_plot(const report_facts *f, double width, double min, double max)
{
    const double count = f->count;

    return (plot){
        .f = f,
        .x = chart_ruler_exact(0.5, count + 0.5, LEFT, width - RIGHT, width > PAGE_NARROW ? 12 : 6),
        .y = chart_ruler(min, max, TOP + PLOT, TOP, 5),
        .radius = count <= LARGE_MARKERS_MAX && width > PAGE_NARROW ? 4
                  : count <= LARGE_MARKERS_MAX                      ? 3
                                                                    : 1.6,
    };
}

static void draw_axes(FILE *file, plot *p, double width, const char *what)
{
    char title[CELL];

    p->x.step = fmax(1, p->x.step); /* position numbers are integers */
    snprintf(title, sizeof title, "%s, %s", what, p->f->unit);
    svg_text(file, "ink heading", SVG_START, 0, 16, title);
    chart_ticks_x(file, &p->x, &p->y);
    chart_ticks_y(file, &p->y, &p->x);
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, HEIGHT - 8, "position");
}

/* Which length of a position. */
typedef enum { BEFORE, AFTER } stage;

static double value_of(const report_position *p, stage which)
{
    return which == BEFORE ? p->before : p->after;
}

/* The pixel of a value; values out of range are drawn at the edge. */
static double y_of(const plot *p, double value)
{
    return chart_pixel(&p->y, fmax(p->y.first, fmin(p->y.last, value)));
}

/* Thousands of markers would overlap and make a large file: columns one pixel wide show the
 * same. */
static void draw_columns(FILE *file, const plot *p, stage which, const char *style)
{
    unsigned n = 0;

    while (n < p->f->count) {
        const double at = floor(chart_pixel(&p->x, n + 1.0));
        double min = HUGE_VAL;
        double max = -HUGE_VAL;
        for (; n < p->f->count && chart_pixel(&p->x, n + 1.0) < at + 1; n++) {
            const double value = value_of(&p->f->position[n], which);
            min = fmin(min, value);
            max = fmax(max, value);
        }
        svg_line(file, style, at, y_of(p, max) - 0.5, at, y_of(p, min) + 0.5);
    }
}

static void draw_points(FILE *file, const plot *p, stage which)
{
    const char *const style = which == BEFORE ? "c0 hollow" : "c1 full";

    if (p->f->count > POINTS_MAX) {
        draw_columns(file, p, which, which == BEFORE ? "c0 column" : "c1 column");
        return;
    }
    for (unsigned n = 0; n < p->f->count; n++) {
        const report_position *at = &p->f->position[n];
        if (!at->is_left_out) {
            svg_circle(file, style, chart_pixel(&p->x, n + 1.0), y_of(p, value_of(at, which)),
                       p->radius);
        }
    }
}

static void draw_left_out(FILE *file, const plot *p, stage which)
{
    for (unsigned n = 0; n < p->f->count; n++) {
        const report_position *at = &p->f->position[n];
        if (at->is_left_out) {
            svg_marker(file, "c2 full", SVG_CROSS, chart_pixel(&p->x, n + 1.0),
                       y_of(p, value_of(at, which)), fmax(p->radius, 3) + 1);
        }
    }
}

/* ---- before and after -------------------------------------------------------------------------- */

static void describe(const report_facts *f, char *text, size_t size)
{
    const calibrate_result *r = f->result;
    char before[CELL] = "";

    if (f->has_before) {
        snprintf(before, sizeof before, "%.4g %s before calibration, ",
                 f->scale * r->residual_before, f->unit);
    }
    snprintf(text, size,
             "Deviation of %s from the field at each of %u positions: root mean square %s%.4g %s "
             "after it. The maximum after it is %.4g %s, at position %u. %u left out.",
             f->length, f->count, before, f->scale * r->quality.rms, f->unit,
             f->scale * r->quality.max, f->unit, r->quality.worst + 1, r->rejected.count);
}

static void draw_change_legend(FILE *file, const report_facts *f, double y)
{
    svg_circle(file, "c0 hollow", LEFT + 6, y - 4, 4);
    svg_text(file, "ink small", SVG_START, LEFT + 16, y, f->invocation->nominal_name);
    svg_circle(file, "c1 full", LEFT + 126, y - 4, 4);
    svg_text(file, "ink small", SVG_START, LEFT + 136, y, "calibrated");
    if (f->result->rejected.count > 0) {
        svg_marker(file, "c2 full", SVG_CROSS, LEFT + 214, y - 4, 5);
        svg_text(file, "ink small", SVG_START, LEFT + 224, y, "left out");
    }
}

static void draw_change(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    char text[TEXT_MAX];
    double min = 0;
    double max = 0;

    for (unsigned n = 0; n < f->count; n++) {
        min = fmin(min, fmin(f->position[n].before, f->position[n].after));
        max = fmax(max, fmax(f->position[n].before, f->position[n].after));
    }
    plot p = begin_plot(f, width, min, max);
    describe(f, text, sizeof text);
    svg_begin_inline(file, width, HEIGHT, "Deviation from the field before and after", text);
    draw_axes(file, &p, width, f->is_gravity ? "|a| - g" : "length - field");
    draw_change_legend(file, f, 38);
    for (unsigned n = 0; n < f->count && f->count <= LARGE_MARKERS_MAX; n++) {
        const double at = chart_pixel(&p.x, n + 1.0);
        svg_line(file, "rule", at, y_of(&p, f->position[n].before), at,
                 y_of(&p, f->position[n].after));
    }
    draw_points(file, &p, BEFORE);
    draw_points(file, &p, AFTER);
    draw_left_out(file, &p, AFTER);
    svg_end(file);
}

/* ---- residuals --------------------------------------------------------------------------------- */

/* The band that holds 95 % of the residuals of good positions. */
static double noise_band(const report_facts *f)
{
    return f->knows_noise ? f->coverage * f->noise : 0;
}

/* Where a label is: the centre of its base line. */
typedef struct {
    double x;
    double y;
} place;

static int is_vacant(const place *occupied, unsigned count, place at)
{
    for (unsigned i = 0; i < count; i++) {
        if (fabs(at.x - occupied[i].x) < NAME_WIDTH && fabs(at.y - occupied[i].y) < NAME_HEIGHT) {
            return 0;
        }
    }
    return 1;
}

/* Labels positions left out, at three heights in turn, as far as the labels do not overlap; the
 * text above the chart names them all. */
static void label_left_out(FILE *file, const plot *p, double width)
{
    place occupied[LABELLED_MAX];
    unsigned labelled = 0;

    for (unsigned n = 0; n < p->f->count && labelled < LABELLED_MAX; n++) {
        const report_position *at = &p->f->position[n];
        const double inwards = at->after > 0 ? 1 : -1;
        char text[CELL];
        char number[FIGURE_MAX];
        if (!at->is_left_out) {
            continue;
        }
        const double y = y_of(p, at->after) + inwards * (8 + NAME_HEIGHT * (labelled % 3));
        const double x = chart_pixel(&p->x, n + 1.0);
        const place here = {fmax(LEFT + NAME_WIDTH / 2, fmin(width - RIGHT - NAME_WIDTH / 2, x)),
                            y + (at->after > 0 ? 10 : 0)};
        if (!is_vacant(occupied, labelled, here)) {
            continue;
        }
        snprintf(text, sizeof text, "%u: %s%s", n + 1, at->after > 0 ? "+" : "",
                 figure_digits(at->after, 3, number));
        svg_text(file, "ink small halo", SVG_MIDDLE, here.x, here.y, text);
        occupied[labelled++] = here;
    }
}

static void draw_residuals(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const double band = noise_band(f);
    char text[TEXT_MAX];
    double reach = 1.2 * fmax(band, f->scale * f->result->quality.max);

    reach = reach > 0 ? reach : 1e-9;
    plot p = begin_plot(f, width, -reach, reach);
    describe(f, text, sizeof text);
    svg_begin_inline(file, width, HEIGHT, "Residuals of the calibration", text);
    draw_axes(file, &p, width, f->is_gravity ? "calibrated |a| - g" : "calibrated length - field");
    if (band > 0) {
        svg_rectangle(file, "c0 area", LEFT, chart_pixel(&p.y, band), width - RIGHT - LEFT,
                      chart_pixel(&p.y, -band) - chart_pixel(&p.y, band));
        svg_rectangle(file, "c0 area", LEFT, 28, 18, 12);
        svg_text(file, "ink small", SVG_START, LEFT + 24, 38, "95 % of good positions");
    }
    if (f->result->rejected.count > 0) {
        svg_marker(file, "c2 full", SVG_CROSS, LEFT + 184, 34, 5);
        svg_text(file, "ink small", SVG_START, LEFT + 194, 38, "left out");
    }
    draw_points(file, &p, AFTER);
    draw_left_out(file, &p, AFTER);
    label_left_out(file, &p, width);
    svg_end(file);
}

/* ---- the sections ------------------------------------------------------------------------------ */

static void write_left_out(page *p, const report_facts *f)
{
    const rejection *r = &f->result->rejected;

    if (rejection_drifting(r) > 0) {
        page_say(p,
                 "Left out: %u rest%s in which the temperature drifted by more than %.2g K: the "
                 "thermometer may lag. Let the sensor settle before each rest.",
                 rejection_drifting(r), rejection_drifting(r) == 1 ? "" : "s",
                 f->result->fit.drift_limit);
    }
    for (unsigned k = 0; k < r->count && k < LABELLED_MAX; k++) {
        const unsigned n = r->list[k].position;
        char number[FIGURE_MAX];
        if (r->list[k].drift > 0) {
            page_say(p, "Position %u (line %lu) drifted by %.2g K.", n + 1,
                     f->result->data->origin[n].line, r->list[k].drift);
            continue;
        }
        page_say(p,
                 "Left out: position %u (line %lu) contradicts the others; it reads %s %s too %s. "
                 "Repeat it, or check what happened there.",
                 n + 1, f->result->data->origin[n].line,
                 figure_digits(fabs(f->position[n].after), 3, number), f->unit,
                 f->position[n].after > 0 ? "much" : "little");
    }
    if (r->count > LABELLED_MAX) {
        page_say(p, "And %u more were left out.", r->count - LABELLED_MAX);
    }
    if (r->suspected > 0) {
        page_say(p,
                 "%u %spositions contradict one another, and nothing shows which of them are "
                 "wrong: repeat the measurement.",
                 r->suspected, r->count > 0 ? "more " : "");
    }
}

/* The residuals are larger than the noise explains. */
static void write_unexplained(page *p, const report_facts *f)
{
    const double times = calibrate_unexplained(f->result);
    char number[FIGURE_MAX];

    if (times > 0) {
        page_say(p,
                 "They are %s times as large as the noise %s explains: look for motion or tremor "
                 "of the device, a changing temperature, clipped readings (--clip), or an outlier.",
                 figure_digits(times, 2, number),
                 f->result->is_noise_given ? "stated" : "of the samples");
    }
}

/* Lengths before and after; needs a nominal calibration. */
static void write_change(page *p, const report_facts *f)
{
    char caption[TEXT_MAX];

    page_section(p, "Before and after");
    snprintf(caption, sizeof caption,
             "Deviation of the length of each reading from the field, with %s and calibrated.",
             f->invocation->nominal_name);
    page_picture(p, caption, draw_change, f);
}

void report_positions(page *p, const report_facts *f)
{
    if (f->has_before) {
        write_change(p, f);
    }
    page_section(p, "Residuals");
    write_left_out(p, f);
    write_unexplained(p, f);
    page_picture(p,
                 f->result->quality.dof > 0
                     ? "Deviation of the length of each calibrated reading from the field."
                     : "No redundancy: with as many positions as parameters, the residuals are "
                       "always zero and check nothing.",
                 draw_residuals, f);
    report_histogram(p, f);
}
