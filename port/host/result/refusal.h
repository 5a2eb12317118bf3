/* SPDX-License-Identifier: MIT
 * result/refusal.h: about positions that were refused: where they point, and which to add.
 */
#ifndef REFUSAL_H
#define REFUSAL_H

#include "result/result.h"

#define REFUSAL_DIRECTIONS 18u

/* A position to add. */
typedef struct {
    double up[3];
    char words[INVCAL_TEXT_SIZE];
} refusal_direction;

/* A calibration for the directions of readings that were not calibrated: the nominal one if it was
 * stated, else that with zero 0 or with zero in the middle of the range, whichever makes their
 * lengths more equal. */
typedef enum {
    REFUSAL_NO_VIEW,
    REFUSAL_BY_NOMINAL,
    REFUSAL_BY_ZERO,
    REFUSAL_BY_RANGE
} refusal_view;
refusal_view refusal_find_view(const calibrate_result *result, invcal_calibration *view);

/* The up direction at a position. Returns 1; 0 if the reading does not show it. */
int refusal_up(const calibrate_result *result, const invcal_calibration *view, unsigned position,
               double up[3]);

/* The length of a reading; and the mean length, without a reading that was refused. */
double refusal_length(const calibrate_result *result, const invcal_calibration *view,
                      unsigned position);
double refusal_mean_length(const calibrate_result *result, const invcal_calibration *view);

/* 1 if the position itself is wrong or left out, not only the set refused. */
int refusal_is_wrong(const calibrate_result *result, unsigned position);

/* The positions that make the set one of twelve or more that determines everything, in an order
 * with little turning. Returns their number, 0 without memory. */
unsigned refusal_additions(const calibrate_result *result,
                           refusal_direction out[REFUSAL_DIRECTIONS]);

/* "reason; remedy". Returns text. */
#define REFUSAL_TEXT_MAX (2 * REFUSAL_MAX + 8)
const char *refusal_text(const calibrate_result *result, char text[REFUSAL_TEXT_MAX]);

/* One JSON object. */
void refusal_json(FILE *file, const calibrate_result *result);

#endif
