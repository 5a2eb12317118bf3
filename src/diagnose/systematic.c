/* SPDX-License-Identifier: MIT
 *
 * Tests for one kind of systematic error (mathematics_judgement.md, "Systematic errors"): three
 * columns, one for each axis, are added to the nine of a fit ("One fit for all of them"). How much
 * of them the nine leave shows whether the positions could reveal the error at all ("What cannot be
 * tested").
 */
#include "systematic.h"

#include <stddef.h>

#include "../core/sums.h"
#include "../core/vector.h"

#define TURNED INVCAL_REAL(1e-3) /* over field: min change of a turned axis */

enum {
    MORE = 3,              /* unknowns after the nine */
    C = INVCAL_PARAMETERS, /* index of their elements in a row */
    REST = C + MORE        /* index of J or of the residual, after them */
};

/* One of them, number d, by its column c of H: H'c, then c'c of those before it and its own, then
 * c'J or c'r. */
typedef invcal_real column[REST + 1];

/* The error of an axis with component x of the field, which was elsewhere before. Nonlinearity
 * without the offset of 3/5 and the scale error of 6/7 that absorb part of it, over all
 * directions. */
static INVCAL_ONCE invcal_real error_of(unsigned kind, invcal_real x, invcal_real before,
                                        invcal_real tau)
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
static INVCAL_ONCE void sum_columns(const invcali_fit *fit, unsigned kind, unsigned step,
                                    column columns[MORE])
{
    const invcal_positions *p = &fit->selection.given;
    invcal_real before[3];
    column v;

    invcali_zero_array(before, 3);
    for (unsigned k = 0; k < p->count; k++) {
        const unsigned passed = step ? k >= step : k;
        const unsigned all = step ? 1 : p->count - 1;
        const invcal_real tau = invcali_number(passed) / invcali_number(all) - INVCAL_REAL(0.5);
        (void)invcali_read(p->nominal, p->mean[k].v, v);
        v[REST] = v[INVCAL_J];
        INVCAL_UNROLL
        for (unsigned a = 0; a < MORE; a++) {
            const invcal_real x = v[a];
            if (k == 0) {
                before[a] = x;
            }
            v[C + a] = x * error_of(kind, x, before[a], tau);
            before[a] = x;
        }
        if (fit->selection.left_out >> k & 1u) {
            continue;
        }
        INVCAL_UNROLL
        for (unsigned a = 0; a < MORE; a++) {
            INVCAL_UNROLL
            for (unsigned i = 0; i <= REST; i++) {
                columns[a][i] += v[C + a] * v[i];
            }
        }
    }
}

/* The Cholesky factor of the normal equations continues below L: column d becomes its row, with the
 * reciprocal of the diagonal; 0 if the others explain all but 0.1 % of its square. The square of
 * the new c'r is the reduction of the squares by the unknown (mathematics_judgement.md, "One fit
 * for all of them").
 *
 * Returns the part of c'c that the nine do not explain. */
static INVCAL_ONCE invcal_real append(const invcali_fit *fit, column columns[MORE], unsigned d)
{
    const invcal_real *const l = fit->sums.sum;
    invcal_real *const x = columns[d];
    const invcal_real whole = x[C + d];

    x[REST] += invcali_dot(&l[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], x, INVCAL_PARAMETERS);
    const invcal_real unexplained = whole - invcali_leverage(l, x);
    invcal_real left = unexplained;
    for (unsigned b = 0; b < d; b++) {
        const invcal_real *const before = columns[b];
        const invcal_real y = (x[C + b] - invcali_dot(x, before, C + b)) * before[C + b];
        x[C + b] = y;
        x[REST] -= y * before[REST];
        left -= y * y;
    }
    x[C + d] = left > INVCAL_TOLERANCE * whole ? 1 / INVCAL_SQRT(left) : 0;
    x[REST] *= x[C + d];
    return unexplained / whole;
}

void invcali_test_for(const invcali_fit *fit, unsigned kind, unsigned step, invcali_test *out)
{
    column columns[MORE];
    invcal_real squares = fit->squares;
    invcal_real least = 1;
    unsigned rank = 0;

    invcali_zero_array(columns[0], MORE * (REST + 1));
    sum_columns(fit, kind, step, columns);
    INVCAL_ROLL
    for (unsigned a = 0; a < MORE; a++) {
        const invcal_real shown = append(fit, columns, a);
        least = shown >= least ? least : shown;
        rank += columns[a][C + a] > 0;
        squares -= columns[a][REST] * columns[a][REST];
    }
    INVCAL_ROLL
    for (unsigned a = MORE; a-- > 0;) { /* l' size = z */
        invcal_real size = columns[a][REST];
        INVCAL_ROLL
        for (unsigned b = a + 1; b < MORE; b++) {
            size -= columns[b][C + a] * out->size[b];
        }
        out->size[a] = size * columns[a][C + a];
    }
    out->rank = rank;
    out->squares = squares;
    out->shown = least;
}
