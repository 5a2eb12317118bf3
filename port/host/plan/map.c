/* SPDX-License-Identifier: MIT */
#include "plan/map.h"

#include <string.h>

#include "invcal/plan.h"

/* Too large for the stack. */
static sphere map;
static sphere_mark marks[DESIGN_MAX];

static sphere_kind kind_of(unsigned group)
{
    return group == 3 ? SPHERE_GROUP_3 : group == 2 ? SPHERE_GROUP_2 : SPHERE_POSITION;
}

const sphere *plan_map(const design *d, const sphere_shading *shading)
{
    for (unsigned n = 0; n < d->count; n++) {
        memcpy(marks[n].up, d->position[n].vertical, sizeof marks[n].up);
        marks[n].kind = kind_of(d->position[n].group);
    }
    sphere_arrange(&map, marks, d->count, shading);
    return &map;
}

void plan_map_legend(FILE *file, double x, double y)
{
    for (unsigned group = 1; group <= INVCAL_PLAN_GROUPS; group++) {
        char text[32];
        snprintf(text, sizeof text, "group %u", group);
        sphere_marker(file, kind_of(group), x, y - 5);
        svg_text(file, "ink", SVG_START, x + 12, y, text);
        x += 105;
    }
}
