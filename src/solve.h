/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of invcal_solve, for those who do something between them.
 */
#ifndef INVCAL_SOLVE_H
#define INVCAL_SOLVE_H

#include "invcal/expert.h"

/* calibrated = a (u - delta), u what the nominal calibration makes of a reading. */
typedef struct {
    invcal_real a[3][3];
    invcal_real delta[3];
} invcal_triad;

/* m^-1; an m that is singular gives what is not finite. */
void invcal_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3]);

/* a becomes the symmetric matrix of the same a'a. */
void invcal_make_symmetric(invcal_real a[3][3]);

/* INVCAL_BAD_NOMINAL if the calibration is singular, not finite, or absurdly scaled. */
invcal_status invcal_nominal_check(const invcal_calibration *nominal);

/* The coefficients p of an ellipsoid to its centre and axes. INVCAL_NOT_ELLIPSOID if it is none, or
 * its semi-axes or its centre are beyond ten times those of a perfect triad. */
invcal_status invcal_triad_of(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *triad);

/* The triad behind the nominal calibration, as one calibration. */
void invcal_triad_join(const invcal_triad *triad, const invcal_calibration *nominal,
                       invcal_calibration *out);

#endif
