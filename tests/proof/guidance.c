/* SPDX-License-Identifier: MIT */
#include "plan/guidance.h"

#include <stddef.h>

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30 -eva-slevel 60 -eva-split-return-function invcal_observe:0

enum { COUNT = 100 };

void main(void)
{
    static invcal_real raw[3 * COUNT];
    invcal_calibration nominal;
    invcal_sums sums;
    invcal_real up[3];
    invcal_real next[3];
    invcal_real root[INVCAL_PARAMETERS];

    ANY(raw);
    ANY(nominal);
    ANY(up);
    invcal_next(NULL, 0, &nominal, next);
    invcal_next(raw, BETWEEN(1, COUNT), &nominal, next);
    invcal_prospect(NULL, 0, &nominal, NULL, root);
    invcal_prospect(raw, BETWEEN(1, COUNT), &nominal, up, root);
    ANY(sums);
    invcal_next_of_sums(&sums, up, next);
    ANY(sums);
    (void)invcal_ridged_inverse(&sums);
}
