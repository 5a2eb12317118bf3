/* SPDX-License-Identifier: MIT */
#include "calibrate/solve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/result.h"
#include "calibrate/cross_check.h"
#include "calibrate/gyro.h"
#include "calibrate/nonlinear.h"
#include "calibrate/refuse.h"
#include "calibrate/resolve.h"
#include "cli/command.h"
#include "cli/message.h"
#include "fit/fit_drift.h"
#include "result/calibration_file.h"
#include "text/number.h"

static double residual_of_nominal(const positions *data, const invcal_calibration *nominal)
{
    double squares = 0;

    for (unsigned n = 0; n < data->count; n++) {
        double v[3];
        invcal_apply(nominal, data->mean[3 * (size_t)n], data->mean[3 * (size_t)n + 1],
                     data->mean[3 * (size_t)n + 2], v);
        const double r = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
        squares += r * r;
    }
    return sqrt(squares / data->count);
}

static int refuse(const request *r, calibrate_result *result, invcal_status status,
                  const fit_reason *reason)
{
    return status == INVCAL_TOO_FEW && rejection_drifting(&result->rejected) > 0
               ? calibrate_refuse_drift(result)
               : calibrate_refuse(result, &r->stand, status, reason);
}

/* Copies the systematic errors that the outlier search found into the quality. */
static void adopt_findings(calibrate_result *result)
{
    const invcal_quality *found = &result->rejected.found;
    fit_quality *q = &result->quality;

    if (!result->rejected.is_judged) {
        return;
    }
    q->systematic = found->systematic;
    q->axis = found->axis;
    q->size = found->size;
    q->unchecked = found->unchecked;
    q->dof -= found->positions - INVCAL_PARAMETERS - found->dof; /* repeated directions */
    if (found->verdict > q->verdict) {
        q->verdict = found->verdict;
    }
}

/* Fits a drift that was found. If residuals remain, it was not a drift but, say, a step. */
static void fit_drift(calibrate_result *result)
{
    rejection *r = &result->rejected;
    double *tau = calloc((size_t)r->kept_count + 1, sizeof *tau);
    fit_solution solution;
    fit_quality q;

    for (unsigned k = 0; tau && k < r->kept_count; k++) {
        tau[k] = calibrate_tau(result->data, rejection_original(r, k));
    }
    if (tau && isfinite(tau[0]) && !fit_has_prior(&result->settings) &&
        fit_drift_make(r->kept, tau, r->kept_count, &result->settings, &solution, &q, result->drift,
                       result->drift_sigma) == INVCAL_OK) {
        result->is_drift_fitted = q.verdict != INVCAL_ROUGH;
        if (result->is_drift_fitted) {
            result->solution = solution;
            result->quality = q;
        } else {
            r->found.systematic = INVCAL_NO_SYSTEMATIC;
            r->found.verdict = INVCAL_ROUGH;
        }
    }
    free(tau);
}

/* Fits nine parameters. */
static int solve_plain(const request *r, calibrate_result *result)
{
    fit_reason reason;
    const int failure = rejection_find(&result->rejected, result->data, &result->settings,
                                       r->value[OPT_KEEP_ALL] != NULL);

    if (failure) {
        return failure;
    }
    const invcal_status status =
        fit_make(result->rejected.kept, result->rejected.kept_count, &result->settings,
                 &result->solution, &result->quality, &reason);
    if (status != INVCAL_OK) {
        reason.position = rejection_original(&result->rejected, reason.position);
        return refuse(r, result, status, &reason);
    }
    if (result->rejected.is_judged && result->rejected.found.verdict == INVCAL_DRIFTING) {
        fit_drift(result);
    }
    const int failed = r->degree > 0 ? calibrate_nonlinear(result, r->degree) : EXIT_GOOD;
    adopt_findings(result);
    return failed;
}

/* Fits them as functions of temperature. */
static int solve_thermal(const request *r, calibrate_result *result)
{
    invcal_status status;
    fit_reason reason;

    if (!result->data->has_temperature) {
        message("%s: --thermal needs a column of temperature in °C, K or °F: name it temperature, "
                "or leave out --thermal",
                result->data->name);
        return EXIT_FILE;
    }
    const int failure = thermal_fit_make(&result->fit, result->data, &result->settings, &r->thermal,
                                         &result->rejected, &status, &reason);
    if (failure) {
        return failure;
    }
    if (status != INVCAL_OK) {
        return refuse(r, result, status, &reason);
    }
    result->temperature = CALIBRATE_THERMAL;
    result->solution = result->fit.solution;
    result->quality = result->fit.quality;
    return EXIT_GOOD;
}

/* Finds what --thermal 1 would find, with an outlier search of its own. */
static int probe_temperature(calibrate_result *result)
{
    const thermal_options options = {.degree = 1};
    rejection rejected = {0};
    invcal_status status = INVCAL_TOO_FEW;
    fit_reason reason;
    int failure = EXIT_GOOD;

    if (result->data->has_temperature) {
        failure = thermal_fit_make(&result->fit, result->data, &result->settings, &options,
                                   &rejected, &status, &reason);
        result->temperature = status == INVCAL_OK ? CALIBRATE_PROBED : CALIBRATE_PLAIN;
        rejection_free(&rejected);
    }
    return failure;
}

/* Accuracy of lengths, 95 %, without the error of the field. */
static double accuracy_of(const fit_quality *q)
{
    invcal_quality quality = {.held = q->from_prior,
                              .sigma_dof = (uint16_t)fmin(UINT16_MAX, q->sigma_dof)};

    memcpy(quality.sigma, q->sigma, sizeof quality.sigma);
    return invcal_accuracy(&quality, 0);
}

/* An error of the field is a common error of all three scales. */
static void add_field_sigma(const request *r, calibrate_result *result)
{
    result->field_sigma = r->field_sigma / result->settings.field;
    result->is_field_stated = r->value[OPT_GRAVITY] || r->value[OPT_LATITUDE];
    for (unsigned p = INVCAL_DK_X; p <= INVCAL_DK_Z; p++) {
        double *sigma = &result->quality.sigma[p];
        *sigma = sqrt(*sigma * *sigma + result->field_sigma * result->field_sigma);
    }
}

/* Results from the angles of the stand, for readings without drift. */
static int find_stand(const request *r, calibrate_result *result)
{
    const rejection *kept = &result->rejected;
    const double noise = calibrate_knows_noise(result) ? result->quality.noise : NUMBER_UNKNOWN;
    double *raw = calloc(3 * (size_t)kept->kept_count + 1, sizeof *raw);
    int failure = EXIT_FILE;

    for (unsigned k = 0; raw && k < kept->kept_count; k++) {
        calibrate_linear_reading(result, rejection_original(kept, k), &raw[3 * (size_t)k]);
    }
    if (raw) {
        failure = stand_find(&result->stand, &r->stand, result->data, kept, raw,
                             &result->settings.nominal, noise);
    }
    free(raw);
    if (!failure && r->stand.is_frame && result->stand.convention != STAND_AS_STATED) {
        return calibrate_refuse_frame(result);
    }
    if (!failure && r->stand.is_frame) {
        stand_turn(&result->stand, &result->solution.calibration);
        result->is_stand_frame = 1;
    }
    return failure;
}

/* Turns the result to the axes of the case, by the positions whose up axis was stated. */
static int find_case(const request *r, calibrate_result *result)
{
    const rejection *kept = &result->rejected;
    const double noise = calibrate_knows_noise(result) ? result->quality.noise : NUMBER_UNKNOWN;
    invcal_frame frame;
    invcal_status status = INVCAL_OK;

    invcal_frame_init(&frame);
    for (unsigned k = 0; k < kept->kept_count && status == INVCAL_OK; k++) {
        double raw[3];
        const unsigned number = rejection_original(kept, k);
        calibrate_linear_reading(result, number, raw);
        status = case_add(&frame, &r->up_axes, number, &result->solution.calibration, raw);
    }
    status = status == INVCAL_OK ? case_solve(&frame, &r->up_axes, noise, &result->frame) : status;
    if (status != INVCAL_OK) {
        return calibrate_refuse_case(result, status);
    }
    invcal_rotate(&result->solution.calibration, &result->frame.rotation);
    return EXIT_GOOD;
}

/* Fills in what follows from the solution. */
static void complete(const request *r, const positions *data, calibrate_result *result)
{
    result->accuracy = accuracy_of(&result->quality);
    add_field_sigma(r, result);
    result->quality.worst = rejection_original(&result->rejected, result->quality.worst);
    result->residual_before = residual_of_nominal(data, &result->settings.nominal);
}

int solve_positions(const request *r, const positions *data, const gyro_log *gyro,
                    calibrate_result *result)
{
    int failure = stand_check(&r->stand, data);
    failure = failure ? failure : resolve_nominal(r, result);
    failure = failure ? failure : resolve_check_size(r, result);
    result->settings.nominal = fit_over_field(&result->nominal.calibration, r->settings.field);
    failure = failure ? failure : resolve_noise(r, data, result);
    failure = failure                 ? failure
              : r->value[OPT_THERMAL] ? solve_thermal(r, result)
                                      : solve_plain(r, result);
    failure = calibrate_gyro(r, gyro, failure, result);
    failure = failure || r->value[OPT_THERMAL] ? failure : probe_temperature(result);
    failure = failure || !r->stand.is_wanted ? failure : find_stand(r, result);
    failure = failure || r->up_axes.count == 0 ? failure : find_case(r, result);
    if (failure) {
        return failure;
    }
    calibrate_gyro_turn(result);
    result->is_robust_wanted = r->value[OPT_ROBUST] != NULL;
    if (result->is_robust_wanted) {
        cross_check(result);
    }
    complete(r, data, result);
    return EXIT_GOOD;
}

/* The rotation to the axes of the accelerometer. */
static int find_axes(const request *r, calibrate_result *result)
{
    const char *path = r->value[OPT_WITH];
    dip_frame *dip = &result->dip;
    static calibration_file file; /* large */
    int failure = path ? calibration_file_read_correction(path, &file) : EXIT_GOOD;

    if (!failure && path && file.is_magnetometer) {
        return message_usage(
            r->syntax->command,
            "--with %s: is a calibration of a magnetometer: give that of the accelerometer", path);
    }
    failure = failure ? failure
                      : dip_frame_find(result->magnetometer, path ? &file.calibration : NULL, dip);
    if (failure) {
        return failure;
    }
    if ((path && dip->answer == DIP_NO_ACCELEROMETER) ||
        (r->wants_accelerometer_axes && dip->answer != DIP_FOUND)) {
        return calibrate_refuse_axes(result);
    }
    if (r->wants_accelerometer_axes) {
        invcal_rotate(&result->solution.calibration, &dip->rotation);
        result->is_dip_frame = 1;
    }
    return EXIT_GOOD;
}

/* --need of a magnetometer: % of the field, or a number in the unit of the readings. */
static void resolve_need(const request *r, calibrate_result *result)
{
    const double field = result->settings.field;

    if (r->value[OPT_NEED] && strchr(r->value[OPT_NEED], '%')) {
        result->need *= field / r->settings.field;
    } else if (r->value[OPT_NEED]) {
        result->need_unit = (display_unit){field, calibrate_field_unit(result)};
    }
}

int solve_magnetometer(const request *r, const positions *data, calibrate_result *result)
{
    const magnetometer_log *m = result->magnetometer;
    const int is_scaled = r->value[OPT_LSB] || r->value[OPT_NOMINAL];

    result->is_field_measured = !r->value[OPT_GRAVITY];
    if (result->is_field_measured) {
        result->settings.field = m->found.field;
    } else if (!is_scaled) {
        result->nominal.lsb = NOMINAL_RANGE;
        for (unsigned i = 0; i < 3; i++) {
            result->nominal.calibration.matrix[i][i] = r->settings.field / m->found.field;
        }
    }
    result->settings.nominal = fit_over_field(&result->nominal.calibration, result->settings.field);
    const int failure = rejection_find(&result->rejected, data, &result->settings, 1);
    if (failure) {
        return failure;
    }
    result->solution = fit_solution_of(&m->calibration, &result->settings);
    result->quality = fit_quality_of(&m->quality, &result->settings, &result->solution);
    result->quality.condition = m->quality.condition;
    complete(r, data, result);
    resolve_need(r, result);
    return find_axes(r, result);
}
