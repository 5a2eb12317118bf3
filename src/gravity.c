/* SPDX-License-Identifier: MIT */
#include "invcal/gravity.h"

#include <math.h>

#include "vector.h"

/* WGS 84 */
#define EQUATOR INVCAL_REAL(9.7803253359)          /* ge, m/s^2 */
#define SOMIGLIANA INVCAL_REAL(0.00193185265241)   /* k */
#define ECCENTRICITY INVCAL_REAL(6.69437999014e-3) /* e^2 */
#define RADIUS INVCAL_REAL(6378137.0)              /* a, m */
#define FLATTENING INVCAL_REAL(3.3528106647475e-3) /* f = 1 / 298.257223563 */
#define ROTATION INVCAL_REAL(3.44978650684e-3)     /* m = omega^2 a^2 b / GM */

static int is_between(invcal_real x, invcal_real low, invcal_real high)
{
    return x >= low && x <= high;
}

invcal_status invcal_gravity(invcal_real latitude, invcal_real height, invcal_real *gravity)
{
    INVCAL_ASSERT(gravity);
    if (!is_between(latitude, -90, 90) ||
        !is_between(height, INVCAL_GRAVITY_LOWEST, INVCAL_GRAVITY_HIGHEST)) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_real sine = INVCAL_SIN(latitude * INVCAL_DEGREE);
    const invcal_real s2 = sine * sine;
    const invcal_real h = height / RADIUS;
    const invcal_real surface =
        EQUATOR * (1 + SOMIGLIANA * s2) / INVCAL_SQRT(1 - ECCENTRICITY * s2);
    const invcal_real loss = 2 * (1 + FLATTENING + ROTATION - 2 * FLATTENING * s2) * h - 3 * h * h;
    *gravity = surface - surface * loss;
    return INVCAL_OK;
}
