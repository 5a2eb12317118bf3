/* SPDX-License-Identifier: MIT
 *
 * draw/chart.h: what charts share: rulers from values to pixels, round steps, ticks.
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

/* The least of ... 1, 2, 5, 10, 20, 50 ... that is not below x, x > 0. */
double chart_round_step(double x);

/* A linear axis that reaches from `least` or below to `most` or above, both ends at a tick, with
 * about `ticks` of them. Equal ends are spread. */
ruler chart_ruler(double least, double most, double from, double to, unsigned ticks);

/* The same without room to spare: from `least` to `most`, ticks inside. */
ruler chart_ruler_exact(double least, double most, double from, double to, unsigned ticks);

/* Pixel of a value. */
double chart_pixel(const ruler *r, double value);

/* Lines and figures of the ticks, over the extent of the other axis. `from` ... `to` of `other`
 * is the pixel range of that axis. Figures of x stand below it, of y to its left. */
void chart_ticks_x(FILE *file, const ruler *x, const ruler *y);
void chart_ticks_y(FILE *file, const ruler *y, const ruler *x);

/* Decimals that a step needs. */
unsigned chart_places(double step);

#endif
