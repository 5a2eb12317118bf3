/* SPDX-License-Identifier: MIT
 *
 * invcal/quality.h: how far a solution can be trusted.
 */
#ifndef INVCAL_QUALITY_H
#define INVCAL_QUALITY_H

#include "invcal/eigen.h"
#include "invcal/residual.h"

#ifdef __cplusplus
extern "C" {
#endif

/* May the solution be used? */
typedef enum {
    INVCAL_GOOD,          /* every parameter determined, and checked by positions to spare */
    INVCAL_NO_REDUNDANCY, /* determined, but as many equations as unknowns: nothing checks it */
    INVCAL_WEAK           /* some parameter is determined badly (or by its prior only): usable
                             only within its large sigma; see undetermined */
} invcal_verdict;

/* "good", "no redundancy", "weak"; any other value gives "unknown verdict". */
const char *invcal_verdict_text(invcal_verdict verdict);

/* How well a solution is known. */
typedef struct {
    invcal_real sigma_offset[3]; /* standard deviation of the offset, raw units */
    invcal_real sigma_delta[3];  /* likewise of the zero offsets, over field */
    invcal_real sigma_dk[3];     /* likewise of the scale errors */
    invcal_real sigma_gamma[3];  /* likewise of the non-orthogonality terms, rad */
    invcal_real noise;           /* standard deviation of a position mean behind them, in calibrated
                                 units over field: the larger of stated and observed, 1 if neither
                                 is there; raised beside a prior, see invcal_information */
    invcal_real dof;             /* degrees of freedom left for the residuals; 0: no check */
    invcal_real coverage;        /* +- coverage * sigma holds the truth in 95 % of cases */
    invcal_real residual_rms;    /* of |calibrated| / field - 1 over the positions */
    invcal_real residual_max;    /* the largest of these, without sign */
    unsigned worst;              /* the position of that, from 0 */
    invcal_real condition;       /* of H'H of the calibrated unit vectors, prior included; with
                                 priors of very different width it may be INVCAL_REAL_MAX */
    uint16_t undetermined;       /* bit r: parameter r is badly determined: sqrt(K(r,r)) > 10, or
                              K(r,r) noise^2 used > 0.1: by the noise in the readings itself */
    uint16_t from_prior;         /* bit r: the prior tells more about parameter r than the data */
    invcal_verdict verdict;      /* what all this comes to */
} invcal_quality;

/* What rounding costs, against the exact solution of the same readings, for 9 to 64 positions,
 * errors up to 20 % and a condition up to 10^6:
 *
 *     |parameter - exact|          <= INVCAL_LOSS        INVCAL_EPSILON condition
 *     |sigma / exact - 1|          <= INVCAL_LOSS_SIGMA  INVCAL_EPSILON condition
 *     |length - exact| over field  <= INVCAL_LOSS_LENGTH INVCAL_EPSILON sqrt(condition)
 *
 * the last for the positions of the solution, and so for its residuals. Sums and Cholesky give the
 * exact solution of equations H'H p = -H'J that are off by some epsilon of their largest element;
 * (H'H)^-1 makes that epsilon times condition in p, and H (H'H)^-1 its root in the lengths (Higham,
 * Accuracy and Stability of Numerical Algorithms, 10.1 and 20.4). The theory's factors grow with
 * the number of positions; these are measured (make numerics: 10^5 random sets, 50 digits).
 *
 * sigma does not know of it: in float it is the smaller of the two where a position mean is better
 * than about INVCAL_EPSILON sqrt(condition) of the field. Such positions are solved once more, with
 * the calibration found as nominal (invcal_session_renew, or settings->nominal): p and J are next
 * to nothing then, and so is what is lost of them,
 *
 *     |parameter - exact|          <= INVCAL_LOSS_AGAIN  INVCAL_EPSILON sqrt(condition) */
#define INVCAL_LOSS INVCAL_REAL(2.0)
#define INVCAL_LOSS_SIGMA INVCAL_REAL(32.0) /* see INVCAL_LOSS */
#define INVCAL_LOSS_LENGTH INVCAL_REAL(8.0) /* see INVCAL_LOSS */
#define INVCAL_LOSS_AGAIN INVCAL_REAL(4.0)  /* see INVCAL_LOSS */

/* Judges a solution.
 *
 * Cov = noise^2 G K G', G the Jacobian from calibrated units to the parameters: no shortcut
 * X = -p, so sigma holds to 1 % at errors of 10 % too (mathematics.md, "Uncertainty").
 * noise^2 is the larger of what settings->noise says and sum(residual^2) / dof, dof = positions
 * minus parameters (minus what the prior supplied).
 *
 * residuals  all positions that made the solution, or as many of them as are still stored. These
 *            then stand for all: dof = stored (1 - 9 / used), and the information of the stored
 *            ones counts used / stored times.
 * used       the count of the normal equations behind the solution.
 * settings   those of invcal_solve.
 *
 * Returns INVCAL_OK;
 *   INVCAL_BAD_SETTING   invcal_settings_check refuses the settings, no residuals, or used less
 *                        than their number; or a sigma does not fit the number type, as raw units
 *                        or a prior are beyond reason;
 *   INVCAL_UNDETERMINED  some sqrt(K(r,r)) exceeds 1000, or the condition exceeds
 *                        1 / INVCAL_PIVOT_FLOOR, with no prior to hold the parameter;
 *   INVCAL_NOT_ELLIPSOID residuals of more than 10 % of the field: these are no readings of one
 *                        field by one triad at rest.
 * After a failure the solution must not be used. Stack: about 650 bytes. */
invcal_status invcal_assess(const invcal_residuals *residuals, unsigned used,
                            const invcal_settings *settings, const invcal_solution *solution,
                            invcal_quality *quality);

/* K of the calibrated unit vectors, packed: (H'H + prior)^-1, the covariance of the nine
 * parameters in calibrated units over noise^2.
 *
 * noise  quality->noise of these residuals; finite, > 0. Matters with a prior only.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if H'H is singular; INVCAL_BAD_SETTING for unusable
 * settings or noise. Stack: about 370 bytes. */
invcal_status invcal_covariance(const invcal_residuals *residuals, const invcal_settings *settings,
                                invcal_real noise,
                                invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

/* The factor k for which +- k sigma covers 95 %: Student's t for a sigma estimated with dof
 * degrees of freedom, 12.706 at 1, 1.960 for very many. dof is rounded down; below 1: that of 1.
 * Exact to 0.002 (relative). */
invcal_real invcal_coverage(invcal_real dof);

#ifdef __cplusplus
}
#endif

#endif
