/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "result/result.h"
#include "text/wrapped.h"

#define LABEL 14u       /* columns before a line's text */
#define CONTRADICTS 4.0 /* standard deviations of the difference */

/* Sigma of a parameter by the noise that is stated, if the residuals are larger: they may be what is wrong. */
static double sigma_of(const calibrate_result *r, unsigned p)
{
    const double times = calibrate_times(r);

    return r->quality.sigma[p] / (times > 1 ? times : 1);
}

void calibrate_robust(calibrate_result *r)
{

    r->has_robust =
        l1_fit(r->data->mean, r->data->count, &r->settings.nominal, r->robust) == INVCAL_OK;
    for (unsigned p = 0; p < INVCAL_PARAMETERS && r->has_robust; p++) {
        const double off = fabs(r->robust[p] - r->solution.x[p]) / (L1_DIFFERENCE * sigma_of(r, p));
        if (!(off <= r->robust_most)) {
            r->robust_most = off;
            r->robust_worst = p;
        }
    }
}

/* The positions left out may pull, each to the same side. */
static int contradicts(const calibrate_result *r)
{
    const double limit = CONTRADICTS + r->rejected.count * L1_PULL / L1_DIFFERENCE;

    return calibrate_knows_noise(r) && !(r->robust_most <= limit);
}

void calibrate_robust_print(FILE *file, const calibrate_result *r)
{
    char text[300];

    if (!r->has_robust) {
        wrapped_printf(
            file, LABEL,
            "l1            no estimate: the positions, all of them, lie on no ellipsoid");
        return;
    }
    snprintf(
        text, sizeof text,
        "of all %u positions differs most in %s, by %.2g of the difference that noise makes: %s",
        r->data->count, invcal_parameter_name(r->robust_worst), r->robust_most,
        contradicts(r) ? "it contradicts. Something is wrong that was not left out, or what was "
                         "left out was right."
                       : "it agrees.");
    fprintf(file, "l1            ");
    wrapped_line(file, LABEL, LABEL, text);
}

void calibrate_robust_json(json_writer *w, const calibrate_result *r)
{
    json_object(w, "robust");
    if (r->has_robust) {
        json_vector(w, "delta", &r->robust[INVCAL_DELTA_X]);
        json_vector(w, "dk", &r->robust[INVCAL_DK_X]);
        json_vector(w, "gamma", &r->robust[INVCAL_GAMMA_XY]);
        json_text(w, "worst", invcal_parameter_name(r->robust_worst));
        json_number(w, "difference", r->robust_most);
    }
    json_text(w, "answer", !r->has_robust ? "none" : contradicts(r) ? "contradicts" : "agrees");
    json_object_end(w);
}
