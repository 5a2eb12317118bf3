/* SPDX-License-Identifier: MIT
 *
 * invcal/dip.h: the axes of a magnetometer turned to those of an accelerometer.
 *
 * Lengths leave open how the calibrated axes of each sit on the board. But up and the field have the same
 * angle between them wherever the device turns, 90 degrees and the dip: with a calibrated acceleration a and a
 * calibrated field m, both of length 1, at the same instants
 *
 *     a R m = s    the same for all,    (R, s) minimise  sum (a R m - s)^2
 *
 * R turns m to the axes of a. It is what a compass that is corrected for tilt depends on: a degree of it is
 * a degree of heading and more.
 *
 *     invcal_dip dip;
 *     invcal_dip_quality quality;
 *     invcal_real r[3][3];
 *     invcal_dip_init(&dip);
 *     ... for each instant: invcal_dip_add(&dip, a, m);           calibrated, of any length
 *     if (invcal_dip_solve(&dip, found.alike, r, &quality) == INVCAL_OK) {
 *         invcal_frame_turn(r, &magnetometer);                    frame.h
 *     }
 *
 * The hand must turn slowly: what it accelerates is no gravity. invcal.h states the rules and units.
 */
#ifndef INVCAL_DIP_H
#define INVCAL_DIP_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_DIP_ROW 10u /* the nine products of a and m, and 1 */

/* The sums of all instants: 224 bytes. */
typedef struct {
    /* The triangle of the row times itself over all instants. */
    invcal_real sum[INVCAL_DIP_ROW * (INVCAL_DIP_ROW + 1u) / 2u];
    unsigned count; /* instants; at most UINT_MAX */
} invcal_dip;

/* What they tell. */
typedef struct {
    invcal_real sigma[3]; /* of the three angles about the axes of a, rad */
    invcal_real sine;     /* s: of how far the field points up; north of the equator negative */
    invcal_real scatter;  /* of a R m about it, root mean square */
    invcal_real
        heading; /* what sigma leaves of the error of a heading, rad, over all orientations */
} invcal_dip_quality;

/* Empties the sums. All bytes zero is the same state. */
void invcal_dip_init(invcal_dip *dip);

/* Adds an instant.
 *
 * up, field  calibrated, in the axes of each sensor; of any length above 0.
 *
 * Returns INVCAL_OK; else the sums are as they were: INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a length of
 * 0, or one that cannot be squared. Cost: 350 instructions. Stack: about 80 bytes. */
invcal_status invcal_dip_add(invcal_dip *dip, const invcal_real up[3], const invcal_real field[3]);

/* Solves them, for rotations of up to some 40 degrees: axes that are exchanged have to be put right before.
 *
 * alike     how many instants in a row err as one (invcal_magnetometer_found), at least 1: sigma is
 *           by so many fewer.
 * rotation  out: R.
 * quality   out; may be null.
 *
 * Returns INVCAL_OK; else nothing is written:
 *   INVCAL_TOO_FEW        fewer than 5 instants;
 *   INVCAL_UNDETERMINED   they leave an angle open: all about one axis, or the field is vertical.
 * Cost: 35,000 instructions. Stack: about 500 bytes. */
invcal_status invcal_dip_solve(const invcal_dip *dip, invcal_real alike, invcal_real rotation[3][3],
                               invcal_dip_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
