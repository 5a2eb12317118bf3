/* SPDX-License-Identifier: MIT
 *
 * Histogram of the residuals, with the curve of noise alone.
 */
#include <math.h>

#include "draw/chart.h"
#include "report/facts.h"

#define POSITIONS_MIN 12u /* fewer positions show no shape */
#define BINS 11u
#define REACH 4.0 /* standard deviations to either side */
#define LEFT 52.0
#define RIGHT 24.0
#define TOP 34.0
#define PLOT 120.0
#define AXIS 44.0
#define SQRT_2PI 2.50662827463100050

typedef struct {
    double sigma; /* expected of a residual from noise alone, which is less than the noise */
    unsigned total;
    unsigned count[BINS]; /* values beyond the ends are in the outermost bins */
} histogram;

static histogram find_histogram(const report_facts *f)
{
    const fit_quality *q = &f->result->quality;
    const unsigned kept = f->result->rejected.kept_count;
    histogram h = {.sigma = f->noise * sqrt(q->dof / kept)};

    for (unsigned n = 0; n < f->count; n++) {
        const report_position *at = &f->position[n];
        const double bin = floor((at->after / h.sigma + REACH) / (2 * REACH) * BINS);
        if (!at->is_left_out) {
            h.count[(unsigned)fmax(0, fmin(BINS - 1, bin))]++;
            h.total++;
        }
    }
    return h;
}

/* Positions expected in a bin at x standard deviations: normal density times width. */
static double expected(const histogram *h, double x)
{
    return h->total * exp(-x * x / 2) / SQRT_2PI * 2 * REACH / BINS;
}

static void draw_curve(FILE *file, const histogram *h, const ruler *x, const ruler *y)
{
    svg_polyline_begin(file, "c0 curve");
    for (double at = -REACH; at <= REACH; at += REACH / 40) {
        svg_polyline_point(file, chart_pixel(x, at * h->sigma), chart_pixel(y, expected(h, at)));
    }
    svg_polyline_end(file);
}

static void draw_histogram(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const histogram h = find_histogram(f);
    const double reach = REACH * h.sigma;
    const ruler x =
        chart_ruler_exact(-reach, reach, LEFT, width - RIGHT, width > PAGE_NARROW ? 8 : 4);
    double max = expected(&h, 0);
    char title[64];

    for (unsigned k = 0; k < BINS; k++) {
        max = fmax(max, h.count[k]);
    }
    const ruler y = chart_ruler(0, max, TOP + PLOT, TOP, 4);
    svg_begin_inline(file, width, TOP + PLOT + AXIS, "Histogram of the residuals",
                     "Number of positions by residual, with the curve of normal noise.");
    svg_text(file, "ink heading", SVG_START, 0, 16, "positions");
    chart_ticks_x(file, &x, &y);
    chart_ticks_y(file, &y, &x);
    for (unsigned k = 0; k < BINS; k++) {
        const double left = chart_pixel(&x, (2.0 * k / BINS - 1) * reach);
        const double right = chart_pixel(&x, (2.0 * (k + 1) / BINS - 1) * reach);
        const double top = chart_pixel(&y, h.count[k]);
        svg_rectangle(file, "c1 area", left + 1, top, right - left - 2, y.from - top);
    }
    draw_curve(file, &h, &x, &y);
    snprintf(title, sizeof title, "residual, %s", f->unit);
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, TOP + PLOT + AXIS - 8,
             title);
    svg_end(file);
}

void report_histogram(page *p, const report_facts *f)
{
    if (f->knows_noise && f->result->quality.dof > 0 &&
        f->result->rejected.kept_count >= POSITIONS_MIN) {
        page_picture(p,
                     "Number of positions by residual; the curve is that of noise alone. Positions "
                     "beyond the ends are counted in the last bars.",
                     draw_histogram, f);
    }
}
