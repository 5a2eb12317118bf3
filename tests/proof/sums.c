/* SPDX-License-Identifier: MIT */
#include "core/sums.h"

#include <stddef.h>

#include "arbitrary.h"

// eva: -eva-auto-loop-unroll 64
// config: -DINVCAL_FAST=1

enum { MOST = 27 }; /* unknowns, for parabolas in temperature */

/* That many rows. */
static void rank_one(unsigned n)
{
    static invcal_real a[INVCAL_PACKED_SIZE(MOST + 1)];
    invcal_real v[MOST + 1];
    invcal_real weight;

    ANY(a);
    ANY(v);
    ANY(weight);
    invcali_rank_one(a, v, n, weight);
}

void main(void)
{
    rank_one(INVCAL_PARAMETERS + 1);
    rank_one(MOST + 1);
    rank_one(INVCAL_PARAMETERS);
    invcal_sums sums;
    invcal_calibration nominal;
    invcal_real raw[3];
    invcal_real weight;
    invcal_real h[INVCAL_PARAMETERS];
    invcali_row row;

    invcal_sums_init(&sums);
    ANY(nominal);
    ANY(raw);
    ANY(weight);
    (void)invcali_observe(&nominal, raw, &row);
    (void)invcal_sums_add(&sums, &nominal, raw, weight);
    ANY(sums);
    ANY(row);
    (void)invcal_sums_add(&sums, &nominal, raw, weight);
    invcali_sums_add_row(&sums, &row, weight);
    ANY(h);
    invcali_products(raw, h);
    invcali_row_of(h);
    (void)invcali_variance_inline(sums.sum, INVCAL_PARAMETERS, BETWEEN(0, INVCAL_PARAMETERS - 1));
    (void)invcali_leverage(sums.sum, h);
    (void)invcali_variance(sums.sum, INVCAL_PARAMETERS, BETWEEN(0, INVCAL_PARAMETERS - 1));
}
