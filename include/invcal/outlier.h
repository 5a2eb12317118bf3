/* SPDX-License-Identifier: MIT
 *
 * invcal/outlier.h: which positions contradict the others.
 *
 * A position that was read in motion, with a hand on the case or beside a magnet spoils the
 * calibration silently: 0.05 g in one of 18 costs 9.5 mg. Baarda's data snooping (mathematics.md,
 * "Outliers") compares each residual with its standard deviation sigma sqrt(1 - h K h'), but two
 * wrong positions hide one another and put the blame on a third. So groups of one, two and three
 * are tried, all of them, and the sums of squares S left by the best of each size compared:
 *
 *     leaving out k of n is better than leaving out j < k of them, if
 *     P(F > f) choose(n - j, k - j) <= 0.007,   f = (S_j - S_k) / (k - j) / (S_k / (n - 9 - k)),
 *
 * Fisher's F (fisher.h) of the best of so many choices (Bonferroni's inequality). The largest
 * group that beats every smaller one, and of which no rival of the same size comes near (P above
 * 0.05), is taken out, and the search repeated among the rest. Two degrees of freedom are left.
 */
#ifndef INVCAL_OUTLIER_H
#define INVCAL_OUTLIER_H

#include "invcal/solution.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_OUTLIERS_CAPACITY INVCAL_MAX_POSITIONS /* positions at most */
#define INVCAL_OUTLIERS_FEWEST 11u /* and these only beside a stated noise: else 12 */
#define INVCAL_OUTLIERS_MOST 6u    /* outliers named at most */

/* Which positions contradict the others, and by how much. */
typedef struct {
    invcal_mask removed; /* bit i: position i is an outlier: leave it out, or repeat it */
    invcal_mask
        suspected;  /* bit i: position i is of two groups left in that contend: one of them is
                           wrong, the residuals do not tell which. Repeat these. 0 as a rule */
    unsigned count; /* of those removed */
    unsigned position[INVCAL_OUTLIERS_MOST];       /* their numbers from 0, ascending */
    invcal_real error[INVCAL_OUTLIERS_MOST];       /* what each reads too much, over field */
    invcal_real w[INVCAL_OUTLIERS_MOST];           /* the same over its standard deviation */
    invcal_real checked[INVCAL_OUTLIERS_CAPACITY]; /* 1 - h K h', 0 ... 1: how much of an error of
                                                      position i its own residual shows. Below
                                                      0.0001 none is found. 0 if removed */
    invcal_real sigma; /* standard deviation of one equation, over field, as shown by the
                          residuals left and by what was stated */
} invcal_outliers;

/* Looks for positions that contradict the others.
 *
 * raw       3 count numbers as for invcal_calibrate: position means in raw units.
 * count     INVCAL_OUTLIERS_FEWEST ... INVCAL_OUTLIERS_CAPACITY.
 * settings  nominal calibration and field. The noise stated, if any, counts like one residual
 *           more: it helps where few are left, and keeps lucky ones from making outliers of the
 *           rest. Priors are not used, nor is the frame.
 * out       the outliers. What is not removed may be given to invcal_calibrate.
 *
 * Found, with noise of 1e-4 and programs of plan.h: one of 18, wrong by 0.002 or 0.05, in at
 * least 99.5 % (and the error afterwards is 80e-6, that of 17 good ones); two of 18 and three of
 * 24, by 0.002 to 0.1 of either sign, in at least 97 %. Without outliers about one data set in a
 * hundred loses a position. Random orientations show less: 0.002 in one of 18 is found in 97 %, in
 * one of 14 in 63 %, in one of 12 in 5 %. More than three wrong ones of 24 may hide each other.
 *
 * Returns INVCAL_OK, with or without outliers;
 *   INVCAL_BAD_SETTING    more than INVCAL_OUTLIERS_CAPACITY positions, or
 *                         invcal_settings_check refuses the settings;
 *   INVCAL_TOO_FEW        fewer than INVCAL_OUTLIERS_FEWEST;
 *   INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE    for a reading, as in observation.h;
 *   INVCAL_UNDETERMINED   the positions leave parameters open: invcal_calibrate names them.
 * Cost: 1,000 groups of 18 positions, 5,500 of 32, each about 30 multiply-adds and a row, and
 * eight least-squares fits; for every group removed once more.
 * Stack: about 950 bytes (float, Cortex-M4F, -Os). */
invcal_status invcal_outliers_find(const invcal_real *raw, unsigned count,
                                   const invcal_settings *settings, invcal_outliers *out);

#ifdef __cplusplus
}
#endif

#endif
