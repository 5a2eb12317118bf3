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
    static invcal_real raw[3 * INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcal_positions positions;
    invcal_quality quality;

    ANY(raw);
    ANY(nominal);
    ANY(positions);
    ANY(quality);
    positions.raw = raw;
    positions.count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    positions.nominal = &nominal;
    (void)invcal_diagnose(&positions, &nominal, NULL);
    (void)invcal_diagnose(&positions, &nominal, &quality);
}
