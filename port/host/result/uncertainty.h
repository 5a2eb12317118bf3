/* SPDX-License-Identifier: MIT
 *
 * result/uncertainty.h: how accurately nine parameters give the length of a reading, direction by direction.
 *
 * The row h of a reading (invcal/expert.h) and the covariance K of the nine give its variance,
 * h K h'.
 */
#ifndef UNCERTAINTY_H
#define UNCERTAINTY_H

#include "invcal/expert.h"
#include "draw/sphere.h"

typedef struct {
    double covariance[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]; /* K, over the squared noise */
    double unit;  /* the noise of a position mean in the unit to print; 1 for multiples of it */
    double least; /* sigma of the length, over all directions */
    double most;
    double worst[3];                /* the direction of the latter, */
    char worst_words[INVCAL_WORDS]; /* and in words */
} uncertainty;

/* Finds the least and the most, by a grid of 5 degrees; covariance and unit are given. */
void uncertainty_search(uncertainty *u);

/* Sigma of the length in a direction. Takes an uncertainty, for sphere.h. */
double uncertainty_sigma(const void *context, const double up[3]);

/* Half of the interval that holds 95 % in a direction: `coverage` sigma, but 1.96 of what the parameters
 * `held` leave, whose sigma is stated. In the unit of u. */
double uncertainty_half(const uncertainty *u, const double up[3], double coverage, uint16_t held);

/* Shades a sphere with it: classes at round numbers from `least` to `most`; one class only, if
 * sigma is the same everywhere. u stays the caller's. */
sphere_shading uncertainty_shading(const uncertainty *u, double least, double most);

/* Explains the colours, in the upper UNCERTAINTY_LEGEND pixels of a picture as wide as a half of
 * the sphere. `what` names the quantity and its unit. */
#define UNCERTAINTY_LEGEND 56.0
void uncertainty_legend(FILE *file, const sphere_shading *shading, const char *what);

#endif
