/* SPDX-License-Identifier: MIT
 *
 * text/figure.h: numbers as people like to read them: as many digits as are known.
 */
#ifndef FIGURE_H
#define FIGURE_H

#define FIGURE_MAX 64
#define FIGURE_DEGREES 57.295779513082321 /* in a radian */

/* Decimals that show two digits of sigma, or six of the value if sigma is not above 0 or NaN. */
int figure_places(double value, double sigma);

/* A number with so many decimals, "+" before it if asked for, never "-0.00". Returns text. */
typedef enum { FIGURE_PLAIN, FIGURE_SIGNED } figure_sign;
const char *figure_fixed(double x, int places, figure_sign sign, char text[FIGURE_MAX]);

/* "+0.21 ± 0.06", or "+0.214503" if sigma is not known (NaN). Returns text. */
const char *figure_with_sigma(double value, double sigma, figure_sign sign, char text[FIGURE_MAX]);

/* So many digits, 1 ... 6, of a number: 3 of them are "0.214", "21.4", "2140". Returns text. */
const char *figure_digits(double x, int digits, char text[FIGURE_MAX]);

#endif
