/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/eigen.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000

void main(void)
{
    invcal_real m[6];
    invcal_real a[INVCAL_PACKED_SIZE(INVCAL_MAX_PARAMETERS)];
    invcal_eigen3 axes;
    const unsigned n = BETWEEN(1, INVCAL_MAX_PARAMETERS);

    ANY(m);
    ANY(a);
    invcal_eigen3_decompose(m, &axes);
    //@ split n;
    (void)invcal_condition(a, n);
    (void)invcal_largest_eigenvalue(a, n);
}
