/* SPDX-License-Identifier: MIT
 *
 * invcal_calibrate_robust: searches for outliers, then calibrates once (mathematics_judgement.md,
 * "Two cross-checks"). Does without diagnosis.c and systematic.c, for devices with little flash.
 */
#include "outliers.h"
#include "../core/vector.h"

/* In nominal units, in which no position is too wrong to be tested. Returns the suspected ones. */
static INVCAL_NOINLINE invcali_set find_outliers(const invcal_positions *positions,
                                                 invcali_set *left_out)
{
    invcali_group g;
    invcali_fit fit;

    fit.selection.given = *positions;
    fit.selection.left_out = 0;
    g.suspected = 0;
    while (invcali_fit_solve(&fit) == INVCAL_OK) { /* at most INVCAL_MAX_POSITIONS times */
        *left_out = fit.selection.left_out;
        invcali_outliers_search(&fit, &g);
        if (g.group == 0) {
            break;
        }
        fit.selection.left_out |= g.group;
    }
    return g.suspected;
}

/* Not inline: its frame should not lie under the search. */
static INVCAL_NOINLINE invcal_status calibrate_others(const invcal_positions *positions,
                                                      invcali_set left_out, invcal_calibration *out,
                                                      invcal_quality *quality)
{
    const invcali_selection selection = {*positions, left_out};

    return invcali_positions_calibrate(&selection, out, quality);
}

invcal_status invcal_calibrate_robust(const invcal_positions *positions, invcal_calibration *out,
                                      invcal_quality *quality)
{
    invcali_set left_out = 0;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && out && quality);
    if (positions->count > INVCAL_MAX_POSITIONS) {
        return INVCAL_BAD_COUNT;
    }
    const invcali_set suspected = find_outliers(positions, &left_out);
    const invcal_status status = calibrate_others(positions, left_out, out, quality);
    if (status == INVCAL_OK) {
        quality->suspected = suspected;
        if (suspected != 0 || invcali_are_many(quality->positions, positions->count)) {
            invcali_raise(quality, INVCAL_ROUGH);
        }
    }
    return status;
}
