/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of a judgement, also for equations beyond the nine parameters.
 */
#ifndef INVCAL_JUDGE_H
#define INVCAL_JUDGE_H

#include <stddef.h>

#include "invcal/positions.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* An invcal_mask of positions in as few bits as the build needs, in which it computes. */
#if INVCAL_MAX_POSITIONS <= 16
typedef uint16_t invcali_set;
#elif INVCAL_MAX_POSITIONS > 32
typedef uint64_t invcali_set;
#else
typedef uint32_t invcali_set;
#endif

/* Positions, less some of them. */
typedef struct {
    invcal_positions given;
    invcali_set left_out; /* only of the first INVCAL_MAX_POSITIONS */
} invcali_selection;

static inline int invcali_is_left_out(const invcali_selection *selection, unsigned i)
{
    return i < INVCAL_MAX_POSITIONS && (selection->left_out >> i & 1u);
}

/* INVCAL_BAD_... of the nominal and noise. */
invcal_status invcali_positions_check(const invcal_positions *positions);

/* One pass over all that are not left out.
 *
 * First, with c the nominal, a and q NULL: the sums of their exact rows.
 *
 * Second, with the calibration c of the raw counts, and A of it: residuals without cancellation,
 * and the information on the nine parameters, each row weighted by its actual noise. sums become a
 * system: sigma^2 of the parameters is noise^2 times the diagonal of its inverse. Its last element:
 * the weighted squares of the residuals, in terms of noise of u. q begins again, with the residuals.
 *
 * Returns as invcali_observe for the first that is not a reading; in the second INVCAL_NOT_ELLIPSOID
 * if a residual is absurd, or all are. */
invcal_status invcali_positions_pass(const invcali_selection *selection,
                                     const invcal_calibration *c, const invcal_real a[3][3],
                                     invcal_sums *sums, invcal_quality *q);

static inline invcal_status invcali_positions_sum(const invcali_selection *selection,
                                                  invcal_sums *sums)
{
    return invcali_positions_pass(selection, selection->given.nominal, NULL, sums, NULL);
}

/* First pass, and its solution: sums become L^-1 and p, and q has their K and their condition.
 * Returns as the pass, then INVCAL_TOO_FEW, then as invcali_determine. */
invcal_status invcali_positions_solve(const invcali_selection *selection, invcal_sums *sums,
                                      invcal_quality *q);

/* The system of nine to L^-1, and to p if there is a row behind them.
 *
 * q->sigma      the diagonal K(r,r) of the inverse.
 * q->condition  tr A tr A^-1: at least that of A.
 *
 * INVCAL_UNDETERMINED if it is determined by rounding only. */
invcal_status invcali_determine(invcal_real *a, unsigned rows, invcal_quality *q);

/* invcal_calibrate_plain of what is left. */
invcal_status invcali_positions_calibrate(const invcali_selection *selection,
                                          invcal_calibration *out, invcal_quality *quality);

/* ---- the steps of a judgement ---------------------------------------------------------------- */

#define INVCAL_WEAK_K INVCAL_REAL(100.0)   /* square of 10. Above: usable only within its sigma */
#define INVCAL_ABSURD INVCAL_REAL(0.1)     /* rms of the residuals. Above: refused */
#define INVCAL_HOPELESS_K INVCAL_REAL(1e6) /* square of 1000, all nine K together. Above: refused */

enum { INVCAL_UNCHECKED = 0x1E }; /* a bit for each systematic error */

/* Nothing was found, since nothing was tested; no residuals. */
static inline void invcali_judge_begin(invcal_quality *q)
{
    invcali_zero(q, sizeof *q); /* INVCAL_GOOD, INVCAL_NO_SYSTEMATIC */
    q->unchecked = INVCAL_UNCHECKED;
}

/* Position i, calibrated: rms (until the end the sum of the squares), max and worst of |eta| - 1.
 * From j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2, since a root less 1 would cancel. */
static INVCAL_ONCE void invcali_residuals_add(invcal_quality *q, unsigned i, const invcali_row *row)
{
    const invcal_real twice = 2 * row->h[INVCAL_J];
    const invcal_real r = twice / (1 + INVCAL_SQRT(1 + twice));

    q->rms += r * r;
    if (!(INVCAL_FABS(r) <= q->max)) {
        q->max = INVCAL_FABS(r);
        q->worst = (uint16_t)i;
    }
    q->positions++;
}

/* Returns INVCAL_OK; INVCAL_NOT_ELLIPSOID if they are not readings of one field. */
static INVCAL_ONCE invcal_status invcali_residuals_end(invcal_quality *q)
{
    q->rms = INVCAL_SQRT(q->rms / invcali_number(q->positions));
    return q->rms <= INVCAL_ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* g = A eta: noise of u, the same on all axes, moves the length of eta = A (u - delta), A
 * symmetric, by |g| times that noise. Returns |g|^2. */
static INVCAL_ONCE invcal_real invcali_gradient(const invcal_real a[3][3], const invcal_real eta[3],
                                                invcal_real g[3])
{
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        g[i] = invcali_dot3(a[i], eta);
    }
    return invcali_dot3(g, g);
}

/* Only a worse one counts. */
static inline void invcali_raise(invcal_quality *q, unsigned verdict)
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
void invcali_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof,
                         invcal_real silent, invcal_quality *q);

/* Weighs a stated noise against the residuals (mathematics.md, "Uncertainty"), for equations of
 * your own. The stated noise counts as four residuals, unless the residuals are clearly larger (at
 * 95 %) or nearly zero; then they alone count. Residuals too large for noise (at 99.7 %) raise the
 * verdict to rough.
 *
 * stated   standard deviation of a position mean on each axis, over field; 0: not known. With a NaN
 *          the verdict is rough.
 * squares  the sum of the squared residuals, each over its standard deviation at a noise of 1.
 * quality  reads dof and verdict; sets noise, sigma_dof and verdict. noise is 1, the whole field,
 *          if there is neither a residual nor a stated noise.
 *
 * Stack: about 10 bytes. */
void invcali_weigh_noise(invcal_real stated, invcal_real squares, invcal_quality *quality);

/* dof rounded down, and limited so that a stated noise can still be added. */
static inline uint16_t invcali_whole(invcal_real dof)
{
    const invcal_real most = UINT16_MAX - INVCAL_STATED;

    if (!(dof >= 1)) {
        return 0;
    }
    //@ assert \is_finite(dof); // no NaN is at least 1
    return (uint16_t)(dof < most ? dof : most); /* uncovered: that many positions with a prior */
}

/* tr A tr A^-1 from L^-1: at least the condition. Is it determined by more than rounding? */
invcal_real invcali_condition(const invcal_real *inverse, unsigned n, invcal_real trace);
static inline int invcali_is_resolved(invcal_real condition)
{
    return condition < 2 / INVCAL_FLOOR;
}

/* weak, sigma and the verdict, from K(r,r) = sigma^2 / noise^2 in q->sigma[r]. Weak: K is large, or the
 * information 1 / K is at most ten times the part added by noise in the readings themselves, about
 * noise^2 in each row: then open directions look determined (mathematics.md, "Verdict, and near
 * cones"). */
void invcali_judge_parameters(const invcal_real a[3][3], invcal_quality *q);

#endif
