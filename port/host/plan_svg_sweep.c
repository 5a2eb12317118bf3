/* SPDX-License-Identifier: MIT
 *
 * The picture of a sweep: sigma against the number of positions.
 */
#include "plan.h"

#include <math.h>
#include <string.h>

#include "chart.h"
#include "svg.h"

#define TEXT_MAX 1000
#define ALL_AXES ((1u << INVCAL_AXES) - 1)

#define SWEEP_WIDTH 640.0
#define SWEEP_HEIGHT 468.0
#define PLOT_LEFT 52.0
#define PLOT_RIGHT 622.0
#define PLOT_TOP 122.0
#define PLOT_BOTTOM 376.0
#define LOGARITHMIC 20.0 /* from this ratio of last to first on */

typedef struct {
    const char *name;
    const char *style[3]; /* of the curve, of full and hollow markers */
    svg_shape shape;
} curve;

static const curve curves[3] = {
    {"non-orthogonality (rad)", {"c3 curve", "c3 full", "c3 hollow"}, SVG_TRIANGLE},
    {"scale errors", {"c2 curve", "c2 full", "c2 hollow"}, SVG_SQUARE},
    {"offsets (over the field)", {"c1 curve", "c1 full", "c1 hollow"}, SVG_CIRCLE},
};

static double curve_value(unsigned k, const plan_row *row)
{
    const invcal_criteria *c = &row->criteria;
    const double values[] = {c->sigma_gamma, c->sigma_dk, c->sigma_delta};

    return values[k];
}

static double row_positions(const plan_row *row)
{
    return INVCAL_PLAN_GROUPS * row->per_group;
}

static ruler positions_axis(const plan_row *rows, unsigned count)
{
    const double first = row_positions(&rows[0]);
    const double last = row_positions(&rows[count - 1]);
    ruler a = {first, last, PLOT_LEFT, PLOT_RIGHT, last >= LOGARITHMIC * first, 0};

    if (a.is_logarithmic) {
        a.first = log(first);
        a.last = log(last);
    }
    const double margin = count > 1 ? 0.03 * (a.last - a.first) : INVCAL_PLAN_GROUPS;
    a.first -= margin;
    a.last += margin;
    return a;
}

/* From 0 to a round number above the highest point. */
static ruler sigma_axis(const plan_row *rows, unsigned count)
{
    double highest = 0;

    for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < 3; k++) {
            highest = fmax(highest, curve_value(k, &rows[i]));
        }
    }
    return chart_ruler(0, highest, PLOT_BOTTOM, PLOT_TOP, 8);
}

static void draw_tick_x(FILE *file, const ruler *x, double value)
{
    char text[SVG_NUMBER_MAX];
    const double at = chart_pixel(x, value);

    svg_line(file, "grid", at, PLOT_TOP, at, PLOT_BOTTOM);
    svg_text(file, "ink small", SVG_MIDDLE, at, PLOT_BOTTOM + 18, svg_fixed(value, 0, text));
}

/* Ticks stand at programs that exist, multiples of 3: 3 times 1, 2, 5, 10 ... on a logarithmic
 * axis, multiples of one of these on a linear one. */
static void draw_ticks_x(FILE *file, const ruler *x, double first, double last)
{
    if (x->is_logarithmic) {
        for (double v = chart_round_step(first / 3); 3 * v <= last; v = chart_round_step(1.5 * v)) {
            draw_tick_x(file, x, 3 * v);
        }
        return;
    }
    const double step = 3 * fmax(1, chart_round_step(fmax(1, last - first) / 36));
    for (double k = ceil(first / step); k * step <= last; k++) {
        draw_tick_x(file, x, k * step);
    }
}

static void draw_curve(FILE *file, unsigned k, const ruler *x, const ruler *y, const plan_row *rows,
                       unsigned count)
{
    svg_polyline_begin(file, curves[k].style[0]);
    for (unsigned i = 0; i < count; i++) {
        svg_polyline_point(file, chart_pixel(x, row_positions(&rows[i])),
                           chart_pixel(y, curve_value(k, &rows[i])));
    }
    svg_polyline_end(file);
}

/* Marks programs at least 8 pixels apart. Full and hollow markers take turns, as even and odd N
 * do: an odd number of steps from one marked program to the next keeps both in sight. Returns the
 * number that are marked. */
static unsigned draw_markers(FILE *file, const ruler *x, const ruler *y, const plan_row *rows,
                             unsigned count)
{
    const double apart = (chart_pixel(x, row_positions(&rows[count - 1])) - PLOT_LEFT) / count;
    const double radius = apart > 16 && !x->is_logarithmic ? 4.5 : 3.2;
    unsigned marked = 0;
    unsigned last = 0;

    for (unsigned i = 0; i < count; i++) {
        const double at = chart_pixel(x, row_positions(&rows[i]));
        const double gap = at - chart_pixel(x, row_positions(&rows[last]));
        if (marked > 0 && (gap < 8 || (i - last) % 2 == 0)) {
            continue;
        }
        for (unsigned k = 0; k < 3; k++) {
            const char *style = curves[k].style[rows[i].axes == ALL_AXES ? 1 : 2];
            svg_marker(file, style, curves[k].shape, at, chart_pixel(y, curve_value(k, &rows[i])),
                       radius);
        }
        marked++;
        last = i;
    }
    return marked;
}

static void draw_sweep_legend(FILE *file)
{
    static const double left[] = {22, 236, 382};

    for (unsigned k = 0; k < 3; k++) {
        svg_line(file, curves[k].style[0], left[k] - 10, 50, left[k] + 18, 50);
        svg_marker(file, curves[k].style[1], curves[k].shape, left[k] + 4, 50, 4.5);
        svg_text(file, "ink", SVG_START, left[k] + 24, 55, curves[k].name);
    }
    svg_marker(file, "c0 full", SVG_CIRCLE, 26, 73, 4.5);
    svg_text(file, "soft small", SVG_START, 46, 77,
             "each of +x, -x, +y, -y, +z, -z points up in some position");
    svg_marker(file, "c0 hollow", SVG_CIRCLE, 436, 73, 4.5);
    svg_text(file, "soft small", SVG_START, 450, 77, "not all of them do");
}

static void draw_sweep_words(FILE *file, int is_logarithmic, int is_thinned)
{
    svg_text(file, "ink title", SVG_START, 12, 27, "Standard deviations of the 3 x N programs");
    svg_text(file, "ink", SVG_START, 12, PLOT_TOP - 14,
             "standard deviation / (noise of a position mean / field)");
    svg_text(file, "ink", SVG_MIDDLE, (PLOT_LEFT + PLOT_RIGHT) / 2, PLOT_BOTTOM + 40,
             is_logarithmic ? "number of positions, 3 N (logarithmic)"
                            : "number of positions, 3 N");
    svg_text(
        file, "soft small", SVG_START, 12, SWEEP_HEIGHT - 28,
        "With a noise of 1e-6 of the field, 1 means offsets 1e-6 of the field, scale errors 1e-6, "
        "1 µrad.");
    svg_text(file, "soft small", SVG_START, 12, SWEEP_HEIGHT - 11,
             is_thinned ? "Each value is the largest of three. Not every program has a marker."
                        : "Each value is the largest of three.");
}

static void describe_row(const plan_row *row, char *text, size_t size)
{
    char figures[3][SVG_NUMBER_MAX];
    const size_t length = strlen(text);

    for (unsigned k = 0; k < 3; k++) {
        svg_fixed(curve_value(k, row), 3, figures[k]);
    }
    snprintf(text + length, size - length,
             " With %u positions: offsets %s, scale errors %s, non-orthogonality %s.",
             INVCAL_PLAN_GROUPS * row->per_group, figures[2], figures[1], figures[0]);
}

static void describe_sweep(const plan_row *rows, unsigned count, char *text, size_t size)
{
    unsigned all = 0;

    for (unsigned i = 0; i < count; i++) {
        all += rows[i].axes == ALL_AXES;
    }
    snprintf(text, size,
             "Standard deviations over the noise of a position mean, for programs of three groups "
             "of N positions; the largest of the three axes each. They fall as 1 over the square "
             "root of N.");
    describe_row(&rows[0], text, size);
    if (count > 2) {
        describe_row(&rows[count / 2], text, size);
    }
    if (count > 1) {
        describe_row(&rows[count - 1], text, size);
    }
    const size_t length = strlen(text);
    snprintf(text + length, size - length,
             " All six of +x, -x, +y, -y, +z, -z point up in some position of %u of %u programs.",
             all, count);
}

void plan_svg_sweep(FILE *file, const plan_row *rows, unsigned count)
{
    char description[TEXT_MAX];
    const ruler x = positions_axis(rows, count);
    const ruler y = sigma_axis(rows, count);

    describe_sweep(rows, count, description, sizeof description);
    svg_begin(file, SWEEP_WIDTH, SWEEP_HEIGHT, "Standard deviations against number of positions",
              description);
    draw_ticks_x(file, &x, row_positions(&rows[0]), row_positions(&rows[count - 1]));
    chart_ticks_y(file, &y, &x);
    svg_line(file, "rule", PLOT_LEFT, PLOT_TOP, PLOT_LEFT, PLOT_BOTTOM);
    for (unsigned k = 0; k < 3; k++) {
        draw_curve(file, k, &x, &y, rows, count);
    }
    const unsigned marked = draw_markers(file, &x, &y, rows, count);
    draw_sweep_legend(file);
    draw_sweep_words(file, x.is_logarithmic, marked < count);
    svg_end(file);
}
