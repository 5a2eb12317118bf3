/* SPDX-License-Identifier: MIT */
#include "text/figure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIGURE_ZERO 1e-9 /* less is rounding error */

int figure_places(double value, double sigma)
{
    const double size = sigma > 0 ? sigma : fabs(value);
    const double digits = sigma > 0 ? 1 : 5;
    const double places = size > 0 ? digits - floor(log10(size)) : digits;

    return places < 0 ? 0 : places > 9 ? 9 : (int)places;
}

const char *figure_fixed(double x, int places, figure_sign sign, char text[FIGURE_MAX])
{
    if (!(fabs(x) < 1e10)) {
        snprintf(text, FIGURE_MAX, "%.6g", x);
        return text;
    }
    snprintf(text, FIGURE_MAX, "%.*f", places, x);
    const int is_zero = !(fabs(strtod(text, NULL)) > 0);
    snprintf(text, FIGURE_MAX, "%s%.*f", sign == FIGURE_SIGNED && (is_zero || x > 0) ? "+" : "",
             places, is_zero ? 0.0 : x);
    return text;
}

const char *figure_with_sigma(double value, double sigma, figure_sign sign, char text[FIGURE_MAX])
{
    char number[FIGURE_MAX];
    char spread[FIGURE_MAX];
    const int places = figure_places(value, sigma);

    figure_fixed(value, places, sign, number);
    if (isnan(sigma)) {
        snprintf(text, FIGURE_MAX, "%s", number);
    } else {
        snprintf(text, FIGURE_MAX, "%.29s ± %.29s", number,
                 figure_fixed(sigma, places, FIGURE_PLAIN, spread));
    }
    return text;
}

const char *figure_digits(double x, int digits, char text[FIGURE_MAX])
{
    const double size = fabs(x);

    if (!(size >= FIGURE_ZERO)) {
        snprintf(text, FIGURE_MAX, "0");
    } else if (size < 0.001 || size >= 1e6) {
        snprintf(text, FIGURE_MAX, "%.*g", digits, x);
    } else { /* the exponent after rounding: 0.9999 is 1.00 */
        snprintf(text, FIGURE_MAX, "%.*e", digits - 1, x);
        /* NOLINTNEXTLINE(cert-err34-c): snprintf has just written it */
        const int places = digits - 1 - atoi(strchr(text, 'e') + 1);
        figure_fixed(x, places > 0 ? places : 0, FIGURE_PLAIN, text);
    }
    return text;
}
