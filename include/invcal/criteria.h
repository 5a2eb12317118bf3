/* SPDX-License-Identifier: MIT
 *
 * invcal/criteria.h: what a set of positions is worth, before anything has been measured.
 *
 * The directions are summed up like positions (normal.h), one row h(eta) each. Whatever they
 * are - a program of plan.h, a list of one's own, or the positions taken so far - the covariance
 * of the nine parameters is K = (H'H)^-1 times the squared noise of a position mean.
 */
#ifndef INVCAL_CRITERIA_H
#define INVCAL_CRITERIA_H

#include "invcal/eigen.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a design is worth. */
typedef struct {
    unsigned positions;      /* the labour: positions to visit */
    invcal_real sigma_delta; /* the largest sqrt(K(r,r)) among the three offsets: standard deviation
                                over that of a position mean */
    invcal_real sigma_dk;    /* likewise among the three scale errors */
    invcal_real sigma_gamma; /* likewise among the three non-orthogonality terms */
    invcal_real condition;   /* of H'H: largest over smallest eigenvalue */
    invcal_real log_det;     /* natural logarithm of det H'H; a D-optimal set has the largest */
} invcal_criteria;

/* Adds a direction to a design: its row h(eta), with j = 0.
 *
 * design    sums begun with invcal_normal_init.
 * vertical  the up direction in the instrument frame, unit length within 1e-4.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE or INVCAL_NOT_UNIT for what is no
 * unit vector; INVCAL_MIXED if the sums hold exact rows. Cost: as invcal_normal_add. */
invcal_status invcal_criteria_add(invcal_normal *design, const invcal_real vertical[3]);

/* Judges a design (mathematics.md, "Programs").
 *
 * design  sums of rows of either kind. Not changed.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if H'H is singular to rounding, or its condition
 * exceeds 1 / INVCAL_PIVOT_FLOOR: invcal_undetermined names the parameters that stay open.
 * Relative error for the programs of plan.h: 1e-12 (double), 1e-6 (float; the condition 2e-6);
 * otherwise about INVCAL_EPSILON times the condition.
 * Cost: about 1500 multiply-adds and two extreme eigenvalues. Stack: about 480 bytes. */
invcal_status invcal_criteria_judge(const invcal_normal *design, invcal_criteria *out);

#ifdef __cplusplus
}
#endif

#endif
