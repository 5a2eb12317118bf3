/* SPDX-License-Identifier: MIT
 *
 * calibrated = matrix (raw - offset): mathematics.md, "From p to the calibration". The offset is
 * subtracted before the product: matrix raw - matrix offset would cancel in float.
 *
 * Every program links this module, even one that only loads a calibration. So it calls no other,
 * and invcali_dot is here.
 */
#include "invcal/invcal.h"
#include "vector.h"

#if !INVCAL_FAST
invcal_real invcali_dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    return invcali_dot_inline(a, b, n);
}
#endif

#if !INVCAL_FAST
void invcali_correct(const invcal_calibration *c, const invcal_real raw[3], invcal_real out[3])
{
    invcali_correct_inline(c, raw, out);
}
#endif

void invcal_apply(const invcal_calibration *calibration, invcal_real x, invcal_real y,
                  invcal_real z, invcal_real calibrated[3])
{
    const invcal_real raw[3] = {x, y, z};

    INVCAL_ASSERT(calibration && calibrated);
    invcali_correct(calibration, raw, calibrated);
}

invcal_status invcal_scale(invcal_calibration *calibration, invcal_real field)
{
    INVCAL_ASSERT(calibration);
    if (!invcali_is_positive(field)) {
        return INVCAL_BAD_FIELD;
    }
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        INVCAL_ROLL
        for (unsigned j = 0; j < 3; j++) {
            calibration->matrix[i][j] *= field;
        }
    }
    return INVCAL_OK;
}
