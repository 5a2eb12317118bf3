/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of invcal_solve, for those who do something between them.
 */
#ifndef INVCAL_SOLVE_H
#define INVCAL_SOLVE_H

#include "invcal/expert.h"

/* The rows of c are the cross products of the other two rows of m: c / det m = m^-T. Returns det m. */
invcal_real invcal_cofactors(const invcal_real m[3][3], invcal_real c[3][3]);

/* m^-1; an m that is singular gives what is not finite. */
void invcal_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3]);

/* How many numbers the next two work with; their stack would lie under that of what they call. */
enum { INVCAL_WORK = 18 };

/* a = S R becomes S, the symmetric matrix of the same a a'; the orthonormal R is what work begins with. */
void invcal_make_symmetric(invcal_real a[3][3], invcal_real work[INVCAL_WORK]);

/* INVCAL_BAD_NOMINAL if the calibration is singular, not finite, or absurdly scaled. */
invcal_status invcal_nominal_check(const invcal_calibration *nominal);

/* The coefficients p of an ellipsoid to the calibration of what lies on it, its matrix
 * symmetric. INVCAL_NOT_ELLIPSOID if it is none, or no triad's: with a semi-axis below about 1/10 of
 * nominal or of another one, or a centre beyond ten times the field. out is lost then. */
invcal_status invcal_ellipsoid(const invcal_real p[INVCAL_PARAMETERS],
                               invcal_real work[INVCAL_WORK], invcal_calibration *out);

/* The calibration of u from X = (delta, dk, gamma): A = (I + S)^-1. INVCAL_NOT_ELLIPSOID unless I + S is
 * positive definite, the diagonals of both below 10, and delta too: of the leading minors of I + S the
 * last is the second over the last element of A. triad is lost then. */
invcal_status invcal_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad);

/* The calibration of a triad, that is of readings that nominal has corrected, becomes one of raw
 * counts. INVCAL_BAD_NOMINAL if it could be none itself: c is lost then. */
invcal_status invcal_behind(const invcal_calibration *nominal, invcal_calibration *c);

#endif
