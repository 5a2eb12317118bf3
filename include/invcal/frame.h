/* SPDX-License-Identifier: MIT
 *
 * invcal/frame.h: turns the calibrated axes to those of the case.
 *
 * Lengths leave open how the calibrated axes sit in the case. Rests in known orientations determine
 * it: two or more of its faces on a table. Each gives a direction c of the case that pointed up,
 * and the calibrated reading a of the same direction:
 *
 *     c = R a,    R minimises  sum |c - R a|^2                       (Wahba's problem)
 *
 * The table limits this, not the sensor: half a degree of tilt makes 6 to 9 mrad. So put down all
 * faces, then all again, each turned by half a turn on the table: the tilt cancels to first order,
 * and `scatter` shows it. One that is turned at once may be refused as INVCAL_REST_SAME.
 *
 *     invcal_frame_init(&frame);
 *     for each rest:
 *         invcal_frame_add(&frame, &calibration, mean, up);     up: {0, 0, 1}, {1, 0, 0} ...
 *     if (invcal_frame_solve(&frame, &rotation, NULL) == INVCAL_OK)
 *         invcal_rotate(&calibration, &rotation);               of each sensor
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_FRAME_H
#define INVCAL_FRAME_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A rotation: turned = r v. */
typedef struct {
    invcal_real r[3][3]; /* by rows */
} invcal_rotation;

/* Turns a calibration: multiplies its matrix by the rotation from the left. Stack: about 50
 * bytes. */
void invcal_rotate(invcal_calibration *calibration, const invcal_rotation *rotation);

/* Sums over rests of known orientation. */
typedef struct {
    invcal_real own_sum[3][3]; /* private: of c a' */
    unsigned count;            /* of directions; at most UINT_MAX */
} invcal_frame;

/* The quality of a rotation. */
typedef struct {
    /* Standard deviation of the three angles about the axes of the case, over that of one
     * direction: multiply by scatter, or the tilt of the table if larger. Two faces: 1, 1,
     * 0.71. */
    invcal_real sigma[3];
    invcal_real scatter; /* of the directions, rad, root mean square; float rounds to 5e-4 */
} invcal_frame_quality;

/* Empties the sums. All bytes zero is the same state. */
void invcal_frame_init(invcal_frame *frame);

/* Adds a rest.
 *
 * calibration  to be turned; the same for all rests.
 * raw          the mean of the rest, raw counts.
 * up           the direction of the case that pointed up: unit length within 1e-4.
 *
 * Returns INVCAL_OK; else the sums are unchanged:
 *   INVCAL_NOT_FINITE      a reading is NaN or infinite;
 *   INVCAL_OUT_OF_RANGE    its length is outside 1/2 ... 2: not a rest, or not a calibration;
 *   INVCAL_BAD_DIRECTION   up has another length.
 * Cost: 250 instructions. Stack: about 40 bytes. */
invcal_status invcal_frame_add(invcal_frame *frame, const invcal_calibration *calibration,
                               const invcal_real raw[3], const invcal_real up[3]);

/* Solves the sums, for any rotation.
 *
 * quality  out; may be null.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than two rests;
 *   INVCAL_UNDETERMINED   all directions were nearly the same, or opposite: the turn about them is
 *                         open (invcal_frame_level); or they contradict each other.
 * Cost: 2,100 instructions. Stack: about 310 bytes. */
INVCAL_NODISCARD invcal_status invcal_frame_solve(const invcal_frame *frame, invcal_rotation *out,
                                                  invcal_frame_quality *quality);

/* Level trim, from rests in one orientation: the smallest rotation that brings the reading to up.
 * The heading stays.
 *
 * up  the direction with which they were added.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        no rest;
 *   INVCAL_UNDETERMINED   a rotation of more than 139 degrees; or the mean direction is shorter
 *                         than 0.9, as of rests 52 degrees apart.
 * Stack: about 70 bytes. */
INVCAL_NODISCARD invcal_status invcal_frame_level(const invcal_frame *frame,
                                                  const invcal_real up[3], invcal_rotation *out);

#ifdef __cplusplus
}
#endif

#endif
