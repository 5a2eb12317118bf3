/* SPDX-License-Identifier: MIT
 *
 * invcal/expert.h: single steps, for programs that no other header fits.
 *
 *     invcal_sums        any number of positions in constant memory, each with a weight of its own
 *     invcal_directions  positions of known direction: a stand
 *
 * Neither judges: INVCAL_OK means solvable. invcal.h states the rules and units.
 */
#ifndef INVCAL_EXPERT_H
#define INVCAL_EXPERT_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the normal equations, position by position -------------------------------------------------
 *
 * Every equation reads J + h p = 0 with the row of the paper
 *
 *     h(a) = (x y z x^2 y^2 z^2 xy xz yz).
 *
 * With u the reading over field, not normalised, J = (|u|^2 - 1)/2 + h(u) p = 0 is the equation of
 * an ellipsoid: exact for errors of any size, and linear in p. The size of its sums does not depend
 * on the number of positions, and their order matters only to rounding. */
typedef struct {
    invcal_real sum[55]; /* private: the triangle of H'H, then H'J and J'J */
    unsigned count;      /* positions; at most UINT_MAX */
} invcal_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_sums_init(invcal_sums *sums);

/* Adds a position.
 *
 * nominal  the same for all positions.
 * mean     raw counts.
 * weight   1 for a position like the others; (sigma_usual / sigma_this)^2 for another precision.
 *
 * Returns INVCAL_OK; else the sums are unchanged: INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a
 * length outside 0.1 ... 10; INVCAL_BAD_NOISE unless weight is positive and finite.
 * Cost: 460 instructions. */
invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real mean[3], invcal_real weight);

/* Solves the sums (mathematics.md, "From p to the calibration"):
 *
 *     p = -(H'H)^-1 H'J                                               one 9x9 Cholesky
 *     v = (p0 p1 p2),  Q = I + [2 p3 p6 p7; p6 2 p4 p8; p7 p8 2 p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta,  A'A = Q / k,  A symmetric
 *     calibrated = A (u - delta)
 *
 * sums     are overwritten: copy them if more positions will follow.
 * nominal  the one they were added with; may equal out.
 *
 * A system determined by little more than rounding may pass as solvable.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than nine positions;
 *   INVCAL_UNDETERMINED   the positions leave parameters open;
 *   INVCAL_NOT_ELLIPSOID  see invcal_calibrate (positions.h);
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal.
 * Cost: 4,200 instructions. Stack: about 180 bytes. */
invcal_status invcal_sums_solve(invcal_sums *sums, const invcal_calibration *nominal,
                                invcal_calibration *out);

/* ---- known directions: a stand ------------------------------------------------------------------
 *
 * With the direction eta known, the paper's vertical composition J = u eta - 1 is exactly linear in
 * X = (delta, dk, gamma): J + h(eta) p = 0 with p = -X. An error d of the direction costs |d|^2 /
 * 2, and s |d| at most, s half the spread of the eigenvalues of S: 2e-5 for 1 mrad at s = 0.02
 * (mathematics.md, "Known directions"). */
typedef struct {
    invcal_sums sums; /* private: of h(eta) and J. In exact rows p has another meaning */
} invcal_directions;

/* Empties the sums. All bytes zero is the same state. */
void invcal_directions_init(invcal_directions *directions);

/* Adds a position of known direction.
 *
 * nominal  the same for all positions.
 * mean     raw counts.
 * eta      the up direction in the frame of the unit, unit length within 1e-4.
 *
 * Returns INVCAL_OK; else the sums are unchanged: INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE as
 * invcal_sums_add; INVCAL_BAD_DIRECTION. Stack: about 120 bytes. */
invcal_status invcal_directions_add(invcal_directions *directions,
                                    const invcal_calibration *nominal, const invcal_real mean[3],
                                    const invcal_real eta[3]);

/* Solves the sums: A = (I + S)^-1.
 *
 * directions  are overwritten.
 * nominal     the one they were added with; may equal out.
 * x           out: the nine parameters.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than nine positions;
 *   INVCAL_UNDETERMINED   the directions leave parameters open;
 *   INVCAL_NOT_ELLIPSOID  a semi-axis of I + S is outside about 0.1 ... 10, or delta beyond 10;
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal.
 * Stack: about 200 bytes. */
invcal_status invcal_directions_solve(invcal_directions *directions,
                                      const invcal_calibration *nominal, invcal_calibration *out,
                                      invcal_real x[INVCAL_PARAMETERS]);

#ifdef __cplusplus
}
#endif

#endif
