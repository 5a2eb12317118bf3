/* SPDX-License-Identifier: MIT */
#include "design/weights.h"

#include <math.h>

#include "design/covariance.h"

enum { P = INVCAL_PARAMETERS };

#define STEPS_MAX 20000u
#define TOLERANCE 1e-12 /* of the largest d_i / 9 above 1 */
#define NEGLIGIBLE 1e-6

/* A step of the multiplicative algorithm, p_i d_i / 9. Returns the largest d_i / 9, minus 1: det M
 * is within the ninth power of that factor of the maximum. */
static double improve(const double (*direction)[3], unsigned count, double *share)
{
    double K[P][P];
    double max = 0;

    (void)covariance_find(direction, share, count, K);
    for (unsigned i = 0; i < count; i++) {
        double h[P];
        covariance_row(direction[i], h);
        const double factor = covariance_product(K, h, h) * count / (double)P;
        max = fmax(max, factor);
        share[i] *= factor;
    }
    return max - 1;
}

void weights_find(const double (*direction)[3], unsigned count, double *share)
{
    double sum = 0;

    for (unsigned i = 0; i < count; i++) {
        share[i] = 1;
    }
    for (unsigned step = 0; step < STEPS_MAX && improve(direction, count, share) > TOLERANCE;
         step++) {
    }
    for (unsigned i = 0; i < count; i++) {
        share[i] = share[i] > NEGLIGIBLE ? share[i] : 0;
        sum += share[i];
    }
    for (unsigned i = 0; i < count; i++) {
        share[i] *= count / sum;
    }
}

/* Of a spherical 4-design: H'H / n has 1/3 for offsets, 2/15 twice and 1/3 for scale errors, 1/15 for
 * angles. */
double weights_bound(unsigned n)
{
    return 4 * log(n / 3.0) + 2 * log(2.0 * n / 15) + 3 * log(n / 15.0);
}
