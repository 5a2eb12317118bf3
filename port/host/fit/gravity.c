/* SPDX-License-Identifier: MIT */
#include "fit/gravity.h"

#include <math.h>

/* WGS 84 */
#define EQUATOR 9.7803253359          /* ge, m/s^2 */
#define SOMIGLIANA 0.00193185265241   /* k */
#define ECCENTRICITY 6.69437999014e-3 /* e^2 */
#define RADIUS 6378137.0              /* a, m */
#define FLATTENING 3.3528106647475e-3 /* f = 1 / 298.257223563 */
#define ROTATION 3.44978650684e-3     /* m = omega^2 a^2 b / GM */
#define DEGREE 0.017453292519943296   /* in radians */

double gravity_at(double latitude, double height)
{
    if (!(fabs(latitude) <= 90 && height >= GRAVITY_LOWEST && height <= GRAVITY_HIGHEST)) {
        return (double)NAN;
    }
    const double sine = sin(latitude * DEGREE);
    const double s2 = sine * sine;
    const double h = height / RADIUS;
    const double surface = EQUATOR * (1 + SOMIGLIANA * s2) / sqrt(1 - ECCENTRICITY * s2);

    return surface * (1 - 2 * (1 + FLATTENING + ROTATION - 2 * FLATTENING * s2) * h + 3 * h * h);
}
