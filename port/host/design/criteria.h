/* SPDX-License-Identifier: MIT
 *
 * design/criteria.h: the accuracy that a set of positions gives, known before anything is measured.
 *
 * The directions are summed up like positions (invcal/expert.h), one row h(eta) each. For any set -
 * a program of plan.h, your own list, or the positions taken so far - the covariance of the nine
 * parameters is K = (H'H)^-1 times the squared noise of a position mean.
 */
#ifndef CRITERIA_H
#define CRITERIA_H

#include "invcal/expert.h"
#include "core/system.h"

/* Optimality criteria of a design. */
typedef struct {
    unsigned positions; /* the labour: positions to visit */
    double sigma_delta; /* the largest sqrt(K(r,r)) of the three offsets: standard deviation over
                           that of a position mean */
    double sigma_dk;    /* the same for the three scale errors */
    double sigma_gamma; /* the same for the three non-orthogonality terms */
    double condition;   /* of H'H: largest over smallest eigenvalue */
    double log_det;     /* natural logarithm of det H'H; a D-optimal set has the largest */
} criteria;

/* Adds a direction to a design: its row h(eta), without a measurement.
 *
 * design    sums begun with invcal_sums_init.
 * vertical  the up direction in the instrument frame, a unit vector. */
void criteria_add(invcal_sums *design, const double vertical[3]);

/* The same with a weight, 0 or more: the position's dwell, relative to that of the others. */
void criteria_add_weighted(invcal_sums *design, const double vertical[3], double weight);

/* H'H of a design, packed. */
void criteria_information(const invcal_sums *design,
                          double hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

/* Computes the criteria of a design (mathematics_programs.md).
 *
 * Returns 1; 0 if H'H is singular to rounding, or its condition exceeds 1 / INVCAL_FLOOR:
 * invcal_undetermined names the undetermined parameters. Relative error for the programs of
 * plan.h: 1e-12; otherwise about DBL_EPSILON times the condition. */
int criteria_evaluate(const invcal_sums *design, criteria *out);

#endif
