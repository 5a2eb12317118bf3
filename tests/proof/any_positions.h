/* SPDX-License-Identifier: MIT
 *
 * A function that looks at positions, for the proofs of its callers.
 */
#ifndef ANY_POSITIONS_H
#define ANY_POSITIONS_H

#include "arbitrary.h"
#include "calibrate/judge.h"

/* May look at any reading; raises an alarm if there are more than the mask has bits. */
static void look_at(const invcali_selection *selection)
{
    const invcal_positions *given = &selection->given;

    (void)(1 / (given->count <= INVCAL_MAX_POSITIONS));
    if (given->count > 0) {
        (void)given->mean[BETWEEN(0, given->count - 1)].v[BETWEEN(0, 2)];
    }
    (void)given->nominal->matrix[2][2];
    (void)given->noise;
    (void)selection->left_out;
}

invcal_status invcali_positions_calibrate(const invcali_selection *selection,
                                          invcal_calibration *out, invcal_quality *quality)
{
    const invcal_status status = (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);

    look_at(selection);
    if (status == INVCAL_OK) {
        ANY(*out);
        ANY(*quality);
    }
    return status;
}

#endif
