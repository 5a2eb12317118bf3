/* SPDX-License-Identifier: MIT
 *
 * Internal: the choice of the next direction, for those who have summed positions up already.
 */
#ifndef INVCAL_GUIDANCE_H
#define INVCAL_GUIDANCE_H

#include "invcal/expert.h"

/* The sums of positions; those that are no readings are passed over.
 *
 * last  out: the last that is one, over field; 0 if there is none. */
void invcal_sum_readings(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                         invcal_sums *sums, invcal_real last[3]);

/* The direction to take next beside the rows in sums, which are lost.
 *
 * current  the last reading, over field; 0 if there is none. */
void invcal_next_beside(invcal_sums *sums, const invcal_real current[3], invcal_real up[3]);

/* L^-1 of H'H and a small ridge, of sums that are lost: works for any positions, even none. Returns
 * the ridge. */
invcal_real invcal_ridged_inverse(invcal_sums *sums);

#endif
