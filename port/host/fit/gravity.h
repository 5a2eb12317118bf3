/* SPDX-License-Identifier: MIT
 *
 * fit/gravity.h: the length of the field at a place on Earth.
 *
 * Normal gravity is that of the ellipsoid WGS 84 (NIMA TR8350.2, third edition, equations 4-1 and
 * 4-3; the second is the free-air term to second order in h, Heiskanen and Moritz, Physical
 * Geodesy, equation 2-123), phi the geodetic latitude, h the height:
 *
 *     gamma0 = ge (1 + k sin^2 phi) / sqrt(1 - e^2 sin^2 phi)                       (Somigliana)
 *     gamma  = gamma0 (1 - 2 (1 + f + m - 2 f sin^2 phi) h / a + 3 h^2 / a^2)
 *
 * 9.7803253359 m/s^2 at the equator, 9.8061977694 at 45 degrees, 9.8321849379 at the poles; 1 m of
 * height takes 3.086e-6.
 *
 * An error of g affects the scale only, and equally on all axes: with g' instead of g, the matrix
 * and every calibrated reading are multiplied by g' / g. Offsets, angles and the ratios of the
 * scales do not change, nor do the residuals, so that nothing in a calibration can reveal the
 * error. A calibration in g has none.
 */
#ifndef GRAVITY_H
#define GRAVITY_H

/* The error of normal gravity, m/s^2, due to the masses in the neighbourhood. The root mean square
 * of free-air anomalies over the Earth is 35 mGal (1201 mGal^2, Heiskanen and Moritz, section 7-3)
 * to 42 mGal (1795 mGal^2 at a point, Tscherning and Rapp 1974), 1 mGal = 1e-5 m/s^2; 100 and more
 * occur in high mountains. This is 50 mGal, 51 millionths of g, as most users are on land.
 *
 * Small compared with it are the tides (0.2 mGal), and up to 100 m between height above the sea and
 * above the ellipsoid (31 mGal, part of the anomaly if h is counted from the sea). Not small is a
 * degree of latitude, 90 mGal at 45 degrees: state a tenth of it. */
#define GRAVITY_SIGMA 5e-4

#define GRAVITY_LOWEST (-500.0) /* height, metres */
#define GRAVITY_HIGHEST 10000.0

/* Normal gravity, m/s^2.
 *
 * latitude  geodetic, degrees, north positive, -90 ... 90.
 * height    metres above sea level or above the ellipsoid, GRAVITY_LOWEST ... GRAVITY_HIGHEST.
 *
 * NaN outside these ranges. Error against the field of the ellipsoid: 1e-9 m/s^2 at height 0 and
 * 1.4e-10 for each metre. */
double gravity_at(double latitude, double height);

#endif
