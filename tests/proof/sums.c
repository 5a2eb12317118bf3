/* SPDX-License-Identifier: MIT */
#include "sums.h"
#include "arbitrary.h"

// eva: -eva-auto-loop-unroll 64
// config: -D__OPTIMIZE__=1

void main(void)
{
    invcal_sums sums;
    invcal_calibration nominal;
    invcal_real raw[3];
    invcal_real weight;
    invcal_real h[INVCAL_PARAMETERS];
    invcal_row row;

    invcal_sums_init(&sums);
    ANY(nominal);
    ANY(raw);
    ANY(weight);
    (void)invcal_observe(&nominal, raw, &row);
    (void)invcal_sums_add(&sums, &nominal, raw);
    ANY(sums);
    ANY(row);
    (void)invcal_sums_add(&sums, &nominal, raw);
    invcal_sums_add_row(&sums, &row, weight);
    invcal_row_of(raw, h);
    invcal_row_of(h, h);
    invcal_sums_system(&sums);
}
