/* SPDX-License-Identifier: MIT */
#include "draw/chart.h"

#include <math.h>
#include <stdio.h>

#include "draw/svg.h"

#define LONG_FIGURE 1e5 /* from here on figures of y have an exponent */

double chart_round_step(double x)
{
    const double decade = pow(10, floor(log10(x)));

    return x <= decade       ? decade
           : x <= 2 * decade ? 2 * decade
           : x <= 5 * decade ? 5 * decade
                             : 10 * decade;
}

ruler chart_ruler_exact(double min, double max, double from, double to, unsigned ticks)
{
    if (!(max > min)) { /* one value, or none */
        const double spread = fmax(1e-6, fabs(min) * 0.1);
        min -= spread;
        max = min + 2 * spread;
    }
    return (ruler){min, max, from, to, 0, chart_round_step((max - min) / ticks)};
}

ruler chart_ruler(double min, double max, double from, double to, unsigned ticks)
{
    ruler r = chart_ruler_exact(min, max, from, to, ticks);

    r.first = r.step * floor(r.first / r.step + 1e-9);
    r.last = r.step * ceil(r.last / r.step - 1e-9);
    return r;
}

double chart_pixel(const ruler *r, double value)
{
    const double v = r->is_logarithmic ? log(value) : value;

    return r->from + (r->to - r->from) * (v - r->first) / (r->last - r->first);
}

unsigned chart_places(double step)
{
    return step < 1 ? (unsigned)ceil(-log10(step) - 1e-9) : 0;
}

/* The first tick, as a multiple of the step, and the last. */
static double first_tick(const ruler *r)
{
    return ceil(r->first / r->step - 1e-9);
}

static double last_tick(const ruler *r)
{
    return floor(r->last / r->step + 1e-9);
}

void chart_ticks_x(FILE *file, const ruler *x, const ruler *y)
{
    char text[SVG_NUMBER_MAX];

    for (double k = first_tick(x); k <= last_tick(x); k++) {
        const double at = chart_pixel(x, k * x->step);
        svg_line(file, "grid", at, y->to, at, y->from);
        svg_text(file, "ink small", SVG_MIDDLE, at, y->from + 17,
                 svg_fixed(k * x->step, chart_places(x->step), text));
    }
}

/* A figure of the y axis, shortened if it is too long for the margin: "-2e5" for -200000. */
static const char *tick_text(double value, unsigned places, char text[SVG_NUMBER_MAX])
{
    (void)svg_fixed(value, places, text);
    if (fabs(value) >= LONG_FIGURE) {
        const int exponent = (int)floor(log10(fabs(value)) + 1e-9);
        snprintf(text, SVG_NUMBER_MAX, "%.3ge%d", value / pow(10, exponent), exponent);
    }
    return text;
}

void chart_ticks_y(FILE *file, const ruler *y, const ruler *x)
{
    char text[SVG_NUMBER_MAX];

    for (double k = first_tick(y); k <= last_tick(y); k++) {
        const double at = chart_pixel(y, k * y->step);
        svg_line(file, fabs(k) > 0 ? "grid" : "rule", x->from, at, x->to, at);
        svg_text(file, "ink small", SVG_END, x->from - 6, at + 4,
                 tick_text(k * y->step, chart_places(y->step), text));
    }
}
