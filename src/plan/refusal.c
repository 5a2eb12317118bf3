/* SPDX-License-Identifier: MIT
 *
 * Why a calibration was refused: which position is not a reading of this field, or which parameters
 * are open (mathematics.md, "Verdict, and near cones"). Computed again from the positions, so that
 * the solution need not carry it along.
 */
#include "guidance.h"
#include "../core/sums.h"

#define RIDGED INVCAL_REAL(0.1) /* share of the ridge in a parameter; above: it is open */

unsigned invcal_bad_reading(const invcal_positions *positions)
{
    invcali_row row;
    unsigned i = 0;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions));
    /* at most count steps */
    while (i < positions->count &&
           invcali_observe(positions->nominal, positions->mean[i].v, &row) == INVCAL_OK) {
        i++;
    }
    return i;
}

/* ridge K(r,r) is the share of the ridge in what is known of parameter r: 1 if the positions
 * contribute nothing. */
uint16_t invcal_undetermined(const invcal_positions *positions)
{
    invcal_sums sums;
    invcal_real last[3];
    unsigned open = 0;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions));
    invcali_sum_readings(positions, &sums, last);
    const invcal_real ridge = invcali_ridged_inverse(&sums);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real k = invcali_variance(sums.sum, INVCAL_PARAMETERS, r);
        open |= (ridge * k <= RIDGED ? 0u : 1u) << r;
    }
    return (uint16_t)open;
}
