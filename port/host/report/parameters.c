/* SPDX-License-Identifier: MIT
 *
 * The nine parameters: a table, and bars with the limits of the data sheet or the prior.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "maths/matrix.h"
#include "design/parameters.h"
#include "report/facts.h"
#include "text/number.h"

#define CELL 160
#define ROW 22.0
#define PANEL_TOP 30.0 /* of the bars in their panel */
#define PANEL (PANEL_TOP + 3 * ROW + 42)
#define LABEL_RIGHT 34.0
#define MARGIN 16.0

/* Offsets, scale errors, angles. */
typedef struct {
    const char *title;
    const char *label[3];
} kind_of_parameter;

static const kind_of_parameter kinds[3] = {
    {"offset", {"x", "y", "z"}},
    {"scale error", {"x", "y", "z"}},
    {"angle off square", {"xy", "xz", "zy"}},
};

static const char *unit_of(const report_facts *f, unsigned kind)
{
    return report_unit(f, kind).unit;
}

static double scale_of(const report_facts *f, unsigned kind)
{
    return report_unit(f, kind).scale;
}

static double value_of(const report_facts *f, unsigned kind, unsigned i)
{
    return scale_of(f, kind) * f->result->solution.x[3 * kind + i];
}

/* ±: half-width of the 95 % interval. NaN: unknown. */
static double spread_of(const report_facts *f, unsigned kind, unsigned i)
{
    const unsigned p = 3 * kind + i;
    const double coverage = f->knows_noise ? fit_coverage(&f->result->quality, p) : NUMBER_UNKNOWN;

    return scale_of(f, kind) * coverage * f->result->quality.sigma[p];
}

/* The limit of the data sheet, or NaN. */
static double limit_of(const report_facts *f, unsigned kind, unsigned i)
{
    return scale_of(f, kind) * f->outcome.limit[3 * kind + i];
}

/* ± of the prior, or 0. */
static double prior_of(const report_facts *f, unsigned kind)
{
    return REPORT_NORMAL * scale_of(f, kind) * f->result->settings.prior[3 * (size_t)kind];
}

static int is_failed(const report_facts *f, unsigned kind, unsigned i)
{
    return f->outcome.failed >> (3 * kind + i) & 1;
}

static int is_weak(const report_facts *f, unsigned kind, unsigned i)
{
    return f->result->quality.weak >> (3 * kind + i) & 1;
}

/* ---- the table --------------------------------------------------------------------------------- */

/* The reading at zero field (offset) or per field unit (scale), calibrated and nominal; empty for
 * angles. */
static void raw_cells(const report_facts *f, unsigned kind, unsigned i, char raw[CELL],
                      char nominal[CELL])
{
    const calibrate_result *r = f->result;
    const double dk = r->solution.x[INVCAL_DK_X + i];
    double inverse[3][3];
    double value = r->solution.calibration.offset[i];
    double spread = f->coverage * r->quality.sigma_offset[i];
    double before = r->nominal.calibration.offset[i];
    char text[FIGURE_MAX];

    (void)matrix_inverse(&r->nominal.calibration, inverse); /* no result without */
    if (kind == 1) {
        before = inverse[i][i];
        value = before * (1 + dk);
        spread = f->coverage * fabs(before) * r->quality.sigma[INVCAL_DK_X + i];
    }
    snprintf(raw, CELL, "%s",
             kind == 2 ? "" : figure_with_sigma(value, spread, FIGURE_PLAIN, text));
    snprintf(nominal, CELL, "%s",
             kind == 2 ? ""
                       : figure_fixed(before, figure_places(value, spread), FIGURE_PLAIN, text));
}

static const char *state_of(const report_facts *f, unsigned kind, unsigned i)
{
    const int from_prior = f->result->quality.from_prior >> (3 * kind + i) & 1;
    const int is_held = fit_held(&f->result->settings, &f->result->quality) >> (3 * kind + i) & 1;
    const int is_beyond = f->outcome.beyond >> (3 * kind + i) & 1;

    return is_weak(f, kind, i)     ? "poorly determined"
           : is_beyond             ? "beyond the limit"
           : is_failed(f, kind, i) ? "possibly beyond"
           : is_held               ? "not measured"
           : from_prior            ? "from the prior"
                                   : "";
}

/* Without a nominal calibration, the columns about it are left out, and the column of values shows
 * the angles. */
enum { NAME, DEVIATION, LIMIT, USED, RAW, NOMINAL, REMARK, COLUMNS };

static int is_shown(const report_facts *f, unsigned which)
{
    return which == DEVIATION || which == NOMINAL ? nominal_is_stated(&f->result->nominal)
           : which == LIMIT || which == USED      ? f->outcome.limited != 0
                                                  : 1;
}

/* The columns that are shown. Returns their number. */
static unsigned pick_columns(const report_facts *f, const char *const all[COLUMNS],
                             const char *out[COLUMNS])
{
    unsigned count = 0;

    for (unsigned k = 0; k < COLUMNS; k++) {
        if (is_shown(f, k)) {
            out[count++] = all[k];
        }
    }
    return count;
}

static void write_row(page *p, const page_table *sheet, const report_facts *f, unsigned kind,
                      unsigned i)
{
    const unsigned r = 3 * kind + i;
    char cell[COLUMNS][CELL] = {{0}};
    char text[FIGURE_MAX];
    const char *all[COLUMNS];
    const char *cells[COLUMNS];

    snprintf(cell[NAME], CELL, "%s", parameter_words(r));
    snprintf(cell[DEVIATION], CELL, "%s %s",
             figure_with_sigma(value_of(f, kind, i), spread_of(f, kind, i), FIGURE_SIGNED, text),
             unit_of(f, kind));
    raw_cells(f, kind, i, cell[RAW], cell[NOMINAL]);
    if (f->outcome.limited >> r & 1u) {
        snprintf(cell[LIMIT], CELL, "%s %s", figure_digits(limit_of(f, kind, i), 3, text),
                 unit_of(f, kind));
        snprintf(cell[USED], CELL, isnan(f->outcome.used[r]) ? "?" : "%.0f %%",
                 100 * f->outcome.used[r]);
    }
    snprintf(cell[REMARK], CELL, "%s", state_of(f, kind, i));
    if (!nominal_knows(&f->result->nominal, r)) {
        cell[DEVIATION][0] = cell[NOMINAL][0] = '\0';
    } else if (!is_shown(f, DEVIATION)) {
        memcpy(cell[RAW], cell[DEVIATION], CELL);
    }
    for (unsigned k = 0; k < COLUMNS; k++) {
        all[k] = cell[k];
    }
    (void)pick_columns(f, all, cells);
    (is_failed(f, kind, i) ? page_bad_cells : page_cells)(p, sheet, cells);
}

static void write_table(page *p, const report_facts *f)
{
    static const char *const all[COLUMNS] = {"parameter",    "deviation", "limit", "used",
                                             "sensor reads", "nominal",   "remark"};
    static const char *const alone[COLUMNS] = {[NAME] = "parameter",
                                               [LIMIT] = "limit",
                                               [USED] = "used",
                                               [RAW] = "value",
                                               [REMARK] = "remark"};
    const char *titles[COLUMNS];
    char caption[4 * CELL];
    const unsigned count = pick_columns(f, is_shown(f, NOMINAL) ? all : alone, titles);
    const page_table sheet = {caption, titles, count, 1u << (count - 1)};

    snprintf(
        caption, sizeof caption,
        "%sOffsets and scales as the sensor reads them: %s, and %s per %s.%s",
        is_shown(f, DEVIATION) ? "Deviation: from nominal. " : "", calibrate_input_unit(f->result),
        calibrate_input_unit(f->result), calibrate_field_unit(f->result),
        f->outcome.limited ? " Limit: ± limit of the data sheet. Used: deviation and its ± in % "
                             "of the limit; 100 % or less is within."
                           : "");
    page_table_begin(p, &sheet);
    for (unsigned kind = 0; kind < 3; kind++) {
        for (unsigned i = 0; i < 3; i++) {
            write_row(p, &sheet, f, kind, i);
        }
    }
    page_table_end(p);
}

/* ---- the bars ---------------------------------------------------------------------------------- */

/* The range of the axis, so that everything is visible. */
static double reach_of(const report_facts *f, unsigned kind)
{
    double reach = fmax(0, prior_of(f, kind));

    for (unsigned i = 0; i < 3; i++) {
        reach = fmax(reach, limit_of(f, kind, i)); /* fmax ignores NaN */
        const double spread = spread_of(f, kind, i);
        reach = fmax(reach, fabs(value_of(f, kind, i)) + (isnan(spread) ? 0 : spread));
    }
    return reach > 0 ? 1.05 * reach : 1;
}

/* A bar from zero to the value, with its 95 % interval. */
static void draw_bar(FILE *file, const report_facts *f, unsigned kind, unsigned i, const ruler *x)
{
    const double value = value_of(f, kind, i);
    const double spread = spread_of(f, kind, i);
    const double zero = chart_pixel(x, 0);
    const double end = chart_pixel(x, value);
    const double y = PANEL_TOP + (i + 0.5) * ROW;
    const int stands_out = is_weak(f, kind, i) || is_failed(f, kind, i);

    svg_text(file, "ink", SVG_END, LABEL_RIGHT - 6, y + 5, kinds[kind].label[i]);
    svg_rectangle(file, stands_out ? "c2 bar" : "c1 bar", fmin(zero, end), y - 6,
                  fmax(1, fabs(end - zero)), 12);
    if (spread > 0) {
        const double low = chart_pixel(x, value - spread);
        const double high = chart_pixel(x, value + spread);
        svg_line(file, "whisker", low, y, high, y);
        svg_line(file, "whisker", low, y - 5, low, y + 5);
        svg_line(file, "whisker", high, y - 5, high, y + 5);
    }
}

/* The limits of the data sheet and of the prior, on both sides. */
static void draw_limits(FILE *file, const report_facts *f, unsigned kind, const ruler *x)
{
    const double bottom = PANEL_TOP + 3 * ROW;
    const double prior = prior_of(f, kind);

    if (prior > 0) {
        const double left = chart_pixel(x, -prior);
        svg_rectangle(file, "c3 area", left, PANEL_TOP, chart_pixel(x, prior) - left,
                      bottom - PANEL_TOP);
    }
    for (unsigned i = 0; i < 6; i++) { /* three axes, both sides of each */
        const unsigned axis = i / 2;
        const double limit = limit_of(f, kind, axis);
        const double at = chart_pixel(x, i % 2 == 0 ? limit : -limit);
        const double top = PANEL_TOP + axis * ROW;
        if (limit > 0) {
            svg_line(file, "c0 dashed", at, i < 2 ? top - 4 : top, at, top + ROW);
        }
    }
}

static void draw_panel(FILE *file, const report_facts *f, unsigned kind, double width)
{
    const double reach = reach_of(f, kind);
    const ruler x =
        chart_ruler_exact(-reach, reach, LABEL_RIGHT, width - MARGIN, width > PAGE_NARROW ? 8 : 4);
    const ruler y = {0, 1, PANEL_TOP + 3 * ROW, PANEL_TOP, 0, 0};
    char title[CELL];

    snprintf(title, sizeof title, "%s, %s", kinds[kind].title, unit_of(f, kind));
    svg_text(file, "ink heading", SVG_START, 0, 16, title);
    chart_ticks_x(file, &x, &y);
    svg_line(file, "rule", chart_pixel(&x, 0), PANEL_TOP - 4, chart_pixel(&x, 0),
             PANEL_TOP + 3 * ROW);
    draw_limits(file, f, kind, &x);
    for (unsigned i = 0; i < 3; i++) {
        draw_bar(file, f, kind, i, &x);
    }
}

static void describe(const report_facts *f, char *text, size_t size)
{
    snprintf(text, size, "Bars for the nine parameters, as in the table:");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const size_t length = strlen(text);
        char number[FIGURE_MAX];
        snprintf(text + length, size - length, " %s %s %s%s", parameter_words(r),
                 figure_with_sigma(value_of(f, r / 3, r % 3), spread_of(f, r / 3, r % 3),
                                   FIGURE_SIGNED, number),
                 unit_of(f, r / 3), r + 1 < INVCAL_PARAMETERS ? ";" : ".");
    }
}

static void draw_bars(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    char text[1000];

    describe(f, text, sizeof text);
    svg_begin_inline(file, width, 3 * PANEL, "The nine parameters with their uncertainty", text);
    for (unsigned kind = 0; kind < 3; kind++) {
        svg_group_begin(file, 0, kind * PANEL);
        draw_panel(file, f, kind, width);
        svg_group_end(file);
    }
    svg_end(file);
}

/* ---- the section ------------------------------------------------------------------------------- */

/* The parameters beyond the limits of the data sheet, in a sentence. */
static void write_limits(page *p, const report_facts *f)
{
    const uint16_t unsure = (uint16_t)(f->outcome.failed & ~(unsigned)f->outcome.beyond);
    char list[CELL];

    if (f->outcome.beyond) {
        page_say(p, "Beyond the limits of the data sheet: %s.",
                 parameters_list(f->outcome.beyond, list, sizeof list));
    }
    if (unsure) {
        page_say(p, "Possibly beyond the limits of the data sheet, which lie within their ±: %s.",
                 parameters_list(unsure, list, sizeof list));
    }
    if (f->outcome.limited && !f->outcome.failed) {
        page_say(p, "All are within the limits of the data sheet, including their ±.");
    }
}

void report_parameters(page *p, const report_facts *f)
{
    char caption[4 * CELL];

    page_section(p, "The nine parameters");
    write_limits(p, f);
    write_table(p, f);
    if (nominal_is_guess(&f->result->nominal)) {
        return; /* bars are of deviations from it */
    }
    snprintf(caption, sizeof caption, "Deviation from nominal.%s%s%s",
             f->knows_noise ? " Whiskers: ±." : "",
             f->outcome.limited ? " Dashed: limits of the data sheet." : "",
             fit_has_prior(&f->result->settings) ? " Shaded: the prior (95 %)." : "");
    page_picture(p, caption, draw_bars, f);
}
