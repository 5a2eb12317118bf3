/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of a judgement, for those who have other equations behind the nine parameters.
 */
#ifndef INVCAL_JUDGE_H
#define INVCAL_JUDGE_H

#include "invcal/expert.h"

/* Positions, and what they were read with. */
typedef struct {
    const invcal_real *raw;
    unsigned count;
    invcal_mask left_out; /* only of the first INVCAL_MAX_POSITIONS */
    const invcal_calibration *nominal;
    invcal_real noise; /* stated, over field; 0: not known */
} invcal_positions;

static inline int invcal_is_left_out(const invcal_positions *positions, unsigned i)
{
    return positions->left_out && i < INVCAL_MAX_POSITIONS && (positions->left_out >> i & 1u);
}

/* First pass: the sums of all that are not left out. Returns as invcal_observe. */
invcal_status invcal_positions_sum(const invcal_positions *positions, invcal_sums *sums);

/* INVCAL_BAD_... of what the positions were read with. */
invcal_status invcal_positions_check(const invcal_positions *positions);

/* Second pass, now with calibrated readings: residuals without cancellation, the sums of unit
 * vectors, and each row weighted with the noise that it really has. Fills in rms, max, worst,
 * positions and left_out.
 *
 * a  with calibrated = a (u - delta), u what nominal makes of a reading; c the same for raw counts.
 *
 * Returns INVCAL_OK; INVCAL_NOT_ELLIPSOID if the residuals are absurd. */
invcal_status invcal_compare(const invcal_positions *positions, const invcal_real a[3][3],
                             const invcal_calibration *c, invcal_sums *sums, invcal_quality *q);

/* noise and dof: the larger of what is stated and what the residuals say. */
void invcal_judge_noise(invcal_real stated, invcal_real weighted_squares, invcal_real dof,
                        invcal_quality *q);

/* sigma, weak and verdict from L^-1 of the second pass, a of it, and the noise and dof in q. */
void invcal_judge_parameters(const invcal_real *inverse, const invcal_real a[3][3],
                             invcal_quality *q);

/* Both passes: solution, residuals, judgement. out and q are lost on failure. */
invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q);

#endif
