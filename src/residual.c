/* SPDX-License-Identifier: MIT */
#include "invcal/residual.h"

#include <string.h>

#include "near.h"
#include "vector.h"

void invcal_residuals_init(invcal_residuals *residuals, const invcal_solution *solution)
{
    invcal_real s[6];

    INVCAL_ASSERT(residuals && solution);
    memset(residuals, 0, sizeof *residuals);
    memcpy(residuals->delta, solution->delta, sizeof residuals->delta);
    invcal_solution_deviation(solution, s);
    invcal_near_inverse(s, residuals->correction);
    /* the trace of A^2: the sum of the squares of all elements */
    const invcal_real *a = residuals->correction;
    const invcal_real squares = (1 + a[0]) * (1 + a[0]) + (1 + a[2]) * (1 + a[2]) +
                                (1 + a[5]) * (1 + a[5]) +
                                2 * (a[1] * a[1] + a[3] * a[3] + a[4] * a[4]);
    residuals->gain = INVCAL_SQRT(squares / 3);
}

/* Noise of u moves the length of eta = A (u - delta) by |A eta| times itself: rows are weighted
 * with the inverse square, relative to the mean over all directions. */
static invcal_real direction_weight(const invcal_residuals *residuals, const invcal_real eta[3])
{
    invcal_real gradient[3];

    invcal_near_multiply(residuals->correction, eta, gradient);
    return residuals->gain * residuals->gain / invcal_dot(gradient, gradient, 3);
}

invcal_status invcal_residuals_add(invcal_residuals *residuals, const invcal_real u[3],
                                   invcal_real weight, invcal_real *residual)
{
    invcal_real centred[3];
    invcal_real eta[3];
    invcal_observation row;

    INVCAL_ASSERT(residuals && u);
    for (unsigned i = 0; i < 3; i++) {
        centred[i] = u[i] - residuals->delta[i];
    }
    invcal_near_multiply(residuals->correction, centred, eta);
    invcal_status status = invcal_observation_exact(eta, &row);
    if (status == INVCAL_OK) {
        status =
            invcal_normal_add(&residuals->normal, &row, weight * direction_weight(residuals, eta));
    }
    if (status != INVCAL_OK) {
        return status;
    }
    /* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
    const invcal_real r = 2 * row.j / (1 + INVCAL_SQRT(invcal_dot(eta, eta, 3)));
    residuals->squares += r * r;
    if (!(INVCAL_FABS(r) <= residuals->max)) {
        residuals->max = INVCAL_FABS(r);
        residuals->worst = residuals->count;
    }
    residuals->count++;
    if (residual != NULL) {
        *residual = r;
    }
    return INVCAL_OK;
}
