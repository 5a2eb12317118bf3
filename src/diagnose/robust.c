/* SPDX-License-Identifier: MIT
 *
 * invcal_calibrate_robust: searches for outliers, then calibrates once (mathematics_judgement.md,
 * "Two cross-checks"). Does without diagnosis.c and systematic.c, for devices with little flash.
 */
#include "outliers.h"
#include "../core/vector.h"

/* In nominal units, in which no position is too wrong to be tested. Returns the suspected ones. */
static INVCAL_NOINLINE invcal_set leave_out_outliers(invcal_positions *positions)
{
    invcal_group g;
    invcal_fit fit;

    fit.positions = *positions;
    g.suspected = 0;
    while (invcal_fit_solve(&fit) == INVCAL_OK) { /* at most INVCAL_MAX_POSITIONS times */
        positions->left_out = fit.positions.left_out;
        invcal_outliers_search(&fit, &g);
        if (g.group == 0) {
            break;
        }
        fit.positions.left_out |= g.group;
    }
    return g.suspected;
}

invcal_status invcal_calibrate_robust(const invcal_real *raw, unsigned count,
                                      const invcal_calibration *nominal, invcal_real noise,
                                      invcal_calibration *out, invcal_quality *quality)
{
    invcal_positions positions = {raw, count, 0, nominal, noise};

    INVCAL_ASSERT((raw || count == 0) && nominal && out && quality);
    if (count > INVCAL_MAX_POSITIONS) {
        return INVCAL_BAD_COUNT;
    }
    const invcal_set suspected = leave_out_outliers(&positions);
    const invcal_status status = invcal_positions_calibrate(&positions, out, quality);
    if (status == INVCAL_OK) {
        quality->suspected = suspected;
        if (suspected != 0 || invcal_are_many(quality->positions, count)) {
            invcal_raise(quality, INVCAL_ROUGH);
        }
    }
    return status;
}
