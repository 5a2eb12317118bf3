/* SPDX-License-Identifier: MIT */
#include "sums.h"

#include <limits.h>
#include <string.h>

#include "invcal/expert.h"
#include "vector.h"

static inline void row_of(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS])
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

void invcal_row_of(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS])
{
    row_of(a, h);
}

/* J = (|u|^2 - 1)/2 and h(u), exact for errors of any size. A length outside 0.1 ... 10 is no
 * reading of this field, and neither is a NaN. */
static inline invcal_status observe(const invcal_calibration *nominal, const invcal_real raw[3],
                                    invcal_row *row)
{
    invcal_correct(nominal, raw, row->h);
    row_of(row->h, row->h);
    const invcal_real square = row->h[INVCAL_DK_X] + row->h[INVCAL_DK_Y] + row->h[INVCAL_DK_Z];
    row->j = (square - 1) / 2;
    if (square >= INVCAL_REAL(0.01) && square <= INVCAL_REAL(100.0)) {
        return INVCAL_OK;
    }
    return invcal_is_finite(square) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
}

/* All products of degree d + 1 of x, y, z behind those of degree d: x times each, y times those
 * without x, z times the last. So they stand in the order xx xy xz yy yz zz, xxx xxy ... zzz. */
static INVCAL_INLINE invcal_real *raised(invcal_real *list, unsigned degree, const invcal_real a[3])
{
    const unsigned without_x = degree + 1;
    const unsigned all = without_x * (degree + 2) / 2;
    invcal_real *next = list + all;

    INVCAL_UNROLL
    for (unsigned i = 0; i < all; i++) {
        *next++ = a[0] * list[i];
    }
    INVCAL_UNROLL
    for (unsigned i = all - without_x; i < all; i++) {
        *next++ = a[1] * list[i];
    }
    *next = a[2] * list[all - 1];
    return list + all;
}

/* H'H += w h h', H'J += w h j, J'J += w j j. */
static INVCAL_INLINE void add(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
    const invcal_real wj = weight * row->j;
    invcal_real *sum = sums->sum;
    invcal_real product[3 + INVCAL_MOMENTS];

    product[0] = weight * row->h[0];
    product[1] = weight * row->h[1];
    product[2] = weight * row->h[2];
    (void)raised(raised(raised(product, 1, row->h), 2, row->h), 3, row->h);
    INVCAL_UNROLL
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        *sum++ += product[3 + i];
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
    invcal_row r;

    INVCAL_ASSERT(nominal && raw && row);
    const invcal_status status = observe(nominal, raw, &r);
    if (status == INVCAL_OK) {
        *row = r;
    }
    return status;
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

/* Element (r, c) is the sum of one product: it stands behind those of lower degree, and of those
 * with fewer factors other than x, and fewer z. */
void invcal_sums_expand(const invcal_real moment[INVCAL_MOMENTS], invcal_real *a)
{
    /* of x y z xx yy zz xy xz yz */
    static const unsigned char not_x[INVCAL_PARAMETERS] = {0, 1, 1, 0, 2, 2, 1, 1, 2};
    static const unsigned char is_z[INVCAL_PARAMETERS] = {0, 0, 1, 0, 0, 2, 0, 1, 1};

    INVCAL_UNROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        INVCAL_UNROLL
        for (unsigned c = 0; c <= r; c++) {
            /* cppcheck-suppress misra-c2012-10.6 ; constants, no wider than they are */
            const unsigned start = c >= INVCAL_DK_X ? 16 : r >= INVCAL_DK_X ? 6 : 0;
            const unsigned others = (unsigned)not_x[r] + not_x[c];
            *a++ = moment[start + INVCAL_PACKED(others, (unsigned)is_z[r] + is_z[c])];
        }
    }
}

void invcal_sums_system(invcal_sums *sums)
{
    invcal_real moment[INVCAL_MOMENTS];
    invcal_real *a = sums->sum;

    memcpy(moment, a, sizeof moment);
    memcpy(&a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], &a[INVCAL_MOMENTS],
           (INVCAL_PARAMETERS + 1) * sizeof *a);
    invcal_sums_expand(moment, a);
}
