/* SPDX-License-Identifier: MIT
 *
 * text/figure.h: formats numbers for people, with as many digits as are significant.
 */
#ifndef FIGURE_H
#define FIGURE_H

#define FIGURE_MAX 64
#define FIGURE_DEGREES 57.295779513082321 /* in a radian */

/* Decimal places that show two digits of sigma, or six of the value if sigma is not above 0 or
 * NaN. */
int figure_places(double value, double sigma);

/* A number with that many decimal places, on request with a "+", never "-0.00". Returns text. */
typedef enum { FIGURE_PLAIN, FIGURE_SIGNED } figure_sign;
const char *figure_fixed(double x, int places, figure_sign sign, char text[FIGURE_MAX]);

/* "+0.21 ± 0.06", or "+0.214503" if sigma is not known (NaN). Returns text. */
const char *figure_with_sigma(double value, double sigma, figure_sign sign, char text[FIGURE_MAX]);

/* A number with that many significant digits, 1 ... 6; with 3: "0.214", "21.4", "2140". Returns
 * text. */
const char *figure_digits(double x, int digits, char text[FIGURE_MAX]);

#endif
