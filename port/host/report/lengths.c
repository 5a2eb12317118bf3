/* SPDX-License-Identifier: MIT
 *
 * The length of the readings over the log, before and after calibration. It should be constant over
 * all rests; between them there is motion.
 */
#include <math.h>

#include "draw/chart.h"
#include "report/facts.h"

#define LEFT 68.0
#define RIGHT 10.0
#define TOP 48.0
#define PLOT 150.0
#define AXIS 40.0
#define MARGIN 1.5 /* range of the axis over the largest deviation at rest */

typedef struct {
    const report_facts *f;
    ruler x;
    ruler y;
} plot;

static double deviation(const report_facts *f, const invcal_calibration *c, const double raw[3])
{
    double v[3];

    invcal_apply(c, raw[0], raw[1], raw[2], v);
    return f->scale * (sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1);
}

/* The deviation of the mean of a block. */
static double value_of(const report_facts *f, const recording_mean *m, int is_after)
{
    const calibrate_result *r = f->result;
    double raw[3] = {m->mean[0], m->mean[1], m->mean[2]};

    if (!is_after) {
        return deviation(f, &r->settings.nominal, raw);
    }
    const invcal_calibration here = calibrate_at_temperature(r, m->temperature);
    calibrate_remove_drift(r, calibrate_tau_at(r->data, m->time), raw);
    return deviation(f, &here, raw);
}

/* A line from minimum to maximum in each pixel, clipped to the axis. */
static void draw_trace(FILE *file, const plot *p, int is_after, const char *style)
{
    const rests_summary *log = p->f->result->log;
    const unsigned count = recording_count(log->track);
    double at = -1;
    double min = HUGE_VAL;
    double max = -HUGE_VAL;

    for (unsigned k = 0; k <= count; k++) {
        recording_mean m = {.time = -1};
        double value = HUGE_VAL;
        if (k < count) {
            m = recording_at(log->track, k, log->unit);
            value = value_of(p->f, &m, is_after);
        }
        const double here = floor(chart_pixel(&p->x, m.time));
        if ((k == count || here != at) && min <= max) {
            svg_line(file, style, at + 0.5, chart_pixel(&p->y, max) - 0.75, at + 0.5,
                     chart_pixel(&p->y, min) + 0.75);
            min = HUGE_VAL;
            max = -HUGE_VAL;
        }
        at = here;
        if (value >= p->y.first && value <= p->y.last) {
            min = fmin(min, value);
            max = fmax(max, value);
        }
    }
}

/* An axis for the readings at rest. */
static ruler find_axis(const report_facts *f, int has_before)
{
    double reach = 0;

    for (unsigned n = 0; n < f->count; n++) {
        const report_position *at = &f->position[n];
        reach = fmax(reach, at->is_left_out ? 0 : fabs(at->after));
        reach = fmax(reach, has_before ? fabs(at->before) : 0);
    }
    reach = fmax(MARGIN * reach, f->knows_noise ? 4 * f->noise : 0);
    return chart_ruler(-reach, reach, TOP + PLOT, TOP, 5);
}

static void draw_lengths(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const timeline *outline = &f->result->log->track->outline;
    const int has_before = f->has_before;
    const plot p = {
        f,
        chart_ruler_exact(0, outline->duration, LEFT, width - RIGHT, width > PAGE_NARROW ? 10 : 5),
        find_axis(f, has_before)};
    char title[64];

    svg_begin_inline(file, width, TOP + PLOT + AXIS, "Length of the readings along the log",
                     "Deviation of the length of the readings from the field over time. After "
                     "calibration it is near zero in every rest.");
    snprintf(title, sizeof title, "%s - %s, %s", f->length, f->is_gravity ? "g" : "field", f->unit);
    svg_text(file, "ink heading", SVG_START, 0, 14, title);
    chart_ticks_x(file, &p.x, &p.y);
    chart_ticks_y(file, &p.y, &p.x);
    if (has_before) {
        svg_line(file, "c0 curve", LEFT, 30, LEFT + 18, 30);
        svg_text(file, "ink small", SVG_START, LEFT + 24, 34, f->invocation->nominal_name);
        draw_trace(file, &p, 0, "c0 column");
    }
    svg_line(file, "c1 curve", LEFT + 126, 30, LEFT + 144, 30);
    svg_text(file, "ink small", SVG_START, LEFT + 150, 34, "calibrated");
    draw_trace(file, &p, 1, "c1 column");
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, TOP + PLOT + AXIS - 6,
             "time from the first sample, s");
    svg_end(file);
}

void report_lengths(page *p, const report_facts *f)
{
    if (f->result->log && !f->result->refused.word && recording_count(f->result->log->track) > 0) {
        page_wide_picture(
            p,
            "The length of the readings, averaged over a fraction of a second. Values "
            "beyond the axis are from motion.",
            draw_lengths, f);
    }
}
