/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "solve.h"
#include "vector.h"

#define SMALLEST INVCAL_REAL(1e-12) /* over field per count; the largest is its inverse */
#define FARTHEST INVCAL_REAL(1e18)  /* zero, over field */

static invcal_real largest(const invcal_real v[3])
{
    invcal_real most = 0;

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real size = INVCAL_FABS(v[i]);
        most = size <= most ? most : size; /* a NaN stays */
    }
    return most;
}

/* Singular to rounding is a determinant that its rows, made of length 1 to 1.7, do not show. */
invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    invcal_calibration unit;
    invcal_real cofactor[3][3];

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real scale = largest(nominal->matrix[i]);
        if (!(scale >= SMALLEST && scale <= 1 / SMALLEST &&
              INVCAL_FABS(nominal->offset[i]) * scale <= FARTHEST)) {
            return INVCAL_BAD_NOMINAL;
        }
        for (unsigned j = 0; j < 3; j++) {
            unit.matrix[i][j] = nominal->matrix[i][j] / scale;
        }
    }
    const invcal_real det = invcal_cofactors((const invcal_real(*)[3])unit.matrix, cofactor);
    return INVCAL_FABS(det) > 16 * INVCAL_EPSILON ? INVCAL_OK : INVCAL_BAD_NOMINAL;
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
