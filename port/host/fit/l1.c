/* SPDX-License-Identifier: MIT */
#include "fit/l1.h"

#include <math.h>
#include <stddef.h>

#include "invcal/expert.h"
#include "invcal/result.h"
#include "core/sums.h"

#define ITERATIONS 200u
#define RESIDUAL_MIN 1e-3 /* over the mean absolute residual: smaller ones are weighted like this */
#define NOISE_MIN 1e-15   /* over the field, for readings without any noise */

/* Half of |calibrated|^2 - 1: the residual of the row, up to a factor common to all rows. */
static double residual(const invcal_calibration *c, const double raw[3])
{
    double v[3];

    invcal_apply(c, raw[0], raw[1], raw[2], v);
    return fabs(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - 1) / 2;
}

static double mean_residual(const double *raw, unsigned count, const invcal_calibration *nominal,
                            const invcal_calibration *c)
{
    double sum = 0;
    unsigned used = 0;
    invcali_row row;

    for (unsigned i = 0; i < count; i++) {
        if (invcali_observe(nominal, &raw[3 * (size_t)i], &row) == INVCAL_OK) {
            sum += residual(c, &raw[3 * (size_t)i]);
            used++;
        }
    }
    return sum / used + NOISE_MIN;
}

/* Solves with weights by the residuals of c; equal weights if c is null. */
static invcal_status solve(const double *raw, unsigned count, const invcal_calibration *nominal,
                           const invcal_calibration *c, double mean, invcal_calibration *out)
{
    invcal_sums sums;
    invcali_row row;

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < count; i++) {
        const double *u = &raw[3 * (size_t)i];
        if (invcali_observe(nominal, u, &row) == INVCAL_OK) {
            invcali_sums_add_row(&sums, &row,
                                 c ? mean / fmax(residual(c, u), RESIDUAL_MIN * mean) : 1);
        }
    }
    return invcal_sums_solve(&sums, nominal, out);
}

invcal_status l1_fit(const double *raw, unsigned count, const invcal_calibration *nominal,
                     double x[INVCAL_PARAMETERS])
{
    invcal_calibration c;
    invcal_status status = solve(raw, count, nominal, NULL, 1, &c);

    for (unsigned iteration = 0; iteration < ITERATIONS && status == INVCAL_OK; iteration++) {
        const invcal_calibration last = c;
        status = solve(raw, count, nominal, &last, mean_residual(raw, count, nominal, &last), &c);
    }
    if (status == INVCAL_OK) {
        invcal_deviation(&c, nominal, x);
    }
    return status;
}
