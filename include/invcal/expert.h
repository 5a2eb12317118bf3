/* SPDX-License-Identifier: MIT
 *
 * invcal/expert.h: the steps one by one, and rarely needed options.
 *
 *     raw samples -> rests -> row -> sums -> solve -> judge
 *
 * Only what you call is linked. invcal.h states the rules and units. A program and a library with
 * different build options do not link.
 */
#ifndef INVCAL_EXPERT_H
#define INVCAL_EXPERT_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- one position, one equation -----------------------------------------------------------------
 *
 * Every equation reads J + h p = 0 with the row of the paper
 *
 *     h(a) = (x y z x^2 y^2 z^2 xy xz yz).
 *
 * With u the reading over field, not normalised, J = (|u|^2 - 1)/2 + h(u) p = 0 is the equation of
 * an ellipsoid: exact for errors of any size, and linear in p. */
#define INVCAL_J INVCAL_PARAMETERS /* index of J: after the row */

/* One equation. */
typedef struct {
    invcal_real h[INVCAL_PARAMETERS + 1]; /* the row, its first three elements u; then J */
} invcal_row;

/* The exact row of a reading.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a length outside 0.1 ... 10. On
 * failure row is overwritten. */
invcal_status invcal_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                             invcal_row *row);

/* ---- the normal equations, position by position -------------------------------------------------
 *
 * The sums H'H, H'J, J'J of all rows: their size does not depend on the number of positions, and
 * their order matters only to rounding. */

/* Index of (r, c), c <= r, in a symmetric matrix, stored as its lower triangle by rows. */
#define INVCAL_PACKED(r, c) ((r) * ((r) + 1u) / 2u + (c))
/* Number of elements. */
#define INVCAL_PACKED_SIZE(n) ((n) * ((n) + 1u) / 2u)

/* The sums of all positions: 224 bytes. */
typedef struct {
    /* The triangle of H'H, then H'J and J'J: the system of equations below. */
    invcal_real sum[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)];
    unsigned count; /* rows in the sums; at most UINT_MAX */
} invcal_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_sums_init(invcal_sums *sums);

/* Adds a position.
 *
 * nominal  the same for all positions.
 *
 * Returns as invcal_observe. Cost: 440 instructions, no division. */
invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real raw[3]);

/* Adds an existing row.
 *
 * weight  1 for a position like the others; (sigma_usual / sigma_this)^2 for another precision;
 *         finite. Checks nothing. */
void invcal_sums_add_row(invcal_sums *sums, const invcal_row *row, invcal_real weight);

/* Solves the sums (mathematics.md, "From p to the calibration"):
 *
 *     p = -(H'H)^-1 H'J                                               one 9x9 Cholesky
 *     v = (p0 p1 p2),  Q = I + [2 p3 p6 p7; p6 2 p4 p8; p7 p8 2 p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta,  A'A = Q / k,  A symmetric
 *     calibrated = A (u - delta)
 *
 * No iteration that could fail to converge.
 *
 * sums     are overwritten: copy them if more positions will follow.
 * nominal  the one they were added with; may equal out.
 *
 * Does not judge: INVCAL_OK means solvable, invcal_calibrate says how good. A system determined by
 * little more than rounding may pass as solvable.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than nine positions;
 *   INVCAL_UNDETERMINED   the positions leave parameters open;
 *   INVCAL_NOT_ELLIPSOID  the readings lie on no ellipsoid, or on one that no triad has: see
 *                         invcal_calibrate;
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal.
 * Cost: 4,200 instructions. Stack: about 180 bytes. */
invcal_status invcal_solve(invcal_sums *sums, const invcal_calibration *nominal,
                           invcal_calibration *out);

/* ---- the system of equations --------------------------------------------------------------------
 *
 * A symmetric system of n unknowns, A p = -b, in one packed triangle. Row n, if present, is b'
 * and the constant: factoring it with A does the forward substitution. */

/* A pivot below this, over the largest element of the diagonal, may be a rounding error. */
#define INVCAL_FLOOR (INVCAL_DOUBLE ? INVCAL_REAL(1e-8) : 16 * INVCAL_EPSILON)

/* The sum of the diagonal. */
invcal_real invcal_trace(const invcal_real *a, unsigned n);

/* The largest element of the diagonal, at least 0. Skips NaN; 0 if the first element is one. */
invcal_real invcal_largest_diagonal(const invcal_real *a, unsigned n);

/* A = L L' in place. The diagonal becomes 1 / L(r,r), so that no later step divides. Rows from n to
 * rows - 1 are only divided by L': b' becomes y' of L y = b, and the constant its remainder.
 *
 * floor  a pivot counts as zero unless it exceeds floor times the largest element of the diagonal:
 *        INVCAL_FLOOR. Relative to the largest, since a test against the pivot's own element
 *        accepts matrices that are singular to rounding.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if a pivot is too small, negative or NaN: a is
 * overwritten.
 * Cost: n^3/6 multiply-adds, n square roots. */
invcal_status invcal_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor);

/* Replaces y in row n by p = -L'^-1 y. */
void invcal_back_substitute(invcal_real *l, unsigned n);

/* Replaces L by L^-1: A^-1(r,r) is then the squared length of column r, x'A^-1 x that of L^-1 x. */
void invcal_invert(invcal_real *l, unsigned n);

/* A^-1(r,r) from L^-1. */
invcal_real invcal_variance(const invcal_real *inverse, unsigned n, unsigned r);

/* The leverage h K h' of a row, from L^-1 of the nine parameters: what it adds to the rows in the
 * sums. h becomes y = L^-1 h; the result is its squared length. */
invcal_real invcal_leverage(const invcal_real *inverse, invcal_real h[INVCAL_PARAMETERS]);

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

/* ---- causes of a refusal --------------------------------------------------------------------- */

/* Which parameters the positions leave open, after INVCAL_TOO_FEW or INVCAL_UNDETERMINED. Adds a
 * small ridge to H'H: if it contributes more than a tenth of a parameter's information, the data do
 * not determine that parameter. This is a hint, never a verdict: noise can make an open parameter
 * look determined.
 *
 * raw      3 * count numbers, as for invcal_calibrate. Skips those that are not readings.
 * count    any; no positions leave all nine open.
 * nominal  the one of the refusal.
 *
 * Returns bit r for parameter r; 0: none. Cost: 12,000 instructions for 18 positions. Stack: about
 * 400 bytes. */
uint16_t invcal_undetermined(const invcal_real *raw, unsigned count,
                             const invcal_calibration *nominal);

/* Which position is not a reading of this field, after INVCAL_NOT_FINITE or INVCAL_OUT_OF_RANGE.
 *
 * raw, count, nominal  those of the refusal.
 *
 * Returns the first one, from 0; count if all are readings. Stack: about 70 bytes. */
unsigned invcal_bad_reading(const invcal_real *raw, unsigned count,
                            const invcal_calibration *nominal);

/* ---- other forms of the result --------------------------------------------------------------- */

/* X = (delta, dk, gamma): the errors of the sensor against nominal. The sensor reads
 * u = (I + S) eta + delta, and A = (I + S)^-1 corrects it.
 *
 * calibration  in the symmetric frame, as it was solved: neither turned (invcal_make_triangular)
 *              nor in another unit (invcal_scale).
 * nominal      the one it was solved with.
 * x            delta over field, dk (1), gamma (rad): accurate to a few INVCAL_EPSILON.
 *
 * Checks nothing: a bad calibration gives NaN. Stack: about 190 bytes. */
void invcal_deviation(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      invcal_real x[INVCAL_PARAMETERS]);

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
void invcal_make_triangular(invcal_calibration *calibration, const invcal_calibration *nominal);

/* The standard deviation of the offset in raw counts: quality.sigma of delta through the inverse of
 * nominal. If the matrix of nominal is not diagonal, the three deltas count as independent:
 * accurate to a few percent, since well spread positions make them so.
 *
 * sigma  of the three raw axes, counts.
 *
 * Stack: about 80 bytes. */
void invcal_sigma_offset(const invcal_quality *quality, const invcal_calibration *nominal,
                         invcal_real sigma[3]);

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
void invcal_weigh_noise(invcal_real stated, invcal_real squares, invcal_quality *quality);

/* Is `found` the better of two calibrations? For a device that recalibrates now and then.
 *
 * Returns 1 if its verdict is no worse, and the sum of the squares of its nine 95 % intervals,
 * invcal_coverage of sigma_dof times sigma, is smaller, so that a sigma that happens to be small
 * does not decide. 0 otherwise, also if they are equal. Stack: about 40 bytes. */
int invcal_improves(const invcal_quality *found, const invcal_quality *present);

/* ---- without some of the positions ----------------------------------------------------------- */

/* invcal_calibrate without the search for systematic errors, all of which stay unchecked,
 * and without counting directions: the verdict is good if no remaining position contradicts the
 * others. Takes half the flash, for a device like an ATmega328P.
 *
 * out  may equal nominal.
 *
 * Everything else as for invcal_calibrate. Cost: 110,000 instructions for 18 good
 * positions. */
invcal_status invcal_calibrate_robust(const invcal_real *raw, unsigned count,
                                      const invcal_calibration *nominal, invcal_real noise,
                                      invcal_calibration *out, invcal_quality *quality);

/* invcal_calibrate_plain without some of the positions.
 *
 * left_out  bit i: position i does not count, whatever it reads. For the first
 *           INVCAL_MAX_POSITIONS; all later ones count. quality.left_out repeats it; quality.worst
 *           is an index into raw, which includes those left out.
 *
 * Everything else as for invcal_calibrate_plain. */
invcal_status invcal_calibrate_without(const invcal_real *raw, unsigned count, invcal_mask left_out,
                                       const invcal_calibration *nominal, invcal_real noise,
                                       invcal_calibration *out, invcal_quality *quality);

/* ---- what is known beforehand -------------------------------------------------------------------
 *
 * Parameter r is 0 with standard deviation sigma(r): one more row, noise / sigma(r) p(r) = 0, which
 * makes the solution a Bayesian update (mathematics.md, "Prior"). A parameter that the positions
 * leave open keeps its nominal value, with the sigma of the prior. Use it for a device that can
 * only be tilted, or to renew the offsets of an earlier calibration with three positions. */

/* invcal_calibrate_plain with a prior.
 *
 * raw, count, nominal  as for invcal_calibrate. At least one position, and as many as there are
 *                      parameters without a prior.
 * noise       standard deviation of a position mean on each axis, over field, above 0 and below 1:
 *             the weight of the prior. If the residuals show more noise, solves again with theirs.
 *             If the positions alone leave parameters open, raises it to what the number type
 *             resolves next to the prior, in float sqrt(count) / 2000 of the widest prior: with
 *             less, rounding errors would count as data.
 * prior       standard deviation of each parameter's deviation from nominal, over field, 1 or rad,
 *             up to about 0.2 (above that, p is no longer -X); 0: not known. Not all may be 0.
 * quality     sigma never exceeds the prior. dof counts data only, rounded down: a parameter
 *             supplied by the prior costs no position. noise may have been raised. condition
 *             includes the rows of the prior; it may be infinite if the widths of priors differ
 *             very much.
 * from_prior  bit r: parameter r is determined by the prior more than by the data.
 *
 * Returns as invcal_calibrate; INVCAL_BAD_PRIOR if a number is negative or not finite, or all are
 * 0. INVCAL_UNDETERMINED refers to parameters without a prior.
 * Cost: 80,000 instructions for 18 positions. Stack: about 950 bytes. */
invcal_status invcal_calibrate_prior(const invcal_real *raw, unsigned count,
                                     const invcal_calibration *nominal, invcal_real noise,
                                     const invcal_real prior[INVCAL_PARAMETERS],
                                     invcal_calibration *out, invcal_quality *quality,
                                     uint16_t *from_prior);

/* ---- six faces ----------------------------------------------------------------------------------
 *
 * The usual procedure, each axis once up and once down, determines offsets and scales, but none of
 * the three angles: on a face the product of two readings is nearly 0. The angles are taken from
 * the data sheet: 0, with a standard deviation of g. The error left in a calibrated length is
 * gamma_xy xy + gamma_xz xz + gamma_zy zy:
 *
 *     with a face up          0              on an edge, midway between two axes   g / 2
 *     on a corner, the most   g / sqrt(3)    over all directions, rms              g / sqrt(5)
 *
 * so 1 % costs 4.5 mg rms, or 8.8 mg at 95 %. Six more positions midway between two axes determine
 * the angles: pass all twelve to invcal_calibrate. */
#define INVCAL_CROSS_AXIS INVCAL_REAL(0.01) /* g for a data sheet's 1 % (0.57 degrees) */

/* invcal_calibrate_plain for six positions or more, the angles held at those of nominal.
 *
 * raw      3 * count numbers, as for invcal_calibrate; from a session, its mean and count.
 * noise    standard deviation of a position mean on each axis, over field, above 0 and below 1.
 *          With six positions nothing checks it: sigma of offsets and scales is noise / sqrt(2).
 * gamma    standard deviation of each angle, rad, up to about 0.2: INVCAL_CROSS_AXIS.
 * quality  of offsets and scales: verdict and weak do not cover the angles. INVCAL_NO_REDUNDANCY
 *          with six positions. sigma of the angles is gamma, or less if positions off the faces
 *          reduce it.
 * held     bit r: parameter r is not measured: each angle that the positions leave open. Its 95 %
 *          interval is 1.96 sigma, without Student's t: gamma is stated, not estimated.
 *
 * An actual angle of gamma shifts a scale by gamma^2 / 8 (12 ppm at 1 %), and no offset, if the
 * faces are along gravity; sigma includes a tilt.
 *
 * Returns as invcal_calibrate; INVCAL_TOO_FEW for fewer than six; INVCAL_UNDETERMINED if they leave
 * offsets or scales open; INVCAL_BAD_PRIOR unless gamma is above 0 and below 1.
 * Cost: 51,000 instructions for six positions. Stack: about 990 bytes. */
invcal_status invcal_calibrate_faces(const invcal_real *raw, unsigned count,
                                     const invcal_calibration *nominal, invcal_real noise,
                                     invcal_real gamma, invcal_calibration *out,
                                     invcal_quality *quality, uint16_t *held);

/* invcal_accuracy of a calibration with some parameters from a prior.
 *
 * held  bit r: sigma of parameter r is stated, not estimated; from invcal_calibrate_faces, or
 *       from_prior of invcal_calibrate_prior.
 *
 * Stack: about 140 bytes. */
invcal_real invcal_accuracy_held(const invcal_quality *quality, uint16_t held, invcal_real gravity);

/* ---- known directions: a stand ------------------------------------------------------------------
 *
 * With the direction eta known, the paper's compositions are linear in X = (delta, dk, gamma), here
 * as J + h(eta) p = 0 with p = -X:
 *
 *     J1 = u eta - 1            the vertical composition: exactly linear
 *     J2 = (|u|^2 - 1)/2        the scalar composition: leaves an error of second order in X,
 *                               1e-4 at errors of 1 %, 1e-2 at errors of 10 %
 *
 * An error d of the direction does not affect lengths at all, which is why invcal_calibrate needs
 * no directions. In J1 its effect is -|d|^2/2 + eta S d, S the matrix of dk and gamma / 2. The
 * second part is at most s |d|, s half the spread of the eigenvalues of S:
 *
 *     d          lengths   J1, s = 0.02     full vector
 *     1 mrad     0         5e-7 + 2e-5      1e-3
 *     10 mrad    0         5e-5 + 2e-4      1e-2
 *
 * In exact rows p has another meaning, so these sums have a type of their own. */
typedef struct {
    invcal_sums sums; /* of h(eta) and J */
} invcal_linear_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_linear_init(invcal_linear_sums *linear);

/* Adds a position of known direction by J1.
 *
 * nominal  the same for all positions.
 * raw      a position mean, raw counts.
 * eta      the up direction in the frame of the unit, unit length within 1e-4.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE as invcal_observe;
 * INVCAL_BAD_DIRECTION. Stack: about 120 bytes. */
invcal_status invcal_linear_add_vertical(invcal_linear_sums *linear,
                                         const invcal_calibration *nominal,
                                         const invcal_real raw[3], const invcal_real eta[3]);

/* The same by J2. Do not mix the two in the same sums. */
invcal_status invcal_linear_add_scalar(invcal_linear_sums *linear,
                                       const invcal_calibration *nominal, const invcal_real raw[3],
                                       const invcal_real eta[3]);

/* Solves the sums: A = (I + S)^-1.
 *
 * linear   the sums; are overwritten.
 * nominal  the one they were added with; may equal out.
 * out      the calibration.
 * x        the nine parameters, in the order of the paper.
 *
 * Does not judge.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than nine positions;
 *   INVCAL_UNDETERMINED   the directions leave parameters open;
 *   INVCAL_NOT_ELLIPSOID  a semi-axis of I + S is outside about 0.1 ... 10, or delta beyond 10;
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal.
 * Stack: about 200 bytes. */
invcal_status invcal_linear_solve(invcal_linear_sums *linear, const invcal_calibration *nominal,
                                  invcal_calibration *out, invcal_real x[INVCAL_PARAMETERS]);

/* The full vector. Lengths do not show how the unit is turned on the stand, and J1 shows it to
 * second order only. All three readings of a position show it to first order:
 *
 *     u = M eta + delta,    M = (I + S) R
 *
 * with R the mounting: a direction eta of the stand's frame is R eta in the frame of the unit. That
 * is linear in the twelve elements of M and delta, and the three axes share one 4x4 system; I + S
 * and R are the polar decomposition of M. An angle error d counts to first order here (see the
 * table above): so take the parameters from the lengths, and only the mounting from here. */
typedef struct {
    /* The triangle of (eta 1 u)'(eta 1 u) over all positions. */
    invcal_real sum[INVCAL_PACKED_SIZE(7)];
    unsigned count; /* positions in the sums; at most UINT_MAX */
} invcal_full_vector;

/* Empties the sums. All bytes zero is the same state. */
void invcal_full_vector_init(invcal_full_vector *full);

/* Adds a position of known direction.
 *
 * nominal  the same for all positions.
 * raw      a position mean, raw counts.
 * eta      the up direction in the frame of the stand, unit length within 1e-4.
 *
 * Returns as invcal_linear_add_vertical. Cost: 340 instructions. Stack: about 110 bytes. */
invcal_status invcal_full_vector_add(invcal_full_vector *full, const invcal_calibration *nominal,
                                     const invcal_real raw[3], const invcal_real eta[3]);

/* Solves the sums, for errors of any size.
 *
 * full      the sums; are overwritten.
 * nominal   the one they were added with; may equal out.
 * out       the calibration, in the frame of the stand: calibrated readings are eta in that frame.
 * x         the nine parameters, in the frame of the unit and the order of the paper.
 * mounting  R. With the paper's N positions on each of three great circles, and noise s on every
 *           axis, the standard deviation of its three angles is s / sqrt(2 N).
 *
 * Does not judge.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than four positions;
 *   INVCAL_UNDETERMINED   the ends of the directions lie in a plane, as those of a circle do;
 *   INVCAL_NOT_ELLIPSOID  a semi-axis of I + S is outside about 0.1 ... 10, or delta beyond 10; or
 *                         the directions are mirrored: an angle has the wrong sign;
 *   INVCAL_BAD_NOMINAL    the result is beyond the limits of invcal_nominal.
 * Cost: 3,300 instructions. Stack: about 290 bytes. */
invcal_status invcal_full_vector_solve(invcal_full_vector *full, const invcal_calibration *nominal,
                                       invcal_calibration *out, invcal_real x[INVCAL_PARAMETERS],
                                       invcal_real mounting[3][3]);

/* ---- where to turn next -------------------------------------------------------------------------
 *
 * Of 26 directions - the 6 faces, 12 edges and 8 corners of a cube - the next is the one with the
 * largest h K h', K = (H'H)^-1 of the positions so far: it multiplies det H'H by 1 + h K h', more
 * than any other (greedy D-optimal design). With a small ridge on H'H, K exists from the first
 * position on. Nine such positions determine everything, sqrt(K(r,r)) at most 3.01; eighteen come
 * within 0.3 of the largest possible log det H'H. Hand errors of 10 degrees cost little. From 14
 * positions on, their order lets a drift be detected: fitting it as well would increase sigma 1.16
 * times. */

/* The direction to take next.
 *
 * raw, count  the positions so far; none at the beginning. Skips those that are not readings.
 *
 * Of directions with about the same information it takes the closest to the last position: the
 * opposite one counts 1.6 % less. It takes none within 26 degrees of the last position. */
void invcal_next(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                 invcal_real up[3]);

/* sqrt(K(r,r)) of the positions so far: sigma of parameter r over that of a position mean.
 *
 * up  null, or a direction to include as if taken, to see what it will improve. The ridge limits
 *     that of open parameters to about 100. */
void invcal_prospect(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                     const invcal_real *up, invcal_real root[INVCAL_PARAMETERS]);

/* ---- rests --------------------------------------------------------------------------------------
 *
 * The user turns the device, holds it, and turns it again. The detector finds the rests (static
 * intervals: stretches in which only noise changes the readings) in the stream of raw samples,
 * trims the motion at their ends, and sums the samples between exactly. There is nothing to tune:
 * no threshold in counts or m/s^2, no quiet time at the beginning. It learns from the stream:
 *
 *     noise    variance inside a block of about 1/8 s, a low quantile of all quiet blocks
 *     wander   squared distance of a block mean from the trend, also a low quantile: hand tremor
 *     quantum  the smallest change of a reading
 *     reach    how far readings have moved from the last rest: the scale of "another orientation"
 *
 * A block is quiet if its variance is that of the noise, and belongs to the rest if its mean is
 * where the rest expects it. After trimming, 0.6 s of blocks make a position; holding longer makes
 * it better. The slope over the last two seconds detects a slow turn, which a threshold on a
 * variance cannot: 0.3 degrees/s (up to 1 mg of noise, 100 Hz or more) never passes for a rest.
 *
 * All three axes are treated alike and together, and the decisions do not depend on unit, offset or
 * order of the axes. All arithmetic is in integers. Raw counts may be any int32. Noise may reach
 * 65,000 counts (standard deviation); more looks like motion, and so do readings that creep by more
 * than 500,000 counts in one rest. Noise is what stays the same: a steady vibration counts as rest,
 * and adds to the variance. It works for a magnetometer too.
 *
 * A rest needs 2 seconds (from 32 Hz on; 5 at 10 Hz). About 0.5 s are trimmed at its beginning,
 * 0.3 s at its end.
 *
 * Begin a stream at rest, if you can: its beginning counts as noise until something quieter
 * follows, and if the device moves at several g, the first second may look like a rest.
 */
#define INVCAL_RATE_MIN 8    /* samples per second */
#define INVCAL_RATE_MAX 8000 /* the same */

/* A rest. */
typedef struct {
    int64_t sum[3];       /* of the raw samples, exact */
    uint32_t count;       /* how many, > 0 */
    uint32_t begin, end;  /* index of the first, and of the one after the last; fewer than
                             end - begin are summed if the rest was disturbed in between. Samples
                             in full blocks count, from 0, modulo 2^32 */
    invcal_real variance; /* of one sample about its block, counts^2, the mean of the three axes */
} invcal_rest;

/* Begins a stream.
 *
 * rate  samples per second, INVCAL_RATE_MIN ... INVCAL_RATE_MAX; an error of 10 % does no harm.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RATE for any other. */
invcal_status invcal_rests_init(invcal_rests *rests, invcal_real rate);

/* Sets the counts at which the sensor clips (-32768, 32767), from now on. Without it only the
 * ends of int32 count as clipped.
 *
 * Returns INVCAL_OK; INVCAL_BAD_LIMITS unless low < high. */
invcal_status invcal_rests_rails(invcal_rests *rests, int32_t low, int32_t high);

/* Sets how long a rest must be measured from now on, trimmed ends not included; a shorter one is
 * refused. If the current rest is READY but shorter, it is no longer READY; READY is returned again
 * later.
 *
 * milliseconds  clamped to 600 (the minimum for a position) ... 3,600,000. */
void invcal_rests_hold(invcal_rests *rests, uint32_t milliseconds);

/* Feeds one sample, of any value.
 *
 * Returns what happened. INVCAL_TAKEN comes 0.6 to 1 s after motion began. Costs as much as
 * invcal_session_feed. */
invcal_event invcal_rests_feed(invcal_rests *rests, const int32_t raw[3]);

/* Call it where samples were lost: a new block begins. The rest goes on if the next samples agree
 * with it; otherwise it ends as if by motion. */
void invcal_rests_gap(invcal_rests *rests);

/* Ends the stream: closes the current rest, if any, as motion would.
 *
 * Returns INVCAL_TAKEN, INVCAL_REFUSED, or INVCAL_MOVING if there is none. Samples may follow; what
 * was learned is kept. */
invcal_event invcal_rests_finish(invcal_rests *rests);

/* Progress of the current position, percent of the time to hold: 0 in motion, 100 from READY on. It
 * does not fall during a rest, unless the rest is refused for drift and restarts, or the time to
 * hold is raised. */
unsigned invcal_rests_progress(const invcal_rests *rests);

/* Why the last rest was REFUSED: an INVCAL_REST_ of invcal_status. INVCAL_OK after READY or TAKEN,
 * and before the first. */
invcal_status invcal_rests_reason(const invcal_rests *rests);

/* The rest that is READY, as measured so far without the newest quarter of a second; or the one
 * just TAKEN, until the next sample. Returns 1; 0, out untouched, if there is neither. */
int invcal_rests_get(const invcal_rests *rests, invcal_rest *out);

/* Only the mean of its samples: computed from differences, so the size of the sum costs no
 * precision. Within 1 ulp of the largest reading; returns as invcal_rests_get. */
int invcal_rests_mean(const invcal_rests *rests, invcal_real mean[3]);

/* ---- in the background --------------------------------------------------------------------------
 *
 * The same for a device that is never calibrated on purpose: feed it samples for days. A rest in a
 * well covered direction is refused (INVCAL_REFUSED, INVCAL_REST_SAME); the table keeps the most
 * informative positions, up to INVCAL_MAX_POSITIONS - 1. If it is full, the least informative one
 * is dropped, the one just taken included, and of two alike the older; after 88 days each is
 * dropped. */
typedef struct {
    invcal_session session;            /* the positions and the detector */
    uint8_t age[INVCAL_MAX_POSITIONS]; /* days */
} invcal_background;

/* Begins: as invcal_session_init_nominal. Use the functions of invcal.h to set up, read and solve
 * the session inside. After a reset, begin it, then load background->session by invcal_session_load
 * (store.h): all its positions count as new.
 *
 * size  sizeof *background. */
INVCAL_NODISCARD invcal_status invcal_background_init(invcal_background *background, size_t size,
                                                      const invcal_calibration *nominal,
                                                      invcal_real rate);

/* Feeds one sample: as invcal_session_feed, but refuses a position that adds little. At the end of
 * a rest it compares the positions kept. Cost: of that, 26,000 instructions. */
invcal_event invcal_background_feed(invcal_background *background, int32_t x, int32_t y, int32_t z);

/* Call it once a day: positions become a day older. */
void invcal_background_age(invcal_background *background);

#ifdef __cplusplus
}
#endif

#endif
