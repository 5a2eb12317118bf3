/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "allan/allan.h"
#include "text/figure.h"
#include "plan/words.h"

#define MISFIT_MAX 1.5 /* of misfit (invcal/allan.h) */
#define REST_MIN 2.0   /* seconds (invcal/expert.h) */
#define FIXED_MIN 1e-4
#define FIXED_MAX 1e5
#define NO_BREAK_SPACE "\302\240" /* U+00A0, between a number and its unit */

const char *const allan_kinds[INVCAL_NOISE_KINDS] = {"white noise", "bias instability",
                                                     "rate random walk"};

const char allan_misfit_words[] =
    "the model does not fit: a filter in the sensor, vibration, a drift, or steps of whole counts";

const char *allan_estimator(const allan_settings *settings)
{
    return settings->is_apart ? "windows apart" : "overlapping";
}

const char *allan_deviation(const allan_result *r, double deviation, char text[ALLAN_WORDS_MAX])
{
    char number[FIGURE_MAX];

    if (r->is_ms2) {
        snprintf(text, ALLAN_WORDS_MAX, "%s" NO_BREAK_SPACE "µg",
                 figure_digits(deviation / ALLAN_MICRO_G, 3, number));
    } else {
        snprintf(text, ALLAN_WORDS_MAX, "%s" NO_BREAK_SPACE "%s",
                 figure_digits(deviation, 3, number), r->unit);
    }
    return text;
}

#define ROOT_HZ "√Hz"
const allan_line allan_lines[ALLAN_LINES] = {
    {"white noise N", "µg/" ROOT_HZ, NULL, INVCAL_NOISE_WHITE, ALLAN_MICRO_G},
    {"bias instability B", "µg", NULL, INVCAL_NOISE_INSTABILITY, ALLAN_MICRO_G},
    {"rate random walk K", "µg " ROOT_HZ, NULL, INVCAL_NOISE_WALK, ALLAN_MICRO_G},
    {"velocity random walk", "m/s/√h", NULL, INVCAL_NOISE_WHITE, 1.0 / 60},
    {"N", NULL, "/" ROOT_HZ, INVCAL_NOISE_WHITE, 1},
    {"B", NULL, "", INVCAL_NOISE_INSTABILITY, 1},
    {"K", NULL, " " ROOT_HZ, INVCAL_NOISE_WALK, 1},
};

int allan_has_line(const allan_result *r, const allan_line *line)
{
    return r->is_ms2 || !line->unit;
}

const char *allan_label(const allan_result *r, const allan_line *line, char text[ALLAN_WORDS_MAX])
{
    if (line->unit) {
        snprintf(text, ALLAN_WORDS_MAX, "%s, %s", line->name, line->unit);
    } else {
        snprintf(text, ALLAN_WORDS_MAX, "%s%s%s, %s%s", r->is_ms2 ? "" : allan_kinds[line->kind],
                 r->is_ms2 ? "" : " ", line->name, r->unit, line->power);
    }
    return text;
}

const char *allan_coefficient(const allan_result *r, const allan_line *line, unsigned axis,
                              char text[ALLAN_WORDS_MAX])
{
    const invcal_noise *n = &r->noise[axis];
    const double value = n->coefficient[line->kind] / line->scale;
    const double sigma = value * n->relative[line->kind];
    char number[FIGURE_MAX];

    if (!(n->visible >> line->kind & 1u)) {
        snprintf(text, ALLAN_WORDS_MAX, "not visible");
    } else if (sigma < FIXED_MIN || sigma > FIXED_MAX) { /* too small or large for fixed decimals */
        snprintf(text, ALLAN_WORDS_MAX, "%.3e ± %.0e", value, sigma);
    } else {
        snprintf(text, ALLAN_WORDS_MAX, "%s",
                 figure_with_sigma(value, sigma, FIGURE_PLAIN, number));
    }
    return text;
}

const char *allan_misfits(const allan_result *r, char text[ALLAN_WORDS_MAX])
{
    text[0] = '\0';
    for (unsigned i = 0; i < 3; i++) {
        if (!(r->noise[i].misfit <= MISFIT_MAX)) {
            const size_t length = strlen(text);
            snprintf(text + length, ALLAN_WORDS_MAX - length, "%s%c", length > 0 ? " " : "",
                     "xyz"[i]);
        }
    }
    return text;
}

const char *allan_advice(const allan_result *r, const allan_settings *settings,
                         char text[ALLAN_WORDS_MAX])
{
    const allan_dwell *d = &r->dwell[r->worst];
    const char axis = "xyz"[r->worst];
    char time[PLAN_WORDS_MAX];
    char sigma[ALLAN_WORDS_MAX];
    char wanted[ALLAN_WORDS_MAX];

    plan_time_text(d->seconds, time);
    allan_deviation(r, d->sigma, sigma);
    if (d->end == ALLAN_LONGEST) {
        snprintf(text, ALLAN_WORDS_MAX,
                 "Hold each position as long as you like: the mean improves up to %s, the longest "
                 "time measured. Its sigma on the worst axis, %c, is then %.60s, limited by %s.",
                 time, axis, sigma, allan_kinds[d->limit]);
    } else if (d->end == ALLAN_FLOOR && settings->sigma > 0) {
        snprintf(text, ALLAN_WORDS_MAX,
                 "No dwell brings the sigma of the mean of %c down to %.60s. Hold each position "
                 "%s: it is then %.60s, the floor, limited by %s.",
                 axis, allan_deviation(r, settings->sigma, wanted), time, sigma,
                 allan_kinds[d->limit]);
    } else {
        snprintf(text, ALLAN_WORDS_MAX,
                 "Hold each position %s: the sigma of the mean on the worst axis, %c, is then "
                 "%.60s%s, limited by %s.",
                 time, axis, sigma, d->end == ALLAN_FLOOR ? " (longer does not help)" : "",
                 allan_kinds[d->limit]);
    }
    return text;
}

const char *allan_next(const allan_result *r, char text[ALLAN_WORDS_MAX])
{
    static const char *const advice[] = {
        "four times as long halves it, down to a floor.",
        "take more positions; more time in each does not help.",
        "the zero wanders: move quickly from position to position, and take more of them.",
    };
    const allan_dwell *d = &r->dwell[r->worst];
    const char *next = advice[d->limit];

    if (d->end == ALLAN_BEYOND) {
        next = "that is longer than the measured averaging times: log longer to be sure.";
    } else if (d->end == ALLAN_LONGEST) {
        next = "state --sigma, the deviation that you need, or log longer to find the floor.";
    }
    snprintf(text, ALLAN_WORDS_MAX, "%s%s", next,
             d->seconds < REST_MIN
                 ? " Hold at least two seconds anyway: shorter rests are not found in a log."
                 : "");
    return text;
}
