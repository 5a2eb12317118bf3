/* SPDX-License-Identifier: MIT */
#include "fit/thermal_solve.h"

#include <string.h>

int thermal_prior(const fit_settings *settings, const thermal_options *options,
                  invcal_thermal_prior *prior)
{
    int is_known = fit_has_prior(settings);

    memset(prior, 0, sizeof *prior);
    memcpy(prior->sigma[0], settings->prior, sizeof prior->sigma[0]);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        prior->sigma[1][r] = options->slope[r / 3];
        is_known = is_known || prior->sigma[1][r] > 0;
    }
    return is_known;
}

invcal_thermal_positions thermal_positions(const rejection *kept, const fit_settings *settings)
{
    return (invcal_thermal_positions){.raw = kept->kept,
                                      .temperature = kept->temperature,
                                      .count = kept->kept_count,
                                      .noise = settings->noise};
}

invcal_status thermal_solve(const rejection *kept, const fit_settings *settings,
                            const thermal_options *options, invcal_thermal *out,
                            invcal_quality *quality)
{
    const invcal_thermal_positions given = thermal_positions(kept, settings);
    invcal_thermal_prior prior;

    const invcal_status status =
        invcal_thermal_start(&settings->nominal, kept->temperature, kept->kept_count, out);
    if (status != INVCAL_OK) {
        return status;
    }
    const invcal_thermal_prior *known = thermal_prior(settings, options, &prior) ? &prior : NULL;
    return invcal_thermal_fit(&given, known, out, options->degree, out, quality);
}
