/* SPDX-License-Identifier: MIT
 *
 * Internal: the fit of positions that are nearly calibrated, what more unknowns would make of it, and how
 * often chance alone would do as much.
 */
#ifndef INVCAL_FIT_H
#define INVCAL_FIT_H

#include <stddef.h>

#include "judge.h"
#include "sums.h"
#include "vector.h"

/* The fit of the positions that are not left out. */
typedef struct {
    invcal_positions positions;
    invcal_real
        squares;      /* of the residuals; with rounding errors, so that exact readings have some */
    invcal_sums sums; /* their number; L^-1 of their system, and p behind it */
} invcal_fit;

/* Returns as invcal_positions_sum, then as invcal_determine. */
invcal_status invcal_fit_solve(invcal_fit *fit);

/* ---- more unknowns ------------------------------------------------------------------------------ */

enum {
    INVCAL_MORE = 3,                              /* unknowns behind the nine at most */
    INVCAL_C = INVCAL_PARAMETERS,                 /* and their elements in a row; */
    INVCAL_REST = INVCAL_PARAMETERS + INVCAL_MORE /* behind them the residual */
};

/* One of them, number d, by its column c of H: H'c, then c'c of those before it and its own, then c'r. */
typedef invcal_real invcal_column[INVCAL_REST + 1];

/* The row of position k: h, and its residual r = J + h p. */
void invcal_fit_row(const invcal_fit *fit, unsigned k, invcal_column x);

static INVCAL_IN_HEADER void invcal_fit_row_inline(const invcal_fit *fit, unsigned k,
                                                   invcal_column x)
{
    const invcal_real *p = &fit->sums.sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)];

    invcal_correct(fit->positions.nominal, &fit->positions.raw[3 * (size_t)k], x);
    invcal_row_of(x);
    x[INVCAL_REST] = (invcal_square_of(x) - 1) / 2 + invcal_dot(p, x, INVCAL_PARAMETERS);
}

/* The Cholesky factor of the normal equations goes on below L: column d becomes its row, with the
 * reciprocal of the diagonal; 0 if all but 0.1 % of its square is made of the others. The square of what c'r
 * becomes is what the unknown takes from the squares.
 *
 * Returns what the nine leave of c'c. */
invcal_real invcal_fit_append(const invcal_fit *fit, invcal_column columns[INVCAL_MORE],
                              unsigned d);

#define INVCAL_TOLD INVCAL_REAL(0.001)

static INVCAL_IN_HEADER invcal_real invcal_fit_append_inline(const invcal_fit *fit,
                                                             invcal_column columns[INVCAL_MORE],
                                                             unsigned d)
{
    invcal_real *const x = columns[d];
    const invcal_real least = INVCAL_TOLD * x[INVCAL_C + d];
    const invcal_real beside = x[INVCAL_C + d] - invcal_leverage_often(fit->sums.sum, x);
    invcal_real left = beside;

    for (unsigned i = INVCAL_C; i < INVCAL_C + d; i++) {
        const invcal_real *const before = columns[i - INVCAL_C];
        x[i] = (x[i] - invcal_dot(x, before, i)) * before[i];
        x[INVCAL_REST] -= x[i] * before[INVCAL_REST];
        left -= x[i] * x[i];
    }
    x[INVCAL_C + d] = left > least ? 1 / INVCAL_SQRT(left) : 0;
    x[INVCAL_REST] *= x[INVCAL_C + d];
    return beside;
}

/* These for those who need them often: compiled into them where speed is asked for. */
#ifdef INVCAL_FAST
#define invcal_fit_row_often invcal_fit_row_inline
#define invcal_fit_append_often invcal_fit_append_inline
#else
#define invcal_fit_row_often invcal_fit_row
#define invcal_fit_append_often invcal_fit_append
#endif

/* ---- chance ------------------------------------------------------------------------------------- */

/* How often chance alone makes one sum of squares so small beside another: m unknowns more, one to three,
 * take it down from `before` to z of itself, and leave dof residuals. The tail of Fisher's F,
 * I_z(dof/2, m/2), by its leading terms: with t = dof (1 - z) / 2
 *
 *     z^(dof/2) / sqrt(pi t) (1, sqrt(pi t), 1 + 2 t),
 *
 * which are too large, by 1/(2 t) of the first or, for one residual, by a quarter: on the safe side.
 *
 * after   the squares that all of `unknowns` leave. No less counts than what rounding may leave of none.
 * stated  how many residuals the noise stated counts as, if one is stated.
 *
 * Returns 1 at most; 0 for what float cannot hold. */
invcal_real invcal_chance(const invcal_fit *fit, invcal_real after, invcal_real before, unsigned m,
                          unsigned unknowns, unsigned stated);

enum { INVCAL_SPARE = 2 }; /* degrees of freedom that are left, for a cause to be named */

/* Degrees of freedom that so many unknowns behind the nine leave. */
static inline unsigned invcal_fit_spare(const invcal_fit *fit, unsigned unknowns)
{
    const unsigned taken = INVCAL_PARAMETERS + unknowns;

    return fit->sums.count > taken ? fit->sums.count - taken : 0;
}

#endif
