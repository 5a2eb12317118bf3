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

/* Both passes: solution, residuals, judgement. out and q are lost on failure. */
invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q);

#endif
