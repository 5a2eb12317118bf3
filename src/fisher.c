/* SPDX-License-Identifier: MIT */
#include "fisher.h"

#include "vector.h"

#define HALF INVCAL_REAL(0.5)
#define PI INVCAL_REAL(3.14159265358979324)

/* x^(twice/2) */
static invcal_real half_power(invcal_real x, unsigned twice)
{
    invcal_real power = twice % 2 ? INVCAL_SQRT(x) : 1;

    for (unsigned i = 0; i < twice / 2; i++) {
        power *= x;
    }
    return power;
}

/* B(dof/2, 1/2), from B(1/2, 1/2) = pi or B(1, 1/2) = 2 by B(a + 1, b) = B(a, b) a / (a + b). */
static invcal_real beta_half(unsigned dof)
{
    invcal_real beta = dof % 2 ? PI : 2;

    for (unsigned k = dof % 2 ? 1 : 2; k < dof; k += 2) {
        beta *= (invcal_real)k / (invcal_real)(k + 1);
    }
    return beta;
}

/* 1/a sum over j >= 0 of x^j (a + b)_j / (a + 1)_j, Pochhammer's symbols: I_x(a, b) without its
 * factor x^a (1 - x)^b / B(a, b). Ends, as the terms at last fall like x^j. */
static invcal_real series(invcal_real x, invcal_real a, invcal_real b)
{
    invcal_real term = 1 / a;
    invcal_real sum = 0;
    invcal_real j = 0;

    /* at most 15 dof + 20 steps, with double 35 dof + 50 */
    while (term > INVCAL_EPSILON / 16 * sum) {
        sum += term;
        term *= x * (a + b + j) / (a + 1 + j);
        j++;
    }
    return sum;
}

/* I_z(a, 1/2), edge = z^a (1 - z)^1/2 / B(a, 1/2). Below f = 1, above 0.3 that is, the complement
 * converges faster, and the subtraction costs little. */
static invcal_real tail_of_one(invcal_real z, invcal_real a, invcal_real edge)
{
    return z * (a + HALF) < a ? edge * series(z, a, HALF) : 1 - edge * series(1 - z, HALF, a);
}

/* I_z(a, b + 1) = I_z(a, b) + z^a (1 - z)^b / (b B(a, b)): from b = 1/2, or from b = 0, where
 * I is 0 and b B(a, b) is 1, up to m/2. */
invcal_real invcal_fisher_tail(invcal_real z, unsigned m, unsigned dof)
{
    INVCAL_ASSERT(m >= 1 && dof >= 1);
    if (!(z < 1)) {
        return 1;
    }
    if (!(z > 0)) {
        return 0;
    }
    const invcal_real a = (invcal_real)dof / 2;
    invcal_real b = 0;
    invcal_real sum = 0;
    invcal_real term = half_power(z, dof);
    if (m % 2) {
        const invcal_real edge = term * INVCAL_SQRT(1 - z) / beta_half(dof);
        b = HALF;
        sum = tail_of_one(z, a, edge);
        term = 2 * edge;
    }
    for (unsigned step = 0; step < m / 2; step++) {
        sum += term;
        term *= (1 - z) * (a + b) / (b + 1);
        b++;
    }
    return sum < 1 ? sum : 1;
}
