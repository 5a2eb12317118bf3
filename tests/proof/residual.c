/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/residual.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all

void main(void)
{
    invcal_residuals residuals;
    invcal_solution solution;
    invcal_real u[3];
    invcal_real weight;
    invcal_real residual;

    ANY(solution);
    ANY(u);
    ANY(weight);
    invcal_residuals_init(&residuals, &solution);
    (void)invcal_residuals_add(&residuals, u, weight, NULL);
    ANY(residuals);
    (void)invcal_residuals_add(&residuals, u, weight, &residual);
}
