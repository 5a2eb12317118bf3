/* SPDX-License-Identifier: MIT */
#include "invcal/series.h"

#include <string.h>

#include "invcal/cholesky.h"
#include "vector.h"

#define LARGEST_SIGNAL INVCAL_REAL(100.0) /* j of a reading ten times the field is 49.5 */

/* 1, cos, sin, cos 2, sin 2 of the angle that the position's group turns. Cosine and sine stand
 * in the vertical: group 1 (0, cos, sin), group 2 (-sin, 0, -cos), group 3 (sin, cos, 0). */
static void terms(const invcal_plan_position *p, invcal_real t[INVCAL_SERIES_TERMS])
{
    const invcal_real *eta = p->vertical;
    const invcal_real c = p->group == 2 ? -eta[2] : eta[1];
    const invcal_real s = p->group == 1 ? eta[2] : p->group == 2 ? -eta[0] : eta[0];

    t[0] = 1;
    t[1] = c;
    t[2] = s;
    t[3] = c * c - s * s;
    t[4] = 2 * s * c;
}

invcal_status invcal_series_init(invcal_series *series, const invcal_plan *plan)
{
    INVCAL_ASSERT(series && plan);
    const invcal_status status = invcal_plan_check(plan);

    if (status == INVCAL_OK) {
        memset(series, 0, sizeof *series);
        series->plan = *plan;
    }
    return status;
}

invcal_status invcal_series_add(invcal_series *series, invcal_real j)
{
    invcal_plan_position position;
    invcal_real t[INVCAL_SERIES_TERMS];

    INVCAL_ASSERT(series);
    if (!(INVCAL_FABS(j) <= LARGEST_SIGNAL)) {
        return invcal_is_finite(j) ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
    }
    const invcal_status status = invcal_plan_position_at(&series->plan, series->next, &position);
    if (status != INVCAL_OK) {
        return status;
    }
    terms(&position, t);
    for (unsigned i = 0; i < INVCAL_SERIES_TERMS; i++) {
        series->sum[position.group - 1][i] += t[i] * j;
    }
    series->next++;
    return INVCAL_OK;
}

/* (H5'H5)^-1 H5'J with H5'H5 = diag(N, N/2, N/2, N/2, N/2). */
invcal_status
invcal_series_coefficients(const invcal_series *series,
                           invcal_real coefficient[INVCAL_PLAN_GROUPS][INVCAL_SERIES_TERMS])
{
    INVCAL_ASSERT(series && coefficient);
    const invcal_real n = (invcal_real)series->plan.per_group;

    if (series->next < INVCAL_PLAN_GROUPS * series->plan.per_group) {
        return INVCAL_TOO_FEW;
    }
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        for (unsigned i = 0; i < INVCAL_SERIES_TERMS; i++) {
            coefficient[g][i] = series->sum[g][i] / (i == 0 ? n : n / 2);
        }
    }
    return INVCAL_OK;
}

/* The scale errors from the a0 = (dk_p + dk_q)/2 and a2 = (dk_p - dk_q)/2 of three groups, which
 * have the weights N and N/2:
 *
 *     minimise  sum over groups of  N (a0 - (dk_p + dk_q)/2)^2 + N/2 (a2 - (dk_p - dk_q)/2)^2
 *
 * gives the normal equations  N/8 (5 I + 11') dk = N rho  with  rho_p = sum (a0/2 + a2/4),
 * rho_q = sum (a0/2 - a2/4), and so  dk = 8/5 (rho - 1 (rho_x + rho_y + rho_z)/8). */
static void scale_errors(invcal_real (*c)[INVCAL_SERIES_TERMS], invcal_real dk[3])
{
    const invcal_real rho[3] = {
        (c[1][0] + c[2][0]) / 2 - (c[1][3] + c[2][3]) / 4, /* x: q of groups 2 and 3 */
        (c[0][0] + c[2][0]) / 2 + (c[0][3] + c[2][3]) / 4, /* y: p of groups 1 and 3 */
        (c[0][0] + c[1][0]) / 2 - (c[0][3] - c[1][3]) / 4, /* z: q of group 1, p of group 2 */
    };
    const invcal_real share = (rho[0] + rho[1] + rho[2]) / 8;

    for (unsigned i = 0; i < 3; i++) {
        dk[i] = INVCAL_REAL(1.6) * (rho[i] - share);
    }
}

invcal_status invcal_series_solve(const invcal_series *series, invcal_real x[INVCAL_PARAMETERS])
{
    enum { A1 = 1, B1 = 2, B2 = 4 };
    invcal_real c[INVCAL_PLAN_GROUPS][INVCAL_SERIES_TERMS];

    INVCAL_ASSERT(x);
    const invcal_status status = invcal_series_coefficients(series, c);
    if (status == INVCAL_OK) {
        x[INVCAL_DELTA_X] = (-c[1][B1] + c[2][B1]) / 2; /* each offset is felt in two groups */
        x[INVCAL_DELTA_Y] = (c[0][A1] + c[2][A1]) / 2;
        x[INVCAL_DELTA_Z] = (c[0][B1] - c[1][A1]) / 2;
        scale_errors(c, &x[INVCAL_DK_X]);
        x[INVCAL_GAMMA_XY] = 2 * c[2][B2];
        x[INVCAL_GAMMA_XZ] = 2 * c[1][B2];
        x[INVCAL_GAMMA_ZY] = 2 * c[0][B2];
    }
    return status;
}

invcal_status
invcal_series_information(const invcal_plan *plan, unsigned group,
                          invcal_real information[INVCAL_PACKED_SIZE(INVCAL_SERIES_TERMS)])
{
    invcal_plan_position position;
    invcal_real t[INVCAL_SERIES_TERMS];

    INVCAL_ASSERT(plan && information);
    const invcal_status status = invcal_plan_check(plan);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!(group >= 1 && group <= INVCAL_PLAN_GROUPS)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_SERIES_TERMS); i++) {
        information[i] = 0;
    }
    for (unsigned k = 0; k < plan->per_group; k++) {
        (void)invcal_plan_position_at(plan, (group - 1) * plan->per_group + k, &position);
        //@ assert \initialized(&position);
        terms(&position, t);
        for (unsigned r = 0; r < INVCAL_SERIES_TERMS; r++) {
            for (unsigned c = 0; c <= r; c++) {
                information[INVCAL_PACKED(r, c)] += t[r] * t[c];
            }
        }
    }
    return INVCAL_OK;
}

/* The determinant is the product of the pivots, bounded by that of the diagonal N, N/2 ... */
invcal_real
invcal_series_efficiency(invcal_real information[INVCAL_PACKED_SIZE(INVCAL_SERIES_TERMS)])
{
    INVCAL_ASSERT(information);
    const invcal_real n = information[0];
    invcal_real ratio = 1;

    if (invcal_cholesky_factor(information, INVCAL_SERIES_TERMS, INVCAL_PIVOT_FLOOR) != INVCAL_OK) {
        return 0;
    }
    for (unsigned r = 0; r < INVCAL_SERIES_TERMS; r++) {
        const invcal_real root = information[INVCAL_PACKED(r, r)];
        ratio *= root * root / (r == 0 ? n : n / 2);
    }
    return ratio;
}
