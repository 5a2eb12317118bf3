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
#include "result/need.h"
#include "text/number.h"
#include "cli/options.h"
#include "text/paint.h"
#include "design/parameters.h"
#include "stand/tell.h"
#include "result/verdict.h"

#define LINE_WIDTH 99u
#define TEXT_MAX 512

/* One line of the table. */
typedef struct {
    const char *label;
    char axis[3];
    double value;
    double sigma;   /* NaN: not known */
    double nominal; /* NaN: leave this column and the difference empty */
    const char *unit;
} figure;

static void print_figure(FILE *file, const figure *f)
{
    char value[FIGURE_MAX];
    char sigma[FIGURE_MAX] = "?";
    char nominal[FIGURE_MAX] = "";
    char difference[FIGURE_MAX] = "";
    char label[FIGURE_MAX];
    const int places = figure_places(f->value, f->sigma);

    snprintf(label, sizeof label, "%s %s", f->label, f->axis);
    figure_fixed(f->value, places, FIGURE_PLAIN, value);
    if (f->sigma >= 0) {
        figure_fixed(f->sigma, places, FIGURE_PLAIN, sigma);
    }
    if (!isnan(f->nominal)) {
        figure_fixed(f->nominal, places, FIGURE_PLAIN, nominal);
        figure_fixed(f->value - f->nominal, places, FIGURE_SIGNED, difference);
    }
    fprintf(file, "%-14s%14s ± %-10s%14s%14s  %s\n", label, value, sigma, nominal, difference,
            f->unit);
}

static void print_offsets(FILE *file, const calibrate_result *r, int known)
{
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "offset",
                          .axis = {"xyz"[i]},
                          .value = r->solution.calibration.offset[i],
                          .sigma = known ? r->quality.sigma_offset[i] : NUMBER_UNKNOWN,
                          .nominal = r->nominal.calibration.offset[i],
                          .unit = calibrate_input_unit(r)};
        print_figure(file, &f);
    }
}

/* The same against nominal, over the field. */
static void print_biases(FILE *file, const calibrate_result *r, int known)
{
    const told_unit told = calibrate_told_field(r);

    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "offset error",
                          .axis = {"xyz"[i]},
                          .value = told.scale * r->solution.x[INVCAL_DELTA_X + i],
                          .sigma = known ? told.scale * r->quality.sigma[INVCAL_DELTA_X + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = NUMBER_UNKNOWN,
                          .unit = told.unit};
        print_figure(file, &f);
    }
}

/* As data sheets state it: input units per field unit. */
static void print_scales(FILE *file, const calibrate_result *r, int known)
{
    double inverse[3][3];
    char unit[FIGURE_MAX];

    snprintf(unit, sizeof unit, "%s per %s", calibrate_input_unit(r),
             unit_is_gravity(r->settings.field) ? "m/s²" : "field unit");

    (void)matrix_inverse(&r->nominal.calibration, inverse); /* no result without */
    for (unsigned i = 0; i < 3; i++) {
        const double nominal = inverse[i][i];
        const figure f = {.label = "scale",
                          .axis = {"xyz"[i]},
                          .value = nominal * (1 + r->solution.x[INVCAL_DK_X + i]),
                          .sigma = known ? fabs(nominal) * r->quality.sigma[INVCAL_DK_X + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = nominal,
                          .unit = unit};
        print_figure(file, &f);
    }
}

static void print_errors(FILE *file, const calibrate_result *r, int known)
{
    static const char *const pairs[] = {"xy", "xz", "zy"};
    const told_unit scale = told_scale(r->told);
    const told_unit angle = told_angle(r->told);
    const uint16_t held = fit_held(&r->settings, &r->quality);
    char off_square[FIGURE_MAX];
    char not_measured[FIGURE_MAX];

    snprintf(off_square, sizeof off_square, "%s off square", angle.unit);
    snprintf(not_measured, sizeof not_measured, "%s, not measured", angle.unit);
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "scale error",
                          .axis = {"xyz"[i]},
                          .value = scale.scale * r->solution.x[INVCAL_DK_X + i],
                          .sigma = known ? scale.scale * r->quality.sigma[INVCAL_DK_X + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = NUMBER_UNKNOWN,
                          .unit = scale.unit};
        print_figure(file, &f);
    }
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "angle",
                          .axis = {pairs[i][0], pairs[i][1]},
                          .value = angle.scale * r->solution.x[INVCAL_GAMMA_XY + i],
                          .sigma = known ? angle.scale * r->quality.sigma[INVCAL_GAMMA_XY + i]
                                         : NUMBER_UNKNOWN,
                          .nominal = 0,
                          .unit = held >> (INVCAL_GAMMA_XY + i) & 1 ? not_measured : off_square};
        print_figure(file, &f);
    }
}

static void print_guess(FILE *file, const nominal_choice *n, const char *nominal_name)
{
    if (nominal_is_guess(n)) {
        fprintf(file,
                "%s is a guess: how far offsets and scales are from it says nothing about the\n"
                "sensor; state its data sheet with --zero and --lsb\n",
                nominal_name);
    }
}

/* A residual, which is over the field, in a unit that one can picture: to 0.1 millionth of the field, in
 * micro-g to a thousandth of that. */
static const char *residual_text(const calibrate_result *r, double residual, char text[TEXT_MAX])
{
    const told_unit told = calibrate_told_field(r);
    const int places = r->told == TOLD_INS ? 3 : unit_is_gravity(r->settings.field) ? 4 : 5;

    snprintf(text, TEXT_MAX, "%14.*f %s", places, told.scale * residual, told.unit);
    return text;
}

static void print_residuals(FILE *file, const calibrate_result *r, const char *nominal_name)
{
    const fit_quality *q = &r->quality;
    const told_unit noise = r->told == TOLD_INS
                                ? calibrate_told_field(r)
                                : (told_unit){r->settings.field, calibrate_field_unit(r)};
    char text[TEXT_MAX];

    fprintf(file, "residual rms  %s\n", residual_text(r, q->rms, text));
    fprintf(file, "         max  %s", residual_text(r, q->max, text));
    if (r->magnetometer) {
        fprintf(file, ", of the means of cells\n");
    } else {
        fprintf(file, ", at position %u (line %lu)\n", q->worst + 1,
                r->data->origin[q->worst].line);
    }
    fprintf(file, "  rms before  %s (%s alone)\n", residual_text(r, r->residual_before, text),
            nominal_name);
    if (calibrate_knows_noise(r)) {
        fprintf(file, "noise         %14.3g %s of one position mean, %.3g degrees of freedom",
                q->noise * noise.scale, noise.unit, q->dof);
        if (r->settings.noise > 0) {
            fprintf(file, " (%s: %.3g)", r->is_noise_given ? "stated" : "of samples",
                    r->settings.noise * noise.scale);
        }
        fprintf(file, "\n±             one standard deviation; %.2f of them cover 95 %%%s\n",
                q->coverage, q->from_prior ? "; 1.96 of what a prior tells" : "");
        if (r->field_sigma > 0) {
            fprintf(file, "of g          %.2g %s in the ± of the scales, alike in all three%s\n",
                    told_scale(r->told).scale * r->field_sigma, told_scale(r->told).unit,
                    r->is_field_stated
                        ? ""
                        : ";\n              --gravity or --latitude tells it better");
        }
        if (calibrate_unexplained(r) > 0) {
            fprintf(
                file,
                "The residuals are %.0f times as large as that noise explains: motion, a changing "
                "temperature,\nclipped readings (--clip), or a wrong position.\n",
                calibrate_unexplained(r));
        }
    } else {
        fprintf(file, "noise         not known: no ± can be given (--noise states it)\n");
    }
}

void calibrate_print_wrapped(FILE *file, size_t used, const char *text)
{
    while (used + strlen(text) > LINE_WIDTH) {
        size_t length = LINE_WIDTH - used;
        while (length > 1 && text[length] != ' ') {
            length--;
        }
        length = length > 1 ? length : strcspn(text, " ");
        fprintf(file, "%.*s\n", (int)length, text);
        text += length + (text[length] == ' ');
        used = 0;
    }
    fprintf(file, "%s\n", text);
}

static void print_limit(FILE *file, const calibrate_result *result)
{
    static const char label[] = "limited by    ";
    char text[CALIBRATE_LIMIT_MAX];
    uncertainty length;

    calibrate_spread(result, 1, &length);
    fprintf(file, "%s", label);
    calibrate_print_wrapped(file, sizeof label - 1, calibrate_limit(result, &length, text));
}

static paint colour_of(invcal_verdict verdict)
{
    return verdict == INVCAL_GOOD                                       ? PAINT_GREEN
           : verdict == INVCAL_NO_REDUNDANCY || verdict == INVCAL_ROUGH ? PAINT_YELLOW
                                                                        : PAINT_RED;
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
        snprintf(text, sizeof text,
                 " every parameter is determined; degrees of freedom left to check it: %.3g. %s",
                 q->dof, verdict_unchecked(result, cause));
    } else if (q->verdict == INVCAL_NO_REDUNDANCY) {
        snprintf(text, sizeof text,
                 " every parameter is determined, but no direction is left to check the result.");
    } else if (q->verdict == INVCAL_WEAK && q->weak) {
        (void)parameters_list(q->weak, list, sizeof list);
        snprintf(text, sizeof text, " %s %s badly determined; use the result only within its ±.",
                 list, strchr(list, ',') ? "are" : "is");
    } else {
        snprintf(text, sizeof text, " %s", verdict_cause(result, cause));
    }
    fprintf(file, "%s%s%s", paint_on(file, colour), word, paint_off(file));
    calibrate_print_wrapped(file, strlen(word), text);
    if (result->beyond) {
        snprintf(text, sizeof text, "Beyond the limits of the data sheet: %s.",
                 parameters_list(result->beyond, list, sizeof list));
        calibrate_print_wrapped(file, 0, text);
    }
    if (result->need > 0) {
        calibrate_print_wrapped(file, 0, need_text(result, cause));
    }
    if (q->from_prior && !is_held) {
        snprintf(text, sizeof text, "Known from the prior rather than from the positions: %s.",
                 parameters_list(q->from_prior, list, sizeof list));
        calibrate_print_wrapped(file, 0, text);
    }
}

static void print_next(FILE *file, const calibrate_result *result, const calibrate_wish *wish)
{
    const fit_quality *q = &result->quality;
    const char *saved = wish->saved;
    char path[MESSAGE_MAX];
    char advice[128];
    char remedy[VERDICT_MAX];
    char text[VERDICT_MAX + 8];

    if (saved) {
        fprintf(file, "Saved in %s.\n", saved);
    }
    if (wish->report) {
        fprintf(file, "Report in %s.\n", wish->report);
    }
    if (faces_are_good(result)) {
        snprintf(text, sizeof text,
                 "Next: to measure the angles, add six positions and leave --six-faces out: %s.",
                 FACES_EDGES);
        calibrate_print_wrapped(file, 0, text);
    } else if (q->verdict == INVCAL_NO_REDUNDANCY) {
        fprintf(file, "Next: add 3 or more positions in other directions, to check the fit.\n");
    } else if (q->verdict == INVCAL_WEAK && calibrate_wants_slopes(result)) {
        fprintf(file, "Next: measure nine positions or more at each of two temperatures, 5 K "
                      "apart or more.\n");
    } else if (q->verdict == INVCAL_WEAK && !result->magnetometer) {
        snprintf(text, sizeof text, "Next: add positions with %s.",
                 parameters_advice(q->weak, advice, sizeof advice));
        calibrate_print_wrapped(file, 0, text);
    } else if (strcmp(verdict_word(result), "Good") == 0) {
        fprintf(file, "Next: %scorrect readings with: invcal apply %s LOG\n",
                saved ? "" : "save it with --out CAL.json, then ",
                options_quoted(saved ? saved : "CAL.json", path, sizeof path));
    } else {
        snprintf(text, sizeof text, "Next: %s", verdict_remedy(result, remedy));
        calibrate_print_wrapped(file, 0, text);
    }
}

/* What the file was taken for. */
static void print_recognised(FILE *file, const positions *data)
{
    char text[COLUMNS_TEXT_MAX];
    char line[COLUMNS_TEXT_MAX + TEXT_MAX];

    columns_describe(&data->seen, text, sizeof text);
    snprintf(line, sizeof line, "%s: %s", data->name, text);
    calibrate_print_wrapped(file, 0, line);
}

/* What the positions were found in. */
static void print_log(FILE *file, const calibrate_result *result)
{
    const rests_summary *log = result->log;

    if (!log) {
        return;
    }
    fprintf(file, "%s: %lu samples, %.6g s at %.4g samples a second%s\n", result->data->name,
            log->samples, log->seconds, log->rate,
            log->is_rate_known ? "" : " (a guess: --rate states it)");
    if (log->gaps > 0) {
        fprintf(file, "%*lu gap%s in the stream\n", 8, log->gaps, log->gaps == 1 ? "" : "s");
    }
    if (log->skipped > 0) {
        fprintf(file, "%*lu malformed line%s skipped\n", 8, log->skipped,
                log->skipped == 1 ? "" : "s");
    }
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        if (log->refused[i] > 0) {
            fprintf(file, "%*u rest%s refused: %s\n", 8, log->refused[i],
                    log->refused[i] == 1 ? "" : "s",
                    rests_reason_text((invcal_status)(INVCAL_REST_SHORT + i)));
        }
    }
}

static void print_place(FILE *file, const calibrate_result *result)
{
    if (result->place) {
        fprintf(file,
                "That is normal gravity at %.6g degrees, %.6g m, ±%.4f: an error scales all "
                "readings alike,\nand does nothing else.\n",
                result->place[0], result->place[1], GRAVITY_SIGMA);
    }
}

static void print_rejected(FILE *file, const calibrate_result *result)
{
    const rejection *r = &result->rejected;
    const told_unit told = calibrate_told_field(result);
    char text[FIGURE_MAX];

    if (rejection_drifting(r) > 0) {
        fprintf(file,
                "%sLeft out:%s %u rest%s in which the temperature drifted by more than %.2g K\n",
                paint_on(file, PAINT_RED), paint_off(file), rejection_drifting(r),
                rejection_drifting(r) == 1 ? "" : "s", result->fit.drift_limit);
    }
    for (unsigned i = 0; i < r->count; i++) {
        if (r->list[i].drift > 0) {
            fprintf(file, "          position %u (line %lu), by %.2g K\n", r->list[i].position + 1,
                    result->data->origin[r->list[i].position].line, r->list[i].drift);
            continue;
        }
        fprintf(file, "%sLeft out:%s position %u (line %lu), wrong by %s %s\n",
                paint_on(file, PAINT_RED), paint_off(file), r->list[i].position + 1,
                result->data->origin[r->list[i].position].line,
                figure_digits(told.scale * r->list[i].error, 3, text), told.unit);
    }
    if (r->suspected > 0) {
        fprintf(file, "Something is wrong among %u %spositions, but not to be told which.\n",
                r->suspected, r->count > 0 ? "more " : "");
    }
}

static void print_stand(FILE *file, const calibrate_result *result)
{
    const told_unit unit[3] = {calibrate_told_field(result), told_scale(result->told),
                               told_angle(result->told)};

    if (result->stand.from) {
        stand_print(file, &result->stand, result->solution.x, unit);
    }
}

static void print_case(FILE *file, const calibrate_result *result)
{
    char text[CALIBRATE_LIMIT_MAX];

    if (result->frame.used > 0) {
        fprintf(file, "case          ");
        calibrate_print_wrapped(file, 14, calibrate_case_text(result, text));
    }
}

void calibrate_print(FILE *file, const calibrate_result *result, const calibrate_wish *wish)
{
    const int known = calibrate_knows_noise(result);
    const nominal_choice *n = &result->nominal;

    print_recognised(file, result->data);
    print_log(file, result);
    if (result->magnetometer) {
        calibrate_waved_print(file, result);
    }
    fprintf(file, "%s: %u %s, field %.7g %s\n", result->data->name, result->data->count,
            result->magnetometer ? "cells of direction, each a position" : "positions",
            result->settings.field, calibrate_field_unit(result));
    print_place(file, result);
    print_rejected(file, result);
    if (n->zero == n->lsb) {
        fprintf(file, "%s: zero and scale %s\n\n", wish->nominal_name,
                nominal_origin_text(n->zero));
    } else {
        fprintf(file, "%s: zero %s, scale %s\n\n", wish->nominal_name, nominal_origin_text(n->zero),
                nominal_origin_text(n->lsb));
    }
    fprintf(file, "%s%-14s%14s ± %-10s%*s%14s%s\n", paint_on(file, PAINT_BOLD), "", "calibrated",
            "sigma", paint_width(wish->nominal_name, 14), wish->nominal_name, "difference",
            paint_off(file));
    print_offsets(file, result, known);
    print_scales(file, result, known);
    if (result->told == TOLD_INS) { /* in input units alone no engineer of INS can read it */
        print_biases(file, result, known);
    }
    print_errors(file, result, known);
    calibrate_nonlinear_print(file, result);
    print_guess(file, n, wish->nominal_name);
    fprintf(file, "\n");
    print_stand(file, result);
    print_case(file, result);
    calibrate_print_thermal(file, result);
    fprintf(file, "%s", result->temperature == CALIBRATE_THERMAL ? "\n" : "");
    print_residuals(file, result, wish->nominal_name);
    if (result->is_robust_wanted) {
        calibrate_robust_print(file, result);
    }
    print_limit(file, result);
    fprintf(file, "\n");
    print_verdict(file, result);
    print_next(file, result, wish);
}
