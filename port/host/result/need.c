/* SPDX-License-Identifier: MIT */
#include "result/need.h"

#include <math.h>

#include "text/figure.h"

#define MANY_MORE 3.0 /* times as many positions: longer rests are easier */

enum { WHAT_MAX = NEED_MAX / 2 };

double need_of_field(const calibrate_result *r)
{
    return FIT_NORMAL * r->field_sigma;
}

double need_reached(const calibrate_result *r)
{
    const double field = need_of_field(r);

    return sqrt(r->accuracy * r->accuracy +
                field * field); /* hypot rounds differently in each libc */
}

/* Over the field. */
static double wanted(const calibrate_result *r)
{
    return r->need / r->settings.field;
}

/* How many times as much has to be measured: what is wrong falls with the root of that. */
static double times_more(const calibrate_result *r)
{
    const double field = need_of_field(r);

    return r->accuracy * r->accuracy / (wanted(r) * wanted(r) - field * field);
}

static need_missing of_verdict(const calibrate_result *r)
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
    const need_missing verdict = of_verdict(r);

    if (verdict != NEED_NOTHING || need_reached(r) <= wanted(r)) {
        return verdict;
    }
    if (!(need_of_field(r) < wanted(r))) {
        return NEED_GRAVITY;
    }
    if (calibrate_is_disturbed(r)) {
        return NEED_STEADINESS;
    }
    if (calibrate_is_uneven(r) || fit_held(&r->settings, &r->quality)) {
        return NEED_DIRECTIONS;
    }
    return times_more(r) <= MANY_MORE ? NEED_POSITIONS : NEED_REST;
}

const char *need_word(need_missing missing)
{
    static const char *const words[] = {"nothing", "warm-up",    "linearity", "steadiness",
                                        "gravity", "directions", "positions", "longer rests"};

    return words[missing];
}

/* What is to be done about it. */
static void say_missing(const calibrate_result *r, need_missing missing, char text[WHAT_MAX])
{
    const unsigned count = r->rejected.kept_count;
    const char *what = "";
    char number[FIGURE_MAX];

    switch (missing) {
    case NEED_NOTHING:
        break;
    case NEED_WARM_UP:
        what = "Missing: a sensor that has warmed up, for it drifts.";
        break;
    case NEED_LINEARITY:
        what =
            "Missing: a sensor that is linear; no calibration of nine parameters makes up for it.";
        break;
    case NEED_STEADINESS:
        what = "Missing: steadier positions, for they disagree by more than noise; longer rests "
               "do not help.";
        break;
    case NEED_DIRECTIONS:
        what = "Missing: positions in directions that have none yet.";
        break;
    case NEED_GRAVITY:
        snprintf(text, WHAT_MAX,
                 "Missing: the length of the field, to ±%s (--gravity G+-S, or --latitude); all "
                 "scales inherit its error.",
                 figure_digits(r->need / FIT_NORMAL, 2, number));
        return;
    case NEED_REST:
        snprintf(text, WHAT_MAX,
                 "Missing: rests about %s times as long, as far as the noise averages out; or a "
                 "sensor of less noise.",
                 figure_digits(times_more(r), 2, number));
        return;
    case NEED_POSITIONS:
        snprintf(text, WHAT_MAX,
                 "Missing: about %.0f positions in place of %u, or rests %s times as long.",
                 ceil(count * times_more(r)), count, figure_digits(times_more(r), 2, number));
        return;
    }
    snprintf(text, WHAT_MAX, "%s", what);
}

const char *need_text(const calibrate_result *r, char text[NEED_MAX])
{
    const need_missing missing = need_judge(r);
    const char *unit = calibrate_field_unit(r);
    char reached[FIGURE_MAX];
    char need[FIGURE_MAX];
    char what[WHAT_MAX];

    say_missing(r, missing, what);
    (void)figure_digits(r->need, 2, need);
    (void)figure_digits(r->settings.field * need_reached(r), 2, reached);
    if (of_verdict(r) != NEED_NOTHING) {
        snprintf(text, NEED_MAX, "Not good for ±%s %s. %s", need, unit, what);
    } else if (!calibrate_knows_noise(r)) {
        snprintf(text, NEED_MAX, "Not known to be good for ±%s %s: nothing tells the noise.", need,
                 unit);
    } else {
        snprintf(text, NEED_MAX, "%s for ±%s %s: lengths are right within ±%s %s (95 %%).%s%s",
                 missing == NEED_NOTHING ? "Good" : "Not good", need, unit, reached, unit,
                 *what ? " " : "", what);
    }
    return text;
}
