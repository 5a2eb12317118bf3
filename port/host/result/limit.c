/* SPDX-License-Identifier: MIT
 *
 * Uncertainty of the result, and what limits it.
 */
#include <math.h>
#include <string.h>

#include "result/result.h"
#include "maths/f_tail.h"
#include "text/figure.h"
#include "maths/matrix.h"

#define SIGNIFICANCE 0.05
#define ITERATIONS 20u          /* each leaves a few percent of the error of the one before */
#define NOISE_DOF 60u           /* degrees of freedom assumed for the noise of the samples */
#define SLOPE_SIGNIFICANCE 0.01 /* of slopes over temperature */
#define UNEVEN_RATIO 2.0 /* ratio of the worst sigma to that of as many well-spread positions */

int calibrate_lacks_slopes(const calibrate_result *r)
{
    return r->temperature == CALIBRATE_THERMAL && r->fit.calibration.fitted == 0 &&
           r->quality.verdict == INVCAL_WEAK && r->quality.weak == (1u << INVCAL_PARAMETERS) - 1;
}

double calibrate_slope_scale(const calibrate_result *r, unsigned parameter)
{
    return parameter >= INVCAL_GAMMA_XY || nominal_knows(&r->nominal, INVCAL_DK_X)
               ? 1
               : 1 / (1 + r->solution.x[INVCAL_DK_X + parameter % 3]);
}

invcal_calibration calibrate_at_temperature(const calibrate_result *r, double temperature)
{
    return r->temperature == CALIBRATE_THERMAL ? thermal_fit_at(&r->fit, temperature)
                                               : r->solution.calibration;
}

invcal_calibration calibrate_at_position(const calibrate_result *r, unsigned position)
{
    return calibrate_at_temperature(r, r->data->origin[position].temperature);
}

void calibrate_remove_drift(const calibrate_result *r, double tau, double reading[3])
{
    double inverse[3][3];

    if (r->is_drift_fitted && matrix_inverse(&r->settings.nominal, inverse)) {
        for (unsigned i = 0; i < 3; i++) {
            for (unsigned j = 0; j < 3; j++) {
                reading[i] -= tau * inverse[i][j] * r->drift[j];
            }
        }
    }
}

/* Removes quadratic and cubic errors. They depend on the direction of the corrected reading
 * (nonlinearity.h), so the correction is iterated. */
static void remove_nonlinearity(const calibrate_result *r, double reading[3])
{
    const double measured[3] = {reading[0], reading[1], reading[2]};
    double inverse[3][3];

    if (r->degree == 0 || !matrix_inverse(&r->settings.nominal, inverse)) {
        return;
    }
    for (unsigned step = 0; step < ITERATIONS; step++) {
        double eta[3];
        double error[3];
        invcal_apply(&r->solution.symmetric, reading[0], reading[1], reading[2], eta);
        for (unsigned a = 0; a < 3; a++) {
            const double cubic = r->degree > 2 ? r->nonlinear[3 + a] : 0;
            error[a] = eta[a] * eta[a] * (r->nonlinear[a] + cubic * eta[a]);
        }
        for (unsigned a = 0; a < 3; a++) {
            const double *n = inverse[a];
            reading[a] = measured[a] - (n[0] * error[0] + n[1] * error[1] + n[2] * error[2]);
        }
    }
}

void calibrate_linear_reading(const calibrate_result *r, unsigned position, double out[3])
{
    memcpy(out, &r->data->mean[3 * (size_t)position], 3 * sizeof *out);
    calibrate_remove_drift(r, calibrate_tau(r->data, position), out);
    remove_nonlinearity(r, out);
}

double calibrate_excess(const calibrate_result *r, unsigned position)
{
    const invcal_calibration here = calibrate_at_position(r, position);
    double v[3];

    calibrate_linear_reading(r, position, v);
    invcal_apply(&here, v[0], v[1], v[2], v);
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
}

void calibrate_reference_reading(const calibrate_result *r, unsigned kept, double out[3])
{
    const double *mean = &r->rejected.kept[3 * (size_t)kept];

    if (r->temperature == CALIBRATE_THERMAL) {
        thermal_fit_to_reference(&r->fit, mean, r->rejected.temperature[kept], out);
    } else {
        memcpy(out, mean, 3 * sizeof *out);
    }
}

void calibrate_with_moves(const calibrate_result *result, fit_settings *with)
{
    *with = result->settings;
    for (unsigned p = INVCAL_GAMMA_XY; p < INVCAL_PARAMETERS && result->is_joint; p++) {
        with->prior[p] = result->quality.sigma[p];
    }
}

void calibrate_uncertainty(const calibrate_result *r, double unit, uncertainty *u)
{
    if (r->temperature == CALIBRATE_THERMAL) { /* the first nine are those at the reference */
        memcpy(u->covariance, r->fit.covariance, sizeof u->covariance);
    } else {
        fit_settings with;
        calibrate_with_moves(r, &with);
        fit_information(r->rejected.kept, r->rejected.kept_count, &with, &r->solution,
                        r->quality.noise, u->covariance);
        (void)matrix_invert_packed(u->covariance,
                                   INVCAL_PARAMETERS); /* regular, or there would be no result */
    }
    u->unit = unit;
    uncertainty_search(u);
}

/* 1 if a ratio of observed to expected noise is significantly above 1 (more than twice the
 * variance). */
static int is_beyond(const calibrate_result *r, double times)
{
    const unsigned dof = (unsigned)fmin(1000, r->quality.dof);

    return dof >= 1 && times * times > 2 &&
           f_tail(1 / (1 + times * times * dof / NOISE_DOF), dof, NOISE_DOF) <= SIGNIFICANCE;
}

int calibrate_is_coarse(const calibrate_result *r)
{
    const double *square = r->data->noise_square;
    const double noise = positions_noise(r->data, &r->settings.nominal);

    return !r->magnetometer && r->data->floor_square > (square[0] + square[1] + square[2]) / 6 &&
           noise > 0 && !is_beyond(r, r->quality.noise / noise);
}

int calibrate_is_disturbed(const calibrate_result *r)
{
    return is_beyond(r, calibrate_noise_ratio(r)) && !calibrate_is_coarse(r);
}

/* Sigma of the length in the worst direction over the minimum that is possible with as many
 * positions, sqrt(9 / n) times their noise. With a parabola over three temperatures, only a third
 * of the positions count at the middle one. */
static double unevenness(const calibrate_result *r, const uncertainty *length)
{
    const int is_parabola = r->temperature == CALIBRATE_THERMAL && r->fit.calibration.fitted == 2;
    const double count = r->rejected.kept_count / (is_parabola ? 3.0 : 1.0);

    return length->max / length->unit / sqrt((double)INVCAL_PARAMETERS / count);
}

int calibrate_is_uneven(const calibrate_result *r)
{
    uncertainty length;

    calibrate_uncertainty(r, 1, &length);
    return unevenness(r, &length) >= UNEVEN_RATIO && !fit_has_prior(&r->settings);
}

static int depends_on_temperature(const calibrate_result *r)
{
    return r->temperature == CALIBRATE_PROBED && r->fit.significance <= SLOPE_SIGNIFICANCE;
}

/* The quantisation step of a reading over the field, mean over the axes. */
static double step_of(const calibrate_result *r)
{
    const double(*m)[3] = (const double(*)[3])r->settings.nominal.matrix;

    return r->data->quantum * (fabs(m[0][0]) + fabs(m[1][1]) + fabs(m[2][2])) / 3;
}

const char *calibrate_limit(const calibrate_result *r, const uncertainty *length,
                            char text[CALIBRATE_LIMIT_MAX])
{
    const double uneven = unevenness(r, length);
    const char *noise = r->is_noise_given ? "stated noise" : "noise of the samples";
    const display_unit display = calibrate_display_unit(r);
    char number[FIGURE_MAX];

    if (depends_on_temperature(r) && r->fit.without > 2 * r->fit.quality.rms) {
        snprintf(text, CALIBRATE_LIMIT_MAX, "temperature, which --thermal would correct.");
    } else if (calibrate_lacks_slopes(r)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "temperature: the slopes are not fitted, and appear as other errors.");
    } else if (fit_held(&r->settings, &r->quality)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "the angles, which these positions do not determine; add positions midway between "
                 "two axes.");
    } else if (uneven >= UNEVEN_RATIO && !fit_has_prior(&r->settings)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "the orientations%s: in the worst direction (%s), ± is %s times that of %u "
                 "well-spread positions.",
                 r->temperature == CALIBRATE_THERMAL ? " at each temperature" : "",
                 length->worst_words, figure_digits(uneven, 2, number), r->rejected.kept_count);
    } else if (r->magnetometer) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "%s. A log four times as long, turned to all sides, halves ±, except for what "
                 "differs from place to place.",
                 r->quality.sigma_dof > r->quality.dof
                     ? "errors that neighbouring samples share"
                     : "disagreement between cells, beyond the noise of their samples");
    } else if (!(r->settings.noise > 0)) {
        snprintf(text, CALIBRATE_LIMIT_MAX, "%s",
                 r->quality.dof > 0 ? "disagreement between positions. State the noise (--noise, "
                                      "columns std and n) to see if it is noise or handling."
                                    : "unknown: no noise is stated, and there is no redundancy.");
    } else if (calibrate_is_coarse(r)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "quantisation: the readings have steps of %s %s, more than their noise, which "
                 "explains the residuals. More positions help, or a smaller range of the sensor; "
                 "longer or steadier rests do not.",
                 figure_digits(display.scale * step_of(r), 2, number), display.unit);
    } else if (calibrate_is_disturbed(r)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "handling, drift or temperature: the positions disagree by %s times the %s. "
                 "Steadier rests help; longer ones do not.",
                 figure_digits(r->quality.noise / r->settings.noise, 2, number), noise);
    } else {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "the %s, which explains the residuals. To halve ±, make the rests four times as "
                 "long, or take four times as many positions.",
                 noise);
    }
    return text;
}

/* ---- effect of temperature, without --thermal ----------------------------------------------- */

/* The offset with the steepest slope. */
static unsigned steepest_offset(const thermal_fit *fit)
{
    unsigned steepest = 0;

    for (unsigned r = 1; r < 3; r++) {
        steepest = fabs(fit->slope[r]) > fabs(fit->slope[steepest]) ? r : steepest;
    }
    return steepest;
}

const char *calibrate_temperature_advice(const calibrate_result *r, char text[CALIBRATE_LIMIT_MAX])
{
    const thermal_fit *fit = &r->fit;
    const double range = fit->calibration.max - fit->calibration.min;
    const display_unit display = unit_style_page_field(r->units, calibrate_is_gravity(r));
    const unsigned steepest = steepest_offset(fit);
    const double scale = display.scale * calibrate_slope_scale(r, steepest);
    char before[FIGURE_MAX];
    char after[FIGURE_MAX];
    char slope[FIGURE_MAX];

    text[0] = '\0';
    if (r->temperature != CALIBRATE_PROBED) {
        return text;
    }
    if (fit->calibration.fitted == 0) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "Dependence on temperature cannot be tested: %s (%.1f K, %u positions).",
                 invcal_thermal_fallback_text(fit->calibration.fallback), range, r->data->count);
    } else if (!depends_on_temperature(r)) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "The residuals do not depend on temperature over %.1f K (p = %.2g): --thermal "
                 "would not help.",
                 range, fit->significance);
    } else {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "The residuals depend on temperature (p = %.1g); offset %c drifts by %s %s/K (95 "
                 "%%). --thermal 1 reduces their rms from %s to %s %s.",
                 fmax(1e-99, fit->significance), "xyz"[steepest],
                 figure_with_sigma(scale * fit->slope[steepest],
                                   scale * fit->quality.coverage * fit->slope_sigma[steepest],
                                   FIGURE_SIGNED, slope),
                 display.unit, figure_digits(display.scale * fit->without, 3, before),
                 figure_digits(display.scale * fit->quality.rms, 3, after), display.unit);
    }
    return text;
}
