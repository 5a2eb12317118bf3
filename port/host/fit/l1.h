/* SPDX-License-Identifier: MIT
 *
 * fit/l1.h: solves for the nine parameters with the least sum of absolute residuals, as a
 * cross-check of least squares.
 *
 * An outlier shifts a least squares fit in proportion to its error; with absolute values only its
 * side matters. So the l1 estimate from all positions agrees with least squares without outliers if
 * the right ones were left out. With normal noise and many positions, its sigma is sqrt(pi/2) =
 * 1.25 times that of least squares, and the sigma of their difference sqrt(pi/2 - 1) = 0.76 times.
 * An outlier, however large, shifts it by at most sqrt(pi/2) sigma_r sqrt(leverage).
 */
#ifndef L1_H
#define L1_H

#include "fit/fit.h"

#define L1_DIFFERENCE 0.7555 /* sqrt(pi/2 - 1) */
#define L1_PULL 1.2533       /* sqrt(pi/2): by an outlier */

/* Minimises sum |J + h(u) p| of the exact rows (invcal/expert.h), by two hundred iterations of
 * least squares with weights 1/|residual|: the sum is within a thousandth of its minimum. Readings
 * that cannot be of this field are skipped.
 *
 * x  delta, dk, gamma against nominal.
 *
 * Returns as invcali_solve; x is untouched unless INVCAL_OK. */
invcal_status l1_fit(const double *raw, unsigned count, const invcal_calibration *nominal,
                     double x[INVCAL_PARAMETERS]);

#endif
