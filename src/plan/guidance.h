/* SPDX-License-Identifier: MIT
 *
 * Internal: directions, and the choice of the next from sums of positions.
 */
#ifndef INVCAL_GUIDANCE_H
#define INVCAL_GUIDANCE_H

#include "invcal/expert.h"
#include "invcal/positions.h"
#include "../core/names.h"

enum { INVCAL_DIRECTIONS = 26 };

/* Faces, edges and corners of a cube, as unit vectors: with the centre as number 13, n to base 3 has
 * a digit for each axis, x first, 0 for +, 1 for neither, 2 for -. */
void invcali_direction(unsigned n, invcal_real up[3]);

/* The sums of positions; skips those that are not readings.
 *
 * last  out: the last reading, over field; 0 if there is none. */
void invcali_sum_readings(const invcal_positions *positions, invcal_sums *sums,
                          invcal_real last[3]);

/* The direction to take next, given the rows in sums, which are overwritten.
 *
 * current  the last reading, over field; 0 if there is none. */
void invcali_next_of_sums(invcal_sums *sums, const invcal_real current[3], invcal_real up[3]);

/* The direction to take next: of directions with about the same information the closest to the last
 * position - the opposite one counts 1.6 % less - but none within 26 degrees of it. */
void invcali_next(const invcal_positions *positions, invcal_real up[3]);

/* sqrt(K(r,r)) of the positions so far: sigma of parameter r over that of a position mean.
 *
 * up  null, or a direction to include as if taken, to see what it will improve. The ridge limits
 *     that of open parameters to about 100. */
void invcali_prospect(const invcal_positions *positions, const invcal_real *up,
                      invcal_real root[INVCAL_PARAMETERS]);

/* L^-1 of H'H and a small ridge; overwrites the sums. Works for any positions, even none. Returns
 * the ridge. */
invcal_real invcali_ridged_inverse(invcal_sums *sums);

#endif
