/* SPDX-License-Identifier: MIT
 *
 * fit/case_frame.h: the calibrated axes turned to those of the case (invcal/frame.h), by positions in which it
 * is known which way the case was.
 */
#ifndef CASE_FRAME_H
#define CASE_FRAME_H

#include "invcal/frame.h"

#define CASE_MOST 100u /* positions that can be stated */

/* Which way of the case was up in the first positions of a file. */
typedef struct {
    unsigned count;
    char axis[CASE_MOST]; /* 'x', 'y', 'z'; '.': not known */
    int sign[CASE_MOST];
} case_wish;

typedef struct {
    unsigned used;         /* positions used; 0: it was not asked for */
    int is_level;          /* they had one way up: the turn about that is left as it was */
    double rotation[3][3]; /* of the calibrated axes to those of the case */
    double angle[3];       /* the same as a rotation vector, rad, */
    double sigma[3];       /* and its standard deviations; NaN: not known */
    double scatter;        /* how far directions were from those stated, rad, root mean square */
} case_frame;

/* Reads "+z,-x,.,y". Returns 0 unless it is such a list, of at most CASE_MOST, one of them known. */
int case_parse(const char *text, case_wish *wish);

/* Adds a position: its number in the file, from 0. Returns as invcal_frame_add; INVCAL_OK if nothing is stated of it. */
invcal_status case_add(invcal_frame *frame, const case_wish *wish, unsigned number,
                       const invcal_calibration *calibration, const double raw[3]);

/* Solves it. `noise` is that of a direction about each axis, rad, or NaN; more scatter than that counts instead.
 * Returns as invcal_frame_solve, or invcal_frame_level if the positions had one way up; INVCAL_BAD_DIRECTION if the
 * directions are off by more than 11 degrees. */
invcal_status case_solve(const invcal_frame *frame, const case_wish *wish, double noise,
                         case_frame *out);

#endif
