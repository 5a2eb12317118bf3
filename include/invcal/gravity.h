/* SPDX-License-Identifier: MIT
 *
 * invcal/gravity.h: the length of the field at a place on Earth.
 *
 * Normal gravity is that of the ellipsoid WGS 84 (NIMA TR8350.2, third edition, equations 4-1 and
 * 4-3; the second is the free-air term to second order in h, Heiskanen and Moritz, Physical
 * Geodesy, equation 2-123), phi the geodetic latitude, h the height:
 *
 *     gamma0 = ge (1 + k sin^2 phi) / sqrt(1 - e^2 sin^2 phi)                       (Somigliana)
 *     gamma  = gamma0 (1 - 2 (1 + f + m - 2 f sin^2 phi) h / a + 3 h^2 / a^2)
 *
 * 9.7803253359 m/s^2 at the equator, 9.8061977694 at 45 degrees, 9.8321849379 at the poles; 1 m
 * of height takes 3.086e-6.
 *
 * What an error of g does: scale only, and the same on all axes. Whoever states g' where it is g
 * gets a matrix, and every calibrated reading, times g' / g. Offsets in raw units, offsets in g,
 * angles and the ratios of the scales are untouched, and so are residuals over field: nothing in a
 * calibration can reveal the error. Calibrated in g (field 1) there is none.
 */
#ifndef INVCAL_GRAVITY_H
#define INVCAL_GRAVITY_H

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What normal gravity does not know, m/s^2: the masses near the place. The root mean square of
 * free-air anomalies over the Earth is 35 mGal (1201 mGal^2, Heiskanen and Moritz, section 7-3) to
 * 42 mGal (1795 mGal^2 at a point, Tscherning and Rapp 1974), 1 mGal = 1e-5 m/s^2; 100 and more
 * are met in high mountains. This is 50 mGal, 51 millionths of g, as people live on land.
 *
 * Small beside it are the tides (0.2 mGal), and up to 100 m between height above the sea and above
 * the ellipsoid (31 mGal, part of the anomaly if h is counted from the sea). Not small is a degree
 * of latitude, 90 mGal at 45 degrees: state a tenth of it. */
#define INVCAL_GRAVITY_SIGMA INVCAL_REAL(5e-4)

#define INVCAL_GRAVITY_LOWEST INVCAL_REAL(-500.0)   /* height, metres */
#define INVCAL_GRAVITY_HIGHEST INVCAL_REAL(10000.0) /* likewise */

/* Normal gravity.
 *
 * latitude  geodetic, degrees, north positive, -90 ... 90.
 * height    metres above sea level or above the ellipsoid, INVCAL_GRAVITY_LOWEST ...
 *           INVCAL_GRAVITY_HIGHEST.
 * gravity   out: m/s^2.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING beyond these ranges, for NaN too.
 * Error against the field of the ellipsoid: 1e-9 m/s^2 at height 0 and 1.4e-10 for each metre, in
 * double; 2e-6 in float, 1/250 of INVCAL_GRAVITY_SIGMA.
 * Cost: a sine, a square root, a division. */
invcal_status invcal_gravity(invcal_real latitude, invcal_real height, invcal_real *gravity);

#ifdef __cplusplus
}
#endif

#endif
