/* SPDX-License-Identifier: MIT */
#include "../positions.h"
#include "plan/guidance.h"

#include <stddef.h>

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30 -eva-slevel 60 -eva-split-return-function invcali_observe:0

enum { COUNT = 100 };

void main(void)
{
    static invcal_vector mean[COUNT];
    invcal_calibration nominal;
    invcal_sums sums;
    invcal_real up[3];
    invcal_real next[3];
    invcal_real root[INVCAL_PARAMETERS];

    ANY(mean);
    ANY(nominal);
    ANY(up);
    invcali_next(POSITIONS_OF(NULL, 0, &nominal, 0), next);
    invcali_next(POSITIONS_OF(mean, BETWEEN(1, COUNT), &nominal, 0), next);
    invcali_prospect(POSITIONS_OF(NULL, 0, &nominal, 0), NULL, root);
    invcali_prospect(POSITIONS_OF(mean, BETWEEN(1, COUNT), &nominal, 0), up, root);
    ANY(sums);
    invcali_next_of_sums(&sums, up, next);
    ANY(sums);
    (void)invcali_ridged_inverse(&sums);
}
