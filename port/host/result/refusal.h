/* SPDX-License-Identifier: MIT
 *
 * result/refusal.h: what is known of positions that were refused: where they point, and which to add.
 */
#ifndef REFUSAL_H
#define REFUSAL_H

#include "result/result.h"

#define REFUSAL_DIRECTIONS 18u

/* Positions to add, in the order that is the least labour. */
typedef struct {
    double up[3];
    char words[INVCAL_WORDS];
} refusal_direction;

/* How readings point without a calibration of their own: by the nominal one that was stated, else by zero 0 or the
 * middle of the range, whichever makes their lengths more alike. */
typedef enum { REFUSAL_UNSEEN, REFUSAL_BY_NOMINAL, REFUSAL_BY_ZERO, REFUSAL_BY_RANGE } refusal_view;
refusal_view refusal_see(const calibrate_result *result, invcal_calibration *view);

/* Where up was. Returns 1; 0 if the reading does not show it. */
int refusal_up(const calibrate_result *result, const invcal_calibration *view, unsigned position,
               double up[3]);

/* The length of a reading, and the mean of all but one that is wrong. */
double refusal_length(const calibrate_result *result, const invcal_calibration *view,
                      unsigned position);
double refusal_mean_length(const calibrate_result *result, const invcal_calibration *view);

/* The position itself was refused, not only the set. */
int refusal_is_wrong(const calibrate_result *result, unsigned position);

/* Those that would make the set one of twelve or more that determines everything. Returns how many, 0 without memory. */
unsigned refusal_add(const calibrate_result *result, refusal_direction out[REFUSAL_DIRECTIONS]);

/* "reason; remedy". Returns text. */
#define REFUSAL_TEXT_MAX (2 * REFUSAL_MAX + 8)
const char *refusal_text(const calibrate_result *result, char text[REFUSAL_TEXT_MAX]);

/* One JSON object. */
void refusal_json(FILE *file, const calibrate_result *result);

#endif
