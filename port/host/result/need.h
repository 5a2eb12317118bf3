/* SPDX-License-Identifier: MIT
 *
 * result/need.h: is the calibration as exact as it has to be, and what is missing if it is not?
 */
#ifndef NEED_H
#define NEED_H

#include "result/verdict.h"

typedef enum {
    NEED_NOTHING,    /* it is */
    NEED_WARM_UP,    /* the sensor drifts */
    NEED_LINEARITY,  /* no nine parameters describe it */
    NEED_STEADINESS, /* the positions disagree by more than noise */
    NEED_GRAVITY,    /* the field itself is not known so well */
    NEED_DIRECTIONS, /* positions in directions that have none */
    NEED_POSITIONS,  /* more of them */
    NEED_REST        /* longer ones */
} need_missing;

/* For a result with a need. */
need_missing need_judge(const calibrate_result *result);

/* "nothing", "warm-up", ... */
const char *need_word(need_missing missing);

/* What lengths are right within, whether that is good enough, and if not, what to do: a sentence or two.
 * Returns text. */
#define NEED_MAX VERDICT_MAX
const char *need_text(const calibrate_result *result, char text[NEED_MAX]);

/* What 95 % of the lengths are right within, over the field, and the part of it that the field leaves. */
double need_reached(const calibrate_result *result);
double need_of_field(const calibrate_result *result);

#endif
