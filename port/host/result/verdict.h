/* SPDX-License-Identifier: MIT
 *
 * result/verdict.h: what the calibration is called, why, and what to do about it, in plain words.
 */
#ifndef VERDICT_H
#define VERDICT_H

#include "result/result.h"

#define VERDICT_MAX 512u

/* "Good", "Rough", ... */
const char *verdict_word(const calibrate_result *result);

/* Where it is rough, drifting, bent or contradictory: the cause, a sentence. Returns text. */
const char *verdict_cause(const calibrate_result *result, char text[VERDICT_MAX]);

/* And what to do next: a sentence that begins with a small letter. Returns text. */
const char *verdict_remedy(const calibrate_result *result, char text[VERDICT_MAX]);

/* Where it is good: which errors were not looked for, as the positions do not show them; a sentence, or
 * "". Returns text. */
const char *verdict_unchecked(const calibrate_result *result, char text[VERDICT_MAX]);

/* A systematic error (invcal_systematic) in a word: "drift", ...; "none". */
const char *verdict_systematic(unsigned systematic);

#endif
