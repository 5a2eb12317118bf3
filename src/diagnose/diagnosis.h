/* SPDX-License-Identifier: MIT
 *
 * Internal: which positions contradict the others, and is there a systematic error?
 */
#ifndef INVCAL_DIAGNOSIS_H
#define INVCAL_DIAGNOSIS_H

#include "../calibrate/judge.h"

/* One round.
 *
 * selection  up to INVCAL_MAX_POSITIONS, in the order in which they were visited. Ignores those
 *            already left out.
 * c          replaces nominal: calibrates them to near-identity.
 * q          null; or of c, and not yet diagnosed: sets suspected, systematic, axis, size and
 *            unchecked, and raises the verdict.
 *
 * Returns the further positions to leave out; 0: none. */
invcali_set invcali_diagnose(const invcali_selection *selection, const invcal_calibration *c,
                             invcal_quality *q);

#endif
