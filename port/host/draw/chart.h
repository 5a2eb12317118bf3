/* SPDX-License-Identifier: MIT
 *
 * draw/chart.h: axes of charts: values to pixels, round steps, ticks.
 */
#ifndef CHART_H
#define CHART_H

#include <stdio.h>

/* One axis of a chart. */
typedef struct {
    double first; /* value at pixel `from`; its logarithm if is_logarithmic */
    double last;
    double from;
    double to;
    int is_logarithmic;
    double step; /* between ticks; 0 where the chart sets its own */
} ruler;

/* The smallest of ... 1, 2, 5, 10, 20, 50 ... that is not below x; x > 0. */
double chart_round_step(double x);

/* A linear axis that contains min and max, with both ends at a tick and about `ticks` of them. If
 * min and max are equal, they are moved apart. */
ruler chart_ruler(double min, double max, double from, double to, unsigned ticks);

/* The same from min to max exactly, with ticks in between. */
ruler chart_ruler_exact(double min, double max, double from, double to, unsigned ticks);

/* Pixel of a value. */
double chart_pixel(const ruler *r, double value);

/* Grid lines and figures of the ticks. Grid lines extend over the pixel range of the other axis.
 * The figures of x are below it, those of y to its left. */
void chart_ticks_x(FILE *file, const ruler *x, const ruler *y);
void chart_ticks_y(FILE *file, const ruler *y, const ruler *x);

/* Number of decimals that a step needs. */
unsigned chart_places(double step);

#endif
