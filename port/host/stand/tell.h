/* SPDX-License-Identifier: MIT
 *
 * stand/tell.h: the output of the results from a stand's angles; the report has one of its own
 * (report/stand.c).
 */
#ifndef STAND_TELL_H
#define STAND_TELL_H

#include <stdio.h>

#include "text/json_write.h"
#include "fit/nominal.h"
#include "stand/stand.h"
#include "cli/unit_style.h"

#define STAND_UNLIKELY 0.01 /* chance of closures so large: the groups contradict each other */
#define STAND_TEXT_MAX 512
#define STAND_MISSET_HARM                                                                          \
    "Lengths do not depend on angles: the calibration is correct. J1, the mounting and the "       \
    "series leave these positions out."

/* So many sigma to either side cover 95 %, where that has so many degrees of freedom: of the mounting, of J1, of
 * the series. */
double stand_coverage(double dof);
double stand_series_coverage(const group_series *s);

/* A unit that is turned so far that nobody mounts it so by mistake: a sentence; else "". */
const char *stand_turned_far(const mounting *m);

/* "Misset: position 8 ...": which, and by how much. Returns text. */
const char *stand_misset_text(const stand *s, const misset *m, char text[STAND_TEXT_MAX]);

/* What to do about a group that was not visited: "group 3 (...) was not visited: ...". Returns text. */
const char *stand_missing_text(const stand_wish *wish, unsigned group, char text[STAND_TEXT_MAX]);

/* The member `stand` of the object that is open. Deviations from a nominal that is not stated are null. */
void stand_json(json_writer *w, const stand *s, const nominal_choice *nominal);

/* A table and sentences for people, a blank line after them. Deviations from a nominal that is not stated are
 * left out; differences of them are not.
 *
 * x     the nine parameters by the lengths, to compare with.
 * unit  of offsets, of scale errors, of angles. */
void stand_print(FILE *file, const stand *s, const nominal_choice *nominal,
                 const double x[INVCAL_PARAMETERS], const display_unit unit[3]);

#endif
