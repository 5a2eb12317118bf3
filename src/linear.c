/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "solve.h"
#include "sums.h"
#include "vector.h"

#define ON_UNIT INVCAL_REAL(2e-4) /* of the square of a direction's length: 1e-4 of the length */
#define LONGEST INVCAL_REAL(10.0) /* semi-axis of I + S, and centre */
#define SHORTEST INVCAL_REAL(0.1) /* semi-axis */

void invcal_linear_init(invcal_linear_sums *linear)
{
    INVCAL_ASSERT(linear);
    invcal_sums_init(&linear->sums);
}

/* The reading u, and h(eta). */
static invcal_status observe_along(const invcal_calibration *nominal, const invcal_real raw[3],
                                   const invcal_real eta[3], invcal_real u[3], invcal_row *row)
{
    const invcal_status status = invcal_observe(nominal, raw, row);

    if (status != INVCAL_OK) {
        return status;
    }
    if (!(INVCAL_FABS(invcal_dot3(eta, eta) - 1) <= ON_UNIT)) {
        return INVCAL_BAD_DIRECTION;
    }
    memcpy(u, row->h, 3 * sizeof u[0]);
    invcal_row_of(eta, row->h);
    return INVCAL_OK;
}

invcal_status invcal_linear_add_vertical(invcal_linear_sums *linear,
                                         const invcal_calibration *nominal,
                                         const invcal_real raw[3], const invcal_real eta[3])
{
    invcal_real u[3];
    invcal_row row;

    INVCAL_ASSERT(linear && nominal && raw && eta);
    const invcal_status status = observe_along(nominal, raw, eta, u, &row);
    if (status == INVCAL_OK) {
        row.h[INVCAL_J] = invcal_dot3(u, eta) - 1;
        invcal_sums_add_row(&linear->sums, &row, 1);
    }
    return status;
}

invcal_status invcal_linear_add_scalar(invcal_linear_sums *linear,
                                       const invcal_calibration *nominal, const invcal_real raw[3],
                                       const invcal_real eta[3])
{
    invcal_real u[3];
    invcal_row row;

    INVCAL_ASSERT(linear && nominal && raw && eta);
    const invcal_status status =
        observe_along(nominal, raw, eta, u, &row); /* j: that of an exact row */
    if (status == INVCAL_OK) {
        invcal_sums_add_row(&linear->sums, &row, 1);
    }
    return status;
}

/* Are the semi-axes of P within their limits? They are if P - 0.1 I and 10 I - P are positive
 * definite. */
static int is_triad(const invcal_real p[3][3])
{
    invcal_real above[INVCAL_PACKED_SIZE(3)];
    invcal_real below[INVCAL_PACKED_SIZE(3)];

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j <= i; j++) {
            above[INVCAL_PACKED(i, j)] = p[i][j];
            below[INVCAL_PACKED(i, j)] = -p[i][j];
        }
    }
    invcal_add_ridge(above, 3, -SHORTEST);
    invcal_add_ridge(below, 3, LONGEST);
    return invcal_factor(above, 3, 3, 0) == INVCAL_OK && invcal_factor(below, 3, 3, 0) == INVCAL_OK;
}

/* X to the calibration of u: A = (I + S)^-1. */
static invcal_status correct(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *c)
{
    const invcal_real xy = x[INVCAL_GAMMA_XY] / 2;
    const invcal_real xz = x[INVCAL_GAMMA_XZ] / 2;
    const invcal_real zy = x[INVCAL_GAMMA_ZY] / 2;
    const invcal_real p[3][3] = {{1 + x[INVCAL_DK_X], xy, xz},
                                 {xy, 1 + x[INVCAL_DK_Y], zy},
                                 {xz, zy, 1 + x[INVCAL_DK_Z]}}; /* I + S */

    if (!is_triad(p) || !(invcal_dot3(x, x) < LONGEST * LONGEST)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    const invcal_real det = invcal_cofactors(p, c->matrix);
    for (unsigned i = 0; i < 3; i++) {
        c->offset[i] = x[i];
        for (unsigned j = 0; j < 3; j++) {
            c->matrix[i][j] /= det;
        }
    }
    return INVCAL_OK;
}

invcal_status invcal_linear_solve(invcal_linear_sums *linear, const invcal_calibration *nominal,
                                  invcal_calibration *out, invcal_real x[INVCAL_PARAMETERS])
{
    invcal_calibration triad;
    invcal_calibration c;

    INVCAL_ASSERT(linear && nominal && out && x);
    invcal_real *a = linear->sums.sum;
    invcal_real *p = &a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)];
    if (linear->sums.count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(&linear->sums);
    invcal_status status = invcal_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_back_substitute(a, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        p[r] = -p[r]; /* X = -p */
    }
    status = correct(p, &triad);
    if (status == INVCAL_OK) {
        status = invcal_behind(nominal, &triad, &c);
    }
    if (status == INVCAL_OK) {
        *out = c;
        memcpy(x, p, INVCAL_PARAMETERS * sizeof *x);
    }
    return status;
}
