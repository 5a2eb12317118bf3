/* SPDX-License-Identifier: MIT
 *
 * result/need.h: is the calibration as exact as it has to be, and what is missing if it is not?
 */
#ifndef NEED_H
#define NEED_H

#include <stddef.h>

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

/* What a need is stated in. */
typedef enum {
    NEED_UNIT,      /* that unit, */
    NEED_PLAIN,     /* none: that of the field */
    NEED_NO_UNIT,   /* an ending that is none, or no number, */
    NEED_NO_GRAVITY /* or one of gravity, which the field is not */
} need_ending;

/* Takes the ending off a need: "1mg", "0.1 %", "0.01m/s2"; g, mg and ug are parts of the field.
 *
 * field   its length.
 * digits  out: so many bytes are the number.
 * unit    out, but for the last two answers: the unit to print it in; its scale makes a need over the field of 1. */
need_ending need_parse(const char *text, double field, size_t *digits, display_unit *unit);

/* For a result with a need. */
need_missing need_judge(const calibrate_result *result);

/* "nothing", "warm-up", ... */
const char *need_word(need_missing missing);

/* What is to be done if it is not: a sentence, "Missing: ..."; else "". Returns text. */
#define NEED_MAX VERDICT_MAX
const char *need_advice(const calibrate_result *result, char text[NEED_MAX]);

/* What 95 % of the lengths are right within, over the field, and the part of it that the field leaves. */
double need_reached(const calibrate_result *result);
double need_of_field(const calibrate_result *result);

#endif
