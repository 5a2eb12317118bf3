/* SPDX-License-Identifier: MIT
 *
 * plan/programs.h: the known programs in one table, against the paper's 18 positions.
 */
#ifndef PLAN_PROGRAMS_H
#define PLAN_PROGRAMS_H

#include <stdio.h>

#include "design/choice.h"

/* Indices of the set. */
enum {
    PLAN_15, /* the paper's */
    PLAN_18,
    PLAN_STAND_24,
    PLAN_EDGES,
    PLAN_STAND_12,
    PLAN_ICOSAHEDRON,
    PLAN_PROGRAMS
};

typedef struct plan_programs {
    design set[PLAN_PROGRAMS];
    const design *paper; /* the one that the others are compared with */
} plan_programs;         /* large: not for the stack */

/* 3 x 5, 3 x 6, stand-24, six faces and twelve edges, stand-12, the icosahedron. */
void plan_programs_make(plan_programs *p);

/* A table; one JSON object. The request holds time and noise. */
void plan_programs_print(FILE *file, const plan_programs *p, const choice_request *request);
void plan_programs_json(FILE *file, const plan_programs *p, const choice_request *request);

#endif
