/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "solve.h"
#include "sums.h"
#include "vector.h"

#define ON_UNIT INVCAL_REAL(2e-4) /* of the square of a direction's length: 1e-4 of the length */

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
    memcpy(row->h, eta, 3 * sizeof *eta);
    invcal_row_of(row->h);
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

invcal_status invcal_linear_solve(invcal_linear_sums *linear, const invcal_calibration *nominal,
                                  invcal_calibration *out, invcal_real x[INVCAL_PARAMETERS])
{
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
    status = invcal_triad(p, &c);
    if (status == INVCAL_OK) {
        status = invcal_behind(nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c;
        memcpy(x, p, INVCAL_PARAMETERS * sizeof *x);
    }
    return status;
}
