/* SPDX-License-Identifier: MIT
 *
 * The rotation from the calibrated axes to those of the case, in words and as JSON.
 */
#include <math.h>

#include "result/result.h"
#include "text/figure.h"
#include "text/number.h"

#define DEGREES 57.2957795130823209

/* "about x +0.52 ± 0.01" */
static void angle_text(const case_frame *c, unsigned i, char text[64])
{
    char figure[FIGURE_MAX];

    snprintf(
        text, 64, "about %c %s", "xyz"[i],
        figure_with_sigma(DEGREES * c->angle[i], DEGREES * c->sigma[i], FIGURE_SIGNED, figure));
}

const char *calibrate_case_text(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX])
{
    const case_frame *c = &result->frame;
    char angle[3][64];
    char off[FIGURE_MAX];

    for (unsigned i = 0; i < 3; i++) {
        angle_text(c, i, angle[i]);
    }
    const int used =
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "rotated to the axes of the case by %u position%s, degrees: %s, %s, %s.", c->used,
                 c->used == 1 ? "" : "s", angle[0], angle[1], angle[2]);
    if (c->is_level) {
        snprintf(text + used, CALIBRATE_LIMIT_MAX - (size_t)used,
                 " One axis only levels the result; the heading is unchanged. State a second axis "
                 "to fix it.");
    } else {
        snprintf(text + used, CALIBRATE_LIMIT_MAX - (size_t)used,
                 " The directions disagree by %s degrees (rms), usually the tilt of the table. Put "
                 "down all faces, then all again, each turned by half a turn, and the tilt "
                 "cancels.",
                 figure_digits(DEGREES * c->scatter, 2, off));
    }
    return text;
}

void calibrate_case_json(json_writer *w, const calibrate_result *result)
{
    const case_frame *c = &result->frame;

    json_object(w, "case");
    json_number(w, "positions", c->used);
    json_matrix(w, "rotation", (const double(*)[3])c->rotation.r);
    json_vector(w, "angle", c->angle);
    json_vector(w, "sigma", c->sigma);
    json_number(w, "scatter", c->scatter);
    json_object_end(w);
}
