/* SPDX-License-Identifier: MIT
 *
 * Internal: the separate steps of invcali_solve.
 */
#ifndef INVCAL_SOLVE_H
#define INVCAL_SOLVE_H

#include "invcal/result.h"
#include "system.h"

/* The rows of c are the cross products of the other two rows of m: c / det m = m^-T. Returns det
 * m. */
invcal_real invcali_cofactors(const invcal_real m[3][3], invcal_real c[3][3]);

/* m^-1; not finite if m is singular. */
void invcali_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3]);

/* Size of the work space of invcali_make_symmetric and invcali_ellipsoid; as a variable of their own
 * it would add to the stack of their callees. */
enum { INVCAL_WORK = 18 };

/* a = S R becomes S, the symmetric matrix of the same a a'; work then begins with the orthonormal
 * R. */
void invcali_make_symmetric(invcal_real a[3][3], invcal_real work[INVCAL_WORK]);

/* INVCAL_BAD_NOMINAL if the calibration is singular, not finite, or absurdly scaled. */
invcal_status invcali_nominal_check(const invcal_calibration *nominal);

/* The coefficients p of an ellipsoid to the calibration of the points on it, with a symmetric
 * matrix. INVCAL_NOT_ELLIPSOID if they are of no ellipsoid, or of one that no triad has: a
 * semi-axis below about 1/10 of nominal or of another one, or a centre beyond ten times the field.
 * out is overwritten then. */
invcal_status invcali_ellipsoid(const invcal_real p[INVCAL_PARAMETERS],
                                invcal_real work[INVCAL_WORK], invcal_calibration *out);

/* The calibration of u from X = (delta, dk, gamma): A = (I + S)^-1. INVCAL_NOT_ELLIPSOID unless I +
 * S is positive definite, the diagonals of both below 10, and delta too: of the leading minors of I
 * + S the last is the second over the last element of A. triad is overwritten then. */
invcal_status invcali_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad);

/* Makes c, which calibrates a triad, that is readings corrected by nominal, a calibration of raw
 * counts. INVCAL_BAD_NOMINAL if that is not a valid nominal itself: c is overwritten then. */
invcal_status invcali_compose(const invcal_calibration *nominal, invcal_calibration *c);

/* Lengths do not determine how the calibrated frame is turned against the case. The symmetric
 * correction is closest to the axes of nominal; this turns it into the upper triangular one, as in
 * imu_tk: only the x sensor responds to a field along the calibrated x axis. Offsets, lengths and
 * sigma stay the same.
 *
 * calibration  as for invcal_deviation. Stays unchanged if it is not a calibration.
 * nominal      the one it was solved with. If its matrix is diagonal, the new one is exactly 0
 *              below the diagonal.
 *
 * Stack: about 200 bytes. */
void invcali_make_triangular(invcal_calibration *calibration, const invcal_calibration *nominal);

/* ---- rounding errors ----------------------------------------------------------------------------
 *
 * Against the exact solution of the same readings, for 9 to 64 positions, errors up to 20 % and a
 * quality.condition up to 10^6:
 *
 *     |parameter - exact|    <= INVCAL_LOSS        INVCAL_EPSILON condition
 *     |sigma / exact - 1|    <= INVCAL_LOSS_SIGMA  INVCAL_EPSILON condition
 *     |length - exact|       <= INVCAL_LOSS_LENGTH INVCAL_EPSILON sqrt(condition)
 *
 * the last for the positions that were solved, over field, and so for the residuals. Sums and
 * Cholesky solve exactly some equations H'H p = -H'J whose elements are wrong by a few epsilon of
 * the largest one. (H'H)^-1 turns that into epsilon condition in p, and H (H'H)^-1 into epsilon
 * sqrt(condition) in the lengths (Higham, Accuracy and Stability of Numerical Algorithms, 10.1 and
 * 20.4). The theory's factors grow with the number of positions; these are measured (make numerics:
 * 30,000 random sets, 50 digits).
 *
 * sigma does not include it: in float the rounding error exceeds sigma if a position mean is better
 * than about INVCAL_EPSILON sqrt(condition) of the field. Solve such positions a second time, with
 * the first calibration as nominal: p and J are then nearly zero, and so is their rounding error,
 *
 *     |parameter - exact|    <= INVCAL_LOSS_AGAIN  INVCAL_EPSILON sqrt(condition) */
#define INVCAL_LOSS INVCAL_REAL(1.0)        /* as above */
#define INVCAL_LOSS_SIGMA INVCAL_REAL(8.0)  /* as above */
#define INVCAL_LOSS_LENGTH INVCAL_REAL(4.0) /* as above */
#define INVCAL_LOSS_AGAIN INVCAL_REAL(6.0)  /* as above */

#endif
