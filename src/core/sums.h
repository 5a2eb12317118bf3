/* SPDX-License-Identifier: MIT
 *
 * Internal: functions of the sums for other modules.
 */
#ifndef INVCAL_SUMS_H
#define INVCAL_SUMS_H

#include "invcal/expert.h"
#include "invcal/positions.h"
#include "system.h"
#include "vector.h"

#define INVCAL_J INVCAL_PARAMETERS /* index of J: after the row */

/* One equation. */
typedef struct {
    invcal_real h[INVCAL_PARAMETERS + 1]; /* the row, its first three elements u; then J */
} invcali_row;

/* The exact row of a reading.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a length outside 0.1 ... 10. On
 * failure row is overwritten. */
invcal_status invcali_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                              invcali_row *row);

/* Adds an existing row.
 *
 * weight  1 for a position like the others; (sigma_usual / sigma_this)^2 for another precision;
 *         finite. Checks nothing. */
void invcali_sums_add_row(invcal_sums *sums, const invcali_row *row, invcal_real weight);

/* No programming error. A macro, as a function would be unused without INVCAL_ASSERT. */
#define INVCAL_ARE_GIVEN(positions)                                                                \
    ((positions) && ((positions)->mean || (positions)->count == 0) && (positions)->nominal)

/* The part of a row after its first three elements g:
 *
 *     (g_x x, g_y y, g_z z, (g_x y + g_y x) / 2, (g_x z + g_z x) / 2, (g_y z + g_z y) / 2)
 *
 * the derivative of J by the parameters, except for the sign, if g = A eta (mathematics.md,
 * "Uncertainty"). */
void invcali_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS]);

/* The paper's row h = (x y z x^2 y^2 z^2 xy xz yz), from its first three elements. */
static INVCAL_ONCE void invcali_row_inline(invcal_real h[INVCAL_PARAMETERS])
{
    const invcal_real x = h[0];
    const invcal_real y = h[1];
    const invcal_real z = h[2];

    h[INVCAL_DK_X] = x * x;
    h[INVCAL_DK_Y] = y * y;
    h[INVCAL_DK_Z] = z * z;
    h[INVCAL_GAMMA_XY] = x * y;
    h[INVCAL_GAMMA_XZ] = x * z;
    h[INVCAL_GAMMA_ZY] = y * z;
}
#if INVCAL_FAST
static INVCAL_ONCE void invcali_row_of(invcal_real h[INVCAL_PARAMETERS])
{
    invcali_row_inline(h);
}
#else
void invcali_row_of(invcal_real h[INVCAL_PARAMETERS]);
#endif

/* |u|^2 of its row. */
static inline invcal_real invcali_square_of(const invcal_real h[INVCAL_PARAMETERS])
{
    return h[INVCAL_DK_X] + h[INVCAL_DK_Y] + h[INVCAL_DK_Z];
}

/* A reading as the exact row: h(u), and J = (|u|^2 - 1)/2, exact for errors of any size
 * (mathematics.md, "The exact row"). Returns as invcali_observe: a length outside 0.1 ... 10 is not a
 * reading of this field, and neither is a NaN. */
static INVCAL_ONCE invcal_status invcali_read_inline(const invcal_calibration *nominal,
                                                     const invcal_real raw[3],
                                                     invcal_real h[INVCAL_PARAMETERS + 1])
{
    invcali_correct(nominal, raw, h);
    invcali_row_of(h);
    const invcal_real square = invcali_square_of(h);
    h[INVCAL_J] = (square - 1) / 2;
    if (square >= INVCAL_REAL(0.01) && square <= INVCAL_REAL(100.0)) {
        return INVCAL_OK;
    }
    return invcali_are_finite(h) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
}
#if INVCAL_FAST
static INVCAL_ONCE invcal_status invcali_read(const invcal_calibration *nominal,
                                              const invcal_real raw[3],
                                              invcal_real h[INVCAL_PARAMETERS + 1])
{
    return invcali_read_inline(nominal, raw, h);
}
#else
invcal_status invcali_read(const invcal_calibration *nominal, const invcal_real raw[3],
                           invcal_real h[INVCAL_PARAMETERS + 1]);
#endif

/* A += weight v v', a packed triangle of n rows. */
void invcali_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight);

#endif
