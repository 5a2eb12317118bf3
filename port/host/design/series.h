/* SPDX-License-Identifier: MIT
 *
 * design/series.h: the nine parameters from the three groups of a program by the paper's
 * trigonometric series, without the 9x9 solve.
 *
 * With the direction known, the compositions J1 and J2 (invcal/expert.h) are h(eta) X, and within a
 * group of Table 1 (invcal/plan.h) that is a series in the angle theta by which the group is
 * turned:
 *
 *     J = a0 + a1 cos theta + b1 sin theta + a2 cos 2 theta + b2 sin 2 theta
 *
 *     group   theta   a0                a1         b1         a2                b2
 *     1       alpha   (dk_y + dk_z)/2   delta_y    delta_z    (dk_y - dk_z)/2   gamma_zy/2
 *     2       beta    (dk_z + dk_x)/2   -delta_z   -delta_x   (dk_z - dk_x)/2   gamma_xz/2
 *     3       alpha   (dk_y + dk_x)/2   delta_y    delta_x    (dk_y - dk_x)/2   gamma_xy/2
 *
 * Derived by inserting eta of each group into h(eta) X, with cos^2 = (1 + cos 2)/2 and so on:
 * group 1 has eta = (0, cos, sin), group 2 (-sin, 0, -cos), group 3 (sin, cos, 0). For a0 of
 * group 1 the paper prints (dk_x + dk_z)/2, a misprint: x reads 0 in that group.
 *
 * N equal steps make the five functions orthogonal, H5'H5 = diag(N, N/2, N/2, N/2, N/2), so each
 * coefficient is one projection, and H5'H5 has the largest determinant that N positions on a circle
 * can have: the D-optimum. Fifteen coefficients, each weighted by its information, give the nine
 * parameters of the same least squares as the 9x9 solve: an independent check of it.
 */
#ifndef SERIES_H
#define SERIES_H

#include "invcal/plan.h"
#include "plan/plan_axes.h"
#include "core/system.h"

#define SERIES_TERMS 5u /* 1, cos, sin, cos 2, sin 2 */

/* Sums of J times each of the five functions, over the positions of each group. */
typedef struct {
    invcal_plan plan;                             /* the program */
    double sum[INVCAL_PLAN_GROUPS][SERIES_TERMS]; /* of J times each function */
    unsigned next;                                /* position, 0 ... 3 N */
} series;

/* The five functions of the angle of a group, 1 ... 3, for one of its directions, whose
 * components are its cosine and sine: group 1 (0, cos, sin), group 2 (-sin, 0, -cos), group 3
 * (sin, cos, 0). */
void series_terms(unsigned group, const double vertical[3], double terms[SERIES_TERMS]);

/* Begins with the first position of a program.
 *
 * Returns as invcali_plan_check. */
invcal_status series_init(series *s, const invcal_plan *plan);

/* Adds the composition J of the next position, J1 or J2.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE if |j| is above 100, impossible for a
 * reading of this field; INVCAL_BAD_COUNT if the program is complete. */
invcal_status series_add(series *s, double j);

/* The coefficients a0 a1 b1 a2 b2 of each group.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW until every position of the program has been added. */
invcal_status series_coefficients(const series *s,
                                  double coefficient[INVCAL_PLAN_GROUPS][SERIES_TERMS]);

/* The nine parameters X = (delta, dk, gamma): to rounding, those of the 9x9 least squares with rows
 * of known direction; J1 exactly, J2 to first order. Returns as series_coefficients. */
invcal_status series_solve(const series *s, double x[INVCAL_PARAMETERS]);

/* H5'H5 of one group of a program, packed (INVCAL_PACKED), summed position by position.
 *
 * group  1 ... 3.
 *
 * Returns as invcali_plan_check; INVCAL_BAD_ANGLE for another group. */
invcal_status series_information(const invcal_plan *plan, unsigned group,
                                 double information[INVCAL_PACKED_SIZE(SERIES_TERMS)]);

/* det(H5'H5) over its upper bound N (N/2)^4: 1 for the D-optimum, else smaller; 0 if it is
 * singular.
 *
 * information  packed, of any n positions on a circle; its first element is n. Overwritten. */
double series_efficiency(double information[INVCAL_PACKED_SIZE(SERIES_TERMS)]);

#endif
