/* SPDX-License-Identifier: MIT
 *
 * invcal_calibrate_robust: searches for outliers, then calibrates once (mathematics_judgement.md,
 * "Two cross-checks"). Does without diagnosis.c and systematic.c, for devices with little flash.
 */
#include "outliers.h"
#include "vector.h"

/* In nominal units, in which no position is too wrong to be tested. Returns the suspected ones. */
static INVCAL_NOINLINE invcal_set leave_out_outliers(invcal_selection *selection)
{
    invcal_group g;
    invcal_fit fit;

    fit.selection = *selection;
    g.suspected = 0;
    while (invcal_fit_solve(&fit) == INVCAL_OK) { /* at most INVCAL_MAX_POSITIONS times */
        selection->left_out = fit.selection.left_out;
        invcal_outliers_search(&fit, &g);
        if (g.group == 0) {
            break;
        }
        fit.selection.left_out |= g.group;
    }
    return g.suspected;
}

invcal_status invcal_calibrate_robust(const invcal_positions *positions, invcal_calibration *out,
                                      invcal_quality *quality)
{
    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && out && quality);
    if (positions->count > INVCAL_MAX_POSITIONS) {
        return INVCAL_BAD_COUNT;
    }
    invcal_selection selection = {*positions, 0};
    const invcal_set suspected = leave_out_outliers(&selection);
    const invcal_status status = invcal_positions_calibrate(&selection, out, quality);
    if (status == INVCAL_OK) {
        quality->suspected = suspected;
        if (suspected != 0 || invcal_are_many(quality->positions, selection.given.count)) {
            invcal_raise(quality, INVCAL_ROUGH);
        }
    }
    return status;
}
