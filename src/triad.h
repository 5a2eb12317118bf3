/* SPDX-License-Identifier: MIT
 *
 * Internal: the closed form that turns p into a calibration, of the solution room, for those who
 * solve other equations for the same p.
 */
#ifndef INVCAL_TRIAD_H
#define INVCAL_TRIAD_H

#include "invcal/solution.h"

#define INVCAL_SHORTEST INVCAL_REAL(0.1) /* semi-axes of a sensor triad, of nominal */
#define INVCAL_LONGEST INVCAL_REAL(10.0)
#define INVCAL_RIDGE INVCAL_REAL(1e-4) /* of the largest diagonal element: between weak and good */

/* The sensor model u = (I + S) eta + delta, and its correction A = (I + S)^-1. Readings lie on the
 * ellipsoid with the centre delta, whose semi-axes are the eigenvalues of I + S. */
typedef struct {
    invcal_real s[6]; /* S, packed */
    invcal_real a[6]; /* A - I */
    invcal_real delta[3];
} invcal_triad;

/* The general form of an ellipsoid, p, to its centre and axes. Returns 0 if it is none, or an
 * absurd one. */
int invcal_triad_of_ellipsoid(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *t);

/* Likewise of the linear model: X = -p is the triad itself. */
int invcal_triad_of_linear(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *t);

/* Turns the triad into the frame of the settings and joins it with their nominal calibration.
 *
 * inverse  of the nominal matrix.
 *
 * Returns INVCAL_OK; INVCAL_NOT_ELLIPSOID if the centre is absurd. t->a is lost. */
invcal_status invcal_triad_join(invcal_triad *t, const invcal_settings *settings,
                                invcal_real inverse[3][3], invcal_solution *solution);

#endif
