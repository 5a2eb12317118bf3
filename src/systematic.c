/* SPDX-License-Identifier: MIT
 *
 * Tests for one kind of systematic error (mathematics_judgement.md, "Systematic errors"): three
 * columns, one for each axis, are added to the nine of a fit ("One fit for all of them"). How much
 * of them the nine leave shows whether the positions could reveal the error at all ("What cannot be
 * tested").
 */
#include "systematic.h"

#include <stddef.h>

#include "sums.h"
#include "vector.h"

#define TURNED INVCAL_REAL(1e-3) /* over field: min change of a turned axis */

/* The error of an axis with component x of the field, which was elsewhere before. Nonlinearity
 * without the offset of 3/5 and the scale error of 6/7 that absorb part of it, over all
 * directions. */
static invcal_real error_of(unsigned kind, invcal_real x, invcal_real before, invcal_real tau)
{
    if (kind == INVCAL_DRIFT) {
        return tau;
    }
    if (kind == INVCAL_QUADRATIC) {
        return x * x - INVCAL_REAL(0.6);
    }
    if (kind == INVCAL_CUBIC) {
        return x * (x * x - INVCAL_REAL(6.0) / 7);
    }
    return x - before > TURNED ? INVCAL_REAL(0.5) : before - x > TURNED ? -INVCAL_REAL(0.5) : 0;
}

/* An error e of an axis moves J by eta e. A position left out still counts as the one before the
 * next: hysteresis depends on how the axis was turned, whether or not that reading is used. */
static void sum_columns(const invcal_fit *fit, unsigned kind, unsigned step,
                        invcal_column columns[INVCAL_MORE])
{
    const invcal_positions *p = &fit->positions;
    const invcal_real half = INVCAL_REAL(0.5);
    invcal_real before[3] = {0, 0, 0};
    invcal_column v;

    for (unsigned k = 0; k < p->count; k++) {
        const invcal_real tau = step ? (k < step ? -half : half)
                                     : invcal_number(k) / invcal_number(p->count - 1) - half;
        invcal_fit_row(fit, k, v);
        INVCAL_UNROLL
        for (unsigned a = 0; a < 3; a++) {
            const invcal_real x = v[a];
            v[INVCAL_C + a] = x * error_of(kind, x, k > 0 ? before[a] : x, tau);
            before[a] = x;
        }
        if (invcal_is_left_out(p, k)) {
            continue;
        }
        INVCAL_UNROLL
        for (unsigned a = 0; a < 3; a++) {
            INVCAL_UNROLL
            for (unsigned i = 0; i <= INVCAL_REST; i++) {
                columns[a][i] += v[INVCAL_C + a] * v[i];
            }
        }
    }
}

void invcal_test_for(const invcal_fit *fit, unsigned kind, unsigned step, invcal_test *out)
{
    invcal_column columns[INVCAL_MORE];

    invcal_zero_reals(columns[0], INVCAL_MORE * (INVCAL_REST + 1));
    sum_columns(fit, kind, step, columns);
    out->rank = 0;
    out->squares = fit->squares;
    out->shown = 1;
    for (unsigned a = 0; a < INVCAL_MORE; a++) {
        const invcal_real *const x = columns[a];
        const invcal_real whole = x[INVCAL_C + a];
        const invcal_real shown = invcal_fit_append(fit, columns, a) / whole;
        out->shown = shown >= out->shown ? out->shown : shown;
        out->rank += x[INVCAL_C + a] > 0;
        out->squares -= x[INVCAL_REST] * x[INVCAL_REST];
    }
    for (unsigned a = INVCAL_MORE; a-- > 0;) { /* l' size = z */
        out->size[a] = columns[a][INVCAL_REST];
        for (unsigned b = a + 1; b < INVCAL_MORE; b++) {
            out->size[a] -= columns[b][INVCAL_C + a] * out->size[b];
        }
        out->size[a] *= columns[a][INVCAL_C + a];
    }
}
