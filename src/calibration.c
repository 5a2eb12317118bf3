/* SPDX-License-Identifier: MIT */
#include "invcal/calibration.h"

#include <string.h>

#include "vector.h"

invcal_status invcal_calibration_nominal(const invcal_real zero[3], const invcal_real scale[3],
                                         invcal_calibration *out)
{
    INVCAL_ASSERT(zero && scale && out);
    for (unsigned i = 0; i < 3; i++) {
        if (!(invcal_is_finite(zero[i]) && invcal_is_positive(INVCAL_FABS(scale[i])))) {
            return INVCAL_BAD_SETTING;
        }
    }
    memset(out, 0, sizeof *out);
    for (unsigned i = 0; i < 3; i++) {
        out->offset[i] = zero[i];
        out->matrix[i][i] = scale[i];
    }
    return INVCAL_OK;
}

void invcal_apply(const invcal_calibration *calibration, const invcal_real raw[3],
                  invcal_real calibrated[3])
{
    const invcal_real x = raw[0] - calibration->offset[0];
    const invcal_real y = raw[1] - calibration->offset[1];
    const invcal_real z = raw[2] - calibration->offset[2];

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *row = calibration->matrix[i];
        calibrated[i] = row[0] * x + row[1] * y + row[2] * z;
    }
}

static void cross(const invcal_real a[3], const invcal_real b[3], invcal_real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static invcal_real length(const invcal_real a[3])
{
    return INVCAL_SQRT(invcal_dot(a, a, 3));
}

/* The columns of the inverse are the cross products of the rows over the determinant. */
invcal_status invcal_calibration_inverse(const invcal_calibration *calibration,
                                         invcal_real inverse[3][3])
{
    const invcal_real *a = calibration->matrix[0];
    const invcal_real *b = calibration->matrix[1];
    const invcal_real *c = calibration->matrix[2];
    invcal_real column[3][3];

    cross(b, c, column[0]);
    cross(c, a, column[1]);
    cross(a, b, column[2]);
    const invcal_real det = invcal_dot(a, column[0], 3);
    const invcal_real box = length(a) * length(b) * length(c); /* |det| of orthogonal rows */

    if (!(INVCAL_FABS(det) > 16 * INVCAL_EPSILON * box && box <= INVCAL_REAL_MAX)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            inverse[j][i] = column[i][j] / det;
        }
    }
    return INVCAL_OK;
}
