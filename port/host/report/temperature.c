/* SPDX-License-Identifier: MIT
 *
 * The effect of temperature on the parameters and on the residuals.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "report/facts.h"

#define CELL 128
#define TEXT_MAX 1000
#define LEFT 62.0
#define RIGHT 30.0 /* names of the curves */
#define TOP 26.0
#define PLOT 120.0
#define GAP 34.0   /* between two plots, with the title of the second */
#define TICKS 16.0 /* added to it for figures of temperature */
#define AXIS 42.0  /* below the last plot */
#define STEPS 24u  /* of a curve */
#define NAME_HEIGHT 13.0
#define POINTS 2500u /* drawn at most */

enum { KINDS = 3 };

/* Offsets, scale errors, angles: as printed. */
typedef struct {
    const char *title;
    const char *unit;
    double scale;
    const char *slope_unit;
    double slope_scale;
    const char *const *name; /* of the three */
} kind;

static kind kind_of(const report_facts *f, unsigned which)
{
    static const char *const axes[] = {"x", "y", "z"};
    static const char *const pairs[] = {"xy", "xz", "zy"};
    const int is_ins = f->result->units == UNIT_STYLE_INS;
    const display_unit scale = unit_style_scale(f->result->units);
    const display_unit angle = unit_style_angle(f->result->units);
    const kind kinds[KINDS] = {
        {"offset over the field", f->unit, f->scale,
         f->is_gravity ? (is_ins ? "µg/K" : "mg/K") : (is_ins ? "ppm/K" : "‰/K"), f->scale, axes},
        {"scale error", scale.unit, scale.scale, "ppm/K", 1e6, axes},
        {"angle off square", angle.unit, angle.scale, is_ins ? "arcsec/K" : "degrees/K",
         angle.scale, pairs},
    };

    return kinds[which];
}

static const char *colour_of(unsigned axis)
{
    static const char *const colours[] = {"c1", "c2", "c3"};

    return colours[axis];
}

/* ---- the slopes ------------------------------------------------------------------------------- */

static void write_slope(page *p, const page_table *sheet, const report_facts *f, unsigned parameter)
{
    static const char *const kinds[KINDS] = {"offset", "scale", "angle"};
    const thermal_fit *fit = &f->result->fit;
    const invcal_thermal *c = &fit->calibration;
    const kind k = kind_of(f, parameter / 3);
    const double range = c->max - c->min;
    char name[CELL];
    char slope[FIGURE_MAX];
    char change[FIGURE_MAX];
    char spread[CELL];
    const double scale = calibrate_slope_scale(f->result, parameter);
    const double own = scale * fit->slope[parameter];
    const double half = scale * f->coverage * fit->slope_sigma[parameter];

    snprintf(name, sizeof name, "%s %s", kinds[parameter / 3], k.name[parameter % 3]);
    figure_with_sigma(k.slope_scale * own, k.slope_scale * half, FIGURE_SIGNED, slope);
    snprintf(spread, sizeof spread, "%s %s", slope, k.slope_unit);
    snprintf(change, sizeof change, "%+.3g %s", k.scale * own * range, k.unit);
    const char *const cells[] = {name, spread, change};
    page_cells(p, sheet, cells);
}

static void write_slopes(page *p, const report_facts *f)
{
    static const char *const titles[] = {"parameter", "slope", "over the range"};
    const page_table sheet = {f->result->fit.calibration.fitted > 1
                                  ? "Slopes of the parameters at the reference temperature, and "
                                    "what they would add up to over the range."
                                  : "Slopes of the parameters, and their change over the range.",
                              titles, 3, 0};

    page_table_begin(p, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        write_slope(p, &sheet, f, r);
    }
    page_table_end(p);
}

/* ---- the parameters over the range ------------------------------------------------------------ */

/* Three parameters at STEPS + 1 temperatures, and the half-widths of their bands. If no nominal
 * value is stated, they are relative to the values at the reference temperature. */
typedef struct {
    double value[KINDS][STEPS + 1];
    double half[KINDS][STEPS + 1];
} curves;

static double temperature_at(const thermal_fit *fit, unsigned step)
{
    const invcal_thermal *c = &fit->calibration;

    return c->min + (c->max - c->min) * step / STEPS;
}

static void find_curves(const report_facts *f, unsigned which, curves *c)
{
    const kind k = kind_of(f, which);
    const double *reference = &f->result->solution.x[3 * (size_t)which];
    const int is_known = nominal_knows(&f->result->nominal, 3 * which);

    for (unsigned step = 0; step <= STEPS; step++) {
        fit_solution s;
        fit_quality q;
        thermal_fit_judge(&f->result->fit, &f->result->rejected,
                          temperature_at(&f->result->fit, step), &s, &q);
        for (unsigned i = 0; i < KINDS; i++) {
            const double scale = k.scale * calibrate_slope_scale(f->result, 3 * which + i);
            c->value[i][step] = scale * (s.x[3 * which + i] - (is_known ? 0 : reference[i]));
            c->half[i][step] = f->knows_noise ? scale * q.coverage * q.sigma[3 * which + i] : 0;
        }
    }
}

static ruler value_ruler(const curves *c, double top)
{
    double min = HUGE_VAL;
    double max = -HUGE_VAL;

    for (unsigned i = 0; i < KINDS; i++) {
        for (unsigned step = 0; step <= STEPS; step++) {
            min = fmin(min, c->value[i][step] - c->half[i][step]);
            max = fmax(max, c->value[i][step] + c->half[i][step]);
        }
    }
    return chart_ruler(min, max, top + PLOT, top, 4);
}

/* A line `halves` half-widths of the band above the curve. */
static void draw_edge(FILE *file, const report_facts *f, const curves *c, unsigned axis,
                      double halves, const ruler *x, const ruler *y)
{
    char style[CELL];

    snprintf(style, sizeof style, "%s %s", colour_of(axis),
             halves * halves > 0 ? "dashed" : "curve");
    svg_polyline_begin(file, style);
    for (unsigned step = 0; step <= STEPS; step++) {
        svg_polyline_point(file, chart_pixel(x, temperature_at(&f->result->fit, step)),
                           chart_pixel(y, c->value[axis][step] + halves * c->half[axis][step]));
    }
    svg_polyline_end(file);
}

/* At the right ends, moved down where they would overlap, but not out of the plot. */
static void label_curves(FILE *file, const kind *k, const curves *c, const ruler *x, const ruler *y)
{
    unsigned order[KINDS] = {0, 1, 2};
    double at[KINDS];

    for (unsigned i = 0; i < KINDS; i++) {
        for (unsigned j = 0; j + 1 < KINDS; j++) {
            if (c->value[order[j]][STEPS] < c->value[order[j + 1]][STEPS]) {
                const unsigned lower = order[j];
                order[j] = order[j + 1];
                order[j + 1] = lower;
            }
        }
    }
    for (unsigned i = 0; i < KINDS; i++) {
        at[i] = chart_pixel(y, c->value[order[i]][STEPS]) + 4;
        at[i] = i > 0 ? fmax(at[i], at[i - 1] + NAME_HEIGHT) : at[i];
    }
    const double lowest = y->from + 4;
    for (unsigned i = KINDS; i-- > 0;) {
        at[i] = fmin(at[i], lowest - NAME_HEIGHT * (KINDS - 1 - i));
        svg_text(file, "ink small", SVG_START, x->to + 6, at[i], k->name[order[i]]);
    }
}

static void draw_kind(FILE *file, const report_facts *f, unsigned which, const ruler *x)
{
    const double top = TOP + which * (PLOT + GAP);
    const kind k = kind_of(f, which);
    curves c;
    char title[CELL];

    find_curves(f, which, &c);
    const ruler y = value_ruler(&c, top);
    if (nominal_knows(&f->result->nominal, 3 * which)) {
        snprintf(title, sizeof title, "%s, %s", k.title, k.unit);
    } else {
        snprintf(title, sizeof title, "%s relative to %.2f °C, %s", k.title,
                 f->result->fit.calibration.reference, k.unit);
    }
    svg_text(file, "ink heading", SVG_START, 0, top - 10, title);
    chart_ticks_y(file, &y, x);
    if (which + 1 == KINDS) {
        chart_ticks_x(file, x, &y);
    }
    for (unsigned i = 0; i < KINDS; i++) {
        for (int edge = f->knows_noise ? -1 : 0; edge <= f->knows_noise; edge++) {
            draw_edge(file, f, &c, i, edge, x, &y);
        }
    }
    label_curves(file, &k, &c, x, &y);
}

static double height_of(unsigned plots, double gap)
{
    return TOP + plots * PLOT + (plots - 1) * gap + AXIS;
}

static ruler temperature_ruler(double min, double max, double width)
{
    return chart_ruler_exact(min, max, LEFT, width - RIGHT, width > PAGE_NARROW ? 10 : 5);
}

static void label_axis(FILE *file, const ruler *x, double height)
{
    svg_text(file, "soft small", SVG_MIDDLE, (x->from + x->to) / 2, height - 8, "temperature, °C");
}

static void draw_parameters(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const invcal_thermal *c = &f->result->fit.calibration;
    const ruler x = temperature_ruler(c->min, c->max, width);
    char text[TEXT_MAX];

    snprintf(text, sizeof text,
             "Offsets, scale errors and angles against temperature from %.4g to %.4g °C, with "
             "their 95 %% band. The table above lists the slopes.",
             c->min, c->max);
    svg_begin_inline(file, width, height_of(KINDS, GAP), "The parameters over temperature", text);
    for (unsigned which = 0; which < KINDS; which++) {
        draw_kind(file, f, which, &x);
    }
    label_axis(file, &x, height_of(KINDS, GAP));
    svg_end(file);
}

/* ---- residuals against temperature ------------------------------------------------------------ */

typedef enum { WITHOUT, WITH } terms;

/* Deviation of the length at a position, in the unit of the report. */
static double residual_of(const report_facts *f, unsigned n, terms which)
{
    const thermal_fit *fit = &f->result->fit;
    double v[3];

    if (which == WITH || f->result->temperature != CALIBRATE_THERMAL) {
        return f->position[n].after;
    }
    invcal_apply(&fit->nine.calibration, f->result->data->mean[3 * (size_t)n],
                 f->result->data->mean[3 * (size_t)n + 1], f->result->data->mean[3 * (size_t)n + 2],
                 v);
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return f->scale * (length - 1);
}

static double reach_of(const report_facts *f, terms which)
{
    double reach = 1e-9;

    for (unsigned n = 0; n < f->count; n++) {
        if (!f->position[n].is_left_out) {
            reach = fmax(reach, fabs(residual_of(f, n, which)));
        }
    }
    return reach;
}

static void draw_residuals_of(FILE *file, const report_facts *f, terms which, double top,
                              const ruler *x)
{
    const double reach = 1.1 * reach_of(f, which);
    const ruler y = chart_ruler(-reach, reach, top + PLOT, top, 4);
    const unsigned step = 1 + f->count / POINTS;

    chart_ticks_y(file, &y, x);
    chart_ticks_x(file, x, &y);
    for (unsigned n = 0; n < f->count; n += step) {
        const double at = chart_pixel(x, f->result->data->origin[n].temperature);
        const double value = fmax(y.first, fmin(y.last, residual_of(f, n, which)));
        if (f->position[n].is_left_out) {
            svg_marker(file, "c2 full", SVG_CROSS, at, chart_pixel(&y, value), 4);
        } else {
            svg_circle(file, which == WITHOUT ? "c0 hollow" : "c1 full", at, chart_pixel(&y, value),
                       3);
        }
    }
}

static void find_range(const report_facts *f, double *min, double *max)
{
    *min = HUGE_VAL;
    *max = -HUGE_VAL;
    for (unsigned n = 0; n < f->count; n++) {
        *min = fmin(*min, f->result->data->origin[n].temperature);
        *max = fmax(*max, f->result->data->origin[n].temperature);
    }
}

/* The number of plots: with slopes, there is a second one without them. */
static unsigned residual_plots(const report_facts *f)
{
    const thermal_fit *fit = &f->result->fit;

    return f->result->temperature == CALIBRATE_THERMAL && fit->calibration.fitted > 0 &&
                   !isnan(fit->without)
               ? 2
               : 1;
}

static void draw_residuals(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const unsigned plots = residual_plots(f);
    const double height = height_of(plots, GAP + TICKS);
    double min;
    double max;
    char text[TEXT_MAX];

    find_range(f, &min, &max);
    const double margin = fmax(0.02 * (max - min), 0.1);
    const ruler x = temperature_ruler(min - margin, max + margin, width);
    snprintf(text, sizeof text,
             "Deviation of %s from the field at each of %u positions over temperature.%s",
             f->length, f->count,
             plots > 1 ? " Above with nine parameters alone, below with temperature." : "");
    svg_begin_inline(file, width, height, "Residuals over temperature", text);
    for (unsigned k = 0; k < plots; k++) {
        const double top = TOP + k * (PLOT + GAP + TICKS);
        const terms which = plots > 1 && k == 0 ? WITHOUT : WITH;
        snprintf(text, sizeof text, "residuals, %s%s", f->unit,
                 plots == 1         ? ""
                 : which == WITHOUT ? ", nine parameters alone"
                                    : ", with temperature");
        svg_text(file, "ink heading", SVG_START, 0, top - 10, text);
        draw_residuals_of(file, f, which, top, &x);
    }
    label_axis(file, &x, height);
    svg_end(file);
}

/* ---- the section ------------------------------------------------------------------------------ */

static void write_fitted(page *p, const report_facts *f)
{
    const invcal_thermal *c = &f->result->fit.calibration;

    if (c->fitted == 0) {
        page_say(p, "The positions were at %.2f ... %.2f °C. No slopes: %s.", c->min, c->max,
                 invcal_thermal_fallback_text(c->fallback));
        return;
    }
    page_say(p,
             "The positions were at %.2f ... %.2f °C: %s of temperature describe offsets, scales "
             "and angles there. The parameters on this page are those at %.2f °C. Outside that "
             "range, invcal apply uses the values at its edge, with a warning.",
             c->min, c->max, c->fitted > 1 ? "parabolas" : "straight lines", c->reference);
    if (c->fallback != INVCAL_THERMAL_AS_ASKED) {
        page_say(p, "Parabolas were requested, but could not be fitted: %s.",
                 invcal_thermal_fallback_text(c->fallback));
    }
}

static void write_difference(page *p, const report_facts *f)
{
    const thermal_fit *fit = &f->result->fit;
    char before[FIGURE_MAX];
    char after[FIGURE_MAX];

    page_say(p,
             "Nine parameters without temperature leave an rms error of %s %s in the same "
             "positions, with temperature %s %s.",
             figure_digits(f->scale * fit->without, 3, before), f->unit,
             figure_digits(f->scale * f->result->quality.rms, 3, after), f->unit);
}

static void write_thermal(page *p, const report_facts *f)
{
    write_fitted(p, f);
    if (f->result->fit.calibration.fitted > 0) {
        write_slopes(p, f);
        page_picture(p,
                     f->knows_noise ? "The parameters over the range. Dashed lines: 95 % band, "
                                      "which may be too narrow to see."
                                    : "The parameters over the range.",
                     draw_parameters, f);
    }
    if (residual_plots(f) > 1) {
        write_difference(p, f);
    }
}

void report_temperature(page *p, const report_facts *f)
{
    char advice[CALIBRATE_LIMIT_MAX];

    if (!f->result->data->has_temperature) {
        return;
    }
    page_section(p, "Temperature");
    if (f->result->temperature == CALIBRATE_THERMAL) {
        write_thermal(p, f);
    } else if (*calibrate_temperature_advice(f->result, advice)) {
        page_say(p, "%s", advice);
    }
    page_picture(p, "Residual of each position over its temperature.", draw_residuals, f);
}
