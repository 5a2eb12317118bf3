/* SPDX-License-Identifier: MIT
 *
 * Accepts or refuses a calibration as nominal. Every solver checks its result in the same way
 * (invcali_compose), so each result may be stored, or be the nominal of the next calibration.
 */
#include "invcal/positions.h"
#include "solve.h"
#include "vector.h"

/* Within these limits a product of three scales (1e-30 ... 1e30) and the square of a zero (1e36)
 * stay in the range of float. */
#define SMALLEST INVCAL_REAL(1e-10)     /* over field per count; the largest is its inverse */
#define FARTHEST_ZERO INVCAL_REAL(1e18) /* zero, over field */

/* Singular to within rounding: the determinant is below 16 epsilon times the product of the lengths
 * of the rows. */
invcal_status invcali_nominal_check(const invcal_calibration *nominal)
{
    invcal_real cofactor[3][3];
    invcal_real of_rows = 16 * INVCAL_EPSILON;

    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real scale = INVCAL_SQRT(invcali_dot3(nominal->matrix[i], nominal->matrix[i]));
        if (!(scale >= SMALLEST && scale <= 1 / SMALLEST &&
              INVCAL_FABS(nominal->offset[i]) * scale <= FARTHEST_ZERO)) {
            return INVCAL_BAD_NOMINAL;
        }
        of_rows *= scale;
    }
    const invcal_real det = invcali_cofactors(nominal->matrix, cofactor);
    return INVCAL_FABS(det) > of_rows ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_nominal(const invcal_real zero[3], const invcal_real counts[3],
                             invcal_calibration *out)
{
    invcal_calibration nominal;

    INVCAL_ASSERT(zero && counts && out);
    invcali_zero(&nominal, sizeof nominal);
    memcpy(nominal.offset, zero, sizeof nominal.offset);
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        nominal.matrix[i][i] = 1 / counts[i];
    }
    const invcal_status status = invcali_nominal_check(&nominal);
    if (status == INVCAL_OK) {
        *out = nominal;
    }
    return status;
}
