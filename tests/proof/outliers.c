/* SPDX-License-Identifier: MIT */
#include "diagnose/outliers.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-partition-history 1 -eva-interprocedural-history
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64

/* In any fit of at most as many positions as the mask has bits. */
void main(void)
{
    static invcal_vector mean[INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcali_fit fit;
    invcali_group found;

    ANY(mean);
    ANY(nominal);
    ANY(fit);
    fit.selection.given.mean = mean;
    fit.selection.given.count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    fit.selection.given.nominal = &nominal;
    invcali_outliers_search(&fit, &found);
    (void)found.group; /* initialised, whatever was found */
    (void)found.suspected;
    (void)found.chance;
    (void)invcali_are_many(found.group, fit.selection.given.count);
}
