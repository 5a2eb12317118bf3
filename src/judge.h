/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of a judgement, also for equations beyond the nine parameters.
 */
#ifndef INVCAL_JUDGE_H
#define INVCAL_JUDGE_H

#include "invcal/expert.h"

/* Positions, with nominal and noise. */
typedef struct {
    const invcal_real *raw;
    unsigned count;
    invcal_mask left_out; /* only of the first INVCAL_MAX_POSITIONS */
    const invcal_calibration *nominal;
    invcal_real noise; /* stated, over field; 0: not known */
} invcal_positions;

static inline int invcal_is_left_out(const invcal_positions *positions, unsigned i)
{
    return positions->left_out && i < INVCAL_MAX_POSITIONS && (positions->left_out >> i & 1u);
}

/* INVCAL_BAD_... of the nominal and noise. */
invcal_status invcal_positions_check(const invcal_positions *positions);

/* First pass: the sums of all that are not left out, up to the first that is not a reading. Returns
 * as invcal_observe. */
invcal_status invcal_positions_sum(const invcal_positions *positions, invcal_sums *sums);

/* The system of nine to L^-1, and to p if there is a row behind them.
 *
 * k          the diagonal of the inverse.
 * condition  tr A tr A^-1: at least that of A.
 *
 * INVCAL_UNDETERMINED if it is determined by rounding only. */
invcal_status invcal_determine(invcal_real *a, unsigned rows, invcal_real k[INVCAL_PARAMETERS],
                               invcal_real *condition);

/* invcal_calibrate_without. */
invcal_status invcal_positions_calibrate(const invcal_positions *positions, invcal_calibration *out,
                                         invcal_quality *quality);

/* ---- the steps of a judgement ---------------------------------------------------------------- */

#define INVCAL_WEAK_K INVCAL_REAL(100.0)   /* square of 10. Above: usable only within its sigma */
#define INVCAL_HOPELESS_K INVCAL_REAL(1e6) /* square of 1000, all nine K together. Above: refused */

/* Of calibrated lengths, each less 1. */
typedef struct {
    invcal_real rms; /* until the end: the sum of their squares */
    invcal_real max; /* without its sign */
    unsigned worst;  /* the position of max */
    unsigned count;
} invcal_residuals;

/* Position i, calibrated. */
void invcal_residuals_add(invcal_residuals *residuals, unsigned i, const invcal_row *row);

/* Returns INVCAL_OK; INVCAL_NOT_ELLIPSOID for an rms of a tenth of the field. */
invcal_status invcal_residuals_end(invcal_residuals *residuals);

enum { INVCAL_UNCHECKED = 0x1E }; /* a bit for each systematic error */

/* Nothing was found, since nothing was tested. */
static inline void invcal_judge_begin(invcal_quality *q)
{
    q->left_out = 0;
    q->suspected = 0;
    q->size = 0;
    q->systematic = INVCAL_NO_SYSTEMATIC;
    q->axis = 0;
    q->unchecked = INVCAL_UNCHECKED;
    q->verdict = INVCAL_GOOD;
}

/* rms, max, worst, positions. */
void invcal_judge_residuals(const invcal_residuals *residuals, invcal_quality *q);

/* g = A eta: noise of u, the same on all axes, moves the length of eta = A (u - delta), A
 * symmetric, by |g| times that noise. Returns |g|^2. */
invcal_real invcal_gradient(const invcal_real a[3][3], const invcal_real eta[3], invcal_real g[3]);

/* Second pass, with the calibration c of the raw counts: residuals without cancellation, and the
 * information on the nine parameters, each row weighted by its actual noise.
 *
 * a     A of c.
 * sums  as a system: sigma^2 of the parameters is noise^2 times the diagonal of its inverse. The
 *       last element: the weighted squares of the residuals, in terms of noise of u.
 *
 * Returns INVCAL_OK; INVCAL_NOT_ELLIPSOID if a residual is absurd, or all are. */
invcal_status invcal_positions_compare(const invcal_positions *positions,
                                       const invcal_calibration *c, const invcal_real a[3][3],
                                       invcal_sums *sums, invcal_residuals *residuals);

/* Only a worse one counts. */
static inline void invcal_raise(invcal_quality *q, unsigned verdict)
{
    if (verdict > q->verdict) {
        q->verdict = (uint8_t)verdict;
    }
}

enum { INVCAL_STATED = 4 }; /* residuals that a stated noise counts as */

/* noise and sigma_dof, from the stated noise and dof. The stated noise counts as some residuals,
 * unless the actual ones are clearly larger (at 95 %); if they are too large for noise (at 99.7 %),
 * raises the verdict.
 *
 * squares  the sum of the weighted squares of the residuals.
 * dof      their degrees of freedom, q->dof rounded down; below 1 they do not count. */
void invcal_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof,
                        invcal_quality *q);

/* dof rounded down, and limited so that a stated noise can still be added. */
static inline uint16_t invcal_whole(invcal_real dof)
{
    const invcal_real most = UINT16_MAX - INVCAL_STATED;

    if (!(dof >= 1)) {
        return 0;
    }
    //@ assert \is_finite(dof); // no NaN is at least 1
    return (uint16_t)(dof < most ? dof : most); /* uncovered: that many positions with a prior */
}

/* tr A tr A^-1 from L^-1: at least the condition. Is it determined by more than rounding? */
invcal_real invcal_condition(const invcal_real *inverse, unsigned n, invcal_real trace);
static inline int invcal_is_resolved(invcal_real condition)
{
    return condition * INVCAL_FLOOR < 2;
}

/* weak, sigma and the verdict, from K(r,r) = k[r] = sigma^2 / noise^2. Weak: K is large, or the
 * information 1 / K is at most ten times the part added by noise in the readings themselves, about
 * noise^2 in each row: then open directions look determined (mathematics.md, "Verdict, and near
 * cones"). */
void invcal_judge_parameters(const invcal_real k[INVCAL_PARAMETERS], const invcal_real a[3][3],
                             invcal_quality *q);

#endif
