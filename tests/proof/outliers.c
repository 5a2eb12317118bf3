/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 20
// eva: -eva-split-return-function start:0,fit:0,determine:0,invcal_positions_check:0,invcal_positions_sum:0,invcal_sums_add:0,invcal_observe:0,invcal_factor:0
// config: -DINVCAL_MAX_POSITIONS=64
// config: -D__OPTIMIZE__=1

void main(void)
{
    static invcal_real raw[3 * INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcal_outliers outliers;
    invcal_outlier outlier;
    invcal_mask removed;
    invcal_real noise;

    ANY(raw);
    ANY(nominal);
    ANY(removed);
    ANY(noise);
    (void)invcal_outliers_find(NULL, 0, &nominal, noise, &outliers);
    (void)invcal_outliers_find(raw, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise, &outliers);
    (void)invcal_outliers_find(raw, BETWEEN(INVCAL_MAX_POSITIONS + 1, 0xFFFFFFFF), &nominal, noise,
                               &outliers);
    (void)invcal_outlier_size(raw, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise, removed,
                              BETWEEN(0, 0xFFFFFFFF), &outlier);
}
