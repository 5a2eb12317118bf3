/* SPDX-License-Identifier: MIT
 *
 * The log: its readings, and the rests in it.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "report/facts.h"

#define TEXT_MAX 1000
#define LEFT 68.0
#define RIGHT 10.0
#define TOP 58.0
#define STRIP 74.0 /* height for each axis, with the gap to the next */
#define GAP 14.0
#define AXIS 40.0
#define DIGIT 7.0 /* width of a digit in a number of a rest */

static const char *const traces[TIMELINE_TRACES] = {"x", "y", "z", "°C"};

static unsigned trace_count(const report_facts *f)
{
    return f->result->data->has_temperature ? TIMELINE_TRACES : TIMELINE_TRACES - 1;
}

/* The outline of one trace: along its upper edge and back along the lower one. */
static void draw_trace(FILE *file, const timeline *t, unsigned trace, const ruler *x,
                       const ruler *y)
{
    const double pixels = x->to - x->from;
    const double bins = fmax(1, t->duration / t->width / pixels); /* of one pixel */
    double low;
    double high;

    svg_polygon_begin(file, "c1 outline");
    for (int direction = 1; direction >= -1; direction -= 2) {
        for (double k = 0; k < pixels; k++) {
            const double i = direction > 0 ? k : pixels - 1 - k;
            const unsigned from = (unsigned)(i * bins);
            if (timeline_range(t, trace, from, (unsigned)fmax(from + 1.0, (i + 1) * bins), &low,
                               &high)) {
                svg_polyline_point(file, chart_pixel(x, from * t->width),
                                   chart_pixel(y, direction > 0 ? high : low));
            }
        }
    }
    svg_polyline_end(file);
}

/* x, y and z share their scale. */
static ruler strip_ruler(const timeline *t, unsigned trace, double top)
{
    const unsigned first = trace < 3 ? 0 : trace;
    const unsigned last = trace < 3 ? 2 : trace;
    double min = HUGE_VAL;
    double max = -HUGE_VAL;

    for (unsigned i = first; i <= last; i++) {
        double low;
        double high;
        (void)timeline_range(t, i, 0, t->bins, &low, &high);
        min = fmin(min, low);
        max = fmax(max, high);
    }
    return chart_ruler_exact(min, max, top + STRIP - GAP, top, 4);
}

static void draw_strip(FILE *file, const report_facts *f, unsigned trace, const ruler *x,
                       double top)
{
    const timeline *t = &f->result->log->track->outline;
    const ruler y = strip_ruler(t, trace, top);

    chart_ticks_y(file, &y, x);
    svg_text(file, "ink heading", SVG_START, 0, top + (STRIP - GAP) / 2 + 5, traces[trace]);
    draw_trace(file, t, trace, x, &y);
}

/* A band from top to bottom for each rest, with its number if it has space. */
static void draw_rests(FILE *file, const report_facts *f, const ruler *x, double bottom)
{
    double taken = LEFT;

    for (unsigned n = 0; n < f->count; n++) {
        const position_origin *o = &f->result->data->origin[n];
        const double left = chart_pixel(x, o->begin);
        const double right = chart_pixel(x, o->end);
        char text[16];
        svg_rectangle(file, f->position[n].is_left_out ? "c2 area" : "c3 area", left, TOP,
                      fmax(0.5, right - left), bottom - TOP);
        const int digits = snprintf(text, sizeof text, "%u", n + 1);
        const double half = 0.5 * DIGIT * digits;
        const double middle = (left + right) / 2;
        if (middle - half >= taken && middle + half <= x->to + RIGHT) {
            svg_text(file, "soft small", SVG_MIDDLE, middle, TOP - 5, text);
            taken = middle + half + DIGIT;
        }
    }
    for (unsigned i = 0; i < f->result->log->track->outline.refusals; i++) {
        svg_marker(file, "c2 full", SVG_CROSS,
                   chart_pixel(x, f->result->log->track->outline.refused[i]), bottom - 5, 4.5);
    }
}

static void draw_legend(FILE *file, const report_facts *f)
{
    svg_rectangle(file, "c3 area", LEFT, 22, 16, 12);
    svg_text(file, "ink small", SVG_START, LEFT + 22, 32, "rest, a position");
    if (f->result->log->track->outline.refusals > 0) {
        svg_marker(file, "c2 full", SVG_CROSS, LEFT + 136, 28, 4.5);
        svg_text(file, "ink small", SVG_START, LEFT + 146, 32, "rest refused");
    }
}

static void describe(const report_facts *f, char *text, size_t size)
{
    const rests_summary *log = f->result->log;

    snprintf(text, size,
             "Readings of x, y and z%s over time, %.4g seconds, with %u rests marked. %u rests "
             "were refused.",
             f->result->data->has_temperature ? " and temperature" : "",
             log->track->outline.duration, f->count, log->track->outline.refusals);
}

static void draw_timeline(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const timeline *t = &f->result->log->track->outline;
    const unsigned count = trace_count(f);
    const double bottom = TOP + count * STRIP - GAP;
    const ruler x =
        chart_ruler_exact(0, t->duration, LEFT, width - RIGHT, width > PAGE_NARROW ? 10 : 5);
    const ruler frame = {0, 1, bottom, TOP, 0, 0};
    char text[TEXT_MAX];

    describe(f, text, sizeof text);
    svg_begin_inline(file, width, bottom + AXIS, "The log and the rests in it", text);
    snprintf(text, sizeof text, "readings, %s", calibrate_input_unit(f->result));
    svg_text(file, "ink heading", SVG_START, 0, 14, text);
    draw_legend(file, f);
    chart_ticks_x(file, &x, &frame);
    draw_rests(file, f, &x, bottom);
    for (unsigned trace = 0; trace < count; trace++) {
        draw_strip(file, f, trace, &x, TOP + trace * STRIP);
    }
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, bottom + AXIS - 6,
             "time from the first sample, s");
    svg_end(file);
}

/* How many rests were refused, and why. */
static void write_refused(page *p, const rests_summary *log)
{
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        if (log->refused[i] > 0) {
            page_say(p, "%u rest%s refused: %s.", log->refused[i],
                     log->refused[i] == 1 ? " was" : "s were",
                     rests_reason_text((invcal_status)(INVCAL_REST_SHORT + i)));
        }
    }
}

void report_timeline(page *p, const report_facts *f)
{
    const rests_summary *log = f->result->log;

    if (!log) {
        return;
    }
    page_section(p, "The log");
    page_say(p,
             "%lu samples, %.6g s at %.4g samples per second%s: %u rests of two seconds or more "
             "are the positions.",
             log->samples, log->seconds, log->rate,
             log->is_rate_known ? "" : " (a guess; state --rate)", f->count);
    write_refused(p, log);
    if (log->gaps > 0) {
        page_say(p, "%lu gap%s in the times; those of more than a minute are left out here.",
                 log->gaps, log->gaps == 1 ? "" : "s");
    }
    page_wide_picture(p, "The range of the readings, minimum to maximum, and the rests in them.",
                      draw_timeline, f);
    report_lengths(p, f);
}
