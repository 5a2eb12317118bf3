/* SPDX-License-Identifier: MIT */
#include "calibrate/cross_check.h"

#include <math.h>

/* Sigma of a parameter by the noise that is stated, if the residuals are larger: they may be what is wrong. */
static double sigma_of(const calibrate_result *r, unsigned p)
{
    const double times = calibrate_times(r);

    return r->quality.sigma[p] / (times > 1 ? times : 1);
}

void cross_check(calibrate_result *r)
{
    r->has_robust =
        l1_fit(r->data->mean, r->data->count, &r->settings.nominal, r->robust) == INVCAL_OK;
    for (unsigned p = 0; p < INVCAL_PARAMETERS && r->has_robust; p++) {
        const double off = fabs(r->robust[p] - r->solution.x[p]) / (L1_DIFFERENCE * sigma_of(r, p));
        if (!(off <= r->robust_most)) {
            r->robust_most = off;
            r->robust_worst = p;
        }
    }
}
