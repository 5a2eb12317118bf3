/* SPDX-License-Identifier: MIT
 *
 * The calibration at a temperature: X(t) is a polynomial, and A = (I + S)^-1 follows from it in
 * closed form (mathematics.md, "Temperature"). A itself is not interpolated: it is X that is linear
 * in temperature.
 */
#include "polynomials.h"

#include <stddef.h>

#include "../core/vector.h"

/* Horner's rule. */
void invcali_polynomials(const invcal_real *c, unsigned degree, invcal_real t,
                         invcal_real out[INVCAL_PARAMETERS])
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        invcal_real x = 0;
        for (unsigned a = degree + 1; a-- > 0;) {
            x = c[a * INVCAL_PARAMETERS + r] + t * x;
        }
        out[r] = x;
    }
}

invcal_status invcali_thermal_triad(const invcal_thermal *thermal, invcal_real t,
                                    invcal_calibration *triad)
{
    invcal_real x[INVCAL_PARAMETERS];

    invcali_polynomials(&thermal->x[0][0], INVCAL_ROWS - 1, t, x);
    return invcali_triad(x, triad);
}

invcal_status invcali_thermal_find(const invcal_thermal *thermal, invcal_real temperature,
                                   invcal_real *t, invcal_thermal_place *place)
{
    if (!invcali_is_finite(temperature)) {
        return INVCAL_BAD_TEMPERATURE;
    }
    *place = INVCAL_THERMAL_WITHIN;
    if (!(temperature >= thermal->min)) {
        temperature = thermal->min;
        *place = INVCAL_THERMAL_BELOW;
    } else if (!(temperature <= thermal->max)) {
        temperature = thermal->max;
        *place = INVCAL_THERMAL_ABOVE;
    } /* cppcheck-suppress misra-c2012-15.7 ; it is within */
    *t = invcali_thermal_scaled(thermal, temperature);
    return INVCAL_OK;
}

invcal_status invcal_thermal_at(const invcal_thermal *thermal, invcal_real temperature,
                                invcal_calibration *out, invcal_thermal_place *place)
{
    invcal_thermal_place where;
    invcal_calibration c;
    invcal_real t;

    INVCAL_ASSERT(thermal && out);
    invcal_status status = invcali_thermal_find(thermal, temperature, &t, &where);
    if (status == INVCAL_OK) {
        status = invcali_thermal_triad(thermal, t, &c);
    }
    if (status == INVCAL_OK) {
        status = invcali_compose(&thermal->nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c;
        if (place != NULL) {
            *place = where;
        }
    }
    return status;
}
