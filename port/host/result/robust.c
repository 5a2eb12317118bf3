/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "result/result.h"
#include "invcal/result.h"
#include "text/wrapped.h"

#define LABEL 14u          /* columns of the label of a line */
#define DIFFERENCE_MAX 4.0 /* standard deviations of the difference */

/* The positions left out, which the l1 estimate includes, may all pull to the same side. */
static int contradicts(const calibrate_result *r)
{
    const double limit = DIFFERENCE_MAX + r->rejected.count * L1_PULL / L1_DIFFERENCE;

    return calibrate_knows_noise(r) && !(r->robust_max <= limit);
}

void calibrate_robust_print(FILE *file, const calibrate_result *r)
{
    char text[300];

    if (!r->has_robust) {
        wrapped_printf(
            file, LABEL,
            "l1            no estimate: all positions together do not lie on an ellipsoid");
        return;
    }
    snprintf(text, sizeof text,
             "over all %u positions: largest difference in %s, %.2g times that of noise: %s",
             r->data->count, invcal_parameter_text(r->robust_worst), r->robust_max,
             contradicts(r)
                 ? "it contradicts. An outlier was kept, or a good position was left out."
                 : "it agrees.");
    fprintf(file, "l1            ");
    wrapped_line(file, LABEL, LABEL, text);
}

void calibrate_robust_json(json_writer *w, const calibrate_result *r)
{
    json_object(w, "robust");
    if (r->has_robust) {
        calibrate_parameters_json(w, r, r->robust);
        json_text(w, "worst", invcal_parameter_text(r->robust_worst));
        json_number(w, "difference", r->robust_max);
    }
    json_text(w, "answer", !r->has_robust ? "none" : contradicts(r) ? "contradicts" : "agrees");
    json_object_end(w);
}
