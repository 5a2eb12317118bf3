/* SPDX-License-Identifier: MIT
 *
 * The picture of a comparison: time and accuracy of B over those of A.
 */
#include <math.h>
#include <string.h>

#include "draw/chart.h"
#include "text/figure.h"
#include "plan/ratios.h"
#include "draw/svg.h"

#define TEXT_MAX 1000
#define STANDALONE_WIDTH 560.0
#define MARGIN 12.0
#define TITLE_HEIGHT 72.0 /* heading and names, in a file */
#define TOP 42.0
#define ROW 44.0
#define BAR 14.0
#define BOTTOM (TOP + (unsigned)PLAN_RATIOS * ROW)
#define HEIGHT (BOTTOM + 44)
#define SIDE_MARGIN 12.0 /* for half the width of a tick's number */
#define LARGE 4.0        /* ranges of ratios */
#define VERY_LARGE 60.0
#define TICK_DISTANCE 60.0 /* pixels between ticks, about */
#define NAME_SHOWN 60

/* Logarithmic: 1/2 and 2 are equally far from 1. With a margin on both sides. */
static ruler ratio_axis(const plan_ratio *ratio, double width)
{
    double min = 1 / 1.1;
    double max = 1.1;

    for (unsigned i = 0; i < PLAN_RATIOS; i++) {
        min = fmin(min, ratio[i].ratio);
        max = fmax(max, ratio[i].ratio);
    }
    const double margin = 0.04 * log(max / min);
    return (ruler){log(min) - margin, log(max) + margin, SIDE_MARGIN, width - SIDE_MARGIN, 1, 0};
}

static void draw_tick(FILE *file, const ruler *x, double value, unsigned places)
{
    const double at = chart_pixel(x, value);
    char text[SVG_NUMBER_MAX];

    svg_line(file, fabs(value - 1) > 0 ? "grid" : "rule", at, TOP, at, BOTTOM);
    svg_text(file, "ink small", SVG_MIDDLE, at, BOTTOM + 17, svg_fixed(value, places, text));
}

/* Equal steps in a small range; 1, 2, 5, 10 ... in a large one, in a very large one 1, 10, 100. */
static void draw_ticks(FILE *file, const ruler *x)
{
    const double min = exp(x->first);
    const double max = exp(x->last);
    const double step = chart_round_step((max - min) * TICK_DISTANCE / (x->to - x->from));

    if (max <= LARGE * min) {
        for (double k = ceil(min / step); k * step < max; k++) {
            draw_tick(file, x, k * step, chart_places(step));
        }
        return;
    }
    const double factor = max > VERY_LARGE * min ? 10 : 1.5;
    double tick = pow(10, floor(log10(min)));
    while (tick < max) {
        if (tick > min) {
            draw_tick(file, x, tick, chart_places(tick));
        }
        tick = chart_round_step(factor * tick * (1 - 1e-9));
    }
}

/* Name and values over the bar, which runs from 1 to the ratio. */
static void draw_row(FILE *file, const plan_ratio *ratio, unsigned i, const ruler *x)
{
    const plan_ratio *r = &ratio[i];
    const double y = TOP + i * ROW;
    const double one = chart_pixel(x, 1);
    const double end = chart_pixel(x, r->ratio);
    char values[3 * PLAN_WORDS_MAX];
    char number[FIGURE_MAX];

    snprintf(values, sizeof values, "%s → %s: %s", r->a, r->b, figure_digits(r->ratio, 4, number));
    svg_text(file, "ink small halo", SVG_START, x->from, y + 15, r->name);
    svg_text(file, "ink small halo", SVG_END, x->to, y + 15, values);
    svg_rectangle(file, r->ratio > 1 ? "c2 bar" : "c1 bar", fmin(one, end) - 1, y + 21,
                  fabs(end - one) + 2, BAR);
}

static void describe(const plan_ratio *ratio, char *text, size_t size)
{
    snprintf(text, size, "Ratios of B to A, less is better:");
    for (unsigned i = 0; i < PLAN_RATIOS; i++) {
        const size_t length = strlen(text);
        char number[FIGURE_MAX];
        snprintf(text + length, size - length, " %.99s %s%s", ratio[i].name,
                 figure_digits(ratio[i].ratio, 4, number), i + 1 < PLAN_RATIOS ? ";" : ".");
    }
}

static void draw_chart(FILE *file, const plan_ratio *ratio, double width)
{
    const ruler x = ratio_axis(ratio, width);

    svg_rectangle(file, "c1 bar", SIDE_MARGIN, 6, 18, BAR);
    svg_text(file, "ink small", SVG_START, SIDE_MARGIN + 24, 17, "B has less, which is better");
    svg_rectangle(file, "c2 bar", SIDE_MARGIN + 196, 6, 18, BAR);
    svg_text(file, "ink small", SVG_START, SIDE_MARGIN + 220, 17, "B has more");
    draw_ticks(file, &x);
    for (unsigned i = 0; i < PLAN_RATIOS; i++) {
        draw_row(file, ratio, i, &x);
    }
    svg_text(file, "soft small", SVG_MIDDLE, width / 2, BOTTOM + 38,
             "B / A (logarithmic; A is the line at 1)");
}

static const char title[] = "Two sets of positions compared";

void plan_svg_comparison(FILE *file, const design *a, const design *b,
                         const choice_request *request)
{
    plan_ratio ratio[PLAN_RATIOS];
    char text[TEXT_MAX];

    plan_ratios(a, b, request, ratio);
    describe(ratio, text, sizeof text);
    svg_begin(file, STANDALONE_WIDTH, TITLE_HEIGHT + HEIGHT, title, text);
    svg_text(file, "ink title", SVG_START, MARGIN, 27, title);
    snprintf(text, sizeof text, "A: %.*s", NAME_SHOWN, a->name);
    svg_text(file, "ink small", SVG_START, MARGIN, 47, text);
    snprintf(text, sizeof text, "B: %.*s", NAME_SHOWN, b->name);
    svg_text(file, "ink small", SVG_START, MARGIN, 65, text);
    svg_group_begin(file, 0, TITLE_HEIGHT);
    draw_chart(file, ratio, STANDALONE_WIDTH);
    svg_group_end(file);
    svg_end(file);
}

void plan_svg_comparison_inline(FILE *file, const design *a, const design *b,
                                const choice_request *request, double width)
{
    plan_ratio ratio[PLAN_RATIOS];
    char text[TEXT_MAX];

    plan_ratios(a, b, request, ratio);
    describe(ratio, text, sizeof text);
    svg_begin_inline(file, width, HEIGHT, title, text);
    draw_chart(file, ratio, width);
    svg_end(file);
}
