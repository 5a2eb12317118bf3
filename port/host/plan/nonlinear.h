/* SPDX-License-Identifier: MIT
 *
 * plan/nonlinear.h: how accurately a set determines quadratic and cubic errors of the axes, if
 * `invcal calibrate --quadratic` or `--cubic` estimates them with the nine parameters.
 */
#ifndef PLAN_NONLINEAR_H
#define PLAN_NONLINEAR_H

#include "text/json_write.h"
#include "draw/page.h"
#include "plan/words.h"

/* Lines of the table: sigma over the noise of a position mean, and in units if the noise is known
 * (else 0); or what is undetermined. The set is solvable. */
void plan_nonlinear_print(FILE *file, const design *d, double noise, unit_style style);

/* The member "nonlinear". */
void plan_nonlinear_json(json_writer *w, const design *d);

/* A line of the page. */
void plan_nonlinear_report(page *p, const design *d, double noise, unit_style style);

#endif
