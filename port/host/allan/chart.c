/* SPDX-License-Identifier: MIT
 *
 * The chart of an Allan deviation, on logarithmic axes: each kind of noise has its slope.
 */
#include <math.h>
#include <string.h>

#include "allan/allan.h"
#include "draw/chart.h"
#include "draw/page.h"
#include "plan/words.h"
#include "draw/svg.h"

#define LEFT 58.0
#define RIGHT 12.0
#define TOP 90.0 /* legend, heading, the dwell's label */
#define PLOT_HEIGHT 300.0
#define BOTTOM_HEIGHT 44.0
#define MARGIN 1.25 /* factor beyond the first and last averaging time */
#define CURVE_STEPS 80
#define SPARSE_DECADES 2.2    /* from this length of an axis on, ticks are at 1, 10, 100 only */
#define LABEL_HALF_WIDTH 55.0 /* of the dwell's label, pixels */
#define TEXT_MAX 1000

static const struct {
    const char *name;
    const char *full;
    const char *curve;
    svg_shape shape;
} traces[3] = {
    {"x", "c1 full", "c1 curve", SVG_CIRCLE},
    {"y", "c2 full", "c2 curve", SVG_SQUARE},
    {"z", "c3 full", "c3 curve", SVG_TRIANGLE},
};

typedef struct {
    const allan_result *r;
    double unit; /* of the chart, in units of the result */
    ruler x;
    ruler y;
} plot;

/* ---- axes -------------------------------------------------------------------------------------- */

static ruler logarithmic(double min, double max, double from, double to)
{
    return (ruler){log(min), log(max), from, to, 1, 0};
}

static ruler time_axis(const allan_result *r, double width)
{
    const double dwell = r->dwell[r->worst].seconds;

    return logarithmic(fmin(dwell, r->row[0].seconds) / MARGIN,
                       fmax(dwell, r->row[r->rows - 1].seconds) * MARGIN, LEFT, width - RIGHT);
}

/* From one round number to another, around all points above 0. */
static ruler deviation_axis(const plot *p)
{
    double min = HUGE_VAL;
    double max = 0;

    for (unsigned k = 0; k < p->r->rows; k++) {
        const allan_row *row = &p->r->row[k];
        for (unsigned i = 0; i < 3; i++) {
            const double v = row->adev[i] / p->unit;
            min = v > 0 ? fmin(min, v * fmax(0.3, 1 - row->relative)) : min;
            max = fmax(max, v * (1 + row->relative));
        }
    }
    const double top = chart_round_step(max);
    return logarithmic(1 / chart_round_step(1 / min), top, TOP + PLOT_HEIGHT, TOP);
}

/* 0.001 ... 10000, 1e5 */
static const char *tick_text(double value, char text[SVG_NUMBER_MAX])
{
    const int power = (int)floor(log10(value) + 1e-9);

    if (power >= -3 && power <= 4) {
        return svg_fixed(value, power < 0 ? (unsigned)-power : 0, text);
    }
    snprintf(text, SVG_NUMBER_MAX, "%.0fe%d", value / pow(10, power), power);
    return text;
}

typedef void tick_drawer(FILE *file, const plot *p, double value, const char *words);

static void draw_tick_x(FILE *file, const plot *p, double value, const char *words)
{
    const double at = chart_pixel(&p->x, value);

    svg_line(file, "grid", at, p->y.to, at, p->y.from);
    svg_text(file, "ink small", SVG_MIDDLE, at, p->y.from + 17, words);
}

static void draw_tick_y(FILE *file, const plot *p, double value, const char *words)
{
    const double at = chart_pixel(&p->y, value);

    svg_line(file, "grid", p->x.from, at, p->x.to, at);
    svg_text(file, "ink small", SVG_END, p->x.from - 6, at + 4, words);
}

static void draw_ticks(FILE *file, const plot *p, const ruler *axis, tick_drawer *draw)
{
    const double last = exp(axis->last) * (1 + 1e-9);
    const int is_dense = axis->last - axis->first < SPARSE_DECADES * log(10);
    char text[SVG_NUMBER_MAX];

    for (double v = pow(10, floor(axis->first / log(10) - 1e-9)); v <= last;
         v = is_dense ? chart_round_step(1.5 * v) : 10 * v) {
        if (log(v) >= axis->first - 1e-9) {
            draw(file, p, v, tick_text(v, text));
        }
    }
}

/* ---- contents ---------------------------------------------------------------------------------- */

static double clamp(double x, double a, double b)
{
    return fmax(fmin(a, b), fmin(fmax(a, b), x));
}

static double y_of(const plot *p, double deviation)
{
    return clamp(chart_pixel(&p->y, deviation / p->unit), p->y.from, p->y.to);
}

static void draw_points(FILE *file, const plot *p, unsigned axis)
{
    for (unsigned k = 0; k < p->r->rows; k++) {
        const allan_row *row = &p->r->row[k];
        const double at = chart_pixel(&p->x, row->seconds);
        const double v = row->adev[axis];
        if (v > 0) {
            svg_line(file, traces[axis].curve, at, y_of(p, v * fmax(0.01, 1 - row->relative)), at,
                     y_of(p, v * (1 + row->relative)));
            svg_marker(file, traces[axis].full, traces[axis].shape, at, y_of(p, v), 3.2);
        }
    }
}

static void draw_model(FILE *file, const plot *p, unsigned axis)
{
    const double first = log(p->r->noise[axis].shortest);
    const double last = log(p->r->noise[axis].longest);

    svg_polyline_begin(file, traces[axis].curve);
    for (unsigned i = 0; i <= CURVE_STEPS; i++) {
        const double tau = exp(first + (last - first) * i / CURVE_STEPS);
        svg_polyline_point(file, chart_pixel(&p->x, tau),
                           y_of(p, invcali_noise_sigma(&p->r->noise[axis], tau)));
    }
    svg_polyline_end(file);
}

/* Slopes of the kinds of noise. */
static const struct {
    double slope;
    const char *words;
} slopes[INVCAL_NOISE_KINDS] = {{-0.5, "-1/2 N"}, {0, "0 B"}, {0.5, "+1/2 K"}};

static int is_visible(const allan_result *r, unsigned kind)
{
    return r->noise[r->worst].visible >> kind & 1u;
}

/* One kind of noise alone: the part of its straight line that is inside. */
static void draw_slope(FILE *file, const plot *p, unsigned kind)
{
    invcal_noise alone = {.coefficient = {0, 0, 0}};
    const double slope = slopes[kind].slope;
    double first = p->x.first;
    double last = p->x.last;

    alone.coefficient[kind] = p->r->noise[p->r->worst].coefficient[kind];
    const double log_at_1 = log(invcali_noise_sigma(&alone, 1) / p->unit);
    if (slope < 0 || slope > 0) {
        const double low = (p->y.first - log_at_1) / slope;
        const double high = (p->y.last - log_at_1) / slope;
        first = fmax(first, fmin(low, high));
        last = fmin(last, fmax(low, high));
    } else if (log_at_1 < p->y.first || log_at_1 > p->y.last) {
        return;
    }
    if (first < last) {
        svg_line(file, "c0 dashed", chart_pixel(&p->x, exp(first)),
                 chart_pixel(&p->y, exp(log_at_1 + slope * first)), chart_pixel(&p->x, exp(last)),
                 chart_pixel(&p->y, exp(log_at_1 + slope * last)));
    }
}

static void draw_dwell(FILE *file, const plot *p)
{
    const double seconds = p->r->dwell[p->r->worst].seconds;
    const double at = chart_pixel(&p->x, seconds);
    char time[PLAN_WORDS_MAX];
    char text[PLAN_WORDS_MAX + 8];

    snprintf(text, sizeof text, "dwell %s", plan_time_text(seconds, time));
    svg_line(file, "rule", at, p->y.to, at, p->y.from);
    svg_text(file, "ink small", SVG_MIDDLE,
             clamp(at, LABEL_HALF_WIDTH, p->x.to + RIGHT - LABEL_HALF_WIDTH), p->y.to - 6, text);
}

static void draw_legend(FILE *file, const allan_result *r)
{
    char text[TEXT_MAX] = "one component, slope";
    const char *comma = "";

    for (unsigned i = 0; i < 3; i++) {
        const double x = 56.0 * i;
        svg_line(file, traces[i].curve, x, 10, x + 24, 10);
        svg_marker(file, traces[i].full, traces[i].shape, x + 12, 10, 4.5);
        svg_text(file, "ink small", SVG_START, x + 29, 14, traces[i].name);
    }
    for (unsigned kind = 0; kind < INVCAL_NOISE_KINDS; kind++) {
        const size_t length = strlen(text);
        if (is_visible(r, kind)) {
            snprintf(text + length, sizeof text - length, "%s %s", comma, slopes[kind].words);
            comma = ",";
        }
    }
    svg_line(file, "c0 dashed", 0, 32, 24, 32);
    svg_text(file, "ink small", SVG_START, 29, 36, text);
}

static void describe(const allan_result *r, char *text, size_t size)
{
    char first[ALLAN_WORDS_MAX];
    char last[ALLAN_WORDS_MAX];
    char lowest[ALLAN_WORDS_MAX];
    const unsigned w = r->worst;

    snprintf(text, size,
             "Allan deviation of x, y and z against averaging time, both logarithmic. That of %s "
             "goes from %.60s at %.4g s to %.60s at %.4g s; the minimum is %.60s at %.4g s. The "
             "recommended dwell is %.4g s.",
             traces[w].name, allan_deviation(r, r->row[0].adev[w], first), r->row[0].seconds,
             allan_deviation(r, r->row[r->rows - 1].adev[w], last), r->row[r->rows - 1].seconds,
             allan_deviation(r, r->noise[w].minimum, lowest), r->noise[w].best,
             r->dwell[w].seconds);
}

void allan_chart(FILE *file, const allan_result *r, double width)
{
    plot p = {.r = r, .unit = r->is_ms2 ? ALLAN_MICRO_G : 1};
    char text[TEXT_MAX];

    p.x = time_axis(r, width);
    p.y = deviation_axis(&p);
    describe(r, text, sizeof text);
    svg_begin_inline(file, width, TOP + PLOT_HEIGHT + BOTTOM_HEIGHT,
                     "Allan deviation against averaging time", text);
    draw_legend(file, r);
    snprintf(text, sizeof text, "Allan deviation, %s", r->is_ms2 ? "µg" : r->unit);
    svg_text(file, "ink heading", SVG_START, 0, TOP - 28, text);
    draw_ticks(file, &p, &p.x, draw_tick_x);
    draw_ticks(file, &p, &p.y, draw_tick_y);
    for (unsigned kind = 0; kind < INVCAL_NOISE_KINDS; kind++) {
        if (is_visible(r, kind)) {
            draw_slope(file, &p, kind);
        }
    }
    draw_dwell(file, &p);
    for (unsigned i = 0; i < 3; i++) {
        draw_model(file, &p, i);
        draw_points(file, &p, i);
    }
    svg_text(file, "soft small", SVG_MIDDLE, (p.x.from + p.x.to) / 2, p.y.from + 37,
             "averaging time, or time in a position, s");
    svg_end(file);
}
