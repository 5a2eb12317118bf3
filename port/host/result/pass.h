/* SPDX-License-Identifier: MIT
 *
 * result/pass.h: PASS or FAIL: does a calibration meet --need and the limits of --tolerance, and by
 * which margin?
 *
 * A limit is met if the value and its 95 % interval are within it, as ISO 14253-1 requires as
 * proof. A value whose uncertainty is unknown fails, and so does a calibration whose verdict is not
 * good.
 */
#ifndef PASS_H
#define PASS_H

#include "result/result.h"

typedef struct {
    int has_criteria;                /* there is a need, or a limit */
    int is_passed;                   /* all are met */
    double need_used;                /* accuracy / need; NaN: unknown, or no need */
    double limit[INVCAL_PARAMETERS]; /* of parameter r, to either side; NaN: none */
    double used[INVCAL_PARAMETERS];  /* (|x| + 95 % interval) / limit; NaN: unknown, or no limit */
    uint16_t limited;                /* bit r: parameter r has a limit */
    uint16_t failed;                 /* bit r: it is not proved to meet the limit */
    uint16_t beyond;  /* bit r: it exceeds it; by its value alone if the interval is unknown */
    unsigned nearest; /* the parameter with the largest `used` */
} pass;

pass pass_judge(const calibrate_result *result);

/* "PASS: |a| within 0.42 of 1.0 mg; offset y up to 33 of 50 mg (95 %).". Returns text. */
#define PASS_MAX 1200u
const char *pass_text(const calibrate_result *result, char text[PASS_MAX]);

/* Why --strict fails: a verdict that is not good, or limits or a need that are not met; else "".
 * Returns text. */
const char *pass_strict(const calibrate_result *result, char text[PASS_MAX]);

#endif
