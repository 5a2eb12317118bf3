/* SPDX-License-Identifier: MIT
 *
 * The positions on the sphere, and the uncertainty of every direction.
 */
#include "report/facts.h"

#define TEXT_MAX 600
#define LEGEND_HEIGHT (UNCERTAINTY_LEGEND + 28)

/* Too large for the stack. */
static sphere map;

static void draw_legend(FILE *file, const report_facts *f, const sphere_shading *s)
{
    char text[TEXT_MAX];

    svg_begin_inline(file, SPHERE_WIDTH, LEGEND_HEIGHT, "Legend",
                     "Meaning of colours and markers.");
    snprintf(text, sizeof text, "± of %s, %s", f->length,
             f->knows_noise ? f->unit : "times the noise of a position mean");
    uncertainty_legend(file, s, text);
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
    snprintf(text, sizeof text,
             "A disc: the hemisphere with z %s, seen from +z. It holds %u of %u positions. The "
             "shading is the uncertainty of %s.",
             half ? "down" : "up or level", here, f->count, f->length);
    svg_begin_inline(file, SPHERE_WIDTH, SPHERE_HEIGHT,
                     half ? "Positions with z down" : "Positions with z up", text);
    sphere_draw(file, &map, half);
    svg_end(file);
}

/* The uncertainty in sentences. */
static void write_uncertainty(page *p, const report_facts *f)
{
    char min[FIGURE_MAX];
    char max[FIGURE_MAX];

    page_say(p,
             "The uncertainty of %s of a corrected reading is ±%s %s in the best direction, and "
             "±%s %s in the worst, %s%s.",
             f->is_gravity ? "|a|" : "the length", figure_digits(f->length_spread.min, 2, min),
             f->knows_noise ? f->unit : "", figure_digits(f->length_spread.max, 2, max),
             f->knows_noise ? f->unit : "", f->length_spread.worst_words,
             f->knows_noise ? ""
                            : ", in multiples of the noise of a position mean, which is unknown");
    if (f->field_spread > 0) {
        page_say(p,
                 "This does not include the uncertainty of %s itself: ±%s %s, the same in all "
                 "directions.",
                 f->is_gravity ? "g" : "the field", figure_digits(f->field_spread, 2, max),
                 f->unit);
    }
    page_say(p,
             f->result->magnetometer ? "Most informative next: swing it around with %s; south of "
                                       "the magnetic equator, with that side down."
                                     : "Most informative next orientation: %s.",
             f->next_words);
}

void report_sphere(page *p, const report_facts *f)
{
    const uncertainty *u = &f->length_spread;
    const sphere_shading shading = uncertainty_shading(u, u->min, u->max);

    page_section(p, "Where the positions lie");
    write_uncertainty(p, f);
    sphere_arrange(&map, f->mark, f->count + 1, &shading);
    page_row_begin(p);
    draw_half(p->file, f, 0);
    draw_half(p->file, f, 1);
    draw_legend(p->file, f, &shading);
    page_row_end(p, f->result->magnetometer
                        ? "The field in the axes of the sensor: the direction of the mean of each "
                          "cell, and the uncertainty of the length of a reading in every direction."
                        : "Up in the axes of the sensor: the direction of each position, and the "
                          "uncertainty of the length of a reading in every direction.");
}
