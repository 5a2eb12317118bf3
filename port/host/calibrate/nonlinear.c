/* SPDX-License-Identifier: MIT */
#include "calibrate/nonlinear.h"

#include "cli/command.h"

static const char *option_of(unsigned degree)
{
    return degree > 2 ? "--cubic" : "--quadratic";
}

/* Names the terms that are undetermined. */
static void list_undetermined(const calibrate_result *r, unsigned degree, char text[REFUSAL_MAX])
{
    const unsigned open =
        nonlinearity_open(r->rejected.kept, r->rejected.kept_count, &r->solution.symmetric, degree);
    unsigned count = 0;
    size_t used = (size_t)snprintf(text, REFUSAL_MAX, "%s: the positions do not determine",
                                   option_of(degree));

    for (unsigned e = 0; e < NONLINEARITY_TERMS; e++) {
        if (open >> e & 1 && used < REFUSAL_MAX) {
            used += (size_t)snprintf(text + used, REFUSAL_MAX - used, "%s %s",
                                     count++ > 0 ? "," : "", nonlinearity_name(e));
        }
    }
}

static int refuse(calibrate_result *r, unsigned degree, invcal_status status)
{
    const int is_few = status == INVCAL_TOO_FEW;
    refusal *why = &r->refused;

    *why = (refusal){
        .word = is_few ? "too few" : "undetermined", .wants_positions = 1, .degree = degree};
    if (is_few) {
        snprintf(why->reason, REFUSAL_MAX, "%s: %u positions are too few: %u or more are needed",
                 option_of(degree), r->rejected.kept_count, nonlinearity_min_positions(degree));
    } else {
        list_undetermined(r, degree, why->reason);
    }
    snprintf(
        why->remedy, REFUSAL_MAX,
        "add positions along the axes and between them, 6 or more on a circle, or leave out %s",
        option_of(degree));
    return EXIT_DATA;
}

int calibrate_nonlinear(calibrate_result *r, unsigned degree)
{
    invcal_quality *found = &r->rejected.found;
    const invcal_status status =
        nonlinearity_fit(r->rejected.kept, r->rejected.kept_count, &r->settings, degree,
                         &r->solution, &r->quality, r->nonlinear, r->nonlinear_sigma);

    if (status != INVCAL_OK) {
        return refuse(r, degree, status);
    }
    r->degree = degree;
    r->is_drift_fitted = 0;
    if (found->systematic == INVCAL_QUADRATIC ||
        (degree > 2 && found->systematic == INVCAL_CUBIC)) {
        found->systematic = INVCAL_NO_SYSTEMATIC; /* reported as a nonlinearity instead */
        found->verdict = INVCAL_GOOD;
    }
    found->unchecked &=
        (uint8_t)~((1u << INVCAL_QUADRATIC) | (degree > 2 ? 1u << INVCAL_CUBIC : 0));
    return EXIT_GOOD;
}
