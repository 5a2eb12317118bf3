/* SPDX-License-Identifier: MIT
 *
 * result/need.h: is the calibration as accurate as --need, and if not, what is missing?
 */
#ifndef NEED_H
#define NEED_H

#include <stddef.h>

#include "result/verdict.h"

typedef enum {
    NEED_NOTHING,    /* it is accurate enough */
    NEED_WARM_UP,    /* the sensor drifts */
    NEED_LINEARITY,  /* nine parameters do not describe the sensor */
    NEED_STEADINESS, /* the positions disagree by more than noise */
    NEED_GRAVITY,    /* the field itself is not known that well */
    NEED_DIRECTIONS, /* positions in other directions */
    NEED_POSITIONS,  /* more positions */
    NEED_REST        /* longer rests */
} need_missing;

/* The unit in which a need is stated. */
typedef enum {
    NEED_UNIT,      /* a known unit */
    NEED_PLAIN,     /* none: the unit of the field */
    NEED_NO_UNIT,   /* an unknown one, or no number */
    NEED_NO_GRAVITY /* one of gravity, but the field is not gravity */
} need_ending;

/* Splits a need or a limit, "1mg", "0.1 %", "0.01m/s2", into number and unit; g, mg and ug are
 * relative to the field.
 *
 * field   length of the field.
 * digits  out: length of the number in bytes.
 * unit    out, unless NEED_NO_UNIT or NEED_NO_GRAVITY: the unit to print; its scale is the field in
 *         that unit. */
need_ending need_parse(const char *text, double field, size_t *digits, display_unit *unit);

/* What is missing, for a result with a need. */
need_missing need_judge(const calibrate_result *result);

/* "nothing", "warm-up", ... */
const char *need_word(need_missing missing);

/* What to do: a sentence, "Missing: ..."; "" if nothing is missing. Returns text. */
#define NEED_MAX VERDICT_MAX
const char *need_advice(const calibrate_result *result, char text[NEED_MAX]);

/* The accuracy of lengths, 95 %, over the field; and the part of it that is the error of the
 * field. */
double need_accuracy(const calibrate_result *result);
double need_field_part(const calibrate_result *result);

#endif
