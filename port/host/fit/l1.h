/* SPDX-License-Identifier: MIT
 *
 * fit/l1.h: the nine parameters with the least sum of absolute residuals, a cross-check of least squares.
 *
 * One wrong position draws a least squares fit as far as it is wrong; the sum of absolute values counts only on
 * which side it is. So the l1 estimate of all positions, and least squares without outliers, agree if the
 * right ones were left out. Of normal noise its sigma is sqrt(pi/2) = 1.25 times that of least squares, and the
 * difference of the two has sqrt(pi/2 - 1) = 0.76 of that, with many positions. A wrong position moves it, however
 * wrong, by sqrt(pi/2) sigma_r sqrt(leverage) at most.
 */
#ifndef L1_H
#define L1_H

#include "fit/fit.h"

#define L1_DIFFERENCE 0.7555 /* sqrt(pi/2 - 1) */
#define L1_PULL 1.2533       /* sqrt(pi/2): of a wrong position */

/* Minimises sum |J + h(u) p| of the exact rows (invcal/expert.h), by least squares with weights 1/|residual|
 * two hundred times: the sum is the least to a thousandth of itself. Readings that are none of the field are passed
 * over.
 *
 * x  delta, dk, gamma against nominal.
 *
 * Returns as invcal_solve; x is untouched unless INVCAL_OK. */
invcal_status l1_fit(const double *raw, unsigned count, const invcal_calibration *nominal,
                     double x[INVCAL_PARAMETERS]);

#endif
