/* SPDX-License-Identifier: MIT */
#include "fit/case_frame.h"

#include <math.h>
#include <string.h>

#include "maths/rotation.h"
#include "text/number.h"

#define OFF_MOST 0.2 /* rad: no table leans that much */

int case_parse(const char *text, case_wish *wish)
{
    int is_known = 0;

    for (wish->count = 0; wish->count < CASE_MOST; text++) {
        const int is_signed = *text == '+' || *text == '-';
        wish->sign[wish->count] = *text == '-' ? -1 : 1;
        text += is_signed;
        if (*text == '\0' || !strchr(is_signed ? "xyz" : "xyz.", *text)) {
            return 0;
        }
        is_known |= *text != '.';
        wish->axis[wish->count++] = *text++;
        if (*text == '\0') {
            return is_known;
        }
        if (*text != ',') {
            return 0;
        }
    }
    return 0;
}

static void up_of(const case_wish *wish, unsigned number, double up[3])
{
    for (unsigned i = 0; i < 3; i++) {
        up[i] = wish->axis[number] == "xyz"[i] ? wish->sign[number] : 0;
    }
}

invcal_status case_add(invcal_frame *frame, const case_wish *wish, unsigned number,
                       const invcal_calibration *calibration, const double raw[3])
{
    double up[3];

    if (number >= wish->count || wish->axis[number] == '.') {
        return INVCAL_OK;
    }
    up_of(wish, number, up);
    return invcal_frame_add(frame, calibration, raw, up);
}

/* The way up of all positions stated, if it is one. */
static int find_level(const case_wish *wish, double up[3])
{
    int is_level = 1;
    unsigned first = 0;

    while (wish->axis[first] == '.') {
        first++;
    }
    for (unsigned n = first; n < wish->count; n++) {
        is_level &= wish->axis[n] == '.' ||
                    (wish->axis[n] == wish->axis[first] && wish->sign[n] == wish->sign[first]);
    }
    up_of(wish, first, up);
    return is_level;
}

/* Of n directions across two axes each, three angles are taken. */
static void judge(const invcal_frame_quality *quality, double noise, case_frame *out)
{
    const double n = out->used;
    const double seen = out->used > 2 ? quality->scatter * sqrt(n / (2 * n - 3)) : 0;
    const double one = fmax(seen, noise); /* noise may be NaN: then what is seen */

    out->scatter = quality->scatter;
    for (unsigned i = 0; i < 3; i++) {
        out->sigma[i] = one > 0 ? quality->sigma[i] * one : NUMBER_UNKNOWN;
    }
}

invcal_status case_solve(const invcal_frame *frame, const case_wish *wish, double noise,
                         case_frame *out)
{
    invcal_frame_quality quality;
    invcal_status status = INVCAL_TOO_FEW;
    double up[3];

    *out = (case_frame){.used = frame->count, .scatter = NUMBER_UNKNOWN};
    for (unsigned i = 0; i < 3; i++) {
        out->sigma[i] = NUMBER_UNKNOWN;
    }
    if (frame->count > 0 && find_level(wish, up)) {
        out->is_level = 1;
        status = invcal_frame_level(frame, up, out->rotation);
    } else {
        status = invcal_frame_solve(frame, out->rotation, &quality);
        if (status == INVCAL_OK) {
            judge(&quality, noise, out);
            status = out->scatter < OFF_MOST ? INVCAL_OK : INVCAL_BAD_DIRECTION;
        }
    }
    if (status == INVCAL_OK) {
        rotation_vector((const double(*)[3])out->rotation, out->angle);
    }
    return status;
}
