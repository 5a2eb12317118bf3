/* SPDX-License-Identifier: MIT */
#include "invcal/invcal.h"
#include "vector.h"

void invcal_apply(const invcal_calibration *calibration, const invcal_real raw[3],
                  invcal_real calibrated[3])
{
    const invcal_real x = raw[0] - calibration->offset[0];
    const invcal_real y = raw[1] - calibration->offset[1];
    const invcal_real z = raw[2] - calibration->offset[2];

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *row = calibration->matrix[i];
        calibrated[i] = row[0] * x + row[1] * y + row[2] * z;
    }
}

void invcal_apply_counts(const invcal_calibration *calibration, const int32_t raw[3],
                         invcal_real calibrated[3])
{
    const invcal_real counts[3] = {(invcal_real)raw[0], (invcal_real)raw[1], (invcal_real)raw[2]};

    invcal_apply(calibration, counts, calibrated);
}

invcal_status invcal_scale(invcal_calibration *calibration, invcal_real field)
{
    INVCAL_ASSERT(calibration);
    if (!invcal_is_positive(field)) {
        return INVCAL_BAD_FIELD;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            calibration->matrix[i][j] *= field;
        }
    }
    return INVCAL_OK;
}
