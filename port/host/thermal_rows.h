/* SPDX-License-Identifier: MIT
 *
 * thermal_rows.h: the equations of a thermal calibration one by one, in calibrated units: what the
 * library keeps as sums only.
 */
#ifndef THERMAL_ROWS_H
#define THERMAL_ROWS_H

#include "invcal/thermal.h"
#include "rejection.h"

/* The row h (x) (1 t t^2) of a reading, 9 (fitted + 1) numbers, and its residual |calibrated| /
 * field - 1. Returns 1; 0 if it is no reading of this field. */
int thermal_row(const invcal_thermal_calibration *c, const double raw[3], double temperature,
                double *row, double *residual);

/* L of the normal equations of all positions kept, packed. `thermal` null: without any prior.
 * Returns 1; 0 if they are singular. */
int thermal_rows_factor(const invcal_thermal_calibration *c, const rejection *kept,
                        const invcal_settings *settings, const invcal_thermal_settings *thermal,
                        double noise, double *l);

#endif
