/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "evidence.h"
#include "invcal/quality.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 2000 -eva-slevel-merge-after-loop @all
// trusted: 2
// A NaN fails dof >= 2, which this Eva does not know. The nominal matrix had an inverse when the
// settings were checked, and they have not changed since.

void main(void)
{
    invcal_residuals residuals;
    invcal_settings settings;
    invcal_solution solution;
    invcal_quality quality;
    invcal_verdict verdict;
    unsigned used;
    invcal_real number;
    invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    ANY(residuals);
    ANY(settings);
    ANY(solution);
    ANY(verdict);
    ANY(used);
    ANY(number);
    (void)invcal_assess(&residuals, used, &settings, &solution, &quality);
    (void)invcal_covariance(&residuals, &settings, number, K);
    (void)invcal_coverage(number);
    (void)invcal_verdict_text(verdict);
}
