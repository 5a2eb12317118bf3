/* SPDX-License-Identifier: MIT */
#include "diagnose/diagnosis.h"

#include <stddef.h>

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-partition-history 1 -eva-interprocedural-history
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64

/* At most as many positions as the mask has bits; nothing is known of them, or anything. */
void main(void)
{
    static invcal_vector mean[INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcali_selection selection;
    invcal_quality quality;

    ANY(mean);
    ANY(nominal);
    ANY(selection);
    ANY(quality);
    selection.given.mean = mean;
    selection.given.count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    selection.given.nominal = &nominal;
    (void)invcali_diagnose(&selection, &nominal, NULL);
    (void)invcali_diagnose(&selection, &nominal, &quality);
}
