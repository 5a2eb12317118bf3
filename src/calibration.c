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
    const invcal_real centred[3] = {raw[0] - calibration->offset[0],
                                    raw[1] - calibration->offset[1],
                                    raw[2] - calibration->offset[2]};

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        calibrated[i] = invcal_dot3(calibration->matrix[i], centred);
    }
}

static void cross(const invcal_real a[3], const invcal_real b[3], invcal_real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static invcal_real largest(const invcal_real v[3])
{
    invcal_real most = 0;

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real size = INVCAL_FABS(v[i]);
        most = size <= most ? most : size; /* a NaN stays */
    }
    return most;
}

/* column / det / scale; 0 if an element is not finite. */
static int divide(invcal_real column[3][3], invcal_real det, const invcal_real scale[3])
{
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            column[i][j] = column[i][j] / det / scale[i];
            if (!invcal_is_finite(column[i][j])) {
                return 0;
            }
        }
    }
    return 1;
}

/* Rows R_i = s_i r_i with largest elements s_i: the columns of the inverse are the cross products
 * of the other two r over their determinant and s_i. In any unit, nothing over- or underflows. */
invcal_status invcal_calibration_inverse(const invcal_calibration *calibration,
                                         invcal_real inverse[3][3])
{
    invcal_real scale[3];
    invcal_real row[3][3];
    invcal_real column[3][3];

    INVCAL_ASSERT(calibration && inverse);
    for (unsigned i = 0; i < 3; i++) {
        scale[i] = largest(calibration->matrix[i]);
        for (unsigned j = 0; j < 3; j++) {
            row[i][j] = calibration->matrix[i][j] / scale[i];
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        cross(row[(i + 1) % 3], row[(i + 2) % 3], column[i]);
    }
    const invcal_real det = invcal_dot3(row[0], column[0]);
    /* the determinant is that of rows of length 1 to 1.7 */
    if (!(INVCAL_FABS(det) > 16 * INVCAL_EPSILON) || !divide(column, det, scale)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            inverse[j][i] = column[i][j];
        }
    }
    return INVCAL_OK;
}
