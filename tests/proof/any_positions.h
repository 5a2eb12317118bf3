/* SPDX-License-Identifier: MIT
 *
 * A function that looks at positions, for the proofs of its callers.
 */
#ifndef ANY_POSITIONS_H
#define ANY_POSITIONS_H

#include "arbitrary.h"
#include "calibrate/judge.h"

/* May look at any reading; raises an alarm if there are more than the mask has bits. */
static void look_at(const invcal_positions *positions)
{
    (void)(1 / (positions->count <= INVCAL_MAX_POSITIONS));
    if (positions->count > 0) {
        (void)positions->raw[BETWEEN(0, 3 * positions->count - 1)];
    }
    (void)positions->nominal->matrix[2][2];
    (void)positions->left_out;
    (void)positions->noise;
}

invcal_status invcal_positions_calibrate(const invcal_positions *positions, invcal_calibration *out,
                                         invcal_quality *quality)
{
    const invcal_status status = (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);

    look_at(positions);
    if (status == INVCAL_OK) {
        ANY(*out);
        ANY(*quality);
    }
    return status;
}

#endif
