/* SPDX-License-Identifier: MIT */
#include "result/pass.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cli/message.h"
#include "design/parameters.h"
#include "result/faces.h"
#include "result/need.h"
#include "text/append.h"
#include "text/figure.h"
#include "text/number.h"

#define NEAR_LIMIT 0.006 /* of the limit: figures this close are printed with more digits */

static int is_good(const calibrate_result *r)
{
    return strcmp(verdict_word(r), "Good") == 0 || faces_are_good(r);
}

/* Upper bound of |x| of a parameter, 95 %. */
static double upper_bound(const calibrate_result *r, unsigned p)
{
    return calibrate_knows_noise(r)
               ? fabs(r->solution.x[p]) + fit_coverage(&r->quality, p) * r->quality.sigma[p]
               : NUMBER_UNKNOWN;
}

static double lower_bound(const calibrate_result *r, unsigned p)
{
    const double spread =
        calibrate_knows_noise(r) ? fit_coverage(&r->quality, p) * r->quality.sigma[p] : 0;

    return fabs(r->solution.x[p]) - spread;
}

static void judge_limits(const calibrate_result *r, pass *p)
{
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        p->limit[i] = p->used[i] = NUMBER_UNKNOWN;
        if (!(r->limit[i] > 0)) {
            continue;
        }
        p->limit[i] = r->limit[i];
        p->used[i] = upper_bound(r, i) / p->limit[i];
        p->limited |= (uint16_t)(1u << i);
        p->failed |= (uint16_t)((unsigned)!(p->used[i] <= 1) << i);
        p->beyond |= (uint16_t)((unsigned)!(lower_bound(r, i) <= p->limit[i]) << i);
        p->nearest = !(p->used[i] <= p->used[p->nearest]) ? i : p->nearest;
    }
}

pass pass_judge(const calibrate_result *r)
{
    pass p = {.need_used = NUMBER_UNKNOWN};

    judge_limits(r, &p);
    p.has_criteria = r->need > 0 || r->has_limits;
    if (r->need > 0 && calibrate_knows_noise(r)) {
        p.need_used = r->settings.field * need_accuracy(r) / r->need;
    }
    p.is_passed = p.has_criteria && is_good(r) && !p.failed && (!(r->need > 0) || p.need_used <= 1);
    return p;
}

/* ---- in words ---------------------------------------------------------------------------------- */

/* Appends "rough", ... */
static void add_verdict(const calibrate_result *r, char text[PASS_MAX])
{
    const char *word = verdict_word(r);

    append(text, PASS_MAX, "%c%s", tolower((unsigned char)word[0]), word + 1);
}

/* Appends the reason for the verdict. */
static void add_cause(const calibrate_result *r, char text[PASS_MAX])
{
    char cause[VERDICT_MAX];
    char list[128];

    if (r->quality.verdict == INVCAL_WEAK) {
        append(text, PASS_MAX, ": %s poorly determined",
               parameters_list(r->quality.weak, list, sizeof list));
    } else if (r->quality.verdict == INVCAL_NO_REDUNDANCY) {
        append(text, PASS_MAX, ": nothing checks the fit");
    } else {
        append(text, PASS_MAX, ": %s", verdict_cause(r, cause));
    }
}

static void add_need(const calibrate_result *r, char text[PASS_MAX])
{
    const double scale = r->need_unit.scale;
    char reached[FIGURE_MAX] = "";
    char needed[FIGURE_MAX] = "";

    for (int digits = 2; digits <= 6 && strcmp(reached, needed) == 0; digits++) {
        figure_digits(scale * need_accuracy(r), digits, reached);
        figure_digits(scale * r->need / r->settings.field, digits, needed);
    }
    append(text, PASS_MAX, "%s within %s of %s %s", calibrate_is_gravity(r) ? "|a|" : "length",
           reached, needed, r->need_unit.unit);
}

static void add_limit(const calibrate_result *r, unsigned parameter, double limit,
                      char text[PASS_MAX])
{
    const display_unit degrees = {FIGURE_DEGREES, "°"};
    const display_unit angle = r->units == UNIT_STYLE_INS ? unit_style_angle(r->units) : degrees;
    const display_unit display = parameter < INVCAL_DK_X       ? calibrate_display_unit(r)
                                 : parameter < INVCAL_GAMMA_XY ? unit_style_scale(r->units)
                                                               : angle;
    const double ratio = upper_bound(r, parameter) / limit;
    const int digits = fabs(ratio - 1) < NEAR_LIMIT ? 6 : 3; /* to show which one is larger */
    char reached[FIGURE_MAX];
    char allowed[FIGURE_MAX];

    append(text, PASS_MAX, "%s up to %s of %s%s%s", parameter_words(parameter),
           figure_digits(display.scale * upper_bound(r, parameter), digits, reached),
           figure_digits(display.scale * limit, digits, allowed),
           strcmp(display.unit, degrees.unit) == 0 ? "" : " ", display.unit);
}

const char *pass_text(const calibrate_result *r, char text[PASS_MAX])
{
    const pass p = pass_judge(r);
    const int is_known = calibrate_knows_noise(r);
    unsigned others = 0;

    snprintf(text, PASS_MAX, "%s:", p.is_passed ? "PASS" : "FAIL");
    if (!is_good(r)) {
        append(text, PASS_MAX, " the verdict is ");
        add_verdict(r, text);
    }
    if (!is_known) {
        append(text, PASS_MAX, "%s the noise is unknown, and with it the accuracy (state --noise)",
               is_good(r) ? "" : ";");
    }
    if (is_known && r->need > 0) {
        append(text, PASS_MAX, "%s ", is_good(r) ? "" : ";");
        add_need(r, text);
    }
    if (is_known && p.limited) {
        append(text, PASS_MAX, "%s ", is_good(r) && !(r->need > 0) ? "" : ";");
        add_limit(r, p.nearest, p.limit[p.nearest], text);
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            others += i != p.nearest && (p.failed >> i & 1u);
        }
    }
    if (others > 0) {
        append(text, PASS_MAX, " and %u more", others);
    }
    append(text, PASS_MAX, "%s.", is_known ? " (95 %)" : "");
    return text;
}

const char *pass_strict(const calibrate_result *r, char text[PASS_MAX])
{
    const pass p = pass_judge(r);
    char advice[NEED_MAX];

    text[0] = '\0';
    if (p.has_criteria && !p.is_passed) {
        (void)pass_text(r, text);
        append(text, PASS_MAX, "%s%s", r->need > 0 && *need_advice(r, advice) ? " " : "",
               r->need > 0 ? advice : "");
        return text;
    }
    if (!is_good(r)) {
        append(text, PASS_MAX, "the verdict is ");
        add_verdict(r, text);
        add_cause(r, text);
    }
    return text;
}
