/* SPDX-License-Identifier: MIT
 *
 * Internal: how often chance alone makes one sum of squares so small beside another.
 */
#ifndef INVCAL_FISHER_H
#define INVCAL_FISHER_H

#include "invcal/invcal.h"

/* The tail of Fisher's F: P(F > f), with m and dof degrees of freedom.
 *
 * z    1 / (1 + f m / dof). When m unknowns more lower the sum of the squared residuals from S
 *      to s and leave dof residuals, that is z = s / S: no division by s, which may be 0.
 * m    degrees of freedom of what is tested, >= 1.
 * dof  degrees of freedom of what it is tested against, >= 1.
 *
 * It is the regularised incomplete beta function I_z(dof/2, m/2), by series whose terms are all
 * positive, so that small probabilities are as exact as large ones. 0 for z <= 0; 1 for z >= 1
 * and for a NaN, which is never significant.
 *
 * Relative error for m up to 31 and dof up to 59: 3e-6 (float, results above 1e-20), 1e-12
 * (double).
 * Cost: (m + dof)/2 steps, and up to 15 of the larger + 20 (double: 35 of it + 50), most of them where
 * the answer is about 0.3. Stack: 56 bytes. */
invcal_real invcal_fisher_tail(invcal_real z, unsigned m, unsigned dof);

#endif
