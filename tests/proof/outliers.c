/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-split-return full -eva-slevel 10
// config: -DINVCAL_MAX_POSITIONS=64

static invcal_real raw[3 * INVCAL_MAX_POSITIONS];
static invcal_calibration nominal;

void main(void)
{
    invcal_real noise;
    invcal_mask removed;
    invcal_outliers outliers;
    invcal_outlier one;
    unsigned count;
    unsigned position;

    ANY(raw);
    ANY(nominal);
    ANY(noise);
    ANY(removed);
    ANY(position);
    (void)invcal_outliers_find(raw, BETWEEN(0, INVCAL_MAX_POSITIONS), &nominal, noise, &outliers);
    (void)invcal_outlier_size(raw, BETWEEN(0, INVCAL_MAX_POSITIONS), &nominal, noise, removed,
                              position, &one);
    ANY(count);
    if (count > INVCAL_MAX_POSITIONS) {
        (void)invcal_outliers_find(raw, count, &nominal, noise, &outliers);
        (void)invcal_outlier_size(raw, count, &nominal, noise, removed, position, &one);
    }
}
