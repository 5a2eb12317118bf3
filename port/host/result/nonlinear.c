/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "result/result.h"
#include "cli/command.h"
#include "text/figure.h"
#include "text/json_write.h"
#include "cli/message.h"
#include "text/number.h"
#include "text/tabular.h"

#define REASON_MAX 400

static const char *option_of(unsigned degree)
{
    return degree > 2 ? "--cubic" : "--quadratic";
}

/* Which of them stay open, and what helps. */
static void say_open(const calibrate_result *r, unsigned degree, char text[REASON_MAX])
{
    const unsigned open =
        nonlinearity_open(r->rejected.kept, r->rejected.kept_count, &r->solution.symmetric, degree);
    unsigned count = 0;
    size_t used = (size_t)snprintf(text, REASON_MAX,
                                   "%s: the positions leave undetermined:", option_of(degree));

    for (unsigned e = 0; e < NONLINEARITY_MOST; e++) {
        if (open >> e & 1 && used < REASON_MAX) {
            used += (size_t)snprintf(text + used, REASON_MAX - used, "%s %s",
                                     count++ > 0 ? "," : "", nonlinearity_name(e));
        }
    }
    if (used < REASON_MAX) {
        snprintf(text + used, REASON_MAX - used,
                 "; add positions between the axes and along them, 6 or more in a circle");
    }
}

static int refuse(const calibrate_result *r, unsigned degree, invcal_status status, int json)
{
    char text[REASON_MAX];
    json_writer w;

    if (status == INVCAL_TOO_FEW) {
        snprintf(text, sizeof text, "%s: %u positions are too few: %u or more are needed",
                 option_of(degree), r->rejected.kept_count, nonlinearity_least(degree));
    } else {
        say_open(r, degree, text);
    }
    message("%s: %s", r->data->name, text);
    if (json) {
        json_begin(&w, stdout);
        json_text(&w, "error", status == INVCAL_TOO_FEW ? "too few" : "undetermined");
        json_text(&w, "reason", text);
        json_parameters(&w, "undetermined", 0);
        json_end(&w);
    }
    return EXIT_DATA;
}

int calibrate_nonlinear(calibrate_result *r, unsigned degree, int json)
{
    invcal_quality *found = &r->rejected.found;
    const invcal_status status =
        nonlinearity_fit(r->rejected.kept, r->rejected.kept_count, &r->settings, degree,
                         &r->solution, &r->quality, r->nonlinear, r->nonlinear_sigma);

    if (status != INVCAL_OK) {
        return refuse(r, degree, status, json);
    }
    r->degree = degree;
    r->is_drift_fitted = 0;
    if (found->systematic == INVCAL_QUADRATIC ||
        (degree > 2 && found->systematic == INVCAL_CUBIC)) {
        found->systematic = INVCAL_NO_SYSTEMATIC; /* it is told as what it is */
        found->verdict = INVCAL_GOOD;
    }
    found->unchecked &=
        (uint8_t)~((1u << INVCAL_QUADRATIC) | (degree > 2 ? 1u << INVCAL_CUBIC : 0));
    return EXIT_GOOD;
}

void calibrate_nonlinear_rows(const calibrate_result *r)
{
    const int is_gravity = unit_is_gravity(r->settings.field);
    const int known = calibrate_knows_noise(r);
    const double in = is_gravity ? 1e3 : 1e2;

    for (unsigned e = 0; r->degree > 0 && e < 3 * (r->degree - 1); e++) {
        char text[FIGURE_MAX];
        const double one = known ? in * r->nonlinear_sigma[e] : NUMBER_UNKNOWN;
        const int places = figure_places(in * r->nonlinear[e], one);
        tabular_cell("%s", nonlinearity_name(e));
        tabular_cell("%s", figure_fixed(in * r->nonlinear[e], places, FIGURE_PLAIN, text));
        tabular_cell("± %s", known ? figure_fixed(one, places, FIGURE_PLAIN, text) : "?");
        tabular_note("%s", !is_gravity ? "% of the field, at the field"
                           : e < 3     ? "mg per g²"
                                       : "mg per g³");
        tabular_row();
    }
}

void calibrate_nonlinear_json(json_writer *w, const calibrate_result *r)
{
    static const char *const names[2][2] = {{"quadratic", "quadratic_sigma"},
                                            {"cubic", "cubic_sigma"}};
    const double unknown[3] = {NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN};
    const invcal_calibration nominal = fit_in_field_units(&r->settings.nominal, r->settings.field);
    const int known = calibrate_knows_noise(r);

    json_object(w, "nonlinearity");
    for (unsigned k = 0; k < 2 && k + 1 < r->degree; k++) {
        const double *sigma = &r->nonlinear_sigma[3 * (size_t)k];
        json_vector(w, names[k][0], &r->nonlinear[3 * (size_t)k]);
        json_vector(w, names[k][1], known ? sigma : unknown);
    }
    json_number(w, "field", r->settings.field);
    json_matrix(w, "nominal_matrix", (const double(*)[3])nominal.matrix);
    json_object_end(w);
}
