/* SPDX-License-Identifier: MIT
 *
 * Where the positions lie on the sphere, and how well every direction is known.
 */
#include <math.h>
#include <string.h>

#include "chart.h"
#include "report_facts.h"
#include "sphere.h"

#define TEXT_MAX 600
#define SWATCH 44.0
#define LEGEND_HEIGHT 84.0

/* Too large for the stack. */
static sphere map;

/* Thresholds at round numbers: equal steps, or 1, 2, 5, 10 ... where sigma spans much. */
static void set_thresholds(sphere_shading *s, double least, double most)
{
    const int is_wide = most > 15 * least;
    double step = chart_round_step((most - least) / (4 * SPHERE_CLASSES));

    while (floor(most / step) - floor(least / step) > SPHERE_CLASSES - 1) {
        step = chart_round_step(1.01 * step);
    }
    double threshold = is_wide ? chart_round_step(most / 50) : step * (floor(least / step) + 1);
    s->classes = 1;
    while (threshold < most && s->classes < SPHERE_CLASSES) {
        s->threshold[s->classes++ - 1] = threshold;
        threshold = is_wide ? chart_round_step(1.01 * threshold) : threshold + step;
    }
}

static void draw_legend(FILE *file, const report_facts *f, const sphere_shading *s)
{
    char text[TEXT_MAX];
    char number[FIGURE_MAX];

    svg_begin_inline(file, SPHERE_WIDTH, LEGEND_HEIGHT, "Legend",
                     "What the colours and markers mean.");
    snprintf(text, sizeof text, "σ of %s, %s", f->length,
             f->knows_noise ? f->unit : "times the noise of a position mean");
    svg_text(file, "ink small", SVG_START, 8, 14, text);
    for (unsigned k = 0; k < s->classes; k++) {
        snprintf(text, sizeof text, "s%u swatch", k);
        svg_rectangle(file, text, 8 + k * SWATCH, 22, SWATCH, 14);
        if (k > 0) {
            svg_text(file, "ink small", SVG_MIDDLE, 8 + k * SWATCH, 50,
                     figure_digits(s->threshold[k - 1], 2, number));
        }
    }
    sphere_marker(file, SPHERE_POSITION, 14, 70);
    svg_text(file, "ink small", SVG_START, 24, 74, "position");
    sphere_marker(file, SPHERE_NEXT, 98, 70);
    svg_text(file, "ink small", SVG_START, 111, 74, "next");
    if (f->result->rejected.count > 0) {
        sphere_marker(file, SPHERE_LEFT_OUT, 158, 70);
        svg_text(file, "ink small", SVG_START, 168, 74, "left out");
    }
    svg_end(file);
}

static void draw_half(FILE *file, const report_facts *f, unsigned half)
{
    unsigned here = 0;
    char text[TEXT_MAX];

    for (unsigned n = 0; n < f->count; n++) {
        here += (f->position[n].up[2] < -SPHERE_EQUATOR) == half;
    }
    snprintf(
        text, sizeof text,
        "A disc: the half of all directions with z %s, seen from +z. %u of %u positions lie in "
        "it. Shaded by the uncertainty of %s.",
        half ? "down" : "up or level", here, f->count, f->length);
    svg_begin_inline(file, SPHERE_WIDTH, SPHERE_HEIGHT,
                     half ? "Positions with z down" : "Positions with z up", text);
    sphere_draw(file, &map, half);
    svg_end(file);
}

/* How well everything is known, in a sentence. */
static void say_uncertainty(page *p, const report_facts *f)
{
    char least[FIGURE_MAX];
    char most[FIGURE_MAX];

    page_say(p,
             "%s of a corrected reading is known to ±%s %s where the positions tell most, and "
             "to ±%s %s where they tell least, %s (one standard deviation%s).",
             f->is_gravity ? "|a|" : "The length", figure_digits(f->sigma_least, 2, least),
             f->knows_noise ? f->unit : "", figure_digits(f->sigma_most, 2, most),
             f->knows_noise ? f->unit : "", f->worst_words,
             f->knows_noise ? ""
                            : ", in multiples of the noise of a position mean, which is not "
                              "known");
    page_say(p, "The orientation that would add most: %s.", f->next_words);
}

void report_sphere(page *p, const report_facts *f)
{
    sphere_shading shading = {.value = report_sigma, .context = f};

    page_section(p, "Where the positions lie");
    say_uncertainty(p, f);
    set_thresholds(&shading, f->sigma_least, f->sigma_most);
    sphere_arrange(&map, f->mark, f->count + 1, &shading);
    page_row_begin(p);
    draw_half(p->file, f, 0);
    draw_half(p->file, f, 1);
    draw_legend(p->file, f, &shading);
    page_row_end(p,
                 "Up in the axes of the sensor: where each position pointed, and how uncertain the "
                 "length of a reading is in every direction.");
}
