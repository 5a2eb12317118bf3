/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/outlier.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-split-return full -eva-slevel 10
// config: -DINVCAL_MAX_POSITIONS=64
// trusted: 2

static void find(unsigned count)
{
    invcal_real raw[3 * INVCAL_MAX_POSITIONS];
    invcal_settings settings;
    invcal_outliers outliers;

    ANY(raw);
    ANY(settings);
    invcal_outliers_find(&raw[3 * (INVCAL_MAX_POSITIONS - count)], count, &settings, &outliers);
}

void main(void)
{
    invcal_settings settings;
    invcal_outliers outliers;
    invcal_real none[1];

    ANY(settings);
    //@ loop unroll INVCAL_MAX_POSITIONS + 1;
    for (unsigned count = 0; count <= INVCAL_MAX_POSITIONS; count++) {
        find(count);
    }
    invcal_outliers_find(none, BETWEEN(INVCAL_MAX_POSITIONS + 1, 0xFFFFFFFF), &settings, &outliers);
}
