/* SPDX-License-Identifier: MIT
 *
 * result/verdict.h: the verdict on the calibration, its cause, and what to do, in plain words.
 */
#ifndef VERDICT_H
#define VERDICT_H

#include "result/result.h"

#define VERDICT_MAX 512u

/* "Good", "Rough", ... */
const char *verdict_word(const calibrate_result *result);

/* The cause, if it is rough, drifting, bent or contradictory: a sentence. Returns text. */
const char *verdict_cause(const calibrate_result *result, char text[VERDICT_MAX]);

/* What to do next: a sentence that begins with a small letter. Returns text. */
const char *verdict_remedy(const calibrate_result *result, char text[VERDICT_MAX]);

/* If it is good: the errors that were not checked, as the positions do not show them: a sentence,
 * or "". Returns text. */
const char *verdict_unchecked(const calibrate_result *result, char text[VERDICT_MAX]);

/* The name of a systematic error (invcal_systematic): "drift", ...; "none". */
const char *verdict_systematic(unsigned systematic);

#endif
