/* SPDX-License-Identifier: MIT
 *
 * The nine parameters: expected sigma, and limits.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "design/parameters.h"
#include "plan/facts.h"
#include "plan/nonlinear.h"

#define TEXT_MAX 1000
#define COLUMNS 5u
#define LEFT 80.0
#define RIGHT 16.0
#define TOP 28.0
#define ROW 22.0
#define GAP 10.0 /* between the kinds */
#define BOTTOM (TOP + PLAN_KINDS * 3 * ROW + 2 * GAP)

static double top_of(unsigned kind)
{
    return TOP + kind * (3 * ROW + GAP);
}

/* Over the noise of a position mean, or NaN. */
static double limit_of(const plan_facts *f, unsigned kind)
{
    return f->request->limits ? f->request->limits[kind] : (double)NAN;
}

static int is_beyond(const plan_facts *f, unsigned r)
{
    return f->sigma[r] > limit_of(f, r / 3) * (1 + 1e-9) || !(f->sigma[r] <= PLAN_WEAK);
}

static int has_remarks(const plan_facts *f)
{
    return f->request->limits || !(plan_sigma_largest(&f->set->criteria) <= PLAN_WEAK);
}

static const char *remark(const plan_facts *f, unsigned r)
{
    return !(f->sigma[r] <= PLAN_WEAK) ? "weak" : is_beyond(f, r) ? "beyond the limit" : "";
}

/* Columns for units, limits and remarks are there only if they are needed. */
static void write_row(page *p, const page_table *sheet, const plan_facts *f, unsigned r)
{
    const unit_style style = f->request->units;
    char times[FIGURE_MAX];
    char sigma[PLAN_WORDS_MAX];
    char limit[PLAN_WORDS_MAX];
    const char *cells[COLUMNS] = {parameter_words(r), figure_digits(f->sigma[r], 4, times)};
    unsigned count = 2;

    if (f->noise > 0) {
        cells[count++] = plan_sigma_text(r / 3, f->sigma[r], f->noise, style, sigma);
    }
    if (f->request->limits) {
        cells[count++] = plan_sigma_text(r / 3, limit_of(f, r / 3), f->noise, style, limit);
    }
    cells[count] = remark(f, r); /* not shown if the table has no such column */
    page_cells(p, sheet, cells);
}

static void write_table(page *p, const plan_facts *f)
{
    const char *heading[COLUMNS] = {"parameter", "σ, × noise"};
    page_table sheet = {"Expected σ, one standard deviation. × noise: times the noise of a "
                        "position mean (offsets over the field, angles in rad).",
                        heading, 2, 0};

    if (f->noise > 0) {
        heading[sheet.count++] = "σ";
    }
    if (f->request->limits) {
        heading[sheet.count++] = "limit";
    }
    if (has_remarks(f)) {
        sheet.text_columns = 1u << sheet.count;
        heading[sheet.count++] = "remark";
    }
    page_table_begin(p, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        write_row(p, &sheet, f, r);
    }
    page_table_end(p);
}

static void describe(const plan_facts *f, char *text, size_t size)
{
    snprintf(text, size, "Bars, as in the table, times the noise of a position mean:");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const size_t length = strlen(text);
        char number[FIGURE_MAX];
        snprintf(text + length, size - length, " %s %s%s", parameter_words(r),
                 figure_digits(f->sigma[r], 3, number), r + 1 < INVCAL_PARAMETERS ? ";" : ".");
    }
}

static void draw_kind(FILE *file, const plan_facts *f, unsigned kind, const ruler *x)
{
    const double top = top_of(kind);
    const double limit = limit_of(f, kind);

    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = 3 * kind + i;
        const double y = top + (i + 0.5) * ROW;
        svg_text(file, "ink small", SVG_END, LEFT - 8, y + 4, parameter_words(r));
        svg_rectangle(file, is_beyond(f, r) ? "c2 bar" : "c1 bar", LEFT, y - 6,
                      fmax(1, chart_pixel(x, f->sigma[r]) - LEFT), 12);
    }
    if (limit > 0) {
        svg_line(file, "c0 dashed", chart_pixel(x, limit), top, chart_pixel(x, limit),
                 top + 3 * ROW);
    }
}

static void draw_bars(FILE *file, const void *data, double width)
{
    const plan_facts *f = data;
    const ruler y = {0, 1, BOTTOM, TOP, 0, 0};
    double reach = 0;
    char text[TEXT_MAX];

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        reach = fmax(reach, fmax(f->sigma[r], limit_of(f, r / 3))); /* fmax ignores NaN */
    }
    const ruler x =
        chart_ruler_exact(0, 1.05 * reach, LEFT, width - RIGHT, width > PAGE_NARROW ? 8 : 4);
    describe(f, text, sizeof text);
    svg_begin_inline(file, width, BOTTOM + 24, "Expected sigma of the nine parameters", text);
    svg_text(file, "ink heading", SVG_START, 0, 14, "σ, times the noise of a position mean");
    chart_ticks_x(file, &x, &y);
    svg_line(file, "rule", LEFT, TOP, LEFT, BOTTOM);
    for (unsigned kind = 0; kind < PLAN_KINDS; kind++) {
        draw_kind(file, f, kind, &x);
    }
    svg_end(file);
}

void plan_report_sigma(page *p, const plan_facts *f)
{
    page_section(p, "Expected accuracy of the nine parameters");
    write_table(p, f);
    plan_nonlinear_report(p, f->set, f->noise, f->request->units);
    page_picture(p,
                 f->request->limits ? "Offsets over the field, angles in rad. Dashed: the limits."
                                    : "Offsets over the field, angles in rad.",
                 draw_bars, f);
}
