/* SPDX-License-Identifier: MIT */
#include "result/faces.h"

#include <math.h>

#include "invcal/positions.h"
#include "design/parameters.h"
#include "text/figure.h"
#include "core/system.h"

#define POSITIONS_MIN 6u /* positions */
#define ANGLE_BITS (7u << INVCAL_GAMMA_XY)
#define NOISE_ASSUMED 1e-3 /* of a position mean over the field, if it is unknown */

int faces_are_good(const calibrate_result *r)
{
    return fit_held(&r->settings, &r->quality) &&
           (r->quality.verdict == INVCAL_GOOD || r->quality.verdict == INVCAL_NO_REDUNDANCY);
}

/* An angle changes the length in direction xyz by itself times xy, xz or zy. */
faces_error faces_error_of(const calibrate_result *r)
{
    const uint16_t held = fit_held(&r->settings, &r->quality);
    uncertainty u = {.unit = FIT_NORMAL};
    double square = 0;

    for (unsigned p = INVCAL_GAMMA_XY; p < INVCAL_PARAMETERS; p++) {
        const double sigma = held >> p & 1 ? r->quality.sigma[p] : 0;
        u.covariance[INVCAL_PACKED(p, p)] = sigma * sigma;
        square += sigma * sigma / 15;
    }
    uncertainty_search(&u);
    return (faces_error){FIT_NORMAL * sqrt(square), u.max};
}

const char *faces_cost(const calibrate_result *r, char text[FACES_MAX])
{
    const uint16_t held = fit_held(&r->settings, &r->quality);
    const display_unit display = calibrate_display_unit(r);
    const display_unit angle = unit_style_angle(r->units);
    const faces_error e = faces_error_of(r);
    char list[128] = "angles";
    char number[3][FIGURE_MAX];

    if (held != ANGLE_BITS) {
        (void)parameters_list(held, list, sizeof list);
    }
    snprintf(text, FACES_MAX,
             "%s not measured: taken as %s ±%s %s (one standard deviation, from a data sheet). "
             "That leaves an error of ±%s %s in lengths (95 %%, over all directions), ±%s %s at "
             "worst, and none with an axis up.%s",
             list, r->nominal.lsb == NOMINAL_EARLIER ? "in the earlier calibration," : "0",
             figure_digits(angle.scale * r->settings.prior[INVCAL_GAMMA_XY], 2, number[0]),
             angle.unit, figure_digits(display.scale * e.rms, 2, number[1]), display.unit,
             figure_digits(display.scale * e.max, 2, number[2]), display.unit,
             r->quality.dof > 0 ? "" : " No redundant position checks offsets and scales.");
    return text;
}

void faces_json(json_writer *w, const calibrate_result *r)
{
    const faces_error e = faces_error_of(r);

    json_object(w, "six_faces");
    json_number(w, "angle_sigma", r->settings.prior[INVCAL_GAMMA_XY]);
    json_parameters(w, "not_measured", fit_held(&r->settings, &r->quality));
    json_number(w, "length95", e.rms * r->settings.field);
    json_number(w, "length95_most", e.max * r->settings.field);
    json_object_end(w);
}

int faces_suffice(const positions *data, const fit_settings *settings)
{
    fit_settings s = *settings;
    fit_solution solution;
    fit_quality q;

    if (data->count < POSITIONS_MIN || fit_has_prior(settings)) {
        return 0;
    }
    s.is_six_faces = 1;
    s.noise = s.noise > 0 ? s.noise : NOISE_ASSUMED;
    for (unsigned p = INVCAL_GAMMA_XY; p < INVCAL_PARAMETERS; p++) {
        s.prior[p] = INVCAL_CROSS_AXIS;
    }
    return fit_make(data->mean, data->count, &s, &solution, &q, NULL) == INVCAL_OK &&
           q.verdict != INVCAL_WEAK;
}
