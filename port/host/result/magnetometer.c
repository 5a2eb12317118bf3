/* SPDX-License-Identifier: MIT
 *
 * The result of a magnetometer that was waved, in words and as JSON.
 */
#include <math.h>

#include "design/parameters.h"
#include "invcal/plan.h"
#include "result/result.h"
#include "text/figure.h"
#include "text/paint.h"
#include "text/plain.h"
#include "text/wrapped.h"

void calibrate_magnetometer_print(FILE *file, const calibrate_result *result)
{
    const magnetometer_log *m = result->magnetometer;
    char name[PLAIN_MAX];

    wrapped_printf(file, 0, "%s: %lu samples, %.6g s at %.4g samples per second%s",
                   plain_copy(result->data->name, name), m->samples, m->seconds, m->rate,
                   m->is_rate_known ? "" : " (a guess: state --rate)");
    wrapped_printf(file, 9,
                   "%*u of %u directions covered; neighbouring samples are correlated: %.0f of "
                   "them count as one",
                   8, m->found.covered, INVCAL_CELLS, m->found.alike > 1 ? m->found.alike : 1);
    if (m->found.dropped > 0) {
        fprintf(file, "%*lu samples contradict the others, and are left out\n", 8,
                (unsigned long)m->found.dropped);
    }
    if (m->found.disturbance != INVCAL_UNDISTURBED) {
        wrapped_printf(file, 0, "%sDisturbed:%s %s.", paint_on(file, PAINT_RED), paint_off(file),
                       invcal_disturbance_text(m->found.disturbance));
    }
}

const char *calibrate_magnetometer_fault(const calibrate_result *result,
                                         char text[CALIBRATE_LIMIT_MAX])
{
    const invcal_magnetometer_found *f = &result->magnetometer->found;
    char words[INVCAL_TEXT_SIZE];

    if (result->quality.verdict == INVCAL_WEAK && f->gap_deg > 45) {
        const double up[3] = {-result->magnetometer->next[0], -result->magnetometer->next[1],
                              -result->magnetometer->next[2]};
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "a gap of %u degrees in the sphere is not covered. North of the equator, hold it "
                 "%s and swing it around.",
                 f->gap_deg, invcal_direction_text(up, words));
    } else if (result->quality.verdict == INVCAL_NO_REDUNDANCY) {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "every parameter is determined, but there is no redundancy to check the fit.");
    } else if (result->quality.verdict == INVCAL_WEAK) {
        char list[128];
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "poorly determined; rely on them only within their ±: %s.",
                 parameters_list(result->quality.weak, list, sizeof list));
    } else if (f->disturbance > INVCAL_PASSING) {
        snprintf(text, CALIBRATE_LIMIT_MAX, "%s.", invcal_disturbance_text(f->disturbance));
    } else {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "%lu of %lu samples contradict the others: repeat away from iron and magnets.",
                 (unsigned long)f->dropped, (unsigned long)f->dropped + f->samples);
    }
    return text;
}

/* What limits the rotation, and what to do. */
static const char *axes_advice(const calibrate_result *result)
{
    const dip_frame *d = &result->dip;

    return d->answer == DIP_UNEVEN ? " the length of gravity varies: correct the accelerometer "
                                     "with its own calibration (--with CAL.json), and turn slowly."
           : d->answer == DIP_UNDETERMINED
               ? " the log does not determine them: turn about all axes, slowly."
           : d->is_corrected ? ""
                             : " The accelerometer is not corrected: use --with CAL.json.";
}

const char *calibrate_axes_text(const calibrate_result *result, char text[CALIBRATE_AXES_MAX])
{
    const dip_frame *d = &result->dip;
    char angle[3][FIGURE_MAX];
    char dip[FIGURE_MAX];
    char left[FIGURE_MAX];

    text[0] = '\0';
    if (!result->magnetometer || d->answer == DIP_NO_ACCELEROMETER) {
        return text;
    }
    if (d->answer != DIP_FOUND) {
        snprintf(text, CALIBRATE_AXES_MAX, "against the accelerometer's unknown:%s",
                 axes_advice(result));
        return text;
    }
    for (unsigned i = 0; i < 3; i++) {
        (void)figure_with_sigma(FIGURE_DEGREES * d->angle[i], FIGURE_DEGREES * d->sigma[i],
                                FIGURE_SIGNED, angle[i]);
    }
    snprintf(
        text, CALIBRATE_AXES_MAX,
        "%s from %lu of %lu samples, degrees: about x %s, about y %s, about z %s%s. The remaining "
        "error of a heading is %s degrees (one sigma). The field points %s by %s degrees%s.%s",
        result->is_dip_frame ? "rotated to those of the accelerometer"
                             : "to those of the accelerometer",
        d->used, d->of, angle[0], angle[1], angle[2],
        result->is_dip_frame ? "" : "; --frame accelerometer rotates the result",
        figure_digits(FIGURE_DEGREES * d->heading, 2, left), d->dip < 0 ? "up" : "down",
        figure_digits(FIGURE_DEGREES * fabs(d->dip), 3, dip),
        d->dip < 0 ? ", as it does south of the magnetic equator; elsewhere an axis, or the "
                     "accelerometer, has the wrong sign, or two are exchanged"
                   : "",
        axes_advice(result));
    return text;
}

static void write_axes(json_writer *w, const dip_frame *d)
{
    static const char *const answers[] = {
        [DIP_FOUND] = "told", [DIP_UNEVEN] = "uneven lengths", [DIP_UNDETERMINED] = "undetermined"};

    json_object(w, "accelerometer");
    json_text(w, "answer", answers[d->answer]);
    json_text(w, "taken", d->is_corrected ? "calibrated" : "as it reads");
    json_number(w, "used", (double)d->used);
    json_number(w, "of", (double)d->of);
    if (d->answer == DIP_FOUND) {
        json_matrix(w, "rotation", (const double(*)[3])d->rotation.r);
        json_vector(w, "angle", d->angle);
        json_vector(w, "sigma", d->sigma);
        json_number(w, "alike", d->alike);
        json_number(w, "dip", d->dip);
        json_number(w, "scatter", d->scatter);
        json_number(w, "heading_sigma", d->heading);
    }
    json_object_end(w);
}

void calibrate_magnetometer_json(json_writer *w, const calibrate_result *result)
{
    static const char *const names[] = {"none", "passing", "places", "step"};
    const invcal_magnetometer_found *f = &result->magnetometer->found;

    json_object(w, "magnetometer");
    json_text(w, "field", result->is_field_measured ? "measured" : "stated");
    json_number(w, "samples", f->samples);
    json_number(w, "left_out", f->dropped);
    json_number(w, "covered", f->covered);
    json_number(w, "gap", f->gap_deg);
    json_vector(w, "next", result->magnetometer->next);
    json_number(w, "sample_rms", result->magnetometer->sample_rms);
    json_number(w, "alike", f->alike);
    json_text(w, "disturbance", names[f->disturbance]);
    if (result->dip.answer != DIP_NO_ACCELEROMETER) {
        write_axes(w, &result->dip);
    }
    json_object_end(w);
}
