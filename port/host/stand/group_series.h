/* SPDX-License-Identifier: MIT
 *
 * stand/group_series.h: the paper's series of each group (series.h), fitted to readings at any
 * angles.
 *
 * The fifteen coefficients of the three groups determine the nine parameters, six of them twice:
 * offset and scale error of x in groups 2 and 3, of y in 1 and 3, of z in 1 and 2. A closure is the
 * difference between the two values, a check that no single group can make.
 *
 *     parameter   one group                        the other
 *     delta_x     -b1 of group 2                   b1 of group 3
 *     delta_y     a1 of group 1                    a1 of group 3
 *     delta_z     b1 of group 1                    -a1 of group 2
 *     dk_x        a0 - a2 of group 2               a0 - a2 of group 3
 *     dk_y        a0 + a2 of group 1               a0 + a2 of group 3
 *     dk_z        a0 - a2 of group 1               a0 + a2 of group 2
 *
 * Everything is in the frame of the stand, in which the groups are circles.
 */
#ifndef GROUP_SERIES_H
#define GROUP_SERIES_H

#include "invcal/plan.h"
#include "stand/mounting.h"
#include "design/series.h"

enum { GROUP_SERIES_CLOSURES = 6 }; /* delta_x ... dk_z, in the order of the parameters */

typedef struct {
    unsigned count[INVCAL_PLAN_GROUPS];    /* positions in the group */
    int is_determined[INVCAL_PLAN_GROUPS]; /* its positions determine its five coefficients */
    double coefficient[INVCAL_PLAN_GROUPS][SERIES_TERMS]; /* a0 a1 b1 a2 b2 */
    double root[INVCAL_PLAN_GROUPS][SERIES_TERMS];        /* their standard deviations / noise */
    int has_closures; /* all three groups are determined; else nothing below is known */
    double closure[GROUP_SERIES_CLOSURES];      /* value of the second group minus the first */
    double closure_root[GROUP_SERIES_CLOSURES]; /* its standard deviation / noise */
    double by_group[GROUP_SERIES_CLOSURES][2];  /* the two values, groups as in the table */
    double x[INVCAL_PARAMETERS];      /* the nine parameters: weighted fit to all coefficients */
    double x_root[INVCAL_PARAMETERS]; /* their standard deviations / noise */
    double noise; /* of J1 over the field, from the residuals of the nine; NaN: unknown */
    unsigned dof; /* degrees of freedom of the fifteen coefficients; those of the nine are 6 more */
    double f;     /* mean square of the closures / that of the residuals of the fifteen */
    double chance; /* probability of an f this large by noise alone; NaN if dof is 0 */
} group_series;

/* Finds the group of each position from its angles, 1 ... 3; 0: none. Group 1 has beta = 0, group 2
 * alpha = -90, group 3 beta = 90 degrees. Where two groups meet, the position belongs to that of
 * its neighbour.
 *
 * group  out: count of them. */
void group_series_groups(const mounting_position *p, unsigned count, unsigned *group);

/* Fits the coefficients. Positions that are left out or in no group are not used.
 *
 * m        the mounting R: J1 = u (R eta) - 1, the projection of a reading u on the true up
 *          direction.
 * nominal  input units to multiples of the field. */
void group_series_find(const mounting_position *p, const unsigned *group, unsigned count,
                       const mounting *m, const invcal_calibration *nominal, group_series *out);

#endif
