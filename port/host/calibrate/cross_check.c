/* SPDX-License-Identifier: MIT */
#include "calibrate/cross_check.h"

#include <math.h>

/* Sigma of a parameter from the stated noise, even if the residuals are larger: an outlier may be
 * the reason. */
static double sigma_of(const calibrate_result *r, unsigned p)
{
    const double times = calibrate_noise_ratio(r);

    return r->quality.sigma[p] / (times > 1 ? times : 1);
}

void cross_check(calibrate_result *r)
{
    r->has_robust =
        l1_fit(r->data->mean, r->data->count, &r->settings.nominal, r->robust) == INVCAL_OK;
    for (unsigned p = 0; p < INVCAL_PARAMETERS && r->has_robust; p++) {
        const double off = fabs(r->robust[p] - r->solution.x[p]) / (L1_DIFFERENCE * sigma_of(r, p));
        if (!(off <= r->robust_max)) {
            r->robust_max = off;
            r->robust_worst = p;
        }
    }
}
