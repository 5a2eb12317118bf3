/* SPDX-License-Identifier: MIT
 *
 * stand/output.h: the results from a stand's angles as texts, table and JSON; for the report see
 * report/stand.c.
 */
#ifndef STAND_OUTPUT_H
#define STAND_OUTPUT_H

#include <stdio.h>

#include "text/json_write.h"
#include "fit/nominal.h"
#include "stand/stand.h"
#include "cli/unit_style.h"

#define STAND_SIGNIFICANCE 0.01 /* of group_series.chance: below it the groups contradict */
#define STAND_TEXT_MAX 512
#define STAND_MISSET_NOTE                                                                          \
    "Lengths do not depend on angles: the calibration is correct. J1, the mounting and the "       \
    "series leave these positions out."

/* Number of sigma to either side that cover 95 %, for this many degrees of freedom; the same for
 * the series. */
double stand_coverage(double dof);
double stand_series_coverage(const group_series *s);

/* A sentence if the mounting angle is too large for a misaligned unit; else "". */
const char *stand_large_angle_text(const mounting *m);

/* "Misset: position 8 ...": which one, and by how much. Returns text. */
const char *stand_misset_text(const stand *s, const misset *m, char text[STAND_TEXT_MAX]);

/* What to do about a group that was not visited: "group 3 (...) was not visited: ...". Returns
 * text. */
const char *stand_missing_text(const stand_options *options, unsigned group,
                               char text[STAND_TEXT_MAX]);

/* Writes the member `stand`. Deviations from a nominal value that is not stated are null. */
void stand_json(json_writer *w, const stand *s, const nominal_choice *nominal);

/* Prints tables and sentences, and a blank line. Deviations from a nominal value that is not stated
 * are left out; differences between them are not.
 *
 * x     the nine parameters from the lengths, for comparison.
 * unit  of offsets, of scale errors, of angles. */
void stand_print(FILE *file, const stand *s, const nominal_choice *nominal,
                 const double x[INVCAL_PARAMETERS], const display_unit unit[3]);

#endif
