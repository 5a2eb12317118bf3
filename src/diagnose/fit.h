/* SPDX-License-Identifier: MIT
 *
 * Internal: the fit of near-identity positions, its improvement by more unknowns, and the
 * probability of that by chance alone.
 */
#ifndef INVCAL_FIT_H
#define INVCAL_FIT_H

#include <stddef.h>

#include "../calibrate/judge.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* The fit of the positions that are not left out. */
typedef struct {
    invcali_selection selection;
    invcal_real
        squares;      /* of the residuals; with rounding errors, so that exact readings have some */
    invcal_sums sums; /* their number; L^-1 of their system, then p */
} invcali_fit;

/* Returns as invcali_positions_solve. */
invcal_status invcali_fit_solve(invcali_fit *fit);

/* The row of position k: h, and in place of J its residual J + h p. */
void invcali_fit_row(const invcali_fit *fit, unsigned k, invcal_real row[INVCAL_PARAMETERS + 1]);

/* Of an unknown's column c the nine explain all but this share of c'c: it is not one of its own. */
#define INVCAL_TOLERANCE INVCAL_REAL(0.001)

/* ---- chance ---------------------------------------------------------------------------------- */

/* The probability that chance alone reduces a sum of squares that much: m more unknowns, one to
 * three, reduce it from `before` to z times that, and leave dof residuals. The tail of Fisher's F,
 * I_z(dof/2, m/2), by its leading terms (mathematics_judgement.md, "Chance"): with
 * t = dof (1 - z) / 2
 *
 *     z^(dof/2) / sqrt(pi t) (1, sqrt(pi t), 1 + 2 t),
 *
 * which are too large, by 1/(2 t) of the first or, for one residual, by a quarter: on the safe
 * side.
 *
 * after   the squares that all of `unknowns` leave; at least what rounding leaves of 0.
 * stated  how many residuals a stated noise counts as.
 *
 * Returns at most 1; 0 on underflow. */
invcal_real invcali_chance(const invcali_fit *fit, invcal_real after, invcal_real before,
                           unsigned m, unsigned unknowns, unsigned stated);

enum { INVCAL_SPARE = 2 }; /* min degrees of freedom left, to name a cause */

/* Degrees of freedom left by that many unknowns after the nine. */
static inline unsigned invcali_fit_spare(const invcali_fit *fit, unsigned unknowns)
{
    const unsigned taken = INVCAL_PARAMETERS + unknowns;

    return fit->sums.count > taken ? fit->sums.count - taken : 0;
}

#endif
