/* SPDX-License-Identifier: MIT
 *
 * stand/group_series.h: the paper's series of each group (series.h), from what was measured at any angles.
 *
 * Fifteen coefficients of three groups determine nine parameters: six of them twice. The offset of x shows in
 * groups 2 and 3, that of y in 1 and 3, that of z in 1 and 2; and so are the scale errors. That both groups
 * agree is the closure, a check that no single group has.
 *
 *     parameter   one group                        the other
 *     delta_x     -b1 of group 2                   b1 of group 3
 *     delta_y     a1 of group 1                    a1 of group 3
 *     delta_z     b1 of group 1                    -a1 of group 2
 *     dk_x        a0 - a2 of group 2               a0 - a2 of group 3
 *     dk_y        a0 + a2 of group 1               a0 + a2 of group 3
 *     dk_z        a0 - a2 of group 1               a0 + a2 of group 2
 *
 * All of it is in the frame of the stand, in which the groups are circles.
 */
#ifndef GROUP_SERIES_H
#define GROUP_SERIES_H

#include "stand/mounting.h"
#include "design/series.h"

enum { GROUP_SERIES_CLOSURES = 6 }; /* delta_x ... dk_z, in the order of the parameters */

typedef struct {
    unsigned count[INVCAL_PLAN_GROUPS];    /* positions in each, */
    int is_determined[INVCAL_PLAN_GROUPS]; /* and whether they determine its five coefficients */
    double coefficient[INVCAL_PLAN_GROUPS][SERIES_TERMS]; /* a0 a1 b1 a2 b2, */
    double root[INVCAL_PLAN_GROUPS]
               [SERIES_TERMS];             /* and their standard deviations over the noise */
    int is_closed_over;                    /* all three are determined: what follows is known */
    double closure[GROUP_SERIES_CLOSURES]; /* the second group minus the first, */
    double closure_root[GROUP_SERIES_CLOSURES]; /* and its standard deviation over the noise */
    double told[GROUP_SERIES_CLOSURES]
               [2];              /* the result of each of the two groups, as in the table */
    double x[INVCAL_PARAMETERS]; /* the nine parameters, each coefficient by its information, */
    double x_root[INVCAL_PARAMETERS]; /* and their standard deviations over the noise */
    double noise;  /* of J1, by what the nine leave, over the field; NaN: not known */
    unsigned dof;  /* that the fifteen leave; six more with the nine */
    double f;      /* the closures' mean square over that of what the fifteen leave, */
    double chance; /* and the chance that it is as large; NaN for dof 0 */
} group_series;

/* The group of each position by its angles, 1 ... 3, or 0: group 1 has beta = 0, group 3 beta = 90, group 2
 * alpha = -90 degrees. Where two meet, the group of the position before or after counts.
 *
 * group  out, count of them. */
void group_series_groups(const mounting_position *p, unsigned count, unsigned *group);

/* Finds the coefficients, without the positions left out and those of no group.
 *
 * m        how the unit sits: J1 = u (R eta) - 1 is the projection of a reading on where up really was.
 * nominal  raw to over the field. */
void group_series_find(const mounting_position *p, const unsigned *group, unsigned count,
                       const mounting *m, const invcal_calibration *nominal, group_series *out);

#endif
