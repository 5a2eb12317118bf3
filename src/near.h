/* SPDX-License-Identifier: MIT
 *
 * Internal: symmetric 3x3 matrices near I, kept packed (INVCAL_PACKED) as their deviation E from
 * it: the ones would cost a float three of its seven digits.
 */
#ifndef INVCAL_NEAR_H
#define INVCAL_NEAR_H

#include "invcal/config.h"

/* out = (I + E)^-1 - I, for an I + E that is positive or negative definite. Any other gives what
 * may be far from it, or not finite. */
void invcal_near_inverse(const invcal_real e[6], invcal_real out[6]);

/* root = (I + E)^1/2 - I, inverse = (I + E)^-1/2 - I. Converges for every positive definite
 * matrix, with each step twice as many digits; ends after 12 steps, enough for eigenvalues from
 * 0.01 to 100. Relative error: within 30 INVCAL_EPSILON times the condition of I + E. */
/* NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name): there Y and Z of its source */
void invcal_near_root(const invcal_real e[6], invcal_real root[6], invcal_real inverse[6]);

/* Are all eigenvalues of I + E above low, and below high? Told to 10 INVCAL_EPSILON of the largest,
 * or of 1. Not if there is a NaN. */
int invcal_near_is_between(const invcal_real e[6], invcal_real low, invcal_real high);

/* y = (I + E) x */
static inline void invcal_near_multiply(const invcal_real e[6], const invcal_real x[3],
                                        invcal_real y[3])
{
    y[0] = x[0] + (e[0] * x[0] + e[1] * x[1] + e[3] * x[2]);
    y[1] = x[1] + (e[1] * x[0] + e[2] * x[1] + e[4] * x[2]);
    y[2] = x[2] + (e[3] * x[0] + e[4] * x[1] + e[5] * x[2]);
}

#endif
