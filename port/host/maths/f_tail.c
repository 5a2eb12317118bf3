/* SPDX-License-Identifier: MIT */
#include "maths/f_tail.h"

#include <float.h>
#include <math.h>

#define TINY 1e-300     /* instead of a zero denominator */
#define TERMS_MAX 10000 /* a few hundred are needed */

/* Coefficient n of the continued fraction of I_x(a, b). */
static double coefficient(unsigned n, double a, double b, double x)
{
    const unsigned half = n / 2;
    const double m = half;

    return n % 2 ? -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))
                 : m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
}

/* I_x(a, b) for x denominator a / (a + b) or so: NIST DLMF 8.17.22, by Lentz's method. */
static double incomplete_beta(double x, double a, double b)
{
    const double factor = exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log1p(-x));
    double c = 1;
    double d = 0;
    double fraction = 1;
    double step = 0;

    for (unsigned n = 1; n < TERMS_MAX && !(fabs(step - 1) <= DBL_EPSILON); n++) {
        const double k = coefficient(n, a, b, x);
        const double denominator = 1 + k * d;
        d = 1 / (fabs(denominator) > TINY ? denominator : TINY);
        c = 1 + k / c;
        c = fabs(c) > TINY ? c : TINY;
        step = c * d;
        fraction *= step;
    }
    return factor / (a * fraction);
}

double f_tail(double z, unsigned m, unsigned dof)
{
    if (!(z < 1)) {
        return 1;
    }
    if (!(z > 0)) {
        return 0;
    }
    /* The smaller tail converges faster, and 1 minus it loses no digits. */
    return z * (dof + m) < dof ? incomplete_beta(z, dof / 2.0, m / 2.0)
                               : 1 - incomplete_beta(1 - z, m / 2.0, dof / 2.0);
}
