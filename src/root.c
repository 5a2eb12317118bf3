/* SPDX-License-Identifier: MIT
 *
 * The square root of a float without an FPU, with the bits of libm's: digit by digit, in integers.
 * See vector.h.
 */
#include "vector.h"

#define SIGN UINT32_C(0x80000000)
#define INFINITE UINT32_C(0x7F800000)
#define HIDDEN UINT32_C(0x00800000) /* the leading bit of a mantissa, and 1 of the exponent */
#define FIRST UINT32_C(0x01000000)  /* of 25 bits of the root, the last of which rounds */
#define NOT_A_NUMBER UINT32_C(0xFFC00000)

float invcal_root(float x)
{
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    if ((bits & ~SIGN) == 0 || bits == INFINITE) {
        return x;
    }
    if (bits > INFINITE) { /* negative, or a NaN */
        bits = NOT_A_NUMBER;
    } else {
        uint32_t exponent = 125; /* half of the bias, twice, less that of the hidden bit */
        uint32_t root = 0;
        for (; bits < HIDDEN; bits <<= 1) { /* at most 23 steps, of a subnormal */
            exponent--;
        }
        exponent += bits >> 23;
        uint32_t rest = (bits << 8 | SIGN) >> (7 - exponent % 2);
        for (uint32_t bit = FIRST; bit > 0; bit >>= 1) { /* 25 steps */
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
