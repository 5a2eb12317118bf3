/* SPDX-License-Identifier: MIT
 *
 * Internal: functions of the sums for other modules.
 */
#ifndef INVCAL_SUMS_H
#define INVCAL_SUMS_H

#include "invcal/expert.h"
#include "vector.h"

/* The part of a row after its first three elements g:
 *
 *     (g_x x, g_y y, g_z z, (g_x y + g_y x) / 2, (g_x z + g_z x) / 2, (g_y z + g_z y) / 2)
 *
 * the derivative of J by the parameters, except for the sign, if g = A eta (mathematics.md,
 * "Uncertainty"). eta = (x y z) may be g itself: then the row is that of the paper. */
void invcal_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS]);

static inline void invcal_products_inline(const invcal_real eta[3],
                                          invcal_real g[INVCAL_PARAMETERS])
{
    const invcal_real x = eta[0];
    const invcal_real y = eta[1];
    const invcal_real z = eta[2];

    g[INVCAL_DK_X] = g[0] * x;
    g[INVCAL_DK_Y] = g[1] * y;
    g[INVCAL_DK_Z] = g[2] * z;
    g[INVCAL_GAMMA_XY] = (g[0] * y + g[1] * x) / 2;
    g[INVCAL_GAMMA_XZ] = (g[0] * z + g[2] * x) / 2;
    g[INVCAL_GAMMA_ZY] = (g[1] * z + g[2] * y) / 2;
}

/* The paper's row h = (x y z x^2 y^2 z^2 xy xz yz), from its first three elements. */
static inline void invcal_row_of(invcal_real h[INVCAL_PARAMETERS])
{
#if INVCAL_FAST
    h[INVCAL_DK_X] = h[0] * h[0];
    h[INVCAL_DK_Y] = h[1] * h[1];
    h[INVCAL_DK_Z] = h[2] * h[2];
    h[INVCAL_GAMMA_XY] = h[0] * h[1];
    h[INVCAL_GAMMA_XZ] = h[0] * h[2];
    h[INVCAL_GAMMA_ZY] = h[1] * h[2];
#else
    invcal_products(h, h); /* both factors the same: two equal halves */
#endif
}

/* |u|^2 of its row. */
static inline invcal_real invcal_square_of(const invcal_real h[INVCAL_PARAMETERS])
{
    return h[INVCAL_DK_X] + h[INVCAL_DK_Y] + h[INVCAL_DK_Z];
}

/* J = (|u|^2 - 1)/2 and h(u), exact for errors of any size (mathematics.md, "The exact row"). A
 * length outside 0.1 ... 10 is not a reading of this field, and neither is a NaN. */
static inline invcal_status invcal_observe_inline(const invcal_calibration *nominal,
                                                  const invcal_real raw[3], invcal_row *row)
{
    invcal_correct(nominal, raw, row->h);
    invcal_row_of(row->h);
    const invcal_real square = invcal_square_of(row->h);
    row->h[INVCAL_J] = (square - 1) / 2;
    if (square >= INVCAL_REAL(0.01) && square <= INVCAL_REAL(100.0)) {
        return INVCAL_OK;
    }
    return invcal_are_finite(row->h) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
}

/* h becomes y = L^-1 h, from its end. Returns |y|^2. */
static INVCAL_IN_HEADER invcal_real invcal_leverage_inline(const invcal_real *inverse,
                                                           invcal_real h[INVCAL_PARAMETERS])
{
    const invcal_real *row = &inverse[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real sum = 0;

    INVCAL_UNROLL_ROWS
    for (unsigned r = INVCAL_PARAMETERS; r > 0; r--) {
        row -= r;
        h[r - 1] = invcal_dot(row, h, r);
        sum += h[r - 1] * h[r - 1];
    }
    return sum;
}

/* For frequent callers: inline if optimised for speed. */
#if INVCAL_FAST
#define invcal_products_often invcal_products_inline
#define invcal_observe_often invcal_observe_inline
#define invcal_leverage_often invcal_leverage_inline
#else
#define invcal_products_often invcal_products
#define invcal_observe_often invcal_observe
#define invcal_leverage_often invcal_leverage
#endif

/* A += weight v v', a packed triangle of n rows. */
void invcal_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight);

#endif
