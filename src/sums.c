/* SPDX-License-Identifier: MIT */
#include "sums.h"

#include <limits.h>
#include <stddef.h>
#include <string.h>

#include "invcal/expert.h"
#include "vector.h"

void invcal_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS])
{
    invcal_products_inline(eta, g);
}

/* Elements of H'H are products of two, three or four of x, y, z, and 31 of 45 different: this one
 * stands for each, itself or an earlier one. J is behind the row. */
static const uint8_t same_as[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)] = {
    0,                                      /* x */
    1,  2,                                  /* y */
    3,  4,  5,                              /* z */
    6,  7,  8,  9,                          /* xx */
    10, 11, 12, 13, 14,                     /* yy */
    15, 16, 17, 18, 19, 20,                 /* zz */
    7,  10, 23, 24, 25, 26, 13,             /* xy */
    8,  23, 15, 31, 32, 33, 34, 18,         /* xz */
    23, 12, 16, 34, 40, 41, 32, 26, 19,     /* yz */
    45, 46, 47, 48, 49, 50, 51, 52, 53, 54, /* J */
};

void invcal_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight,
                     const uint8_t *same)
{
#ifdef INVCAL_FAST
    if (n == INVCAL_PARAMETERS + 1 && !same) {
        invcal_rank_one_inline(a, v, INVCAL_PARAMETERS + 1, weight, NULL);
        return;
    }
    if (!same) {
        invcal_rank_one_inline(a, v, n, weight, NULL);
        return;
    }
#endif
    invcal_rank_one_inline(a, v, n, weight, same);
}

/* H'H += w h h', H'J += w h J, J'J += w J J. */
static INVCAL_INLINE void add(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
#ifdef INVCAL_FAST
    invcal_rank_one_inline(sums->sum, row->h, INVCAL_PARAMETERS + 1, weight, same_as);
#else
    invcal_rank_one(sums->sum, row->h, INVCAL_PARAMETERS + 1, weight, same_as);
#endif
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
    return invcal_observe_inline(nominal, raw, row);
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
    const invcal_status status = invcal_observe_often(nominal, raw, &row);
    if (status == INVCAL_OK) {
        add(sums, &row, 1);
    }
    return status;
}

void invcal_sums_system(invcal_sums *sums)
{
    INVCAL_UNROLL
    for (unsigned i = 0; i < sizeof same_as; i++) {
        sums->sum[i] = sums->sum[same_as[i]];
    }
}
