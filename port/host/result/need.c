/* SPDX-License-Identifier: MIT */
#include "result/need.h"

#include <math.h>
#include <string.h>

#include "text/append.h"
#include "text/figure.h"

#define POSITIONS_RATIO_MAX 3.0 /* if more positions than this are needed, recommend longer rests */

#define FIELD_TOLERANCE 0.01 /* of 1, the length of a field in g */

static int ends_with(const char *text, size_t length, const char *ending)
{
    const size_t size = strlen(ending);

    return length >= size && memcmp(text + length - size, ending, size) == 0;
}

/* Otherwise what is left of "5mgg" or "2um/s2" belongs to an unknown unit. */
static int ends_as_number(const char *text, size_t length)
{
    return length > 0 && text[length - 1] != '\0' && strchr("0123456789.", text[length - 1]);
}

/* Units; `scale` is a field of length 1 in this unit, or 0 for its length in m/s^2. */
static const struct {
    const char *ending;
    display_unit unit;
    int is_of_gravity;
} units[] = {
    {"mg", {1e3, "mg"}, 1},   {"ug", {1e6, "µg"}, 1},
    {"µg", {1e6, "µg"}, 1},   {"g", {1, "g"}, 1},
    {"m/s2", {0, "m/s²"}, 1}, {"m/s^2", {0, "m/s²"}, 1},
    {"m/s²", {0, "m/s²"}, 1}, {"%", {1e2, "% of the field"}, 0},
};

need_ending need_parse(const char *text, double field, size_t *digits, display_unit *unit)
{
    const size_t length = strlen(text);
    const int is_gravity = unit_is_gravity(field);
    const int is_in_g = fabs(field - 1) <= FIELD_TOLERANCE;

    *digits = length;
    for (unsigned i = 0; i < sizeof units / sizeof *units; i++) {
        if (!ends_with(text, length, units[i].ending)) {
            continue;
        }
        const int is_si = !(units[i].unit.scale > 0);
        if (units[i].is_of_gravity && !is_gravity && (is_si || !is_in_g)) {
            return NEED_NO_GRAVITY;
        }
        *digits = length - strlen(units[i].ending);
        while (*digits > 0 && text[*digits - 1] == ' ') {
            --*digits;
        }
        if (!ends_as_number(text, *digits)) {
            return NEED_NO_UNIT;
        }
        *unit = is_si ? (display_unit){field, units[i].unit.unit} : units[i].unit;
        return NEED_UNIT;
    }
    *unit = (display_unit){field, is_gravity ? "m/s²" : "field units"};
    return ends_as_number(text, length) ? NEED_PLAIN : NEED_NO_UNIT;
}

double need_field_part(const calibrate_result *r)
{
    return FIT_NORMAL * r->field_sigma;
}

double need_accuracy(const calibrate_result *r)
{
    const double field = need_field_part(r);

    return sqrt(r->accuracy * r->accuracy +
                field * field); /* hypot rounds differently from libc to libc */
}

/* The need over the field. */
static double needed(const calibrate_result *r)
{
    return r->need / r->settings.field;
}

/* How many times as much must be measured: the error falls with its square root. */
static double effort_ratio(const calibrate_result *r)
{
    const double field = need_field_part(r);

    return r->accuracy * r->accuracy / (needed(r) * needed(r) - field * field);
}

static need_missing missing_by_verdict(const calibrate_result *r)
{
    switch (r->quality.verdict) {
    case INVCAL_GOOD:
        return r->rejected.suspected > 0 ? NEED_STEADINESS : NEED_NOTHING;
    case INVCAL_DRIFTING:
        return NEED_WARM_UP;
    case INVCAL_BENT:
        return NEED_LINEARITY;
    case INVCAL_ROUGH:
        return NEED_STEADINESS;
    default:
        return NEED_DIRECTIONS;
    }
}

need_missing need_judge(const calibrate_result *r)
{
    const need_missing verdict = missing_by_verdict(r);

    if (verdict != NEED_NOTHING || need_accuracy(r) <= needed(r)) {
        return verdict;
    }
    if (!(need_field_part(r) < needed(r))) {
        return NEED_GRAVITY;
    }
    if (calibrate_is_disturbed(r)) {
        return NEED_STEADINESS;
    }
    if (calibrate_is_uneven(r) || fit_held(&r->settings, &r->quality)) {
        return NEED_DIRECTIONS;
    }
    return effort_ratio(r) <= POSITIONS_RATIO_MAX || calibrate_is_coarse(r) ? NEED_POSITIONS
                                                                            : NEED_REST;
}

const char *need_word(need_missing missing)
{
    static const char *const words[] = {"nothing", "warm-up",    "linearity", "steadiness",
                                        "gravity", "directions", "positions", "longer rests"};

    return words[missing];
}

const char *need_advice(const calibrate_result *r, char text[NEED_MAX])
{
    const need_missing missing = need_judge(r);
    const unsigned count = r->rejected.kept_count;
    const char *what = "";
    char number[FIGURE_MAX];

    switch (missing) {
    case NEED_NOTHING:
        break;
    case NEED_WARM_UP:
        what = "Missing: a warm sensor; this one drifts.";
        break;
    case NEED_LINEARITY:
        what = "Missing: a linear sensor; nine parameters do not correct nonlinearity.";
        break;
    case NEED_STEADINESS:
        what = "Missing: steadier positions: they disagree by more than noise, and longer rests do "
               "not help.";
        break;
    case NEED_DIRECTIONS:
        what = "Missing: positions in directions not covered yet.";
        break;
    case NEED_GRAVITY:
        snprintf(text, NEED_MAX,
                 "Missing: the length of the field with a σ of %s (--gravity G+-S, or --latitude): "
                 "its error is an error of all scales.",
                 figure_digits(r->need / FIT_NORMAL, 2, number));
        return text;
    case NEED_REST:
        snprintf(text, NEED_MAX,
                 "Missing: rests about %s times as long, if the noise averages out, or a quieter "
                 "sensor.",
                 figure_digits(effort_ratio(r), 2, number));
        return text;
    case NEED_POSITIONS:
        snprintf(text, NEED_MAX, "Missing: about %.0f positions instead of %u, or ",
                 ceil(count * effort_ratio(r)), count);
        if (calibrate_is_coarse(r)) {
            append(text, NEED_MAX, "a finer resolution; longer rests do not help.");
        } else {
            append(text, NEED_MAX, "rests %s times as long.",
                   figure_digits(effort_ratio(r), 2, number));
        }
        return text;
    }
    snprintf(text, NEED_MAX, "%s", what);
    return text;
}
