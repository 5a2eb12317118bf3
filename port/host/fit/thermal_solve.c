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

invcal_positions thermal_positions(const rejection *kept, const fit_settings *settings)
{
    invcal_positions given =
        fit_positions(kept->kept, kept->kept_count, &settings->nominal, settings->noise);

    given.temperature = kept->temperature;
    return given;
}

invcal_status thermal_solve(const rejection *kept, const fit_settings *settings,
                            const thermal_options *options, invcal_thermal *out,
                            invcal_quality *quality)
{
    const invcal_positions given = thermal_positions(kept, settings);
    invcal_thermal_prior prior;

    const int is_known = thermal_prior(settings, options, &prior);
    return invcal_thermal_fit(&given, is_known ? &prior : NULL, NULL, options->degree, out,
                              quality);
}
