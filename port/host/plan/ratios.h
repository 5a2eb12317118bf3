/* SPDX-License-Identifier: MIT
 *
 * plan/ratios.h: time and accuracy of two sets, and their ratios; less is always better.
 */
#ifndef PLAN_RATIOS_H
#define PLAN_RATIOS_H

#include "plan/words.h"

/* NOLINTNEXTLINE(readability-enum-initial-value): one of them has a length */
enum {
    PLAN_RATIO_POSITIONS,
    PLAN_RATIO_TIME,
    PLAN_RATIO_SIGMA,                                /* of offsets, scale errors, angles, */
    PLAN_RATIO_MEAN = PLAN_RATIO_SIGMA + PLAN_KINDS, /* and the geometric mean of all nine */
    PLAN_RATIO_CONDITION,
    PLAN_RATIOS
};

typedef struct {
    char name[PLAN_WORDS_MAX];
    char a[PLAN_WORDS_MAX]; /* in words, with the unit */
    char b[PLAN_WORDS_MAX];
    double ratio; /* of b to a */
} plan_ratio;

void plan_ratios(const design *a, const design *b, const choice_request *request,
                 plan_ratio ratio[PLAN_RATIOS]);

#endif
