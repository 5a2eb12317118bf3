/* SPDX-License-Identifier: MIT
 *
 * Applies the result to samples of the gyroscope.
 */
#include "invcal/gyro.h"
#include "../core/vector.h"

/* slope is that of the bias, so of the nominal rate, before M: M slope a = (matrix of the result)
 * (matrix of nominal)^-1 slope a is not known here, but differs by the scale error only, of a term
 * that is small itself. */
void invcal_imu_apply(const invcal_imu_result *result, invcal_real x, invcal_real y, invcal_real z,
                      const invcal_real acceleration[3], invcal_real rate[3])
{
    INVCAL_ASSERT(result && acceleration && rate);
    invcal_apply(&result->gyro, x, y, z, rate);
    if (result->g_is_used) {
        INVCAL_UNROLL
        for (unsigned i = 0; i < 3; i++) {
            rate[i] -= invcali_dot3(result->slope[i], acceleration);
        }
    }
}
