/* SPDX-License-Identifier: MIT
 *
 * Internal: what the evaluation and the fit of a calibration over temperature share.
 */
#ifndef INVCAL_POLYNOMIALS_H
#define INVCAL_POLYNOMIALS_H

#include "invcal/thermal.h"
#include "../core/solve.h"

enum { INVCAL_ROWS = 3 }; /* of the coefficients of a calibration, those above the degree 0 */

/* Nine polynomials of t: c has degree + 1 rows of nine coefficients. */
void invcali_polynomials(const invcal_real *c, unsigned degree, invcal_real t,
                         invcal_real out[INVCAL_PARAMETERS]);

static inline invcal_real invcali_thermal_scaled(const invcal_thermal *thermal,
                                                 invcal_real temperature)
{
    return (temperature - thermal->reference) / thermal->span;
}

/* The calibration of u at any t: A = (I + S)^-1. INVCAL_NOT_ELLIPSOID if a semi-axis is more than
 * ten times that of a perfect triad. */
invcal_status invcali_thermal_triad(const invcal_thermal *thermal, invcal_real t,
                                    invcal_calibration *triad);

/* t of a temperature, or of the end of the range seen if it is outside. INVCAL_BAD_TEMPERATURE if
 * it is not finite. */
invcal_status invcali_thermal_find(const invcal_thermal *thermal, invcal_real temperature,
                                   invcal_real *t, invcal_thermal_place *place);

#endif
