/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/expert.h"
#include "core/solve.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-split-return full

void main(void)
{
    invcal_sums sums;
    invcal_calibration nominal;
    invcal_calibration out;
    invcal_real p[INVCAL_PARAMETERS];
    invcal_real m[3][3];
    invcal_real c[3][3];
    invcal_real work[INVCAL_WORK];

    ANY(sums);
    ANY(nominal);
    ANY(p);
    ANY(m);
    (void)invcali_cofactors((const invcal_real(*)[3])m, c);
    invcali_inverse3((const invcal_real(*)[3])m, c);
    invcali_make_symmetric(m, work);
    (void)invcali_ellipsoid(p, work, &out);
    (void)invcali_triad(p, &out);
    ANY(out);
    (void)invcali_compose(&nominal, &out);
    (void)invcal_sums_solve(&sums, &nominal, &out);
    (void)invcal_sums_solve(&sums, &nominal, &nominal);
}
