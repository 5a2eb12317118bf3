/* SPDX-License-Identifier: MIT
 *
 * invcal/residual.h: how well the positions agree with a solution.
 *
 * The stored positions are gone through a second time, now in calibrated units. That serves three
 * ends at once: residuals without cancellation (those from the sums of the first pass are lost
 * in float: 109 against 118 millionths on a real sensor), the covariance of the *calibrated*
 * unit vectors, and each row weighted with the noise that it really has (|A eta| differs between
 * directions by as much as the scale errors, and so would the reported sigma).
 */
#ifndef INVCAL_RESIDUAL_H
#define INVCAL_RESIDUAL_H

#include "invcal/solution.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The second pass over the positions. */
typedef struct {
    invcal_normal normal;      /* weighted exact rows of the calibrated readings */
    invcal_real correction[6]; /* A - I, A = (I + S)^-1, packed */
    invcal_real delta[3];      /* of the solution */
    invcal_real gain;          /* root mean square of |A eta| over all directions */
    invcal_real squares; /* sum of the squared residuals |calibrated| / field - 1, unweighted */
    invcal_real max;     /* the largest residual, without its sign */
    unsigned worst;      /* its position, counted from 0 in the order of addition */
    unsigned count;      /* of positions added */
} invcal_residuals;

/* Empties the sums and takes over what is needed of the solution. */
void invcal_residuals_init(invcal_residuals *residuals, const invcal_solution *solution);

/* Adds one position.
 *
 * u         its reading over field, as made for the rows of the solution, whatever their kind.
 * weight    the one it had in the normal equations, invcal_normal_add: 1 as a rule.
 * residual  |calibrated| / field - 1; may be null.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE if the calibrated reading is absurd;
 * INVCAL_BAD_SETTING for an unusable weight.
 * Cost: about that of adding it to the normal equations. */
invcal_status invcal_residuals_add(invcal_residuals *residuals, const invcal_real u[3],
                                   invcal_real weight, invcal_real *residual);

#ifdef __cplusplus
}
#endif

#endif
