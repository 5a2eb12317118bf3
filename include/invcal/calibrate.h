/* SPDX-License-Identifier: MIT
 *
 * invcal/calibrate.h: everything in one call, for positions that stand in an array.
 */
#ifndef INVCAL_CALIBRATE_H
#define INVCAL_CALIBRATE_H

#include "invcal/quality.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Why a calibration was refused, beyond the status. */
typedef struct {
    unsigned position;     /* of a bad reading, counted from 0; else the number of positions */
    uint16_t undetermined; /* bit r: parameter r is left open (INVCAL_TOO_FEW, _UNDETERMINED) */
} invcal_reason;

/* Calibrates from position means: rows, solution, residuals, judgement.
 *
 * raw       3 count numbers: the position means x y z, x y z, ... in raw units, in any order.
 *           Nine positions are the least without a prior; twelve to eighteen well spread ones
 *           are good. In float a mean carries 24 bits: from counts above 2^24 subtract first.
 * settings  see invcal_settings. The residuals may show more noise than stated; with a prior the
 *           solution is then made once more with that noise.
 * solution  the calibration and its parameters.
 * quality   its sigma and verdict. Look at the verdict before you use the solution.
 * reason    null, or what was wrong; written on failure only.
 *
 * Returns what the rooms return: INVCAL_OK, INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE (with the
 * position), INVCAL_BAD_SETTING, INVCAL_TOO_FEW, INVCAL_UNDETERMINED, INVCAL_NOT_ELLIPSOID.
 * Stack: about 1,550 bytes. */
invcal_status invcal_calibrate(const invcal_real *raw, unsigned count,
                               const invcal_settings *settings, invcal_solution *solution,
                               invcal_quality *quality, invcal_reason *reason);

/* Positions that are kept. */
typedef struct {
    const invcal_real *raw; /* 3 count numbers, as above */
    const uint8_t *age;     /* days that each has faded, invcal_faded; null: none has */
    unsigned count;         /* of them */
    invcal_mask left_out;   /* bit i: position i is not in the sums. Not 0: count is at most
                             INVCAL_MAX_POSITIONS */
} invcal_positions;

/* The weight of a position after some days, each of which takes 1/32 of it: (31/32)^days, one step
 * for each of them: 0 ... 255, what an age holds. */
invcal_real invcal_faded(unsigned days);

/* The second half of it, for sums that were built position by position: solution, residuals,
 * judgement.
 *
 * normal     exact rows; of more positions than are kept, if so.
 * positions  those that are kept, one at least: they stand for all in the residuals.
 *
 * Returns as above; INVCAL_UNDETERMINED also if the condition of the sums themselves, in nominal
 * units, exceeds 1 / INVCAL_PIVOT_FLOOR without a prior: the solution is then one of rounding
 * errors, and invcal_assess, which sees the readings as it has calibrated them, may not notice.
 * On failure solution and quality are lost. Stack: about 1,150 bytes.
 * quality->worst counts from 0 in positions. */
invcal_status invcal_calibrate_sums(const invcal_normal *normal, const invcal_positions *positions,
                                    const invcal_settings *settings, invcal_solution *solution,
                                    invcal_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
