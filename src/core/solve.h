/* SPDX-License-Identifier: MIT
 *
 * Internal: the separate steps of invcal_solve.
 */
#ifndef INVCAL_SOLVE_H
#define INVCAL_SOLVE_H

#include "invcal/expert.h"

/* The rows of c are the cross products of the other two rows of m: c / det m = m^-T. Returns det
 * m. */
invcal_real invcal_cofactors(const invcal_real m[3][3], invcal_real c[3][3]);

/* m^-1; not finite if m is singular. */
void invcal_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3]);

/* Size of the work space of invcal_make_symmetric and invcal_ellipsoid; as a variable of their own
 * it would add to the stack of their callees. */
enum { INVCAL_WORK = 18 };

/* a = S R becomes S, the symmetric matrix of the same a a'; work then begins with the orthonormal
 * R. */
void invcal_make_symmetric(invcal_real a[3][3], invcal_real work[INVCAL_WORK]);

/* INVCAL_BAD_NOMINAL if the calibration is singular, not finite, or absurdly scaled. */
invcal_status invcal_nominal_check(const invcal_calibration *nominal);

/* The coefficients p of an ellipsoid to the calibration of the points on it, with a symmetric
 * matrix. INVCAL_NOT_ELLIPSOID if they are of no ellipsoid, or of one that no triad has: a
 * semi-axis below about 1/10 of nominal or of another one, or a centre beyond ten times the field.
 * out is overwritten then. */
invcal_status invcal_ellipsoid(const invcal_real p[INVCAL_PARAMETERS],
                               invcal_real work[INVCAL_WORK], invcal_calibration *out);

/* The calibration of u from X = (delta, dk, gamma): A = (I + S)^-1. INVCAL_NOT_ELLIPSOID unless I +
 * S is positive definite, the diagonals of both below 10, and delta too: of the leading minors of I
 * + S the last is the second over the last element of A. triad is overwritten then. */
invcal_status invcal_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad);

/* Makes c, which calibrates a triad, that is readings corrected by nominal, a calibration of raw
 * counts. INVCAL_BAD_NOMINAL if that is not a valid nominal itself: c is overwritten then. */
invcal_status invcal_compose(const invcal_calibration *nominal, invcal_calibration *c);

#endif
