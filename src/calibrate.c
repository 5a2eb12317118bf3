/* SPDX-License-Identifier: MIT */
#include "invcal/calibrate.h"

#include <stddef.h>

/* First pass: the normal equations of all positions. */
static invcal_status accumulate(const invcal_real *raw, unsigned count,
                                const invcal_settings *settings, invcal_normal *normal,
                                unsigned *position)
{
    invcal_real u[3];
    invcal_observation row;
    const invcal_real *mean = raw;

    for (*position = 0; *position < count; ++*position, mean += 3) {
        invcal_status status =
            invcal_observation_reading(&settings->nominal, settings->field, mean, u);
        if (status == INVCAL_OK) {
            status = invcal_observation_exact(u, &row);
        }
        if (status == INVCAL_OK) {
            status = invcal_normal_add(normal, &row, 1);
        }
        if (status != INVCAL_OK) {
            return status;
        }
    }
    return INVCAL_OK;
}

/* The weight of a position that is kept; 0: left out. */
static invcal_real weight_of(const invcal_positions *positions, unsigned i)
{
    return positions->weight ? positions->weight[i] : 1;
}

/* Second pass: the residuals of the solution. */
static invcal_status compare(const invcal_positions *positions, const invcal_settings *settings,
                             const invcal_solution *solution, invcal_residuals *residuals)
{
    invcal_real u[3];

    invcal_residuals_init(residuals, solution);
    for (unsigned i = 0; i < positions->count; i++) {
        const invcal_real weight = weight_of(positions, i);
        if (!(weight > 0)) {
            continue;
        }
        if (invcal_observation_reading(&settings->nominal, settings->field,
                                       &positions->raw[3 * (size_t)i], u) != INVCAL_OK ||
            invcal_residuals_add(residuals, u, weight, NULL) != INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* a reading fit for the first pass, absurd after it */
        }
    }
    return INVCAL_OK;
}

static invcal_status solve_and_assess(const invcal_normal *normal,
                                      const invcal_positions *positions,
                                      const invcal_settings *settings, invcal_solution *solution,
                                      invcal_quality *quality, invcal_real *gain)
{
    invcal_residuals residuals;
    invcal_status status = invcal_solve(normal, settings, solution);

    if (status == INVCAL_NOT_ELLIPSOID && invcal_undetermined(normal)) {
        return INVCAL_UNDETERMINED; /* what is left open may take any shape */
    }
    if (status == INVCAL_OK) {
        status = compare(positions, settings, solution, &residuals);
    }
    if (status == INVCAL_OK) {
        status = invcal_assess(&residuals, normal->count, settings, solution, quality);
        *gain = residuals.gain;
    }
    return status;
}

/* The data may be noisier than stated: then the prior counts for more, and the solution is made
 * once more. Whether residuals or the user told the noise was decided the first time. */
static invcal_status weigh_prior_again(const invcal_normal *normal,
                                       const invcal_positions *positions,
                                       const invcal_settings *settings, invcal_solution *solution,
                                       invcal_quality *quality, invcal_real gain)
{
    const invcal_real coverage = quality->coverage;
    const invcal_real observed = quality->noise * settings->field / gain;
    invcal_settings noisier = *settings;

    noisier.noise = observed < settings->field ? observed : settings->field;
    const invcal_status status =
        solve_and_assess(normal, positions, &noisier, solution, quality, &gain);
    if (status == INVCAL_OK) {
        quality->coverage = coverage;
    }
    return status;
}

/* The n-th position that is not left out. */
static unsigned nth_kept(const invcal_positions *positions, unsigned n)
{
    unsigned i = 0;

    while (!(weight_of(positions, i) > 0) || n-- > 0) {
        i++;
    }
    return i;
}

invcal_status invcal_calibrate_sums(const invcal_normal *normal, const invcal_positions *positions,
                                    const invcal_settings *settings, invcal_solution *solution,
                                    invcal_quality *quality)
{
    invcal_solution s;
    invcal_quality q;
    invcal_real gain;

    INVCAL_ASSERT(normal && positions && settings && solution && quality);
    invcal_status status = invcal_settings_check(settings);
    if (status == INVCAL_OK) {
        status = solve_and_assess(normal, positions, settings, &s, &q, &gain);
    }
    if (status == INVCAL_OK && invcal_has_prior(settings)) {
        status = weigh_prior_again(normal, positions, settings, &s, &q, gain);
    }
    if (status == INVCAL_OK) {
        q.worst = nth_kept(positions, q.worst);
        *solution = s;
        *quality = q;
    }
    return status;
}

invcal_status invcal_calibrate(const invcal_real *raw, unsigned count,
                               const invcal_settings *settings, invcal_solution *solution,
                               invcal_quality *quality, invcal_reason *reason)
{
    const invcal_positions positions = {raw, NULL, count};
    invcal_normal normal;
    unsigned position = count;

    INVCAL_ASSERT((raw || count == 0) && settings && solution && quality);
    invcal_normal_init(&normal);
    invcal_status status = invcal_settings_check(settings);
    if (status == INVCAL_OK) {
        status = accumulate(raw, count, settings, &normal, &position);
    }
    if (status == INVCAL_OK) {
        status = invcal_calibrate_sums(&normal, &positions, settings, solution, quality);
    }
    if (status != INVCAL_OK && reason) {
        reason->position = position;
        reason->undetermined = invcal_undetermined(&normal);
    }
    return status;
}
