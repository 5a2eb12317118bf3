/* SPDX-License-Identifier: MIT */
#include "fit/fit_drift.h"

#include "fit/fit_extended.h"

static double at(const fit_extension *self, unsigned position, unsigned kind, double eta)
{
    (void)kind;
    (void)eta;
    return self->tau[position];
}

invcal_status fit_drift_make(const double *raw, const double *tau, unsigned count,
                             const fit_settings *settings, fit_solution *solution,
                             fit_quality *quality, double drift[3], double sigma[3])
{
    const fit_extension extension = {.kinds = 1, .value = at, .tau = tau};

    return fit_extended_make(raw, count, settings, &extension, solution, quality, drift, sigma);
}
