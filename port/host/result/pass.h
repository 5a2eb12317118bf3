/* SPDX-License-Identifier: MIT
 *
 * result/pass.h: PASS or FAIL: does a calibration keep what was asked of it, --need and the limits of
 * --tolerance, and by which margin?
 *
 * A limit is kept if the value and its interval of 95 % lie within, as ISO 14253-1 demands as
 * proof. What nothing is known of passes nothing, nor does a calibration whose verdict is not good.
 */
#ifndef PASS_H
#define PASS_H

#include "result/result.h"

typedef struct {
    int is_asked;     /* there is a need, or limits */
    int is_passed;    /* all of it is kept */
    double need_used; /* accuracy over need: above 1 it is too large; NaN: not known, or no need */
    double limit[INVCAL_PARAMETERS]; /* of parameter r, to either side; NaN: none */
    double
        used[INVCAL_PARAMETERS]; /* (|x| + interval of 95 %) / limit; NaN: not known, or no limit */
    uint16_t limited;            /* bit r: parameter r has a limit, */
    uint16_t failed;             /* is not known to keep it, */
    uint16_t beyond;  /* and is known not to, or by its value alone if the interval is unknown */
    unsigned nearest; /* of those with limits, the one that uses most of its own */
} pass;

pass pass_judge(const calibrate_result *result);

/* "PASS: |a| within 0.42 of 1.0 mg; offset y up to 33 of 50 mg (95 %).". Returns text. */
#define PASS_MAX 1200u
const char *pass_text(const calibrate_result *result, char text[PASS_MAX]);

/* Why --strict refuses it: a verdict that is not good, limits or a need that are not kept; "" if neither.
 * Returns text. */
const char *pass_strict(const calibrate_result *result, char text[PASS_MAX]);

#endif
