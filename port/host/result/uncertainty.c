/* SPDX-License-Identifier: MIT */
#include "result/uncertainty.h"

#include <math.h>
#include <string.h>

#include "invcal/plan.h"
#include "draw/chart.h"
#include "fit/fit.h"
#include "core/sums.h"

#define TURN 6.2831853071795865
#define STEP (TURN / 72)        /* of the search for the most uncertain direction */
#define RELATIVE_TOLERANCE 1e-6 /* sigma that differs by less is the same everywhere */
#define SWATCH_WIDTH 44.0
#define ALL_PARAMETERS ((1u << INVCAL_PARAMETERS) - 1)

/* h K h' of the parameters in the set `of`. */
static double square_of(const uncertainty *u, const double up[3], unsigned of)
{
    static const invcal_calibration unit = {{0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    invcali_row row;
    double square = 0;

    if (invcali_observe(&unit, up, &row) != INVCAL_OK) {
        return 0;
    }
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        for (unsigned j = 0; j <= i && of >> i & 1; j++) {
            square += (of >> j & 1) * (i == j ? 1 : 2) * row.h[i] * row.h[j] *
                      u->covariance[INVCAL_PACKED(i, j)];
        }
    }
    return fmax(0, square);
}

double uncertainty_sigma(const void *context, const double up[3])
{
    const uncertainty *u = context;

    return u->unit * sqrt(square_of(u, up, ALL_PARAMETERS));
}

double uncertainty_half_width(const uncertainty *u, const double up[3], double coverage,
                              uint16_t held)
{
    const double all = square_of(u, up, ALL_PARAMETERS);
    const double stated = fmin(all, square_of(u, up, held));

    return u->unit * sqrt(coverage * coverage * (all - stated) + FIT_NORMAL * FIT_NORMAL * stated);
}

void uncertainty_search(uncertainty *u)
{
    u->min = HUGE_VAL;
    u->max = 0;
    for (double polar = 0; polar < TURN / 2 + STEP / 2; polar += STEP) {
        for (double azimuth = 0; azimuth < TURN - STEP / 2; azimuth += STEP) {
            const double up[3] = {sin(polar) * cos(azimuth), sin(polar) * sin(azimuth), cos(polar)};
            const double sigma = uncertainty_sigma(u, up);
            u->min = fmin(u->min, sigma);
            if (sigma > u->max) {
                u->max = sigma;
                memcpy(u->worst, up, sizeof u->worst);
            }
        }
    }
    (void)invcal_direction_text(u->worst, u->worst_words);
}

/* Equal steps, or 1, 2, 5, 10 ... if the range is wide. */
static void set_thresholds(sphere_shading *s, double min, double max)
{
    const int is_wide = max > 15 * min;
    double step = chart_round_step((max - min) / (4 * SPHERE_CLASSES));

    while (floor(max / step) - floor(min / step) > SPHERE_CLASSES - 1) {
        step = chart_round_step(1.01 * step);
    }
    double threshold = is_wide ? chart_round_step(max / 50) : step * (floor(min / step) + 1);
    while (threshold < max && s->classes < SPHERE_CLASSES) {
        s->threshold[s->classes++ - 1] = threshold;
        threshold = is_wide ? chart_round_step(1.01 * threshold) : threshold + step;
    }
}

sphere_shading uncertainty_shading(const uncertainty *u, double min, double max)
{
    sphere_shading s = {.value = uncertainty_sigma, .context = u, .classes = 1};

    if (max - min > RELATIVE_TOLERANCE * max) {
        set_thresholds(&s, min, max);
    }
    return s;
}

void uncertainty_legend(FILE *file, const sphere_shading *shading, const char *what)
{
    svg_text(file, "ink small", SVG_START, 8, 14, what);
    for (unsigned k = 0; k < shading->classes; k++) {
        char text[32];
        snprintf(text, sizeof text, "s%u swatch", k);
        svg_rectangle(file, text, 8 + k * SWATCH_WIDTH, 22, SWATCH_WIDTH, 14);
        if (k > 0) {
            snprintf(text, sizeof text, "%.6g", shading->threshold[k - 1]);
            svg_text(file, "ink small", SVG_MIDDLE, 8 + k * SWATCH_WIDTH, 50, text);
        }
    }
    if (shading->classes == 1) {
        svg_text(file, "ink small", SVG_START, 16 + SWATCH_WIDTH, 33, "the same everywhere");
    }
}
