/* SPDX-License-Identifier: MIT
 *
 * fit/case_frame.h: rotates the calibrated axes to those of the case (invcal/frame.h), by positions
 * in which the axis of the case that pointed up is known.
 */
#ifndef CASE_FRAME_H
#define CASE_FRAME_H

#include "invcal/frame.h"

#define CASE_MAX 100u /* positions that can be stated */

/* The axes of the case that pointed up in the first positions of a file. */
typedef struct {
    unsigned count;
    char axis[CASE_MAX]; /* 'x', 'y', 'z'; '.': not known */
    int sign[CASE_MAX];
} case_axes;

typedef struct {
    unsigned used;            /* positions used; 0: it was not asked for */
    int is_level;             /* all had the same axis up: the rotation about it is unchanged */
    invcal_rotation rotation; /* from the calibrated axes to those of the case */
    double angle[3];          /* the same as a rotation vector, rad */
    double sigma[3];          /* standard deviations of angle; NaN: not known */
    double scatter;           /* deviation from the stated directions, rad, root mean square */
} case_frame;

/* Parses a list such as "+z,-x,.,y". Returns 1; 0 if it is malformed, longer than CASE_MAX, or all
 * unknown. */
int case_parse(const char *text, case_axes *stated);

/* Adds the position with this index in the file, from 0. Returns as invcal_frame_add; INVCAL_OK,
 * without adding it, if nothing is stated about it. */
invcal_status case_add(invcal_frame *frame, const case_axes *stated, unsigned index,
                       const invcal_calibration *calibration, const double raw[3]);

/* Solves for the rotation. `noise` is that of a direction about each axis, rad, or NaN; if the
 * scatter is larger, sigma follows from that. Returns as invcal_frame_solve, or as
 * invcal_frame_level if the positions had the same axis up; INVCAL_BAD_DIRECTION if the directions
 * are off by more than 11 degrees, or, with the same axis up, differ by that from their mean. */
invcal_status case_solve(const invcal_frame *frame, const case_axes *stated, double noise,
                         case_frame *out);

#endif
