/* SPDX-License-Identifier: MIT
 *
 * plan/facts.h: figures that several sections of a program's page use, and these sections.
 */
#ifndef PLAN_FACTS_H
#define PLAN_FACTS_H

#include "text/figure.h"
#include "draw/page.h"
#include "plan/words.h"
#include "result/uncertainty.h"

typedef struct {
    const design *set; /* solvable */
    const choice_request *request;
    const choice *choice;            /* that led to it, or null */
    double noise;                    /* of a position mean, over the field; 0: unknown */
    double sigma[INVCAL_PARAMETERS]; /* of the parameters, over that noise */
    uncertainty length_sigma;        /* of |a|, in mg or µg if the noise is known */
} plan_facts;

void plan_facts_find(plan_facts *f, const design *d, const choice_request *request,
                     const choice *c);

/* The unit of length_sigma: "mg", "µg" or "× noise". */
const char *plan_length_unit(const plan_facts *f);

/* The sections of the page. */
void plan_report_sheet(page *p, const plan_facts *f);
void plan_report_sphere(page *p, const plan_facts *f);
void plan_report_sigma(page *p, const plan_facts *f);
void plan_report_coverage(page *p, const plan_facts *f);
void plan_report_bound(page *p, const plan_facts *f); /* with --bound */

/* Also for the page of a comparison: both halves of the sphere, shaded; and the legend of the
 * shading and the groups. */
void plan_draw_halves(FILE *file, const design *d, const sphere_shading *shading);
void plan_draw_legend(FILE *file, const sphere_shading *shading, const char *unit, int has_groups);

/* The last section: how the page was made. More facts may follow until page_facts_end. */
void plan_report_origin(page *p, const char *command);

#endif
