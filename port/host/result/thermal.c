/* SPDX-License-Identifier: MIT
 *
 * Temperature on the terminal.
 */
#include <math.h>

#include "result/result.h"
#include "text/figure.h"
#include "text/tabular.h"
#include "text/wrapped.h"
#include "design/parameters.h"

#define TEXT_MAX 512
#define LABEL 14u /* columns of the label of a line */

/* The unit of a slope. */
typedef struct {
    double scale;
    const char *unit;
} slope_unit;

static slope_unit unit_of(const calibrate_result *r, unsigned parameter)
{
    const int is_ins = r->units == UNIT_STYLE_INS;

    return parameter >= INVCAL_GAMMA_XY
               ? (slope_unit){unit_style_angle(r->units).scale, is_ins ? "arcsec/K" : "degrees/K"}
           : parameter >= INVCAL_DK_X ? (slope_unit){1e6, "ppm/K"}
           : calibrate_is_gravity(r)
               ? (slope_unit){unit_style_field(r->units, 1).scale, is_ins ? "µg/K" : "mg/K"}
               : (slope_unit){1e6, "ppm of the field/K"};
}

static void print_fitted(FILE *file, const thermal_fit *fit)
{
    const invcal_thermal *c = &fit->calibration;
    static const char *const words[] = {"no slopes", "straight lines", "parabolas"};
    char text[TEXT_MAX];

    wrapped_printf(file, LABEL,
                   "temperature   %.2f ... %.2f °C, %s; all values above are at %.2f °C", c->min,
                   c->max, words[c->fitted], c->reference);
    if (c->fallback != INVCAL_THERMAL_AS_ASKED) {
        snprintf(text, sizeof text, "%s instead of %s: %s.",
                 c->fitted > 0 ? "Straight lines" : "No slopes", words[fit->options.degree],
                 invcal_thermal_fallback_text(c->fallback));
        wrapped_line(file, 0, 0, text);
    }
}

static void print_slopes(FILE *file, const calibrate_result *r)
{
    const thermal_fit *fit = &r->fit;
    const int known = calibrate_knows_noise(r);
    char text[FIGURE_MAX];

    tabular_begin(file, "lrl");
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        const slope_unit u = unit_of(r, p);
        const double scale = u.scale * calibrate_slope_scale(r, p);
        const double spread = known ? scale * fit->slope_sigma[p] : 0;
        const int places = figure_places(scale * fit->slope[p], spread);
        tabular_cell("%s", parameter_words(p));
        tabular_cell("%s", figure_fixed(scale * fit->slope[p], places, FIGURE_SIGNED, text));
        tabular_cell("± %s", known ? figure_fixed(spread, places, FIGURE_PLAIN, text) : "?");
        tabular_note("%s%s", u.unit, fit->calibration.fitted > 1 ? ", at that temperature" : "");
        tabular_row();
    }
    tabular_end();
}

void calibrate_print_thermal(FILE *file, const calibrate_result *r)
{
    const thermal_fit *fit = &r->fit;
    char text[TEXT_MAX];
    char value[FIGURE_MAX];

    if (r->temperature != CALIBRATE_THERMAL) {
        if (*calibrate_temperature_advice(r, text)) {
            wrapped_line(file, 0, 0, text);
        }
        return;
    }
    print_fitted(file, fit);
    if (fit->calibration.fitted > 0) {
        print_slopes(file, r);
    }
    if (fit->calibration.fitted > 0 && r->quality.dof > 0 && !isnan(fit->without)) {
        const display_unit display = calibrate_display_unit(r);
        char without[FIGURE_MAX];
        snprintf(text, sizeof text,
                 "Nine parameters without temperature leave an rms of %s %s in the same positions, "
                 "%s times as large.",
                 figure_digits(display.scale * fit->without, 3, without), display.unit,
                 figure_digits(fit->without / r->quality.rms, 3, value));
        wrapped_line(file, 0, 0, text);
    }
}
