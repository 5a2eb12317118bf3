/* SPDX-License-Identifier: MIT
 *
 * Reduces the angle to an eighth of a turn by quarter turns, sums both Taylor series there, and
 * exchanges sine and cosine. Angles are in degrees, since a quarter turn is then a whole number:
 * the reduction is exact, and so are the values at its multiples.
 */
#include "circle.h"

#define RADIANS INVCAL_REAL(0.017453292519943296) /* in a degree */
enum { TERMS = INVCAL_DOUBLE ? 17 : 10 }; /* of an eighth of a turn: the next is below rounding */

void invcali_circle(invcal_real degrees, invcal_real *cosine, invcal_real *sine)
{
    unsigned quarters = 0;

    while (degrees > 45) { /* at most eight steps, each exact */
        degrees -= 90;
        quarters += 1;
    }
    while (degrees < -45) { /* at most eight steps */
        degrees += 90;
        quarters += 3;
    }
    const invcal_real x = degrees * RADIANS;
    invcal_real part[2] = {1, 1};          /* cos x, sin x / x: 1 - x^2 / (n (n - 1)) (1 - ...) */
    for (unsigned n = TERMS; n > 1; n--) { /* at most TERMS */
        part[n % 2] = 1 - part[n % 2] * x * x / (invcal_real)(n * (n - 1));
    }
    const invcal_real c = part[0];
    const invcal_real s = part[1] * x;
    const invcal_real wave[4] = {s, c, -s, -c}; /* the sine, in steps of a quarter turn */
    *sine = wave[quarters % 4];
    *cosine = wave[(quarters + 1) % 4];
}
