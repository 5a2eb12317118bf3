/* SPDX-License-Identifier: MIT */
#include "result/verdict.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "result/faces.h"
#include "text/figure.h"
#include "text/unit.h"

static int is_contradictory(const calibrate_result *r)
{
    return (r->quality.verdict == INVCAL_GOOD || r->quality.verdict == INVCAL_ROUGH) &&
           r->rejected.suspected > 0 && !calibrate_many_left_out(r);
}

const char *verdict_word(const calibrate_result *r)
{
    static char word[32];

    if (is_contradictory(r)) {
        return "Contradictory";
    }
    if (faces_are_good(r)) {
        return "Good for offsets and scales";
    }
    snprintf(word, sizeof word, "%s", invcal_verdict_text(r->quality.verdict));
    word[0] = (char)toupper((unsigned char)word[0]);
    return word;
}

const char *verdict_systematic(unsigned systematic)
{
    static const char *const words[] = {"none", "drift", "quadratic", "cubic", "hysteresis"};

    return words[systematic];
}

/* The size of the systematic error with its unit. */
static const char *size_of(const calibrate_result *r, char text[64])
{
    const display_unit display = calibrate_display_unit(r);
    char number[FIGURE_MAX];

    snprintf(text, 64, "%s %s", figure_digits(display.scale * fabs(r->quality.size), 2, number),
             display.unit);
    return text;
}

static void describe_drift(const calibrate_result *r, char text[VERDICT_MAX])
{
    const display_unit display = calibrate_display_unit(r);
    char number[3][FIGURE_MAX];
    char size[64];

    if (!r->is_drift_fitted) {
        snprintf(text, VERDICT_MAX,
                 "the offset of the %c axis drifts: it is %s %s at the last position than at the "
                 "first.",
                 'x' + r->quality.axis, size_of(r, size),
                 r->quality.size > 0 ? "larger" : "smaller");
        return;
    }
    for (unsigned i = 0; i < 3; i++) {
        (void)figure_digits(display.scale * r->drift[i], 2, number[i]);
    }
    snprintf(text, VERDICT_MAX,
             "the offsets drift, by %s, %s, %s %s (x, y, z) from the first position to the last. "
             "The drift is fitted: the calibration is that of the middle of the log.",
             number[0], number[1], number[2], display.unit);
}

static void describe_bent(const calibrate_result *r, char text[VERDICT_MAX])
{
    const fit_quality *q = &r->quality;
    const char axis = (char)('x' + q->axis);
    const char *more = q->size > 0 ? "more" : "less";
    char size[64];

    (void)size_of(r, size);
    if (q->systematic == INVCAL_HYSTERESIS) {
        snprintf(text, VERDICT_MAX,
                 "the %c axis has hysteresis: it reads %s %s when turned upwards than when turned "
                 "downwards.",
                 axis, size, more);
    } else if (q->systematic == INVCAL_QUADRATIC) {
        snprintf(text, VERDICT_MAX,
                 "the %c axis has a quadratic error: at both ends, %c up and %c down, it reads %s "
                 "%s than in the middle.",
                 axis, axis, axis, size, more);
    } else {
        snprintf(text, VERDICT_MAX,
                 "the %c axis has a cubic error: with %c up it reads %s %s than a straight line, "
                 "with %c down the same amount the other way.",
                 axis, axis, size, more, axis);
    }
}

static void describe_rough(const calibrate_result *r, char text[VERDICT_MAX])
{
    const double times = calibrate_noise_ratio(r);
    char number[FIGURE_MAX];

    if (calibrate_many_left_out(r)) {
        snprintf(text, VERDICT_MAX,
                 "%u of %u positions contradict the others and are left out; the same may be wrong "
                 "with the rest.",
                 r->rejected.count, r->data->count);
    } else if (times > 1) {
        snprintf(text, VERDICT_MAX, "the positions disagree by %s times the noise %s.",
                 figure_digits(times, 2, number), r->is_noise_given ? "stated" : "of the samples");
    } else {
        snprintf(text, VERDICT_MAX,
                 "the residuals are not noise: outliers, a drift, a step or a nonlinearity; there "
                 "are too few positions to decide which.");
    }
}

const char *verdict_cause(const calibrate_result *r, char text[VERDICT_MAX])
{
    if (is_contradictory(r)) {
        snprintf(text, VERDICT_MAX,
                 "every parameter is determined, but %u positions contradict one another, and "
                 "nothing shows which of them are wrong.",
                 r->rejected.suspected);
    } else if (r->magnetometer) {
        (void)calibrate_magnetometer_fault(r, text);
    } else if (r->quality.verdict == INVCAL_DRIFTING) {
        describe_drift(r, text);
    } else if (r->quality.verdict == INVCAL_BENT) {
        describe_bent(r, text);
    } else {
        describe_rough(r, text);
    }
    return text;
}

const char *verdict_remedy(const calibrate_result *r, char text[VERDICT_MAX])
{
    const char *what = "look for a disturbance: motion of the hand, vibration, clipping, a knock, "
                       "a sensor that warms up. Then measure again.";

    if (is_contradictory(r)) {
        what =
            "measure again with more positions, each at rest, so that outliers can be identified.";
    } else if (r->magnetometer) {
        what = "wave it again, away from iron, for a minute.";
    } else if (r->is_noise_given && calibrate_is_coarse(r)) {
        what = "leave out --noise, which is less than the steps of the readings leave in a mean.";
    } else if (r->quality.verdict == INVCAL_DRIFTING) {
        what = "let the sensor warm up, and measure again in less time.";
    } else if (r->quality.verdict == INVCAL_BENT) {
        what = r->quality.systematic == INVCAL_HYSTERESIS
                   ? "approach each position from the same side, or accept an error of that size."
                   : "accept an error of that size, or use --quadratic or --cubic: nine parameters "
                     "cannot correct it.";
    }
    snprintf(text, VERDICT_MAX, "%s", what);
    return text;
}

const char *verdict_unchecked(const calibrate_result *r, char text[VERDICT_MAX])
{
    const unsigned bits = r->quality.unchecked;
    unsigned left = 0;
    size_t used = 0;

    for (unsigned k = INVCAL_DRIFT; k <= INVCAL_HYSTERESIS; k++) {
        left += bits >> k & 1u;
    }
    text[0] = '\0';
    if (left == 0 || !r->rejected.is_judged) {
        return text;
    }
    used = (size_t)snprintf(text, VERDICT_MAX, "Not checked for ");
    for (unsigned k = INVCAL_DRIFT; k <= INVCAL_HYSTERESIS; k++) {
        static const char *const words[] = {"", "drift", "quadratic error", "cubic error",
                                            "hysteresis"};
        if (bits >> k & 1u) {
            left--;
            used += (size_t)snprintf(text + used, VERDICT_MAX - used, "%s%s", words[k],
                                     left > 1    ? ", "
                                     : left == 1 ? " and "
                                                 : "");
        }
    }
    snprintf(text + used, VERDICT_MAX - used, ": these positions, in this order, hardly show it.");
    return text;
}
