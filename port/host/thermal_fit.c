/* SPDX-License-Identifier: MIT */
#include "thermal_fit.h"

#include <math.h>
#include <string.h>

#include "command.h"
#include "invcal/fisher.h"
#include "number.h"
#include "thermal_rejection.h"
#include "thermal_rows.h"

static invcal_thermal_settings settings_of(const thermal_wish *wish)
{
    invcal_thermal_settings s = {.less = (uint8_t)(INVCAL_THERMAL_DEGREE - wish->degree)};

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        s.slope[r] = wish->slope[r / 3];
    }
    return s;
}

static void find_sums(thermal_fit *fit, const rejection *kept)
{
    invcal_thermal_init(&fit->sums);
    for (unsigned n = 0; n < kept->kept_count; n++) { /* as the fit did: none can fail */
        (void)invcal_thermal_add(&fit->sums, &fit->calibration, &kept->kept[3 * (size_t)n],
                                 kept->temperature[n]);
    }
}

/* A prior was weighed with the noise that the residuals tell. */
static void settle_noise(thermal_fit *fit)
{
    const double observed = fit->quality.noise * fit->settings.field;
    double steepest = 0;

    for (unsigned k = 0; k < 3; k++) {
        steepest = fmax(steepest, fit->wish.slope[k]);
    }
    if (invcal_has_prior(&fit->settings) || steepest > 0) {
        fit->settings.noise = fmin(fit->settings.field, fmax(fit->settings.noise, observed));
    }
}

/* Slopes at the reference. Sigma in calibrated units is made one of the parameter by the ratio
 * that the two have for the parameter itself. */
static void find_slopes(thermal_fit *fit)
{
    const invcal_quality *q = &fit->quality;
    const double *const sigma[3] = {q->sigma_delta, q->sigma_dk, q->sigma_gamma};
    const double span = fit->calibration.span;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const unsigned s = INVCAL_PARAMETERS + r;
        fit->slope[r] = fit->slope_sigma[r] = 0;
        if (fit->calibration.fitted > 0) {
            const double ratio = sigma[r / 3][r % 3] / sqrt(fit->covariance[INVCAL_PACKED(r, r)]);
            fit->slope[r] = fit->calibration.x[1][r] / span;
            fit->slope_sigma[r] = ratio * sqrt(fit->covariance[INVCAL_PACKED(s, s)]) / span;
        }
    }
}

/* The nine parameters alone, and whether the difference may be chance: Fisher's F. */
static void compare_without(thermal_fit *fit, const rejection *kept)
{
    const unsigned more = INVCAL_PARAMETERS * fit->calibration.fitted;
    const unsigned used = INVCAL_PARAMETERS + more;
    invcal_quality nine;

    fit->significance = 1;
    fit->without = NUMBER_UNKNOWN;
    if (invcal_calibrate(kept->kept, kept->kept_count, &fit->settings, &fit->nine, &nine, NULL) !=
        INVCAL_OK) {
        return;
    }
    fit->without = nine.residual_rms;
    if (more > 0 && kept->kept_count > used && nine.residual_rms > 0) {
        const double ratio = fit->quality.residual_rms / nine.residual_rms;
        fit->significance = invcal_fisher_tail(ratio * ratio, more, kept->kept_count - used);
    }
}

static void complete(thermal_fit *fit, const rejection *kept)
{
    invcal_thermal_place place;

    settle_noise(fit);
    find_sums(fit, kept);
    (void)invcal_thermal_at(&fit->calibration, fit->calibration.reference, &fit->solution, &place);
    if (thermal_rows_factor(&fit->calibration, kept, &fit->settings, &fit->thermal,
                            fit->quality.noise, fit->covariance)) {
        invcal_cholesky_inverse(fit->covariance,
                                INVCAL_PARAMETERS * (fit->calibration.fitted + 1u));
    }
    find_slopes(fit);
    compare_without(fit, kept);
}

int thermal_fit_make(thermal_fit *fit, const positions *p, const invcal_settings *settings,
                     const thermal_wish *wish, rejection *rejected, invcal_status *status,
                     invcal_reason *reason)
{
    *fit = (thermal_fit){.wish = *wish, .settings = *settings, .thermal = settings_of(wish)};
    fit->drift_limit = invcal_thermal_drift_limit(&fit->settings, &fit->thermal);
    int failure = rejection_begin(rejected, p, settings, wish->keep_all);
    if (failure) {
        return failure;
    }
    if (!wish->keep_all) {
        thermal_rejection_drifting(rejected, p, fit->drift_limit);
        thermal_rejection_find(rejected, p, settings, &fit->thermal);
    }
    rejection_finish(rejected, p);
    *status = invcal_thermal_calibrate(rejected->kept, rejected->temperature, rejected->kept_count,
                                       &fit->settings, &fit->thermal, &fit->calibration,
                                       &fit->quality, reason);
    if (*status != INVCAL_OK) {
        reason->position = rejection_original(rejected, reason->position);
        return EXIT_GOOD;
    }
    complete(fit, rejected);
    return EXIT_GOOD;
}

invcal_calibration thermal_fit_at(const thermal_fit *fit, double temperature)
{
    invcal_solution solution = fit->solution;
    invcal_thermal_place place;

    (void)invcal_thermal_at(&fit->calibration, temperature, &solution, &place);
    return solution.calibration;
}

void thermal_fit_to_reference(const thermal_fit *fit, const double raw[3], double temperature,
                              double out[3])
{
    const invcal_calibration here = thermal_fit_at(fit, temperature);
    const invcal_calibration *reference = &fit->solution.calibration;
    double inverse[3][3] = {{0}};
    double v[3];

    invcal_apply(&here, raw, v);
    (void)invcal_calibration_inverse(reference, inverse); /* it has been made of readings */
    for (unsigned i = 0; i < 3; i++) {
        out[i] = reference->offset[i] + inverse[i][0] * v[0] + inverse[i][1] * v[1] +
                 inverse[i][2] * v[2];
    }
}

void thermal_fit_judge(const thermal_fit *fit, double temperature, invcal_solution *solution,
                       invcal_quality *quality)
{
    invcal_thermal_place place;

    *solution = fit->solution;
    *quality = fit->quality;
    (void)invcal_thermal_at(&fit->calibration, temperature, solution, &place);
    (void)invcal_thermal_assess(&fit->sums, &fit->calibration, &fit->settings, &fit->thermal,
                                temperature, quality);
}
