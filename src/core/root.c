/* SPDX-License-Identifier: MIT
 *
 * The square root of a float without an FPU, with the bits of libm's: digit by digit, in integers.
 * See vector.h.
 */
#include "vector.h"

float invcali_root(float x)
{
    const uint32_t sign = UINT32_C(0x80000000);
    const uint32_t infinity = UINT32_C(0x7F800000);
    const uint32_t hidden = UINT32_C(0x00800000); /* leading bit of a mantissa; 1 of the exponent */
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    if ((bits & ~sign) == 0 || bits == infinity) {
        return x;
    }
    if (bits > infinity) { /* negative, or a NaN */
        bits = UINT32_MAX;
    } else {
        uint32_t exponent = 125; /* half of the bias, twice, less that of the hidden bit */
        uint32_t root = 0;
        for (; bits < hidden; bits <<= 1) { /* at most 23 steps, of a subnormal */
            exponent--;
        }
        exponent += bits >> 23;
        uint32_t rest = (bits << 8 | sign) >> (7 - exponent % 2);
        /* at most 25 digits, the last one to round */
        for (uint32_t bit = 2 * hidden; bit > 0; bit >>= 1) {
            const uint32_t least = 2 * root + bit;
            if (rest >= least) {
                rest -= least;
                root += bit;
            }
            rest <<= 1;
        }
        bits = (exponent >> 1 << 23) + ((root + 1) >> 1); /* a root is never half-way */
    }
    memcpy(&x, &bits, sizeof x);
    return x;
}
