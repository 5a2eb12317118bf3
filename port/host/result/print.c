/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "result/result.h"
#include "text/figure.h"
#include "fit/gravity.h"
#include "maths/matrix.h"
#include "cli/message.h"
#include "result/faces.h"
#include "result/gyro.h"
#include "result/need.h"
#include "result/pass.h"
#include "text/number.h"
#include "cli/options.h"
#include "text/paint.h"
#include "design/parameters.h"
#include "stand/output.h"
#include "text/tabular.h"
#include "text/utf8.h"
#include "text/wrapped.h"
#include "result/verdict.h"
#include "text/plain.h"

#define LABEL 14u /* columns of the label of a line */
#define TEXT_MAX 512
#define LISTED_MAX 10u /* positions left out that are listed */

/* One line of the table. */
typedef struct {
    const char *label;
    char axis[3];
    double value;
    double sigma;   /* NaN: not known */
    double nominal; /* NaN: leave this column and the difference empty */
    const char *unit;
} figure;

static void add_figure(const calibrate_result *r, const figure *f)
{
    char text[FIGURE_MAX];
    const int places = figure_places(f->value, f->sigma);

    tabular_cell("%s %s", f->label, f->axis);
    tabular_cell("%s", figure_fixed(f->value, places, FIGURE_PLAIN, text));
    tabular_cell("± %s", f->sigma >= 0 ? figure_fixed(f->sigma, places, FIGURE_PLAIN, text) : "?");
    if (!nominal_is_stated(&r->nominal)) { /* the table has no column for it */
        tabular_note("%s", f->unit);
        tabular_row();
        return;
    }
    if (!isnan(f->nominal)) {
        tabular_cell("%s", figure_fixed(f->nominal, places, FIGURE_PLAIN, text));
        tabular_cell("%s", figure_fixed(f->value - f->nominal, places, FIGURE_SIGNED, text));
    }
    tabular_note("%s", f->unit);
    tabular_row();
}

static void add_offsets(const calibrate_result *r, int known)
{
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "offset",
                          .axis = {"xyz"[i]},
                          .value = r->solution.calibration.offset[i],
                          .sigma = known ? r->quality.sigma_offset[i] : NUMBER_UNKNOWN,
                          .nominal = nominal_knows(&r->nominal, INVCAL_DELTA_X)
                                         ? r->nominal.calibration.offset[i]
                                         : NUMBER_UNKNOWN,
                          .unit = calibrate_input_unit(r)};
        add_figure(r, &f);
    }
}

/* The deviations of offsets from nominal, over the field. */
static void add_biases(const calibrate_result *r, int known)
{
    const display_unit display = calibrate_display_unit(r);

    for (unsigned i = 0; i < 3 && nominal_knows(&r->nominal, INVCAL_DELTA_X); i++) {
        const figure f = {.label = "offset error",
                          .axis = {"xyz"[i]},
                          .value = display.scale * r->solution.x[INVCAL_DELTA_X + i],
                          .sigma = known ? display.scale * r->quality.sigma[INVCAL_DELTA_X + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = NUMBER_UNKNOWN,
                          .unit = display.unit};
        add_figure(r, &f);
    }
}

/* Scales as in data sheets: input units per field unit. */
static void add_scales(const calibrate_result *r, int known)
{
    double inverse[3][3];
    char unit[FIGURE_MAX];
    const int is_named = !strstr(calibrate_field_unit(r), " units");

    snprintf(unit, sizeof unit, "%s per %s", calibrate_input_unit(r),
             is_named ? calibrate_field_unit(r) : "field unit");

    (void)matrix_inverse(&r->nominal.calibration, inverse); /* no result without */
    for (unsigned i = 0; i < 3; i++) {
        const double nominal = inverse[i][i];
        const figure f = {
            .label = "scale",
            .axis = {"xyz"[i]},
            .value = nominal * (1 + r->solution.x[INVCAL_DK_X + i]),
            .sigma = known ? fabs(nominal) * r->quality.sigma[INVCAL_DK_X + i] : NUMBER_UNKNOWN,
            .nominal = nominal_knows(&r->nominal, INVCAL_DK_X) ? nominal : NUMBER_UNKNOWN,
            .unit = unit};
        add_figure(r, &f);
    }
}

static void add_errors(const calibrate_result *r, int known)
{
    static const char *const pairs[] = {"xy", "xz", "zy"};
    const display_unit scale = unit_style_scale(r->units);
    const display_unit angle = unit_style_angle(r->units);
    const uint16_t held = fit_held(&r->settings, &r->quality);
    char off_square[FIGURE_MAX];
    char not_measured[FIGURE_MAX];

    snprintf(off_square, sizeof off_square, "%s off square", angle.unit);
    snprintf(not_measured, sizeof not_measured, "%s, not measured", angle.unit);
    for (unsigned i = 0; i < 3 && nominal_knows(&r->nominal, INVCAL_DK_X); i++) {
        const figure f = {.label = "scale error",
                          .axis = {"xyz"[i]},
                          .value = scale.scale * r->solution.x[INVCAL_DK_X + i],
                          .sigma = known ? scale.scale * r->quality.sigma[INVCAL_DK_X + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = NUMBER_UNKNOWN,
                          .unit = scale.unit};
        add_figure(r, &f);
    }
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "angle",
                          .axis = {pairs[i][0], pairs[i][1]},
                          .value = angle.scale * r->solution.x[INVCAL_GAMMA_XY + i],
                          .sigma = known ? angle.scale * r->quality.sigma[INVCAL_GAMMA_XY + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = 0,
                          .unit = held >> (INVCAL_GAMMA_XY + i) & 1 ? not_measured : off_square};
        add_figure(r, &f);
    }
}

/* A residual over the field in the unit of the table, to 1e-7 of the field; in INS units, to 0.001
 * of a µg. */
static const char *residual_text(const calibrate_result *r, double residual, char text[TEXT_MAX])
{
    const display_unit display = calibrate_display_unit(r);
    const int places = r->units == UNIT_STYLE_INS ? 3 : calibrate_is_gravity(r) ? 4 : 5;

    snprintf(text, TEXT_MAX, "%14.*f %s", places, display.scale * residual, display.unit);
    return text;
}

static void print_residuals(FILE *file, const calibrate_result *r, const char *nominal_name)
{
    const fit_quality *q = &r->quality;
    const display_unit noise = r->units == UNIT_STYLE_INS
                                   ? calibrate_display_unit(r)
                                   : (display_unit){r->settings.field, calibrate_field_unit(r)};
    char text[TEXT_MAX];

    fprintf(file, "residual rms  %s\n", residual_text(r, q->rms, text));
    if (r->magnetometer) {
        wrapped_printf(file, LABEL, "         max  %s, of the means of cells",
                       residual_text(r, q->max, text));
        fprintf(file, "  of samples  %s rms\n",
                residual_text(r, r->magnetometer->sample_rms, text));
    } else {
        wrapped_printf(file, LABEL, "         max  %s, at position %u (line %lu)",
                       residual_text(r, q->max, text), q->worst + 1,
                       r->data->origin[q->worst].line);
    }
    if (!nominal_is_guess(&r->nominal)) {
        wrapped_printf(file, LABEL, "  rms before  %s (%s alone)",
                       residual_text(r, r->residual_before, text), nominal_name);
    }
    if (calibrate_knows_noise(r)) {
        char stated[TEXT_MAX] = "";
        if (r->settings.noise > 0) {
            snprintf(stated, sizeof stated, " (%s: %.3g)",
                     r->is_noise_given ? "stated" : "of samples", r->settings.noise * noise.scale);
        }
        wrapped_printf(file, LABEL,
                       "noise         %14.3g %s of one position mean, %.3g degrees of freedom%s",
                       q->noise * noise.scale, noise.unit, q->dof, stated);
        wrapped_printf(file, LABEL,
                       "±             one standard deviation; %.2f of them cover 95 %%%s",
                       q->coverage, q->from_prior ? "; 1.96 for parameters from the prior" : "");
        if (r->field_sigma > 0) {
            wrapped_printf(file, LABEL, "%-14s%.2g %s, included in the ± of all three scales%s",
                           r->magnetometer ? "of the field" : "of g",
                           unit_style_scale(r->units).scale * r->field_sigma,
                           unit_style_scale(r->units).unit,
                           r->is_field_stated ? "" : "; --gravity or --latitude reduces it");
        }
        if (calibrate_unexplained(r) > 0) {
            wrapped_printf(
                file, 0,
                "The residuals are %s times as large as this noise explains: look for motion, a "
                "changing temperature, clipped readings (--clip), or an outlier.",
                figure_digits(calibrate_unexplained(r), 2, text));
        }
    } else {
        fprintf(file, "noise         unknown, so there is no ±: state --noise\n");
    }
}

static void print_limit(FILE *file, const calibrate_result *result)
{
    static const char label[] = "limited by    ";
    char text[CALIBRATE_LIMIT_MAX];
    uncertainty length;

    calibrate_uncertainty(result, 1, &length);
    fprintf(file, "%s", label);
    wrapped_line(file, LABEL, LABEL, calibrate_limit(result, &length, text));
}

static paint colour_of(invcal_verdict verdict)
{
    return verdict == INVCAL_GOOD                                       ? PAINT_GREEN
           : verdict == INVCAL_NO_REDUNDANCY || verdict == INVCAL_ROUGH ? PAINT_YELLOW
                                                                        : PAINT_RED;
}

/* PASS or FAIL. */
static void print_pass(FILE *file, const calibrate_result *result)
{
    const pass p = pass_judge(result);
    char text[PASS_MAX + NEED_MAX];
    char advice[NEED_MAX];
    char list[128];

    if (!p.has_criteria) {
        return;
    }
    (void)pass_text(result, text); /* begins with a word of four letters and a colon */
    const size_t length = strlen(text);
    if (result->need > 0 && *need_advice(result, advice)) {
        snprintf(text + length, sizeof text - length, " %s", advice);
    }
    fprintf(file, "%s%.5s%s", paint_on(file, p.is_passed ? PAINT_GREEN : PAINT_RED), text,
            paint_off(file));
    wrapped_line(file, 5, 0, text + 5);
    if (p.beyond) {
        snprintf(text, sizeof text, "Beyond the limits of the data sheet: %s.",
                 parameters_list(p.beyond, list, sizeof list));
        wrapped_line(file, 0, 0, text);
    }
}

static void print_verdict(FILE *file, const calibrate_result *result)
{
    const fit_quality *q = &result->quality;
    char list[128];
    char cause[VERDICT_MAX];
    char word[64];
    char text[VERDICT_MAX + 32];
    const int is_held = faces_are_good(result);

    snprintf(word, sizeof word, "%s%s", verdict_word(result), is_held ? ";" : ":");
    const paint colour = is_held ? PAINT_YELLOW : colour_of(q->verdict);
    if (is_held) {
        snprintf(text, sizeof text, " %s", faces_cost(result, cause));
    } else if (strcmp(word, "Good:") == 0) {
        const char *unchecked = verdict_unchecked(result, cause);
        snprintf(text, sizeof text,
                 " every parameter is determined; degrees of freedom to check the fit: %.3g.%s%s",
                 q->dof, *unchecked ? " " : "", unchecked);
    } else if (q->verdict == INVCAL_NO_REDUNDANCY && !result->magnetometer) {
        snprintf(text, sizeof text,
                 " every parameter is determined, but there is no redundancy to check the fit.");
    } else if (q->verdict == INVCAL_WEAK && !result->magnetometer) {
        (void)parameters_list(q->weak, list, sizeof list);
        snprintf(text, sizeof text,
                 " %s %s poorly determined; rely on the result only within its ±.", list,
                 strchr(list, ',') ? "are" : "is");
    } else {
        snprintf(text, sizeof text, " %s", verdict_cause(result, cause));
    }
    fprintf(file, "%s%s%s", paint_on(file, colour), word, paint_off(file));
    wrapped_line(file, utf8_columns(word), 0, text);
    print_pass(file, result);
    if (q->from_prior && !is_held) {
        snprintf(text, sizeof text, "Determined by the prior rather than by the positions: %s.",
                 parameters_list(q->from_prior, list, sizeof list));
        wrapped_line(file, 0, 0, text);
    }
}

static void print_next(FILE *file, const calibrate_result *result,
                       const calibrate_invocation *invocation)
{
    const fit_quality *q = &result->quality;
    const char *saved = invocation->saved;
    char path[PLAIN_MAX];
    char command[PLAIN_MAX + sizeof "invcal apply  LOG"];
    char advice[128];
    char remedy[VERDICT_MAX];
    char text[VERDICT_MAX + 8];

    if (saved) {
        wrapped_printf(file, 0, "Saved in %s.", plain_copy(saved, path));
    }
    if (invocation->report) {
        wrapped_printf(file, 0, "Report in %s.", plain_copy(invocation->report, path));
    }
    if (faces_are_good(result)) {
        snprintf(text, sizeof text,
                 "Next: to measure the angles, add six positions and leave out --six-faces: %s.",
                 FACES_EDGES);
        wrapped_line(file, 0, 0, text);
    } else if (q->verdict == INVCAL_NO_REDUNDANCY && !result->magnetometer) {
        wrapped_printf(file, 0,
                       "Next: add 3 or more positions in other directions, to check the fit.");
    } else if (q->verdict == INVCAL_WEAK && calibrate_lacks_slopes(result)) {
        wrapped_printf(file, 0,
                       "Next: measure nine positions or more at each of two temperatures, at least "
                       "5 K apart.");
    } else if (q->verdict == INVCAL_WEAK && !result->magnetometer) {
        snprintf(text, sizeof text, "Next: add positions with %s.",
                 parameters_advice(q->weak, advice, sizeof advice));
        wrapped_line(file, 0, 0, text);
    } else if (strcmp(verdict_word(result), "Good") == 0) {
        const size_t at = wrapped_words(file, 0, 0,
                                        saved ? "Next: correct readings with:"
                                              : "Next: save it with --out CAL.json, then correct "
                                                "readings with:");
        snprintf(command, sizeof command, "invcal apply %s LOG",
                 saved ? plain(options_quoted(saved, path, sizeof path)) : "CAL.json");
        wrapped_command(file, at, 2, command);
    } else {
        snprintf(text, sizeof text, "Next: %s", verdict_remedy(result, remedy));
        wrapped_line(file, 0, 0, text);
    }
}

/* The record of the calibration. */
static void print_record(FILE *file, const record *r)
{
    char text[RECORD_MAX + 16];

    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        if (*r->text[k] != '\0') {
            snprintf(text, sizeof text, "%-14s%s", record_name((record_text)k), r->text[k]);
            wrapped_line(file, 0, LABEL, text);
        }
    }
}

/* What the file was recognised as. */
static void print_recognised(FILE *file, const positions *data)
{
    char text[COLUMNS_TEXT_MAX];
    char line[COLUMNS_TEXT_MAX + TEXT_MAX];

    columns_describe(&data->seen, text, sizeof text);
    snprintf(line, sizeof line, "%s: %s", data->name, text);
    wrapped_line(file, 0, 0, plain(line));
}

/* The log in which the positions were found. */
static void print_log(FILE *file, const calibrate_result *result)
{
    const rests_summary *log = result->log;
    char name[PLAIN_MAX];

    if (!log) {
        return;
    }
    wrapped_printf(file, 0, "%s: %lu samples, %.6g s at %.4g samples per second%s",
                   plain_copy(result->data->name, name), log->samples, log->seconds, log->rate,
                   log->is_rate_known ? "" : " (a guess: state --rate)");
    if (log->gaps > 0) {
        fprintf(file, "%*lu gap%s in the stream\n", 8, log->gaps, log->gaps == 1 ? "" : "s");
    }
    if (log->skipped > 0) {
        fprintf(file, "%*lu malformed line%s skipped\n", 8, log->skipped,
                log->skipped == 1 ? "" : "s");
    }
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        if (log->refused[i] > 0) {
            wrapped_printf(file, 9, "%*u rest%s refused: %s", 8, log->refused[i],
                           log->refused[i] == 1 ? "" : "s",
                           rests_reason_text((invcal_status)(INVCAL_REST_SHORT + i)));
        }
    }
}

static void print_place(FILE *file, const calibrate_result *result)
{
    if (result->place) {
        wrapped_printf(file, 0,
                       "This is normal gravity at %.6g degrees, %.6g m, ±%.4f; its error scales "
                       "all readings alike.",
                       result->place[0], result->place[1], GRAVITY_SIGMA);
    }
}

static void print_rejected(FILE *file, const calibrate_result *result)
{
    const rejection *r = &result->rejected;
    const display_unit display = calibrate_display_unit(result);
    char text[FIGURE_MAX];

    if (rejection_drifting(r) > 0) {
        wrapped_printf(file, 10,
                       "%sLeft out:%s %u rest%s in which the temperature drifted by more than "
                       "%.2g K",
                       paint_on(file, PAINT_RED), paint_off(file), rejection_drifting(r),
                       rejection_drifting(r) == 1 ? "" : "s", result->fit.drift_limit);
    }
    for (unsigned i = 0; i < r->count; i++) {
        if (i == LISTED_MAX && r->count > LISTED_MAX + 1) {
            fprintf(file, "          and %u more\n", r->count - LISTED_MAX);
            break;
        }
        if (r->list[i].drift > 0) {
            fprintf(file, "          position %u (line %lu), by %.2g K\n", r->list[i].position + 1,
                    result->data->origin[r->list[i].position].line, r->list[i].drift);
            continue;
        }
        wrapped_printf(
            file, 10, "%sLeft out:%s position %u (line %lu), off by %s %s",
            paint_on(file, PAINT_RED), paint_off(file), r->list[i].position + 1,
            result->data->origin[r->list[i].position].line,
            figure_digits(display.scale * calibrate_excess(result, r->list[i].position), 3, text),
            display.unit);
    }
    if (r->suspected > 0) {
        wrapped_printf(
            file, 0,
            "%u %spositions contradict one another, and nothing shows which of them are wrong.",
            r->suspected, r->count > 0 ? "more " : "");
    }
}

static void print_stand(FILE *file, const calibrate_result *result)
{
    const display_unit unit[3] = {calibrate_display_unit(result), unit_style_scale(result->units),
                                  unit_style_angle(result->units)};

    if (result->stand.from) {
        stand_print(file, &result->stand, &result->nominal, result->solution.x, unit);
    }
}

static void print_case(FILE *file, const calibrate_result *result)
{
    char text[CALIBRATE_LIMIT_MAX];

    if (result->frame.used > 0) {
        fprintf(file, "case          ");
        wrapped_line(file, LABEL, LABEL, calibrate_case_text(result, text));
    }
}

/* The axes of a magnetometer relative to those of an accelerometer. */
static void print_axes(FILE *file, const calibrate_result *result)
{
    char text[CALIBRATE_AXES_MAX];

    if (*calibrate_axes_text(result, text) != '\0') {
        fprintf(file, "%-14s", "axes");
        wrapped_line(file, LABEL, LABEL, text);
    }
}

/* Nominal zero and scale, and their source. */
static void print_nominal(FILE *file, const calibrate_result *r, const char *name)
{
    char text[TEXT_MAX];
    char limits[SENSORS_TEXT_MAX];
    const nominal_choice *n = &r->nominal;

    if (!nominal_is_stated(n) && r->data->seen.states_foreign_unit) {
        snprintf(text, sizeof text,
                 "%s: unknown: the unit in the header is not g, mg, m/s2 or counts; state --zero "
                 "0,0,0 and --lsb, what one unit is in m/s^2",
                 name);
    } else if (!nominal_is_stated(n)) {
        snprintf(text, sizeof text, "%s: unknown; state --sensor, --unit, or --zero and --lsb",
                 name);
    } else if (n->zero == n->lsb) {
        snprintf(text, sizeof text, "%s: zero and scale %s", name, nominal_origin_text(n->zero));
    } else {
        snprintf(text, sizeof text, "%s: zero %s, scale %s", name, nominal_origin_text(n->zero),
                 nominal_origin_text(n->lsb));
    }
    wrapped_line(file, 0, 0, text);
    if (n->sensor.type) {
        wrapped_printf(file, 0, "%s at %s: %s", n->sensor.type->name, n->sensor.range->name,
                       n->sensor.type->sheet);
        fprintf(file, "%-14s", "limits");
        wrapped_line(file, LABEL, LABEL, sensors_limits_text(&n->sensor, limits));
    }
    fprintf(file, "\n");
}

static void print_parameters(FILE *file, const calibrate_result *result, const char *nominal_name)
{
    const int known = calibrate_knows_noise(result);

    const int is_stated = nominal_is_stated(&result->nominal);

    tabular_begin(file, is_stated ? "lrlrr" : "lrl");
    tabular_cell("%s", "");
    tabular_cell("calibrated");
    tabular_cell("± sigma");
    if (is_stated) {
        tabular_cell("%s", nominal_name);
        tabular_cell("difference");
    }
    tabular_row_in(PAINT_BOLD);
    add_offsets(result, known);
    add_scales(result, known);
    if (result->units == UNIT_STYLE_INS) { /* biases are not usually in input units there */
        add_biases(result, known);
    }
    add_errors(result, known);
    calibrate_nonlinear_rows(result);
    tabular_end();
}

void calibrate_print(FILE *file, const calibrate_result *result,
                     const calibrate_invocation *invocation)
{
    char name[PLAIN_MAX];
    char nominal[CALIBRATE_NAME_MAX + 1];

    snprintf(nominal, sizeof nominal, "%s", invocation->nominal_name);
    plain(nominal);
    print_record(file, &result->record);
    print_recognised(file, result->data);
    print_log(file, result);
    if (result->magnetometer) {
        calibrate_magnetometer_print(file, result);
    }
    wrapped_printf(file, 0, "%s: %u %s, field %.7g %s", plain_copy(result->data->name, name),
                   result->data->count,
                   result->magnetometer ? "direction cells, used as positions" : "positions",
                   result->settings.field, calibrate_field_unit(result));
    print_place(file, result);
    print_rejected(file, result);
    print_nominal(file, result, nominal);
    print_parameters(file, result, nominal);
    fprintf(file, "\n");
    print_stand(file, result);
    print_case(file, result);
    print_axes(file, result);
    calibrate_print_thermal(file, result);
    fprintf(file, "%s", result->temperature == CALIBRATE_THERMAL ? "\n" : "");
    print_residuals(file, result, nominal);
    if (result->is_robust_wanted) {
        calibrate_robust_print(file, result);
    }
    print_limit(file, result);
    fprintf(file, "\n");
    gyro_print(file, result);
    print_verdict(file, result);
    print_next(file, result, invocation);
    gyro_print_last(file, result);
}
