/* SPDX-License-Identifier: MIT */
#include "design/series.h"

#include <math.h>
#include <string.h>

#include "design/stand_plan.h"

#define LARGEST_SIGNAL 100.0 /* j of a reading ten times the field is 49.5 */

void series_terms(unsigned group, const double vertical[3], double terms[SERIES_TERMS])
{
    const double c = group == 2 ? -vertical[2] : vertical[1];
    const double s = group == 1 ? vertical[2] : group == 2 ? -vertical[0] : vertical[0];

    terms[0] = 1;
    terms[1] = c;
    terms[2] = s;
    terms[3] = c * c - s * s;
    terms[4] = 2 * s * c;
}

invcal_status series_init(series *s, const invcal_plan *plan)
{
    const invcal_status status = invcali_plan_check(plan);

    if (status == INVCAL_OK) {
        memset(s, 0, sizeof *s);
        s->plan = *plan;
    }
    return status;
}

invcal_status series_add(series *s, double j)
{
    invcal_plan_position position;
    double t[SERIES_TERMS];

    if (!(fabs(j) <= LARGEST_SIGNAL)) {
        return isfinite(j) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
    }
    const invcal_status status = invcal_plan_get(&s->plan, s->next, &position);
    if (status != INVCAL_OK) {
        return status;
    }
    series_terms(position.group, position.up, t);
    for (unsigned i = 0; i < SERIES_TERMS; i++) {
        s->sum[position.group - 1][i] += t[i] * j;
    }
    s->next++;
    return INVCAL_OK;
}

/* (H5'H5)^-1 H5'J with H5'H5 = diag(N, N/2, N/2, N/2, N/2). */
invcal_status series_coefficients(const series *s,
                                  double coefficient[INVCAL_PLAN_GROUPS][SERIES_TERMS])
{
    const double n = (double)s->plan.per_group;

    if (s->next < INVCAL_PLAN_GROUPS * s->plan.per_group) {
        return INVCAL_TOO_FEW;
    }
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        for (unsigned i = 0; i < SERIES_TERMS; i++) {
            coefficient[g][i] = s->sum[g][i] / (i == 0 ? n : n / 2);
        }
    }
    return INVCAL_OK;
}

/* The scale errors from a0 = (dk_p + dk_q)/2 and a2 = (dk_p - dk_q)/2 of the three groups, with the
 * weights N and N/2:
 *
 *     minimise  sum over groups of  N (a0 - (dk_p + dk_q)/2)^2 + N/2 (a2 - (dk_p - dk_q)/2)^2
 *
 * gives the normal equations  N/8 (5 I + 11') dk = N rho  with  rho_p = sum (a0/2 + a2/4),
 * rho_q = sum (a0/2 - a2/4), and so  dk = 8/5 (rho - 1 (rho_x + rho_y + rho_z)/8). */
static void scale_errors(double (*c)[SERIES_TERMS], double dk[3])
{
    const double rho[3] = {
        (c[1][0] + c[2][0]) / 2 - (c[1][3] + c[2][3]) / 4, /* x: q of groups 2 and 3 */
        (c[0][0] + c[2][0]) / 2 + (c[0][3] + c[2][3]) / 4, /* y: p of groups 1 and 3 */
        (c[0][0] + c[1][0]) / 2 - (c[0][3] - c[1][3]) / 4, /* z: q of group 1, p of group 2 */
    };
    const double share = (rho[0] + rho[1] + rho[2]) / 8;

    for (unsigned i = 0; i < 3; i++) {
        dk[i] = 1.6 * (rho[i] - share);
    }
}

invcal_status series_solve(const series *s, double x[INVCAL_PARAMETERS])
{
    enum { A1 = 1, B1 = 2, B2 = 4 };
    double c[INVCAL_PLAN_GROUPS][SERIES_TERMS];

    const invcal_status status = series_coefficients(s, c);
    if (status == INVCAL_OK) {
        x[INVCAL_DELTA_X] = (-c[1][B1] + c[2][B1]) / 2; /* two groups determine each offset */
        x[INVCAL_DELTA_Y] = (c[0][A1] + c[2][A1]) / 2;
        x[INVCAL_DELTA_Z] = (c[0][B1] - c[1][A1]) / 2;
        scale_errors(c, &x[INVCAL_DK_X]);
        x[INVCAL_GAMMA_XY] = 2 * c[2][B2];
        x[INVCAL_GAMMA_XZ] = 2 * c[1][B2];
        x[INVCAL_GAMMA_ZY] = 2 * c[0][B2];
    }
    return status;
}

invcal_status series_information(const invcal_plan *plan, unsigned group,
                                 double information[INVCAL_PACKED_SIZE(SERIES_TERMS)])
{
    double t[SERIES_TERMS];

    const invcal_status status = invcali_plan_check(plan);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!(group >= 1 && group <= INVCAL_PLAN_GROUPS)) {
        return INVCAL_BAD_ANGLE;
    }
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(SERIES_TERMS); i++) {
        information[i] = 0;
    }
    for (unsigned k = 0; k < plan->per_group; k++) {
        const invcal_plan_position position =
            stand_plan_at(plan, (group - 1) * plan->per_group + k);
        series_terms(position.group, position.up, t);
        for (unsigned r = 0; r < SERIES_TERMS; r++) {
            for (unsigned c = 0; c <= r; c++) {
                information[INVCAL_PACKED(r, c)] += t[r] * t[c];
            }
        }
    }
    return INVCAL_OK;
}

/* The determinant is the product of the squared pivots, whose inverses are on the diagonal; the
 * bound is the product of N, N/2 ... */
double series_efficiency(double information[INVCAL_PACKED_SIZE(SERIES_TERMS)])
{
    const double n = information[0];
    double ratio = 1;

    if (invcali_factor(information, SERIES_TERMS, SERIES_TERMS, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    for (unsigned r = 0; r < SERIES_TERMS; r++) {
        const double inverse = information[INVCAL_PACKED(r, r)];
        ratio /= inverse * inverse * (r == 0 ? n : n / 2);
    }
    return ratio;
}
