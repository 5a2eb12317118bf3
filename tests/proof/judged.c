/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "any_positions.h"
#include "diagnose/diagnosis.h"

// eva: -eva-precision 0 -eva-slevel 10 -eva-split-return full
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64
// stubs: judge diagnosis

/* ---- what other modules do -------------------------------------------------------------------- */

invcali_set invcali_diagnose(const invcali_selection *selection, const invcal_calibration *c,
                             invcal_quality *q)
{
    invcali_set more;

    look_at(selection);
    (void)c->matrix[2][2];
    if (q != NULL) {
        (void)q->verdict;
        ANY(*q);
    }
    ANY(more);
    return more;
}

/* ---- positions: none, any, too many; the result may overwrite nominal ------------------------- */

void main(void)
{
    static invcal_vector mean[INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcal_real noise;
    invcal_calibration out;
    invcal_quality quality;

    ANY(mean);
    ANY(nominal);
    ANY(noise);
    (void)invcal_calibrate(POSITIONS_OF(NULL, 0, &nominal, noise), &out, &quality);
    (void)invcal_calibrate(POSITIONS_OF(mean, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise),
                           &out, &quality);
    (void)invcal_calibrate(
        POSITIONS_OF(mean, BETWEEN(INVCAL_MAX_POSITIONS + 1, 0xFFFFFFFF), &nominal, noise), &out,
        &quality);
    (void)invcal_calibrate(POSITIONS_OF(mean, BETWEEN(1, INVCAL_MAX_POSITIONS), &nominal, noise),
                           &nominal, &quality);
}
