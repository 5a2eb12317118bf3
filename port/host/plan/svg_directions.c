/* SPDX-License-Identifier: MIT
 *
 * The picture of a set: its directions on the two halves of the sphere.
 */
#include <string.h>

#include "plan/results.h"
#include "invcal/plan.h"
#include "plan/map.h"
#include "text/utf8.h"

#define TEXT_MAX 1000
#define MARGIN 8.0 /* between the halves */
#define WIDTH (2 * SPHERE_WIDTH + MARGIN)
#define TOP 56.0
#define BOTTOM 12.0
#define LEGEND 26.0
#define NAME_SHOWN 36u

/* The last NAME_SHOWN characters of a name: the end of a path is its most
 * informative part. */
static const char *shorten(const char *name, char text[TEXT_MAX])
{
    size_t start[NAME_SHOWN]; /* of the last NAME_SHOWN characters: a ring buffer */
    size_t characters = 0;

    for (size_t i = 0; name[i] != '\0'; characters++) {
        const unsigned length = utf8_length(name + i);
        start[characters % NAME_SHOWN] = i;
        i += length > 0 ? length : 1;
    }
    if (characters <= NAME_SHOWN) {
        return name;
    }
    snprintf(text, TEXT_MAX, "...%s", name + start[characters % NAME_SHOWN]);
    return text;
}

static void draw_words(FILE *file, const design *d, const sphere *map, double height)
{
    const unsigned unlabelled = map->unlabelled[0] + map->unlabelled[1];
    char text[TEXT_MAX];

    svg_text(file, "ink title", SVG_START, 12, 27, shorten(d->name, text));
    snprintf(text, sizeof text, "%u position%s: up in the axes of the instrument", d->count,
             d->count == 1 ? "" : "s");
    svg_text(file, "ink", SVG_START, 12, 48, text);
    if (design_has_groups(d)) {
        plan_map_legend(file, 20, height - BOTTOM);
    }
    if (unlabelled > 0) {
        snprintf(text, sizeof text, "without a number, for lack of space: %u spots", unlabelled);
        svg_text(file, "soft small", SVG_END, WIDTH - 12, height - BOTTOM, text);
    }
}

static void describe_map(const design *d, char *text, size_t size)
{
    unsigned upper = 0;
    unsigned lower = 0;

    for (unsigned n = 0; n < d->count; n++) {
        lower += d->position[n].vertical[2] < -SPHERE_EQUATOR;
        upper += d->position[n].vertical[2] > SPHERE_EQUATOR;
    }
    snprintf(text, size,
             "Two discs, the hemispheres of directions in equal-area projection, z up and z down, "
             "both seen from +z, with a grid of 30 degrees. Of %u positions %u have z up, %u z "
             "down, %u z level. Axes that point straight up in some position:",
             d->count, upper, lower, d->count - upper - lower);
    for (unsigned i = 0; i < INVCAL_AXES; i++) {
        if ((unsigned)d->axes >> i & 1u) {
            const size_t length = strlen(text);
            snprintf(text + length, size - length, " %s", design_axis_name(i));
        }
    }
    const size_t length = strlen(text);
    snprintf(text + length, size - length, d->axes ? "." : " none.");
}

void plan_svg_directions(FILE *file, const design *d)
{
    char text[TEXT_MAX];
    char title[TEXT_MAX];
    const sphere *map = plan_map(d, NULL);
    const int has_legend = design_has_groups(d) || map->unlabelled[0] + map->unlabelled[1] > 0;
    const double height = TOP + SPHERE_HEIGHT + (has_legend ? LEGEND : 0) + BOTTOM;
    describe_map(d, text, sizeof text);
    snprintf(title, sizeof title, "%s: directions of %u positions", d->name, d->count);
    svg_begin(file, WIDTH, height, title, text);
    for (unsigned half = 0; half < 2; half++) {
        svg_group_begin(file, half * (SPHERE_WIDTH + MARGIN), TOP);
        sphere_draw(file, map, half);
        svg_group_end(file);
    }
    draw_words(file, d, map, height);
    svg_end(file);
}
