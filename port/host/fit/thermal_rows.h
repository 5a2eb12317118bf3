/* SPDX-License-Identifier: MIT
 *
 * fit/thermal_rows.h: the linear equations of a thermal calibration, in calibrated units, which the
 * library does not expose.
 */
#ifndef THERMAL_ROWS_H
#define THERMAL_ROWS_H

#include "invcal/thermal.h"
#include "fit/rejection.h"
#include "core/system.h"

#define THERMAL_COEFFICIENTS (3 * INVCAL_PARAMETERS) /* of a parabola */
#define THERMAL_PACKED INVCAL_PACKED_SIZE(THERMAL_COEFFICIENTS)

/* The row of a reading. */
typedef struct {
    double h[THERMAL_COEFFICIENTS]; /* h (x) (1 t t^2): 9 (fitted + 1) numbers */
    double residual;                /* |calibrated| - 1 */
    double weight;                  /* by its noise, see fit_weight */
} thermal_row;

/* The row of a reading. Returns 1; 0 if it cannot be of this field. */
int thermal_rows_one(const invcal_thermal *c, const double raw[3], double temperature,
                     thermal_row *out);

/* The number of fitted coefficients. */
unsigned thermal_rows_unknowns(const invcal_thermal *c);

/* L^-1 of H'H of all kept positions, packed. Returns 1; 0 if it is singular. */
int thermal_rows_inverse(const invcal_thermal *c, const rejection *kept,
                         double inverse[THERMAL_PACKED]);

/* |L^-1 h|^2. */
double thermal_rows_leverage(const double *inverse, unsigned n, const double *h);

/* (H'WH + prior)^-1 of all kept positions, packed: the covariance of the coefficients in calibrated
 * units over noise^2. Returns 1; 0 if it is singular. */
int thermal_rows_covariance(const invcal_thermal *c, const rejection *kept,
                            const invcal_thermal_prior *prior, double noise,
                            double covariance[THERMAL_PACKED]);

#endif
