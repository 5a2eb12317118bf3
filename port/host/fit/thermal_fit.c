/* SPDX-License-Identifier: MIT */
#include "fit/thermal_fit.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "maths/eigen.h"
#include "maths/f_tail.h"
#include "maths/matrix.h"
#include "text/number.h"
#include "fit/thermal_rejection.h"
#include "core/system.h"

#define USUAL_NOISE 1e-4 /* of a position mean, over field */
#define USUAL_SLOPE 1e-3 /* of an offset, 1/K */

/* The prior was weighted with the noise of the residuals. It determines a parameter more than the
 * positions do if more than half of its variance remains. */
static void settle_prior(thermal_fit *fit, const invcal_quality *q)
{
    fit->has_prior = thermal_prior(&fit->settings, &fit->options, &fit->prior);
    if (fit->has_prior) {
        fit->settings.noise = fmax(fit->settings.noise, q->noise);
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double prior = fit->prior.sigma[0][r];
        if (prior > 0 && 2 * q->sigma[r] * q->sigma[r] > prior * prior) {
            fit->quality.from_prior |= (uint16_t)(1u << r);
        }
    }
}

static void find_covariance(thermal_fit *fit, const rejection *kept)
{
    double nine[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    fit->quality.condition = INVCAL_REAL_MAX;
    if (thermal_rows_covariance(&fit->calibration, kept, &fit->prior, fit->quality.noise,
                                fit->covariance)) {
        memcpy(nine, fit->covariance, sizeof nine);
        fit->quality.condition = eigen_condition(nine, INVCAL_PARAMETERS); /* also of its inverse */
    }
}

/* Slopes at the reference. Their sigma in calibrated units is converted with the ratio that holds
 * for the parameter itself. */
static void find_slopes(thermal_fit *fit)
{
    const double span = fit->calibration.span;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const unsigned s = INVCAL_PARAMETERS + r;
        fit->slope[r] = fit->slope_sigma[r] = 0;
        if (fit->calibration.fitted > 0) {
            const double ratio = fit->quality.sigma[r] / sqrt(fit->covariance[INVCAL_PACKED(r, r)]);
            fit->slope[r] = fit->calibration.x[1][r] / span;
            fit->slope_sigma[r] = ratio * sqrt(fit->covariance[INVCAL_PACKED(s, s)]) / span;
        }
    }
}

/* Fits the nine parameters only; Fisher's F shows whether the difference may be chance. */
static void compare_without(thermal_fit *fit, const rejection *kept)
{
    const unsigned more = INVCAL_PARAMETERS * fit->calibration.fitted;
    const unsigned used = INVCAL_PARAMETERS + more;
    fit_quality nine;

    fit->significance = 1;
    fit->without = NUMBER_UNKNOWN;
    if (fit_make(kept->kept, kept->kept_count, &fit->settings, &fit->nine, &nine, NULL) !=
        INVCAL_OK) {
        return;
    }
    fit->without = nine.rms;
    if (more > 0 && kept->kept_count > used && nine.rms > 0) {
        const double ratio = fit->quality.rms / nine.rms;
        fit->significance = f_tail(ratio * ratio, more, kept->kept_count - used);
    }
}

static fit_solution solution_at(const thermal_fit *fit, double temperature)
{
    const invcal_thermal *c = &fit->calibration;
    invcal_calibration here =
        fit->solution.symmetric; /* if invcal_thermal_at fails, which it should not */
    invcal_thermal_place place;

    (void)invcal_thermal_at(c, temperature, &here, &place);
    return fit_solution_of(&here, &fit->settings);
}

static void complete(thermal_fit *fit, const rejection *kept, const invcal_quality *q)
{
    fit->solution = solution_at(fit, fit->calibration.reference);
    fit->quality = fit_quality_of(q, &fit->settings, &fit->solution);
    settle_prior(fit, q);
    find_covariance(fit, kept);
    find_slopes(fit);
    compare_without(fit, kept);
}

/* The reason, whose position is a number among all positions. */
static invcal_status explain(const thermal_fit *fit, const rejection *kept, invcal_status status,
                             fit_reason *reason)
{
    invcal_status why = fit_explain(kept->kept, kept->kept_count, &fit->settings, status, reason);

    if (status == INVCAL_BAD_TEMPERATURE) {
        why = INVCAL_NOT_FINITE;
        for (reason->position = 0; isfinite(kept->temperature[reason->position]);) {
            reason->position++;
        }
    }
    reason->position = rejection_original(kept, reason->position);
    return why;
}

/* The max drift of temperature in a rest, K: 2 noise / slope. The error of a thermometer that lags
 * behind the sensor is at most half the drift, and its effect then at most the noise of a position.
 * (The drift itself does no harm: the mean reading belongs to the mean temperature.) 0: not known. */
static double drift_limit(double noise, double slope)
{
    return 2 * (noise > 0 ? noise : USUAL_NOISE) / (slope > 0 ? slope : USUAL_SLOPE);
}

int thermal_fit_make(thermal_fit *fit, const positions *p, const fit_settings *settings,
                     const thermal_options *options, rejection *rejected, invcal_status *status,
                     fit_reason *reason)
{
    const double steepest = fmax(options->slope[0], fmax(options->slope[1], options->slope[2]));
    invcal_quality q;

    *fit = (thermal_fit){.options = *options, .settings = *settings};
    fit->drift_limit = drift_limit(settings->noise, steepest);
    int failure = rejection_begin(rejected, p, settings, options->keep_all);
    if (failure) {
        return failure;
    }
    if (!options->keep_all) {
        thermal_rejection_drifting(rejected, p, fit->drift_limit);
        thermal_rejection_find(rejected, p, settings, options);
    }
    rejection_finish(rejected, p);
    *status = thermal_solve(rejected, settings, options, &fit->calibration, &q);
    if (*status == INVCAL_OK) {
        complete(fit, rejected, &q);
    } else {
        *status = explain(fit, rejected, *status, reason);
    }
    return EXIT_GOOD;
}

invcal_calibration thermal_fit_at(const thermal_fit *fit, double temperature)
{
    return solution_at(fit, temperature).calibration;
}

void thermal_fit_to_reference(const thermal_fit *fit, const double raw[3], double temperature,
                              double out[3])
{
    const invcal_calibration here = thermal_fit_at(fit, temperature);
    const invcal_calibration *reference = &fit->solution.calibration;
    double inverse[3][3] = {{0}};
    double v[3];

    invcal_apply(&here, raw[0], raw[1], raw[2], v);
    (void)matrix_inverse(reference, inverse); /* it exists, as readings gave this matrix */
    for (unsigned i = 0; i < 3; i++) {
        out[i] = reference->offset[i] + inverse[i][0] * v[0] + inverse[i][1] * v[1] +
                 inverse[i][2] * v[2];
    }
}

void thermal_fit_judge(const thermal_fit *fit, const rejection *kept, double temperature,
                       fit_solution *solution, fit_quality *quality)
{
    const invcal_positions given = thermal_positions(kept, &fit->settings);
    invcal_quality q;

    *solution = solution_at(fit, temperature);
    *quality = fit->quality;
    if (invcal_thermal_judge(&given, fit->has_prior ? &fit->prior : NULL, &fit->calibration,
                             temperature, &q) == INVCAL_OK) {
        memcpy(quality->sigma, q.sigma, sizeof quality->sigma);
    }
}
