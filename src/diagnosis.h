/* SPDX-License-Identifier: MIT
 *
 * Internal: which positions contradict the others, and which error do all share?
 */
#ifndef INVCAL_DIAGNOSIS_H
#define INVCAL_DIAGNOSIS_H

#include "judge.h"

/* One round.
 *
 * positions  up to INVCAL_MAX_POSITIONS, in the order in which they were visited. What is left out already
 *            is looked at no more.
 * c          makes them nearly calibrated, in place of nominal.
 * q          null; or of c, and not yet diagnosed: suspected, systematic, axis, size and unchecked are set,
 *            and the verdict is raised.
 *
 * Returns what is to be left out, too; 0: nothing. */
invcal_mask invcal_diagnose(const invcal_positions *positions, const invcal_calibration *c,
                            invcal_quality *q);

#endif
