/* SPDX-License-Identifier: MIT */
#include "sums.h"

#include <limits.h>
#include <string.h>

#include "invcal/expert.h"
#include "vector.h"

INVCAL_INLINE void invcal_row_of(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS])
{
    invcal_row_inline(a, h);
}

/* J = (|u|^2 - 1)/2 and h(u), exact for errors of any size. A length outside 0.1 ... 10 is no
 * reading of this field, and neither is a NaN. */
static INVCAL_INLINE invcal_status observe(const invcal_calibration *nominal,
                                           const invcal_real raw[3], invcal_row *row)
{
    invcal_correct(nominal, raw, row->h);
    invcal_row_of(row->h, row->h);
    const invcal_real square = row->h[INVCAL_DK_X] + row->h[INVCAL_DK_Y] + row->h[INVCAL_DK_Z];
    row->j = (square - 1) / 2;
    if (square >= INVCAL_REAL(0.01) && square <= INVCAL_REAL(100.0)) {
        return INVCAL_OK;
    }
    return invcal_are_finite(row->h) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
}

/* H'H += w h h', H'J += w h j, J'J += w j j. Every element of h h' is a product of two, three or four
 * of x, y, z: each of the 31 is made of the one before it. */
static INVCAL_INLINE void add(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
    const invcal_real wj = weight * row->j;
    const invcal_real *a = row->h;
    invcal_real *sum = sums->sum;

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real first = weight * a[i];
        INVCAL_UNROLL
        for (unsigned j = i; j < 3; j++) {
            const invcal_real second = first * a[j];
            *sum++ += second;
            INVCAL_UNROLL
            for (unsigned k = j; k < 3; k++) {
                const invcal_real third = second * a[k];
                *sum++ += third;
                INVCAL_UNROLL
                for (unsigned l = k; l < 3; l++) {
                    *sum++ += third * a[l];
                }
            }
        }
    }
    INVCAL_UNROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        *sum++ += wj * row->h[r];
    }
    *sum += wj * row->j;
    sums->count += sums->count < UINT_MAX; /* 0 would say that they are empty */
}

void invcal_sums_init(invcal_sums *sums)
{
    INVCAL_ASSERT(sums);
    memset(sums, 0, sizeof *sums);
}

invcal_status invcal_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                             invcal_row *row)
{
    INVCAL_ASSERT(nominal && raw && row);
    return observe(nominal, raw, row);
}

void invcal_sums_add_row(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
    INVCAL_ASSERT(sums && row);
    add(sums, row, weight);
}

invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real raw[3])
{
    invcal_row row;

    INVCAL_ASSERT(sums && nominal && raw);
    const invcal_status status = observe(nominal, raw, &row);
    if (status == INVCAL_OK) {
        add(sums, &row, 1);
    }
    return status;
}

void invcal_sums_expand(const invcal_real moment[INVCAL_MOMENTS], invcal_real *a)
{
    /* Element (r, c) of h h' is a product of two, three or four of x, y, z: this one of the sums. */
    static const uint8_t moment_of[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)] = {
        0,                                 /* x */
        10, 19,                            /* y */
        16, 25, 28,                        /* z */
        1,  5,  8,  2,                     /* xx */
        11, 20, 23, 6, 21,                 /* yy */
        17, 26, 29, 9, 24, 30,             /* zz */
        5,  11, 14, 3, 12, 15, 6,          /* xy */
        8,  14, 17, 4, 13, 18, 7,  9,      /* xz */
        14, 23, 26, 7, 22, 27, 13, 15, 24, /* yz */
    };

    INVCAL_UNROLL
    for (unsigned i = 0; i < sizeof moment_of; i++) {
        a[i] = moment[moment_of[i]];
    }
}

void invcal_sums_system(invcal_sums *sums)
{
    invcal_real moment[INVCAL_MOMENTS];
    invcal_real *a = sums->sum;

    memcpy(moment, a, sizeof moment);
    /* cppcheck-suppress overlappingWriteFunction ; 45 ... 54 of 31 ... 40 */
    memcpy(&a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], &a[INVCAL_MOMENTS],
           (INVCAL_PARAMETERS + 1) * sizeof *a);
    invcal_sums_expand(moment, a);
}
