/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/criteria.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000

void main(void)
{
    invcal_normal design;
    invcal_real vertical[3];
    invcal_criteria criteria;

    ANY(design);
    ANY(vertical);
    (void)invcal_criteria_judge(&design, &criteria);
    (void)invcal_criteria_add(&design, vertical);
}
