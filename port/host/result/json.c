/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "result/result.h"
#include "invcal/result.h"
#include "result/faces.h"
#include "result/gyro.h"
#include "text/json_write.h"
#include "result/need.h"
#include "result/pass.h"
#include "text/number.h"
#include "stand/output.h"
#include "result/verdict.h"

/* Three numbers; null if they are not known. */
static void write_known(json_writer *w, const char *name, const double x[3], int known)
{
    const double unknown[3] = {NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN};

    json_vector(w, name, known ? x : unknown);
}

void calibrate_parameters_json(json_writer *w, const calibrate_result *result,
                               const double x[INVCAL_PARAMETERS])
{
    write_known(w, "delta", &x[INVCAL_DELTA_X], nominal_knows(&result->nominal, INVCAL_DELTA_X));
    write_known(w, "dk", &x[INVCAL_DK_X], nominal_knows(&result->nominal, INVCAL_DK_X));
    json_vector(w, "gamma", &x[INVCAL_GAMMA_XY]);
}

static void write_nominal(json_writer *w, const nominal_choice *nominal)
{
    const invcal_calibration *c = &nominal->calibration;
    const double lsb[3] = {c->matrix[0][0], c->matrix[1][1], c->matrix[2][2]};
    int is_diagonal = 1;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            is_diagonal = is_diagonal && (i == j || !(fabs(c->matrix[i][j]) > 0));
        }
    }
    json_object(w, "nominal");
    write_known(w, "zero", c->offset, nominal_knows(nominal, INVCAL_DELTA_X));
    write_known(w, "lsb", lsb, nominal_knows(nominal, INVCAL_DK_X));
    if (!is_diagonal) {
        json_matrix(w, "matrix", c->matrix);
    }
    json_text(w, "zero_from", nominal_origin_name(nominal->zero));
    json_text(w, "lsb_from", nominal_origin_name(nominal->lsb));
    if (nominal->sensor.type) {
        char key[SENSORS_TEXT_MAX];
        json_text(w, "sensor", sensors_key(&nominal->sensor, key));
    }
    json_object_end(w);
}

/* Systematic errors that were found, and those that were not checked. */
static void write_systematic(json_writer *w, const calibrate_result *result)
{
    const fit_quality *q = &result->quality;
    const char axis[] = {(char)('x' + q->axis), '\0'};

    if (q->systematic != INVCAL_NO_SYSTEMATIC) {
        json_object(w, "systematic");
        json_text(w, "kind", verdict_systematic(q->systematic));
        json_text(w, "axis", axis);
        json_number(w, "size", q->size);
        if (result->is_drift_fitted) {
            json_vector(w, "drift", result->drift);
            json_vector(w, "drift_sigma", result->drift_sigma);
        }
        json_object_end(w);
    }
    json_names(w, "unchecked", q->unchecked, INVCAL_HYSTERESIS + 1, verdict_systematic);
}

static void write_quality(json_writer *w, const calibrate_result *result)
{
    const fit_quality *q = &result->quality;
    const int known = calibrate_knows_noise(result);

    json_object(w, "sigma");
    write_known(w, "offset", q->sigma_offset, known);
    write_known(w, "delta", &q->sigma[INVCAL_DELTA_X], known);
    write_known(w, "dk", &q->sigma[INVCAL_DK_X], known);
    write_known(w, "gamma", &q->sigma[INVCAL_GAMMA_XY], known);
    json_object_end(w);
    json_number(w, "interval95", q->coverage);
    json_number(w, "noise", known ? q->noise * result->settings.field : NUMBER_UNKNOWN);
    json_number(w, "degrees_of_freedom", q->dof);
    json_number(w, "residual_rms", q->rms);
    json_number(w, "residual_max", q->max);
    json_number(w, "residual_worst", q->worst + 1.0);
    json_number(w, "residual_before",
                nominal_is_guess(&result->nominal) ? NUMBER_UNKNOWN : result->residual_before);
    json_number(w, "condition", q->condition);
    json_text(w, "verdict", invcal_verdict_text(q->verdict));
    write_systematic(w, result);
    json_parameters(w, "undetermined", q->weak);
}

/* The accuracy of lengths, and what is missing for the need. */
static void write_accuracy(json_writer *w, const calibrate_result *result)
{
    const double field = result->settings.field;
    const int known = calibrate_knows_noise(result);

    json_number(w, "accuracy95", known ? need_accuracy(result) * field : NUMBER_UNKNOWN);
    if (result->need > 0) {
        json_object(w, "need");
        json_number(w, "wanted", result->need);
        json_text(w, "missing", need_word(need_judge(result)));
        json_object_end(w);
    }
}

/* Whether need and limits are met, and by which margin. */
static void write_pass(json_writer *w, const calibrate_result *result)
{
    const pass p = pass_judge(result);

    if (p.limited) {
        json_parameters(w, "beyond", p.beyond);
    }
    if (!p.has_criteria) {
        return;
    }
    json_object(w, "pass");
    json_text(w, "answer", p.is_passed ? "PASS" : "FAIL");
    if (result->need > 0) {
        json_number(w, "need_used", p.need_used);
    }
    if (p.limited) {
        json_nine(w, "limit", p.limit);
        json_nine(w, "used", p.used);
        json_parameters(w, "failed", p.failed);
    }
    json_object_end(w);
}

static void write_source(json_writer *w, uint16_t from_prior)
{
    json_object(w, "source");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        json_text(w, invcal_parameter_text(r), from_prior >> r & 1 ? "prior" : "data");
    }
    json_object_end(w);
}

/* Errors of the positions that were left out. */
static void write_excess(json_writer *w, const calibrate_result *result)
{
    const rejection *r = &result->rejected;

    json_list(w, "rejected_excess");
    for (unsigned i = 0; i < r->count; i++) {
        json_number(w, NULL, calibrate_excess(result, r->list[i].position));
    }
    json_list_end(w);
}

/* The source file. */
static void write_file(json_writer *w, const positions *data)
{
    char crc[16];

    snprintf(crc, sizeof crc, "%08lx", (unsigned long)data->crc);
    json_text(w, "source_file", data->name);
    json_text(w, "source_crc", crc);
}

/* Everything that invcal_thermal_at needs, then figures about the fit. */
static void write_thermal(json_writer *w, const calibrate_result *result)
{
    const thermal_fit *fit = &result->fit;
    double slope[2][INVCAL_PARAMETERS]; /* and sigma */
    const invcal_thermal *c = &fit->calibration;
    const invcal_calibration nominal = fit_in_field_units(&c->nominal, fit->settings.field);

    json_object(w, "thermal");
    json_number(w, "degree", c->fitted);
    json_number(w, "reference", c->reference);
    json_number(w, "span", c->span);
    json_number(w, "least", c->min);
    json_number(w, "greatest", c->max);
    json_number(w, "field", fit->settings.field);
    json_text(w, "frame", fit->settings.is_triangular ? "triangular" : "symmetric");
    json_vector(w, "nominal_offset", nominal.offset);
    json_matrix(w, "nominal_matrix", nominal.matrix);
    json_list(w, "coefficients");
    for (unsigned a = 0; a <= c->fitted; a++) {
        json_nine(w, NULL, c->x[a]);
    }
    json_list_end(w);
    json_number(w, "asked", fit->options.degree);
    json_text(w, "fallback", invcal_thermal_fallback_text(c->fallback));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        slope[0][r] = calibrate_slope_scale(result, r) * fit->slope[r];
        slope[1][r] = calibrate_slope_scale(result, r) * fit->slope_sigma[r];
    }
    json_nine(w, "slope", slope[0]);
    json_nine(w, "slope_sigma", slope[1]);
    json_number(w, "residual_rms_without", fit->without);
    json_number(w, "drift_limit", fit->drift_limit);
    json_object_end(w);
}

void calibrate_json(FILE *file, const calibrate_result *result)
{
    const double field = result->settings.field;
    const fit_solution *s = &result->solution;
    const invcal_calibration c = fit_in_field_units(&s->calibration, field);
    json_writer w;

    json_begin(&w, file);
    json_text(&w, "invcal", INVCAL_VERSION);
    record_json(&w, &result->record);
    write_file(&w, result->data);
    json_number(&w, "positions", result->data->count);
    if (result->log) {
        json_number(&w, "rate", result->log->rate);
        json_text(&w, "rate_from", result->log->is_rate_known ? "stated" : "guess");
    }
    json_numbers(&w, "rejected", result->rejected.number, result->rejected.count);
    write_excess(&w, result);
    json_number(&w, "suspected", result->rejected.suspected);
    json_number(&w, "gravity", field);
    json_number(&w, "gravity_sigma", result->field_sigma * field);
    json_text(&w, "unit", unit_name(result->data->seen.unit));
    json_text(&w, "unit_from", unit_origin_name(result->data->seen.unit_from));
    json_vector(&w, "offset", c.offset);
    json_matrix(&w, "matrix", c.matrix);
    json_text(&w, "frame", calibrate_frame(result));
    if (result->frame.used > 0) {
        calibrate_case_json(&w, result);
    }
    write_nominal(&w, &result->nominal);
    calibrate_parameters_json(&w, result, s->x);
    write_quality(&w, result);
    write_accuracy(&w, result);
    write_pass(&w, result);
    if (fit_has_prior(&result->settings)) {
        write_source(&w, result->quality.from_prior);
    }
    if (result->magnetometer) {
        calibrate_magnetometer_json(&w, result);
    }
    if (result->settings.is_six_faces) {
        faces_json(&w, result);
    }
    gyro_json(&w, result);
    if (result->degree > 0) {
        calibrate_nonlinear_json(&w, result);
    }
    if (result->is_robust_wanted) {
        calibrate_robust_json(&w, result);
    }
    if (result->stand.from) {
        stand_json(&w, &result->stand, &result->nominal);
    }
    if (result->temperature == CALIBRATE_THERMAL) {
        write_thermal(&w, result);
    }
    json_end(&w);
}
