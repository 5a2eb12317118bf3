/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "calibrate.h"
#include "number.h"
#include "parameters.h"

#define DEGREES 57.295779513082321
#define LINE_WIDTH 99u
#define FIGURE_MAX 64
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

/* The unit of the field is not told, but gravity is known by its length. */
static const char *field_unit(double field)
{
    return unit_is_gravity(field) ? "m/s²" : "field units";
}

/* Decimals that show two digits of sigma, or six of the value if there is no sigma. */
static int decimals(double value, double sigma)
{
    const double size = sigma > 0 ? sigma : fabs(value);
    const double digits = sigma > 0 ? 1 : 5;
    const double places = size > 0 ? digits - floor(log10(size)) : digits;

    return places < 0 ? 0 : places > 9 ? 9 : (int)places;
}

/* A number with so many decimals, never "-0.00". */
static const char *fixed(double x, int places, const char *format, char text[FIGURE_MAX])
{
    if (!(fabs(x) < 1e10)) {
        snprintf(text, FIGURE_MAX, "%.6g", x);
        return text;
    }
    snprintf(text, FIGURE_MAX, "%.*f", places, x);
    const int is_zero = !(fabs(strtod(text, NULL)) > 0);
    snprintf(text, FIGURE_MAX, "%s%.*f", *format == '+' && (is_zero || x > 0) ? "+" : "", places,
             is_zero ? 0.0 : x);
    return text;
}

static void print_figure(FILE *file, const figure *f)
{
    char value[FIGURE_MAX];
    char sigma[FIGURE_MAX] = "?";
    char nominal[FIGURE_MAX] = "";
    char difference[FIGURE_MAX] = "";
    char label[FIGURE_MAX];
    const int places = decimals(f->value, f->sigma);

    snprintf(label, sizeof label, "%s %s", f->label, f->axis);
    fixed(f->value, places, "", value);
    if (f->sigma >= 0) {
        fixed(f->sigma, places, "", sigma);
    }
    if (!isnan(f->nominal)) {
        fixed(f->nominal, places, "", nominal);
        fixed(f->value - f->nominal, places, "+", difference);
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
                          .unit = unit_words(r->data->seen.unit)};
        print_figure(file, &f);
    }
}

/* As data sheets state it: input units per field unit. */
static void print_scales(FILE *file, const calibrate_result *r, int known)
{
    double inverse[3][3];
    char unit[FIGURE_MAX];

    snprintf(unit, sizeof unit, "%s per %s", unit_words(r->data->seen.unit),
             unit_is_gravity(r->settings.field) ? "m/s²" : "field unit");

    (void)invcal_calibration_inverse(&r->nominal.calibration, inverse); /* no result without */
    for (unsigned i = 0; i < 3; i++) {
        const double nominal = inverse[i][i];
        const figure f = {.label = "scale",
                          .axis = {"xyz"[i]},
                          .value = nominal * (1 + r->solution.dk[i]),
                          .sigma = known ? fabs(nominal) * r->quality.sigma_dk[i] : NUMBER_UNKNOWN,
                          .nominal = nominal,
                          .unit = unit};
        print_figure(file, &f);
    }
}

static void print_errors(FILE *file, const calibrate_result *r, int known)
{
    static const char *const pairs[] = {"xy", "xz", "zy"};

    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "scale error",
                          .axis = {"xyz"[i]},
                          .value = 100 * r->solution.dk[i],
                          .sigma = known ? 100 * r->quality.sigma_dk[i] : NUMBER_UNKNOWN,
                          .nominal = NUMBER_UNKNOWN,
                          .unit = "%"};
        print_figure(file, &f);
    }
    for (unsigned i = 0; i < 3; i++) {
        const figure f = {.label = "angle",
                          .axis = {pairs[i][0], pairs[i][1]},
                          .value = DEGREES * r->solution.gamma[i],
                          .sigma = known ? DEGREES * r->quality.sigma_gamma[i] : NUMBER_UNKNOWN,
                          .nominal = 0,
                          .unit = "degrees off square"};
        print_figure(file, &f);
    }
}

/* A residual in 1e-6 of the field, and in a unit that one can picture. */
static const char *residual_text(double residual, double field, char text[TEXT_MAX])
{
    if (unit_is_gravity(field)) {
        snprintf(text, TEXT_MAX, "%.3fe-6 of the field = %.4f mg", 1e6 * residual, 1e3 * residual);
    } else {
        snprintf(text, TEXT_MAX, "%.3fe-6 of the field = %.4g field units", 1e6 * residual,
                 residual * field);
    }
    return text;
}

static void print_residuals(FILE *file, const calibrate_result *r, const char *nominal_name)
{
    const invcal_quality *q = &r->quality;
    const double field = r->settings.field;
    char text[TEXT_MAX];

    fprintf(file, "residual rms  %s\n", residual_text(q->residual_rms, field, text));
    fprintf(file, "         max  %s, at position %u (line %lu)\n",
            residual_text(q->residual_max, field, text), q->worst + 1, r->data->line[q->worst]);
    fprintf(file, "  rms before  %s (%s alone)\n", residual_text(r->residual_before, field, text),
            nominal_name);
    if (calibrate_knows_noise(r)) {
        fprintf(file, "noise         %.3g %s of one position mean, %.3g degrees of freedom",
                q->noise * field, field_unit(field), q->dof);
        if (r->settings.noise > 0) {
            fprintf(file, " (stated: %.3g)", r->settings.noise);
        }
        fprintf(file, "\n±             one standard deviation; %.2f of them cover 95 %%\n",
                q->coverage);
    } else {
        fprintf(file, "noise         not known: no ± can be given (--noise states it)\n");
    }
}

/* Breaks a text into lines between words. */
static void print_wrapped(FILE *file, const char *text)
{
    while (strlen(text) > LINE_WIDTH) {
        size_t length = LINE_WIDTH;
        while (length > 1 && text[length] != ' ') {
            length--;
        }
        length = length > 1 ? length : strcspn(text, " ");
        fprintf(file, "%.*s\n", (int)length, text);
        text += length + (text[length] == ' ');
    }
    fprintf(file, "%s\n", text);
}

static void print_verdict(FILE *file, const invcal_quality *q)
{
    char list[128];
    char text[TEXT_MAX];

    switch (q->verdict) {
    case INVCAL_GOOD:
        snprintf(text, sizeof text,
                 "Good: every parameter is determined; degrees of freedom left to check it: %.3g.",
                 q->dof);
        break;
    case INVCAL_NO_REDUNDANCY:
        snprintf(text, sizeof text,
                 "No redundancy: every parameter is determined, but no position "
                 "is left to check the result.");
        break;
    case INVCAL_WEAK:
        parameters_list(q->undetermined, list, sizeof list);
        snprintf(text, sizeof text,
                 "Weak: %s %s badly determined; use the result only within its ±.", list,
                 strchr(list, ',') ? "are" : "is");
        break;
    }
    print_wrapped(file, text);
    if (q->from_prior) {
        snprintf(text, sizeof text, "Known from the prior rather than from the positions: %s.",
                 parameters_list(q->from_prior, list, sizeof list));
        print_wrapped(file, text);
    }
}

static void print_next(FILE *file, const invcal_quality *q, const char *saved)
{
    char advice[128];
    char text[TEXT_MAX];

    if (saved) {
        fprintf(file, "Saved in %s.\n", saved);
    }
    switch (q->verdict) {
    case INVCAL_GOOD:
        fprintf(file, "Next: %scorrect readings with: invcal apply %s LOG\n",
                saved ? "" : "save it with --out CAL.json, then ", saved ? saved : "CAL.json");
        break;
    case INVCAL_NO_REDUNDANCY:
        fprintf(file, "Next: add 3 or more positions in other directions, to check the fit.\n");
        break;
    case INVCAL_WEAK:
        snprintf(text, sizeof text, "Next: add positions with %s.",
                 parameters_advice(q->undetermined, advice, sizeof advice));
        print_wrapped(file, text);
        break;
    }
}

/* What the file was taken for. */
static void print_recognised(FILE *file, const positions *data)
{
    char text[COLUMNS_TEXT_MAX];
    char line[COLUMNS_TEXT_MAX + TEXT_MAX];

    columns_describe(&data->seen, text, sizeof text);
    snprintf(line, sizeof line, "%s: %s", data->name, text);
    print_wrapped(file, line);
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
                    invcal_rest_reason_text((invcal_rest_reason)i));
        }
    }
}

static void print_rejected(FILE *file, const calibrate_result *result)
{
    const rejection *r = &result->rejected;
    char text[TEXT_MAX];

    for (unsigned i = 0; i < r->count; i++) {
        fprintf(file, "Left out: position %u (line %lu), wrong by %s\n", r->list[i].position + 1,
                result->data->line[r->list[i].position],
                residual_text(r->list[i].error, result->settings.field, text));
    }
    if (r->suspected > 0) {
        fprintf(file, "Something is wrong among %u more positions, but not to be told which.\n",
                r->suspected);
    }
}

void calibrate_print(FILE *file, const calibrate_result *result, const char *nominal_name,
                     const char *saved)
{
    const int known = calibrate_knows_noise(result);
    const nominal_choice *n = &result->nominal;
    char field[NUMBER_TEXT_MAX];

    print_recognised(file, result->data);
    print_log(file, result);
    fprintf(file, "%s: %u positions, field %s %s\n", result->data->name, result->data->count,
            number_text(result->settings.field, field), field_unit(result->settings.field));
    print_rejected(file, result);
    if (n->zero == n->lsb) {
        fprintf(file, "%s: zero and scale %s\n\n", nominal_name, nominal_origin_text(n->zero));
    } else {
        fprintf(file, "%s: zero %s, scale %s\n\n", nominal_name, nominal_origin_text(n->zero),
                nominal_origin_text(n->lsb));
    }
    fprintf(file, "%-14s%14s ± %-10s%14s%14s\n", "", "calibrated", "sigma", nominal_name,
            "difference");
    print_offsets(file, result, known);
    print_scales(file, result, known);
    print_errors(file, result, known);
    fprintf(file, "\n");
    print_residuals(file, result, nominal_name);
    fprintf(file, "\n");
    print_verdict(file, &result->quality);
    print_next(file, &result->quality, saved);
}
