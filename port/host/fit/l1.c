/* SPDX-License-Identifier: MIT */
#include "fit/l1.h"

#include <math.h>
#include <stddef.h>

#define TURNS 200u
#define FINEST 1e-3 /* of the mean absolute residual: smaller ones weigh as this */
#define LEAST 1e-15 /* over the field: readings without any noise */

/* |calibrated|^2 - 1, half of it: the residual of the row but for a factor that all rows share. */
static double residual(const invcal_calibration *c, const double raw[3])
{
    double v[3];

    invcal_apply(c, raw, v);
    return fabs(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - 1) / 2;
}

static double mean_residual(const double *raw, unsigned count, const invcal_calibration *nominal,
                            const invcal_calibration *c)
{
    double sum = 0;
    unsigned used = 0;
    invcal_row row;

    for (unsigned i = 0; i < count; i++) {
        if (invcal_observe(nominal, &raw[3 * (size_t)i], &row) == INVCAL_OK) {
            sum += residual(c, &raw[3 * (size_t)i]);
            used++;
        }
    }
    return sum / used + LEAST;
}

/* Weighted by what c leaves; all alike without c. */
static invcal_status solve(const double *raw, unsigned count, const invcal_calibration *nominal,
                           const invcal_calibration *c, double usual, invcal_calibration *out)
{
    invcal_sums sums;
    invcal_row row;

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < count; i++) {
        const double *u = &raw[3 * (size_t)i];
        if (invcal_observe(nominal, u, &row) == INVCAL_OK) {
            invcal_sums_add_row(&sums, &row, c ? usual / fmax(residual(c, u), FINEST * usual) : 1);
        }
    }
    return invcal_solve(&sums, nominal, out);
}

invcal_status l1_fit(const double *raw, unsigned count, const invcal_calibration *nominal,
                     double x[INVCAL_PARAMETERS])
{
    invcal_calibration c;
    invcal_status status = solve(raw, count, nominal, NULL, 1, &c);

    for (unsigned turn = 0; turn < TURNS && status == INVCAL_OK; turn++) {
        const invcal_calibration last = c;
        status = solve(raw, count, nominal, &last, mean_residual(raw, count, nominal, &last), &c);
    }
    if (status == INVCAL_OK) {
        invcal_deviation(&c, nominal, x);
    }
    return status;
}
