/* SPDX-License-Identifier: MIT */
#include "fit/case_frame.h"

#include <math.h>
#include <string.h>

#include "maths/rotation.h"
#include "text/number.h"

#define SCATTER_MAX 0.2 /* rad: no table is that uneven */

int case_parse(const char *text, case_axes *stated)
{
    int is_known = 0;

    for (stated->count = 0; stated->count < CASE_MAX; text++) {
        const int is_signed = *text == '+' || *text == '-';
        stated->sign[stated->count] = *text == '-' ? -1 : 1;
        text += is_signed;
        if (*text == '\0' || !strchr(is_signed ? "xyz" : "xyz.", *text)) {
            return 0;
        }
        is_known |= *text != '.';
        stated->axis[stated->count++] = *text++;
        if (*text == '\0') {
            return is_known;
        }
        if (*text != ',') {
            return 0;
        }
    }
    return 0;
}

static void get_up(const case_axes *stated, unsigned index, double up[3])
{
    for (unsigned i = 0; i < 3; i++) {
        up[i] = stated->axis[index] == "xyz"[i] ? stated->sign[index] : 0;
    }
}

invcal_status case_add(invcal_frame *frame, const case_axes *stated, unsigned index,
                       const invcal_calibration *calibration, const double raw[3])
{
    double up[3];

    if (index >= stated->count || stated->axis[index] == '.') {
        return INVCAL_OK;
    }
    get_up(stated, index, up);
    return invcal_frame_add(frame, calibration, raw, up);
}

/* The up direction of the stated positions. Returns 1 if it is the same for all. */
static int find_common_up(const case_axes *stated, double up[3])
{
    int is_level = 1;
    unsigned first = 0;

    while (stated->axis[first] == '.') {
        first++;
    }
    for (unsigned n = first; n < stated->count; n++) {
        is_level &= stated->axis[n] == '.' || (stated->axis[n] == stated->axis[first] &&
                                               stated->sign[n] == stated->sign[first]);
    }
    get_up(stated, first, up);
    return is_level;
}

/* n directions have 2 n components across themselves; three angles are solved for. */
static void find_sigma(const invcal_frame_quality *quality, double noise, case_frame *out)
{
    const double n = out->used;
    const double estimated = out->used > 2 ? quality->scatter * sqrt(n / (2 * n - 3)) : 0;
    const double sigma = fmax(estimated, noise); /* noise may be NaN */

    out->scatter = quality->scatter;
    for (unsigned i = 0; i < 3; i++) {
        out->sigma[i] = sigma > 0 ? quality->sigma[i] * sigma : NUMBER_UNKNOWN;
    }
}

/* The directions that the readings say `up` has, against their mean. NaN for a single one. */
static double level_scatter(const invcal_frame *frame, const double up[3])
{
    double mean[3] = {0, 0, 0};

    if (frame->count < 2) {
        return NUMBER_UNKNOWN;
    }
    for (unsigned i = 0; i < 9; i++) {
        mean[i % 3] += up[i / 3] * frame->own_sum[i / 3][i % 3] / frame->count;
    }
    const double length = sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
    return sqrt(fmax(2 - 2 * length, 0));
}

invcal_status case_solve(const invcal_frame *frame, const case_axes *stated, double noise,
                         case_frame *out)
{
    invcal_frame_quality quality;
    invcal_status status = INVCAL_TOO_FEW;
    double up[3];

    *out = (case_frame){.used = frame->count, .scatter = NUMBER_UNKNOWN};
    for (unsigned i = 0; i < 3; i++) {
        out->sigma[i] = NUMBER_UNKNOWN;
    }
    if (frame->count > 0 && find_common_up(stated, up)) {
        out->is_level = 1;
        out->scatter = level_scatter(frame, up);
        status = out->scatter >= SCATTER_MAX ? INVCAL_BAD_DIRECTION
                                             : invcal_frame_level(frame, up, &out->rotation);
    } else {
        status = invcal_frame_solve(frame, &out->rotation, &quality);
        if (status == INVCAL_OK) {
            find_sigma(&quality, noise, out);
            status = out->scatter < SCATTER_MAX ? INVCAL_OK : INVCAL_BAD_DIRECTION;
        }
    }
    if (status == INVCAL_OK) {
        rotation_vector((const double(*)[3])out->rotation.r, out->angle);
    }
    return status;
}
