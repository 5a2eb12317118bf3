/* SPDX-License-Identifier: MIT
 *
 * plan/results.h: results of `invcal plan`, and their output as text, JSON, CSV, pictures and pages.
 */
#ifndef PLAN_RESULTS_H
#define PLAN_RESULTS_H

#include <stdio.h>

#include "design/choice.h"

/* invcal calibrate calls a parameter weak if its sigma is more than this many times the noise of a
 * position mean. */
#define PLAN_WEAK 10.0

/* One of the paper's programs in a sweep over N. */
typedef struct {
    unsigned per_group;
    criteria criteria;
    uint8_t axes;
} plan_row;

/* The sweep, and the known programs for comparison. */
typedef struct {
    const plan_row *rows;
    unsigned count;
    const struct plan_programs *programs;
} plan_sweep;

/* Bits of the axes that no position points along gravity, from the bits of those that one does. */
unsigned plan_missing_axes(uint8_t axes);

/* Tables. The request holds time, noise and limits; `c` is the choice that led to the set, or null.
 * A set that is not solvable is shown without its sigma. */
void plan_print(FILE *file, const design *d, const choice_request *request, const choice *c);
void plan_print_sweep(FILE *file, const plan_sweep *s);
void plan_print_comparison(FILE *file, const design *a, const design *b,
                           const choice_request *request);

/* The same, as one JSON object each. */
void plan_json(FILE *file, const design *d, const choice_request *request, const choice *c);
void plan_json_sweep(FILE *file, const plan_sweep *s);
void plan_json_comparison(FILE *file, const design *a, const design *b,
                          const choice_request *request);

/* The positions of a set as a table for a stand's controller: number, alpha, beta, dwell, x, y, z.
 * Angles have at most nine decimals, and x, y, z are computed from the rounded angles: the table
 * read by angles_file.h and written again is the same to the byte. */
void plan_csv(FILE *file, const design *d, const design_cost *cost);

/* A refusal for which there is no set. */
void plan_json_refusal(FILE *file, const char *reason, uint16_t undetermined);

/* Pictures as SVG files: the directions of a set on the two halves of the sphere; the paper's
 * figure 2, sigma against the number of positions, with the known programs; the ratios of two sets. */
void plan_svg_directions(FILE *file, const design *d);
void plan_svg_sweep(FILE *file, const plan_sweep *s);
void plan_svg_comparison(FILE *file, const design *a, const design *b,
                         const choice_request *request);

/* The latter two as part of a page. */
void plan_svg_sweep_inline(FILE *file, const plan_sweep *s, double width);
void plan_svg_comparison_inline(FILE *file, const design *a, const design *b,
                                const choice_request *request, double width);

/* Pages (page.h). `command` is the command line. */
void plan_report(FILE *file, const design *d, const choice_request *request, const choice *c,
                 const char *command);
void plan_report_sweep(FILE *file, const plan_sweep *s, const char *command);
void plan_report_comparison(FILE *file, const design *a, const design *b,
                            const choice_request *request, const char *command);

#endif
