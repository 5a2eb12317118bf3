/* SPDX-License-Identifier: MIT
 *
 * The paper's own solution, on a stand: J1 (vertical composition) or J2 (scalar composition) of
 * each position with the row h(eta), and X = (H'H)^-1 H'J (mathematics.md, "The paper's two
 * compositions"). J2 is half of the paper's, which lacks a factor 2 in J2 = hX: so one row serves
 * both. Sums and system are those of the exact row, which has the opposite sign: p = -X.
 */
#include <string.h>

#include "directions.h"
#include "../core/solve.h"
#include "../core/sums.h"
#include "../core/vector.h"

void invcal_directions_init(invcal_directions *directions)
{
    INVCAL_ASSERT(directions);
    invcal_sums_init(&directions->sums);
}

/* h(eta), and J1 of the reading u, or J2: that of an exact row. The exact row comes first: it also
 * refuses what is not a reading. */
static invcal_status add_along(invcal_directions *directions, const invcal_calibration *nominal,
                               const invcal_real mean[3], const invcal_real eta[3], int is_vertical)
{
    invcali_row row;

    INVCAL_ASSERT(directions && nominal && mean && eta);
    const invcal_status status = invcali_observe(nominal, mean, &row);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!invcali_is_unit(eta)) {
        return INVCAL_BAD_DIRECTION;
    }
    if (is_vertical) {
        row.h[INVCAL_J] = invcali_dot3(row.h, eta) - 1;
    }
    memcpy(row.h, eta, 3 * sizeof *eta);
    invcali_row_of(row.h);
    invcali_sums_add_row(&directions->sums, &row, 1);
    return INVCAL_OK;
}

invcal_status invcal_directions_add(invcal_directions *directions,
                                    const invcal_calibration *nominal, const invcal_real mean[3],
                                    const invcal_real eta[3])
{
    return add_along(directions, nominal, mean, eta, 1);
}

invcal_status invcali_directions_add_scalar(invcal_directions *directions,
                                            const invcal_calibration *nominal,
                                            const invcal_real mean[3], const invcal_real eta[3])
{
    return add_along(directions, nominal, mean, eta, 0);
}

invcal_status invcal_directions_solve(invcal_directions *directions,
                                      const invcal_calibration *nominal, invcal_calibration *out,
                                      invcal_real x[INVCAL_PARAMETERS])
{
    invcal_calibration c;

    INVCAL_ASSERT(directions && nominal && out && x);
    invcal_real *a = directions->sums.sum;
    invcal_real *p = &a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)];
    if (directions->sums.count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_status status =
        invcali_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_back_substitute(a, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        p[r] = -p[r]; /* X = -p */
    }
    status = invcali_triad(p, &c);
    if (status == INVCAL_OK) {
        status = invcali_compose(nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c;
        memcpy(x, p, INVCAL_PARAMETERS * sizeof *x);
    }
    return status;
}
