/* SPDX-License-Identifier: MIT
 *
 * Solves the positions once, then tests further unknowns one by one without solving again
 * (mathematics_judgement.md, "One fit for all of them"), and gives the probability of an
 * improvement by chance ("Chance").
 */
#include "fit.h"

#include "../core/vector.h"

#define ROUNDING (32 * INVCAL_EPSILON) /* root of the squares, from rounding of readings and sums */
#define ROUNDED (256 * INVCAL_EPSILON) /* of the squares: no fit reduces them further */
#define HALF_PI INVCAL_REAL(1.57079632679489662)

void invcali_fit_row(const invcali_fit *fit, unsigned k, invcal_real row[INVCAL_PARAMETERS + 1])
{
    const invcal_real *p = &fit->sums.sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)];

    (void)invcali_read(fit->selection.given.nominal, fit->selection.given.mean[k].v, row);
    row[INVCAL_J] += invcali_dot(p, row, INVCAL_PARAMETERS);
}

/* Squares of the residuals themselves, since J'J - p'H'Hp cancels if nominal is far off. */
invcal_status invcali_fit_solve(invcali_fit *fit)
{
    invcal_quality q; /* not used */
    invcal_real row[INVCAL_PARAMETERS + 1];

    const invcal_status status = invcali_positions_solve(&fit->selection, &fit->sums, &q);
    if (status != INVCAL_OK) {
        return status;
    }
    fit->squares = ROUNDING * ROUNDING;
    for (unsigned k = 0; k < fit->selection.given.count; k++) {
        if (!(fit->selection.left_out >> k & 1u)) {
            invcali_fit_row(fit, k, row);
            fit->squares += row[INVCAL_J] * row[INVCAL_J];
        }
    }
    return INVCAL_OK;
}

invcal_real invcali_chance(const invcali_fit *fit, invcal_real after, invcal_real before,
                           unsigned m, unsigned unknowns, unsigned stated)
{
    const invcal_real noise = fit->selection.given.noise;
    unsigned dof = invcali_fit_spare(fit, unknowns);

    if (!(after >= ROUNDED * fit->squares)) {
        after = ROUNDED * fit->squares;
    }
    if (noise > 0) {
        const invcal_real known = invcali_number(stated) * noise * noise;
        dof += stated;
        after += known;
        before += known;
    }
    const invcal_real z = after / before;
    const invcal_real half = INVCAL_SQRT(z);
    const invcal_real twice = invcali_number(dof) * (1 - z);
    invcal_real p = m == 3 ? 1 + twice : 1;

    /* z^(dof/2) as a product: of libm only sqrt and fabs are used */
    while (dof-- > 0) { /* at most INVCAL_MAX_POSITIONS times */
        p *= half;
    }
    if (m != 2) {
        p /= INVCAL_SQRT(HALF_PI * twice);
    }
    return p < 1 ? p : 1;
}
