/* SPDX-License-Identifier: MIT */
#include "invcal/residual.h"

#include <string.h>

#include "vector.h"

/* y = (I + M) x for a packed symmetric 3x3 matrix M. */
static void multiply(const invcal_real m[6], const invcal_real x[3], invcal_real y[3])
{
    y[0] = x[0] + (m[0] * x[0] + m[1] * x[1] + m[3] * x[2]);
    y[1] = x[1] + (m[1] * x[0] + m[2] * x[1] + m[4] * x[2]);
    y[2] = x[2] + (m[3] * x[0] + m[4] * x[1] + m[5] * x[2]);
}

void invcal_residuals_init(invcal_residuals *residuals, const invcal_solution *solution)
{
    invcal_real s[6];
    invcal_eigen3 axes;
    invcal_real squares = 0;

    INVCAL_ASSERT(residuals && solution);
    memset(residuals, 0, sizeof *residuals);
    memcpy(residuals->delta, solution->delta, sizeof residuals->delta);
    invcal_solution_deviation(solution, s);
    invcal_eigen3_decompose(s, &axes);
    invcal_eigen3_inverse(&axes, residuals->correction);
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real semi_axis = 1 + axes.value[i];
        squares += 1 / (semi_axis * semi_axis); /* the trace of A^2 */
    }
    residuals->gain = INVCAL_SQRT(squares / 3);
}

/* Noise of u moves the length of eta = A (u - delta) by |A eta| times itself: rows are weighted
 * with the inverse square, relative to the mean over all directions. */
static invcal_real direction_weight(const invcal_residuals *residuals, const invcal_real eta[3])
{
    invcal_real gradient[3];

    multiply(residuals->correction, eta, gradient);
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
    multiply(residuals->correction, centred, eta);
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
    if (residual) {
        *residual = r;
    }
    return INVCAL_OK;
}
