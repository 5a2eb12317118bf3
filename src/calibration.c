/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <string.h>

#include "vector.h"

#define SMALLEST INVCAL_REAL(1e-12) /* over field per count; the largest is its inverse */
#define FARTHEST INVCAL_REAL(1e18)  /* zero, over field */

void invcal_apply(const invcal_calibration *calibration, const invcal_real raw[3],
                  invcal_real calibrated[3])
{
    invcal_correct(calibration, raw, calibrated);
}

void invcal_apply_counts(const invcal_calibration *calibration, const int32_t raw[3],
                         invcal_real calibrated[3])
{
    const invcal_real counts[3] = {(invcal_real)raw[0], (invcal_real)raw[1], (invcal_real)raw[2]};

    invcal_correct(calibration, counts, calibrated);
}

/* Singular to rounding is a determinant that the sizes of its rows do not show. */
invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    invcal_real cofactor[3][3];
    invcal_real volume = 1;

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *row = nominal->matrix[i];
        const invcal_real size = INVCAL_FABS(row[0]) + INVCAL_FABS(row[1]) + INVCAL_FABS(row[2]);
        if (!(size >= SMALLEST && size <= 1 / SMALLEST &&
              INVCAL_FABS(nominal->offset[i]) * size <= FARTHEST)) {
            return INVCAL_BAD_NOMINAL;
        }
        volume *= size;
    }
    const invcal_real det = invcal_cofactors(nominal->matrix, cofactor);
    return INVCAL_FABS(det) > 16 * INVCAL_EPSILON * volume ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_nominal(const invcal_real zero[3], const invcal_real counts[3],
                             invcal_calibration *out)
{
    invcal_calibration nominal;

    INVCAL_ASSERT(zero && counts && out);
    memset(&nominal, 0, sizeof nominal);
    for (unsigned i = 0; i < 3; i++) {
        nominal.offset[i] = zero[i];
        nominal.matrix[i][i] = 1 / counts[i];
    }
    const invcal_status status = invcal_nominal_check(&nominal);
    if (status == INVCAL_OK) {
        *out = nominal;
    }
    return status;
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
