/* SPDX-License-Identifier: MIT
 *
 * Internal: what other modules ask of the sums.
 */
#ifndef INVCAL_SUMS_H
#define INVCAL_SUMS_H

#include "invcal/expert.h"
#include "vector.h"

/* The paper's row h(a) = (x y z x^2 y^2 z^2 xy xz yz); a may stand where h begins. */
void invcal_row_of(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS]);

/* The same, to be compiled into those who need it often. */
static inline void invcal_row_inline(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS])
{
    h[INVCAL_DELTA_X] = a[0];
    h[INVCAL_DELTA_Y] = a[1];
    h[INVCAL_DELTA_Z] = a[2];
    h[INVCAL_DK_X] = a[0] * a[0];
    h[INVCAL_DK_Y] = a[1] * a[1];
    h[INVCAL_DK_Z] = a[2] * a[2];
    h[INVCAL_GAMMA_XY] = a[0] * a[1];
    h[INVCAL_GAMMA_XZ] = a[0] * a[2];
    h[INVCAL_GAMMA_ZY] = a[1] * a[2];
}

/* A += weight v v', a packed triangle of n rows. Elements i of same[i] != i are passed over; NULL:
 * none is. */
void invcal_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight,
                     const uint8_t *same);

/* The same, to be compiled into those who need it often. */
static inline INVCAL_INLINE void invcal_rank_one_inline(invcal_real *restrict a,
                                                        const invcal_real *restrict v, unsigned n,
                                                        invcal_real weight, const uint8_t *same)
{
    unsigned i = 0;

    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < n; r++) {
        const invcal_real weighted = weight * v[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c <= r; c++) {
            if (!same || same[i] == i) {
                a[i] += weighted * v[c];
            }
            i++;
        }
    }
}

#endif
