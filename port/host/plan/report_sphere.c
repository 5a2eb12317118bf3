/* SPDX-License-Identifier: MIT
 *
 * The directions of the positions, and the expected uncertainty in every direction.
 */
#include "plan/facts.h"
#include "plan/map.h"

#define TEXT_MAX 600
#define GROUPS_HEIGHT 28.0 /* of their legend */

static void draw_half(FILE *file, const design *d, const sphere *map, unsigned half)
{
    unsigned here = 0;
    char text[TEXT_MAX];
    char title[TEXT_MAX];

    for (unsigned n = 0; n < d->count; n++) {
        here += (d->position[n].vertical[2] < -SPHERE_EQUATOR) == half;
    }
    snprintf(title, sizeof title, "%s: positions with z %s", d->name, half ? "down" : "up");
    snprintf(text, sizeof text,
             "A disc: the hemisphere with z %s, seen from +z. It holds %u of %u positions. The "
             "shading is the expected uncertainty of |a|.",
             half ? "down" : "up or level", here, d->count);
    svg_begin_inline(file, SPHERE_WIDTH, SPHERE_HEIGHT, title, text);
    sphere_draw(file, map, half);
    svg_end(file);
}

void plan_draw_halves(FILE *file, const design *d, const sphere_shading *shading)
{
    const sphere *map = plan_map(d, shading);

    draw_half(file, d, map, 0);
    draw_half(file, d, map, 1);
}

void plan_draw_legend(FILE *file, const sphere_shading *shading, const char *unit, int has_groups)
{
    char text[TEXT_MAX];

    svg_begin_inline(file, SPHERE_WIDTH, UNCERTAINTY_LEGEND + (has_groups ? GROUPS_HEIGHT : 0),
                     "Legend", "Meaning of colours and markers.");
    snprintf(text, sizeof text, "σ of |a|, %s", unit);
    uncertainty_legend(file, shading, text);
    if (has_groups) {
        plan_map_legend(file, 14, UNCERTAINTY_LEGEND + 18);
    }
    svg_end(file);
}

static void say_uncertainty(page *p, const plan_facts *f)
{
    const uncertainty *u = &f->length_sigma;
    char min[FIGURE_MAX];
    char max[FIGURE_MAX];

    figure_digits(u->min, 3, min);
    figure_digits(u->max, 3, max);
    if (uncertainty_shading(u, u->min, u->max).classes == 1) {
        page_say(p,
                 "The uncertainty of the length |a| of a corrected reading is the same in every "
                 "direction: ±%s %s (one standard deviation).",
                 max, plan_length_unit(f));
    } else {
        page_say(p,
                 "The uncertainty of the length |a| of a corrected reading is ±%s %s in the best "
                 "direction, and ±%s %s in the worst, %s (one standard deviation).",
                 min, plan_length_unit(f), max, plan_length_unit(f), u->worst_words);
    }
}

void plan_report_sphere(page *p, const plan_facts *f)
{
    const uncertainty *u = &f->length_sigma;
    const sphere_shading shading = uncertainty_shading(u, u->min, u->max);

    page_section(p, "Where the positions point");
    say_uncertainty(p, f);
    page_row_begin(p);
    plan_draw_halves(p->file, f->set, &shading);
    plan_draw_legend(p->file, &shading, plan_length_unit(f), design_has_groups(f->set));
    page_row_end(p, f->set->count > SPHERE_NUMBERED
                        ? "Up in the axes of the device."
                        : "Up in the axes of the device; numbers as in the work sheet.");
}
