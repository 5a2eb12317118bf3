/* SPDX-License-Identifier: MIT */
#include "watch/state.h"

#include <math.h>

#include "invcal/result.h"
#include "text/figure.h"

#define NORMAL 1.959964 /* coverage factor for 95 % with known noise, as in session.c */

const char *const watch_kinds[WATCH_KINDS] = {"offsets", "scales", "angles"};

/* The arc cosine is too coarse near 0 and 180. */
double watch_degrees_to_go(const watch_state *now)
{
    const double *a = now->up;
    const double *b = now->target;
    const double across[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                              a[0] * b[1] - a[1] * b[0]};

    if (!now->has_up || !now->has_target) {
        return -1;
    }
    return FIGURE_DEGREES * atan2(hypot(hypot(across[0], across[1]), across[2]),
                                  a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

int watch_knows_sigma(const watch_state *now)
{
    return now->status == INVCAL_OK && now->quality.dof > 0;
}

double watch_interval(const watch_state *now, unsigned kind)
{
    const double *sigma = &now->quality.sigma[(size_t)WATCH_KINDS * kind];

    return invcal_coverage(now->quality.sigma_dof) * fmax(sigma[0], fmax(sigma[1], sigma[2]));
}

double watch_goal(const watch_state *now, unsigned kind)
{
    return NORMAL * now->target_sigma[kind];
}

int watch_has_goal(const watch_state *now)
{
    const double *target = now->target_sigma;

    return now->need > 0 || target[0] > 0 || target[1] > 0 || target[2] > 0;
}

display_unit watch_unit(const watch_state *now, unsigned kind)
{
    const display_unit degrees = {FIGURE_DEGREES, "°"};

    switch (kind) {
    case 0:
        return now->is_magnetometer ? unit_style_scale(now->units)
                                    : unit_style_field(now->units, 1);
    case 1:
        return unit_style_scale(now->units);
    default:
        return now->units == UNIT_STYLE_INS ? unit_style_angle(now->units) : degrees;
    }
}
