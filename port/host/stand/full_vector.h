/* SPDX-License-Identifier: MIT
 *
 * stand/full_vector.h: all three readings of a position against its known direction.
 */
#ifndef FULL_VECTOR_H
#define FULL_VECTOR_H

#include "core/system.h"

/* The full vector. Lengths do not show how the unit is turned on the stand, and J1 shows it to
 * second order only. All three readings of a position show it to first order:
 *
 *     u = M eta + delta,    M = (I + S) R
 *
 * with R the mounting: a direction eta of the stand's frame is R eta in the frame of the unit. That
 * is linear in the twelve elements of M and delta, and the three axes share one 4x4 system; I + S
 * and R are the polar decomposition of M. An angle error d counts to first order here (expert.h,
 * "known directions"): so take the parameters from the lengths, and only the mounting from here. */
typedef struct {
    /* The triangle of (eta 1 u)'(eta 1 u) over all positions. */
    double sum[INVCAL_PACKED_SIZE(7)];
    unsigned count; /* positions in the sums; at most UINT_MAX */
} full_vector;

/* Empties the sums. All bytes zero is the same state. */
void full_vector_init(full_vector *full);

/* Adds a position of known direction.
 *
 * nominal  the same for all positions.
 * raw      a position mean, input units.
 * eta      the up direction in the frame of the stand, unit length within 1e-4.
 *
 * Returns as invcal_directions_add. */
invcal_status full_vector_add(full_vector *full, const invcal_calibration *nominal,
                              const double raw[3], const double eta[3]);

/* Solves the sums, for errors of any size.
 *
 * full      the sums; are overwritten.
 * nominal   the one they were added with; may equal out.
 * out       the calibration, in the frame of the stand: calibrated readings are eta in that frame.
 * x         the nine parameters, in the frame of the unit and the order of the paper.
 * mounting  R. With the paper's N positions on each of three great circles, and noise s on every
 *           axis, the standard deviation of its three angles is s / sqrt(2 N).
 *
 * Does not judge.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than four positions;
 *   INVCAL_UNDETERMINED   the ends of the directions lie in a plane, as those of a circle do;
 *   INVCAL_NOT_ELLIPSOID  a semi-axis of I + S is outside about 0.1 ... 10, or delta beyond 10; or
 *                         the directions are mirrored: an angle has the wrong sign;
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal. */
invcal_status full_vector_solve(full_vector *full, const invcal_calibration *nominal,
                                invcal_calibration *out, double x[INVCAL_PARAMETERS],
                                double mounting[3][3]);

#endif
