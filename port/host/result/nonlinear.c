/* SPDX-License-Identifier: MIT */
#include "result/result.h"

#include "text/figure.h"
#include "text/json_write.h"
#include "text/number.h"
#include "text/tabular.h"

void calibrate_nonlinear_rows(const calibrate_result *r)
{
    const int is_gravity = calibrate_is_gravity(r);
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
