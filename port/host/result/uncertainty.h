/* SPDX-License-Identifier: MIT
 *
 * result/uncertainty.h: the uncertainty of the calibrated length of a reading, as a function of its
 * direction.
 *
 * Its variance is h K h', with the row h of the reading (invcal/expert.h) and the covariance K of
 * the nine parameters.
 */
#ifndef UNCERTAINTY_H
#define UNCERTAINTY_H

#include "draw/sphere.h"
#include "core/system.h"

typedef struct {
    double covariance[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]; /* K, over the squared noise */
    double unit;     /* the noise of a position mean in the unit to print; 1 for multiples of it */
    double min;      /* smallest sigma of the length over all directions */
    double max;      /* largest */
    double worst[3]; /* direction of max */
    char worst_words[INVCAL_TEXT_SIZE]; /* the same in words */
} uncertainty;

/* Finds min, max and worst on a grid of 5 degrees, for the given covariance and unit. */
void uncertainty_search(uncertainty *u);

/* Sigma of the length in a direction. `context` is an uncertainty: a callback for sphere.h. */
double uncertainty_sigma(const void *context, const double up[3]);

/* Half-width of the 95 % interval in a direction, in the unit of u: `coverage` sigma, but 1.96 for
 * the part from the parameters `held`, whose sigma is stated. */
double uncertainty_half_width(const uncertainty *u, const double up[3], double coverage,
                              uint16_t held);

/* The shading of a sphere: classes at round numbers from min to max; one class only if sigma is the
 * same everywhere. u must outlive it. */
sphere_shading uncertainty_shading(const uncertainty *u, double min, double max);

/* The legend of the colours, in the upper UNCERTAINTY_LEGEND pixels of a picture as wide as a half
 * of the sphere. `what` names the quantity and its unit. */
#define UNCERTAINTY_LEGEND 56.0
void uncertainty_legend(FILE *file, const sphere_shading *shading, const char *what);

#endif
