/* SPDX-License-Identifier: MIT */
#include "plan/words.h"

#include <math.h>
#include <string.h>

#include "invcal/plan.h"
#include "text/figure.h"

#define NO_BREAK_SPACE "\302\240" /* U+00A0, between a number and its unit */
#define SECONDS_MAX 1e15          /* beyond it, hours have too many digits */

const char *const plan_kinds[PLAN_KINDS] = {"offsets", "scale errors", "angles"};

display_unit plan_unit(unsigned kind, unit_style style)
{
    return kind == 0                      ? unit_style_field(style, 1)
           : kind == 1                    ? unit_style_scale(style)
           : style == UNIT_STYLE_EVERYDAY ? (display_unit){FIGURE_DEGREES, "°"}
                                          : unit_style_angle(style);
}

const char *plan_axes_text(unsigned axes, char text[PLAN_WORDS_MAX])
{
    text[0] = '\0';
    for (unsigned i = 0; i < INVCAL_AXES; i++) {
        if (axes >> i & 1u) {
            const size_t length = strlen(text);
            snprintf(text + length, PLAN_WORDS_MAX - length, "%s%s", length > 0 ? " " : "",
                     design_axis_name(i));
        }
    }
    return text;
}

const char *plan_angle_text(double degrees, char text[PLAN_WORDS_MAX])
{
    snprintf(text, PLAN_WORDS_MAX, "%.7g", nearbyint(1000 * degrees) / 1000 + 0.0);
    return text;
}

const char *plan_time_text(double seconds, char text[PLAN_WORDS_MAX])
{
    if (!(seconds >= 59.5 && seconds < SECONDS_MAX)) {
        snprintf(text, PLAN_WORDS_MAX, "%.3g" NO_BREAK_SPACE "s", seconds);
        return text;
    }
    const unsigned long long whole = (unsigned long long)(seconds + 0.5);
    if (whole < 3600) {
        snprintf(text, PLAN_WORDS_MAX,
                 "%llu" NO_BREAK_SPACE "min" NO_BREAK_SPACE "%02llu" NO_BREAK_SPACE "s", whole / 60,
                 whole % 60);
    } else {
        const unsigned long long minutes = (unsigned long long)(seconds / 60 + 0.5);
        snprintf(text, PLAN_WORDS_MAX,
                 "%llu" NO_BREAK_SPACE "h" NO_BREAK_SPACE "%02llu" NO_BREAK_SPACE "min",
                 minutes / 60, minutes % 60);
    }
    return text;
}

double plan_sigma(const criteria *c, unsigned kind)
{
    const double sigma[PLAN_KINDS] = {c->sigma_delta, c->sigma_dk, c->sigma_gamma};

    return sigma[kind];
}

double plan_sigma_largest(const criteria *c)
{
    return fmax(c->sigma_delta, fmax(c->sigma_dk, c->sigma_gamma));
}

const char *plan_sigma_text(unsigned kind, double sigma, double noise, unit_style style,
                            char text[PLAN_WORDS_MAX])
{
    char number[FIGURE_MAX];

    if (noise > 0) {
        const display_unit unit = plan_unit(kind, style);
        figure_digits(unit.scale * noise * sigma, 3, number);
        snprintf(text, PLAN_WORDS_MAX, "%s" NO_BREAK_SPACE "%s", number, unit.unit);
    } else {
        snprintf(text, PLAN_WORDS_MAX, "%s", figure_digits(sigma, 3, number));
    }
    return text;
}

const char *plan_noise_suffix(double noise)
{
    return noise > 0 ? "" : ", × noise";
}

const char *plan_missing_reason(const design *d)
{
    if (d->has_shares) {
        return "the positions there have no share of the time";
    }
    if (d->plan.per_group == 0) {
        return "none of its directions points there";
    }
    return d->plan.per_group % 2 == 1
               ? "an odd number per group cannot point all six along gravity: +g and -g are half a "
                 "turn apart"
               : "its start angles miss them; the default ones include all six";
}
