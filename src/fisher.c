/* SPDX-License-Identifier: MIT */
#include "fisher.h"

#include "vector.h"

#define HALF INVCAL_REAL(0.5)
#define PI INVCAL_REAL(3.14159265358979324)

/* I_x(a, b) = x^a (1 - x)^b / B(a, b) times 1/a sum over j >= 0 of x^j (a + b)_j / (a + 1)_j,
 * Pochhammer's symbols. The factor from a and b of 1/2 or 1, where B is pi, 2 or 1, step by step:
 * B(a + 1, b) = B(a, b) a / (a + b). The sum ends, as its terms at last fall like x^j. */
static invcal_real incomplete_beta(invcal_real x, unsigned twice_a, unsigned twice_b)
{
    invcal_real a = twice_a % 2 ? HALF : 1;
    invcal_real b = twice_b % 2 ? HALF : 1;
    invcal_real term = a + b > 1 ? a * b : 1 / PI;
    invcal_real sum = 0;

    term *= twice_a % 2 ? INVCAL_SQRT(x) : x;
    term *= twice_b % 2 ? INVCAL_SQRT(1 - x) : 1 - x;
    for (unsigned i = 2; i < twice_a; i += 2) {
        term *= x * (a + b) / a;
        a++;
    }
    for (unsigned i = 2; i < twice_b; i += 2) {
        term *= (1 - x) * (a + b) / b;
        b++;
    }
    term /= a;
    /* at most 15 of the larger + 20 steps, with double 35 of it + 50 */
    while (term > INVCAL_EPSILON / 16 * sum) {
        sum += term;
        term *= x * (a + b) / (a + 1);
        a++;
    }
    return sum;
}

/* Beyond the mean the complement converges faster, and the subtraction costs little. */
invcal_real invcal_fisher_tail(invcal_real z, unsigned m, unsigned dof)
{
    INVCAL_ASSERT(m >= 1 && dof >= 1);
    if (!(z < 1)) {
        return 1;
    }
    if (!(z > 0)) {
        return 0;
    }
    return z * (invcal_real)(dof + m) < (invcal_real)dof ? incomplete_beta(z, dof, m)
                                                         : 1 - incomplete_beta(1 - z, m, dof);
}
