/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/solution.h"
#include "triad.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all

void main(void)
{
    invcal_normal normal;
    invcal_settings settings;
    invcal_solution solution;
    invcal_triad triad;
    invcal_real noise;
    invcal_real p[INVCAL_PARAMETERS];
    invcal_real inverse[3][3];
    invcal_real s[6];
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    ANY(normal);
    ANY(settings);
    ANY(noise);
    ANY(p);
    (void)invcal_solve(&normal, &settings, &solution);
    (void)invcal_undetermined(&normal);
    (void)invcal_settings_check(&settings);
    (void)invcal_has_prior(&settings);
    invcal_information(&normal, &settings, &noise, hth);
    (void)invcal_information_factor(&normal, &settings, &noise, hth);
    (void)invcal_triad_of_linear(p, &triad);
    (void)invcal_triad_of_ellipsoid(p, &triad);
    ANY(triad);
    ANY(inverse);
    (void)invcal_triad_join(&triad, &settings, inverse, &solution);
    ANY(solution);
    invcal_solution_deviation(&solution, s);
}
