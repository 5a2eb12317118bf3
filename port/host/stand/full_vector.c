/* SPDX-License-Identifier: MIT
 *
 * All three readings of a position against its known direction, u = M eta + delta (mathematics.md,
 * "The full vector"). The rows (eta 1) are the same for all three axes: one 4x4 factor serves them,
 * with one right side for each. The polar decomposition of M then separates the sensor, I + S, from
 * its mounting, R.
 */
#include "stand/full_vector.h"

#include <limits.h>
#include <string.h>

#include "core/solve.h"
#include "core/sums.h"
#include "core/vector.h"

enum { OF_AXIS = 4, OF_ROW = OF_AXIS + 3 }; /* unknowns of an axis: a row of M, and delta */

#define LEAST_DET 1e-3 /* of det M: invcali_triad wants as much of det (I + S) */

void full_vector_init(full_vector *full)
{
    *full = (full_vector){{0}, 0};
}

invcal_status full_vector_add(full_vector *full, const invcal_calibration *nominal,
                              const double raw[3], const double eta[3])
{
    double row[OF_ROW];
    invcali_row observed;

    const invcal_status status = invcali_observe(nominal, raw, &observed);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!invcali_is_unit(eta)) {
        return INVCAL_BAD_DIRECTION;
    }
    for (unsigned i = 0; i < 3; i++) {
        row[i] = eta[i];
        row[OF_AXIS + i] = observed.h[i];
    }
    row[3] = 1;
    invcali_rank_one(full->sum, row, OF_ROW, 1);
    full->count += full->count < UINT_MAX;
    return INVCAL_OK;
}

/* M and delta, one axis at a time, as the row after the system, where invcali_back_substitute
 * expects it. It solves A p = -b, hence the signs. */
static void solve_axes(double *a, double m[3][3], double delta[3])
{
    double *p = &a[INVCAL_PACKED(OF_AXIS, 0)];

    for (unsigned axis = 0; axis < 3; axis++) {
        if (axis > 0) {
            memcpy(p, &a[INVCAL_PACKED(OF_AXIS + axis, 0)], OF_AXIS * sizeof *p);
        }
        invcali_back_substitute(a, OF_AXIS);
        for (unsigned i = 0; i < 3; i++) {
            m[axis][i] = -p[i];
        }
        delta[axis] = -p[3];
    }
}

/* I + S = p; the mean with p' removes rounding. */
static void parameters_of(const double p[3][3], const double delta[3], double x[INVCAL_PARAMETERS])
{
    memcpy(&x[INVCAL_DELTA_X], delta, 3 * sizeof *delta);
    for (unsigned i = 0; i < 3; i++) {
        x[INVCAL_DK_X + i] = p[i][i] - 1;
    }
    x[INVCAL_GAMMA_XY] = p[0][1] + p[1][0];
    x[INVCAL_GAMMA_XZ] = p[0][2] + p[2][0];
    x[INVCAL_GAMMA_ZY] = p[2][1] + p[1][2];
}

/* M = (I + S) R; the calibrated R'A u is M^-1 u. X is found first, and passes the same limits as
 * that of lengths (invcali_triad). `full` is overwritten as work space. */
invcal_status full_vector_solve(full_vector *full, const invcal_calibration *nominal,
                                invcal_calibration *out, double x[INVCAL_PARAMETERS],
                                double mounting[3][3])
{
    double m[3][3];
    double found[INVCAL_PARAMETERS];
    invcal_calibration c;

    double *work = full->sum;
    if (full->count < OF_AXIS) {
        return INVCAL_TOO_FEW;
    }
    invcal_status status = invcali_factor(work, OF_AXIS, OF_ROW, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    solve_axes(work, m, c.offset);
    if (!(invcali_cofactors((const double(*)[3])m, (double(*)[3])work) > LEAST_DET)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    memcpy(c.matrix, m, sizeof m);
    invcali_make_symmetric(c.matrix, work);
    parameters_of((const double(*)[3])c.matrix, c.offset, found);
    status = invcali_triad(found, &c);
    if (status == INVCAL_OK) {
        invcali_inverse3((const double(*)[3])m, c.matrix);
        status = invcali_compose(nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c;
        memcpy(x, found, sizeof found);
        memcpy(mounting, work, 9 * sizeof *work);
    }
    return status;
}
