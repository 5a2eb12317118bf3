/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "arbitrary.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-split-return-function invcali_observe:0

enum { COUNT = 100 };

void main(void)
{
    static invcal_vector mean[COUNT];
    invcal_calibration nominal;
    unsigned count;

    ANY(mean);
    ANY(nominal);
    count = BETWEEN(1, COUNT);
    (void)invcal_bad_reading(POSITIONS_OF(NULL, 0, &nominal, 0));
    (void)invcal_bad_reading(POSITIONS_OF(mean, count, &nominal, 0));
    (void)invcal_undetermined(POSITIONS_OF(NULL, 0, &nominal, 0));
    (void)invcal_undetermined(POSITIONS_OF(mean, count, &nominal, 0));
}
