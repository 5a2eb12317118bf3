/* SPDX-License-Identifier: MIT */
#include "invcal/observation.h"

#include <string.h>

#include "row.h"
#include "vector.h"

void invcal_row(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS])
{
    h[INVCAL_DELTA_X] = a[0];
    h[INVCAL_DELTA_Y] = a[1];
    h[INVCAL_DELTA_Z] = a[2];
    h[INVCAL_DK_X] = a[0] * a[0];
    h[INVCAL_DK_Y] = a[1] * a[1];
    h[INVCAL_DK_Z] = a[2] * a[2];
    h[INVCAL_GAMMA_XY] = a[0] * a[1];
    h[INVCAL_GAMMA_XZ] = a[0] * a[2];
    h[INVCAL_GAMMA_ZY] = a[1] * a[2];
}

/* Readings far from unit length are no readings of this field. */
static invcal_status check_reading(const invcal_real u[3], invcal_real square)
{
    if (square >= INVCAL_REAL(0.01) && square <= INVCAL_REAL(100.0)) {
        return INVCAL_OK;
    }
    return invcal_are_finite(u) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
}

static invcal_status check_vertical(const invcal_real vertical[3])
{
    const invcal_real excess = invcal_dot3(vertical, vertical) - 1; /* twice that of the length */

    return INVCAL_FABS(excess) <= INVCAL_REAL(2e-4) ? INVCAL_OK : INVCAL_NOT_UNIT;
}

/* u = nominal(raw) / field, whatever the result is. */
static invcal_status scale(const invcal_calibration *nominal, invcal_real field,
                           const invcal_real raw[3], invcal_real u[3])
{
    if (!invcal_is_positive(field)) {
        return INVCAL_BAD_SETTING;
    }
    invcal_apply(nominal, raw, u);
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        u[i] /= field;
    }
    return INVCAL_OK;
}

invcal_status invcal_observation_reading(const invcal_calibration *nominal, invcal_real field,
                                         const invcal_real raw[3], invcal_real u[3])
{
    invcal_real v[3];

    INVCAL_ASSERT(nominal && raw && u);
    const invcal_status status = scale(nominal, field, raw, v);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!invcal_are_finite(v)) {
        return INVCAL_NOT_FINITE;
    }
    memcpy(u, v, sizeof v);
    return INVCAL_OK;
}

static inline invcal_status exact(const invcal_real u[3], invcal_observation *out)
{
    const invcal_real square = invcal_dot3(u, u);
    const invcal_status status = check_reading(u, square);

    if (status == INVCAL_OK) {
        invcal_row(u, out->h);
        out->j = (square - 1) / 2;
        out->model = INVCAL_MODEL_ELLIPSOID;
    }
    return status;
}

invcal_status invcal_observation_exact(const invcal_real u[3], invcal_observation *out)
{
    INVCAL_ASSERT(u && out);
    return exact(u, out);
}

invcal_status invcal_observe(const invcal_calibration *nominal, invcal_real field,
                             const invcal_real raw[3], invcal_observation *out)
{
    invcal_real u[3];

    INVCAL_ASSERT(nominal && raw && out);
    const invcal_status status = scale(nominal, field, raw, u);
    return status == INVCAL_OK ? exact(u, out) : status;
}

/* The row of a known direction, which J1 and J2 share. */
static invcal_status linear(const invcal_real u[3], const invcal_real vertical[3], invcal_real j,
                            invcal_observation *out)
{
    invcal_status status = check_reading(u, invcal_dot3(u, u));

    if (status == INVCAL_OK) {
        status = check_vertical(vertical);
    }
    if (status == INVCAL_OK) {
        invcal_row(vertical, out->h);
        out->j = j;
        out->model = INVCAL_MODEL_LINEAR;
    }
    return status;
}

invcal_status invcal_observation_first_order(const invcal_real u[3], const invcal_real vertical[3],
                                             invcal_observation *out)
{
    INVCAL_ASSERT(u && vertical && out);
    return linear(u, vertical, (invcal_dot3(u, u) - 1) / 2, out);
}

invcal_status invcal_observation_vertical(const invcal_real u[3], const invcal_real vertical[3],
                                          invcal_observation *out)
{
    INVCAL_ASSERT(u && vertical && out);
    return linear(u, vertical, invcal_dot3(u, vertical) - 1, out);
}
