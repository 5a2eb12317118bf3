/* SPDX-License-Identifier: MIT
 *
 * invcal/expert.h: the steps one by one, and the options that few programs need.
 *
 *     raw samples -> rests -> row -> sums -> solve -> judge
 *
 * What is not called is not linked. invcal.h states the rules and units.
 */
#ifndef INVCAL_EXPERT_H
#define INVCAL_EXPERT_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- one position, one equation ----------------------------------------------------------------
 *
 * Every equation reads J + h p = 0 with the row of the paper
 *
 *     h(a) = (x y z x^2 y^2 z^2 xy xz yz).
 *
 * With u the reading over field, not normalised, J = (|u|^2 - 1)/2 + h(u) p = 0 is the equation of
 * an ellipsoid: exact for errors of any size, and linear in p. */
typedef struct {
    invcal_real h[INVCAL_PARAMETERS]; /* the row; the first three are u itself */
    invcal_real j;                    /* the composition */
} invcal_row;

/* The exact row of a reading.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a length outside 0.1 ... 10. */
invcal_status invcal_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                             invcal_row *row);

/* ---- the normal equations, position by position ------------------------------------------------
 *
 * The sums H'H, H'J, J'J of all rows: their size does not depend on the number of positions, and
 * order does not matter beyond rounding. Every element of h h' is a product of two, three or four
 * of x, y, z, and of 45 only 31 are different. */

/* A symmetric matrix of n rows, lower triangle by rows: (r, c) with c <= r stands here. */
#define INVCAL_PACKED(r, c) ((r) * ((r) + 1u) / 2u + (c))
/* How many elements that takes. */
#define INVCAL_PACKED_SIZE(n) ((n) * ((n) + 1u) / 2u)

#define INVCAL_MOMENTS 31u /* different elements of H'H */

/* The sums of all positions: 224 bytes. */
typedef struct {
    /* The moments xx xxx xxxx xxxy ... zzzz; H'J; J'J. What is behind them is used where they are
     * solved. */
    invcal_real sum[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)];
    unsigned count; /* rows in the sums; at most UINT_MAX */
} invcal_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_sums_init(invcal_sums *sums);

/* Adds a position.
 *
 * nominal  the same for all of them.
 *
 * Returns as invcal_observe. Cost: 230 instructions, no division. */
invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real raw[3]);

/* Adds a row that has been made before.
 *
 * weight  1 for a position like the others; (sigma_usual / sigma_this)^2 for another precision;
 *         finite. Nothing is checked. */
void invcal_sums_add_row(invcal_sums *sums, const invcal_row *row, invcal_real weight);

/* Solves them (mathematics.md, "From p to the calibration"):
 *
 *     p = -(H'H)^-1 H'J                                               one 9x9 Cholesky
 *     v = (p0 p1 p2),  Q = I + [2 p3 p6 p7; p6 2 p4 p8; p7 p8 2 p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta,  A'A = Q / k,  A symmetric
 *     calibrated = A (u - delta)
 *
 * No iteration that could fail to converge.
 *
 * sums     are lost: copy them if more positions are to follow.
 * nominal  the one they were added with; may be out.
 *
 * It does not judge: INVCAL_OK says solvable, invcal_judge says how good.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL, INVCAL_TOO_FEW, INVCAL_UNDETERMINED, INVCAL_NOT_ELLIPSOID
 * as invcal_calibrate. Cost: 3,400 instructions. Stack: about 230 bytes. */
invcal_status invcal_solve(invcal_sums *sums, const invcal_calibration *nominal,
                           invcal_calibration *out);

/* ---- the system of equations --------------------------------------------------------------------
 *
 * A symmetric system of n unknowns, A p = -b, in one packed triangle. Row n, if there is one, is b'
 * with the constant behind it: the factorisation of A carries it along, and so solves half of the
 * system. */

/* Below this a pivot, over the largest element of the diagonal, is rounding error, or the parameter
 * behind it might as well be. */
#define INVCAL_FLOOR (INVCAL_DOUBLE ? INVCAL_REAL(1e-8) : 16 * INVCAL_EPSILON)

/* The sums become the system: the triangle of H'H, below it H'J and J'J. */
void invcal_sums_system(invcal_sums *sums);

/* The sum, and the largest, of the diagonal; the latter at least 0, NaN passed over. */
invcal_real invcal_trace(const invcal_real *a, unsigned n);
invcal_real invcal_largest_diagonal(const invcal_real *a, unsigned n);

/* Adds x to the diagonal: a ridge, or an equal prior. */
void invcal_add_ridge(invcal_real *a, unsigned n, invcal_real x);

/* A = L L' in place. The diagonal becomes 1 / L(r,r): nothing that follows divides. Rows from n to
 * rows - 1 are divided by L' only: b' becomes y' of L y = b, and the constant what A leaves of it.
 *
 * floor  a pivot counts as zero unless it exceeds floor times the largest element of the diagonal:
 *        INVCAL_FLOOR. Relative to the largest, not to the pivot's own: the latter lets matrices
 *        through that are singular to rounding.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED if a pivot is too small, negative or NaN: a is lost.
 * Cost: n^3/6 multiply-adds, n square roots. */
invcal_status invcal_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor);

/* y in row n becomes p = -L'^-1 y. */
void invcal_back_substitute(invcal_real *l, unsigned n);

/* L becomes L^-1: A^-1(r,r) is then the squared length of column r, x'A^-1 x that of L^-1 x. */
void invcal_invert(invcal_real *l, unsigned n);

/* A^-1(r,r) from L^-1. */
invcal_real invcal_variance(const invcal_real *inverse, unsigned n, unsigned r);

/* h K h' from L^-1 of nine parameters: what a row tells beside those in the sums. */
invcal_real invcal_leverage(const invcal_real *inverse, const invcal_real h[INVCAL_PARAMETERS]);

#define INVCAL_LOSS INVCAL_REAL(2.0)
#define INVCAL_LOSS_SIGMA INVCAL_REAL(32.0)
#define INVCAL_LOSS_LENGTH INVCAL_REAL(8.0)
#define INVCAL_LOSS_AGAIN INVCAL_REAL(4.0)

/* ---- what a refusal is about -------------------------------------------------------------------- */

/* Which parameters the positions leave open, bit r for parameter r. A small ridge on H'H shows it: a
 * parameter that the ridge holds is one that the data do not. Rough by nature; no positions leave
 * all nine open. Positions that are no readings are passed over. */
uint16_t invcal_undetermined(const invcal_real *raw, unsigned count,
                             const invcal_calibration *nominal);

/* The first position that is no reading of this field; count if all are. */
unsigned invcal_bad_reading(const invcal_real *raw, unsigned count,
                            const invcal_calibration *nominal);

/* ---- the result, looked at otherwise -------------------------------------------------------------- */

/* X = (delta, dk, gamma): what a calibration says of the sensor, against nominal.
 *
 * calibration  in the symmetric frame: as it was solved. */
void invcal_deviation(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      invcal_real x[INVCAL_PARAMETERS]);

/* Lengths cannot tell how the calibrated frame is turned against the case. The symmetric correction
 * is closest to the axes of nominal; this turns it to the upper triangular one, as imu_tk has it:
 * only the x sensor feels a field along the calibrated x axis. */
void invcal_make_triangular(invcal_calibration *calibration, const invcal_calibration *nominal);

/* The standard deviation of the offset in raw counts: sigma[0 ... 2] through the inverse of
 * nominal. */
void invcal_sigma_offset(const invcal_quality *quality, const invcal_calibration *nominal,
                         invcal_real sigma[3]);

/* Is `found` the better of two? 1 if its verdict is no worse, and the sum of its squared sigma, as
 * wide as their 95 % intervals, is smaller. */
int invcal_improves(const invcal_quality *found, const invcal_quality *present);

/* ---- positions that contradict the others ----------------------------------------------------------
 * see src/outliers.c.
 */
#define INVCAL_OUTLIERS_MOST 6u /* outliers named at most */

typedef struct {
    invcal_mask removed;   /* bit i: position i is an outlier: leave it out, or repeat it */
    invcal_mask suspected; /* bit i: position i is of two groups that contend: one of them is wrong,
                              the residuals do not tell which. Repeat these. 0 as a rule */
} invcal_outliers;

invcal_status invcal_outliers_find(const invcal_real *raw, unsigned count,
                                   const invcal_calibration *nominal, invcal_real noise,
                                   invcal_outliers *out);

/* invcal_calibrate without some of the positions. */
invcal_status invcal_calibrate_without(const invcal_real *raw, unsigned count, invcal_mask left_out,
                                       const invcal_calibration *nominal, invcal_real noise,
                                       invcal_calibration *out, invcal_quality *quality);

/* ---- what is known beforehand ------------------------------------------------------------------------
 *
 * Parameter r is 0, with standard deviation prior[r]: a row more for each, which makes the solution
 * a Bayesian update. */
invcal_status invcal_calibrate_with_prior(const invcal_real *raw, unsigned count,
                                          const invcal_calibration *nominal, invcal_real noise,
                                          const invcal_real prior[INVCAL_PARAMETERS],
                                          invcal_calibration *out, invcal_quality *quality,
                                          uint16_t *from_prior);

/* ---- known directions: a stand ------------------------------------------------------------------------ */
/* With the direction eta known, the paper's compositions are linear in X = (delta, dk, gamma), here
 * as J + h(eta) p = 0 with p = -X:
 *
 *     J1 = u eta - 1            the vertical composition: exactly linear
 *     J2 = (|u|^2 - 1)/2        the scalar composition: leaves an error of second order in X
 *
 * Exact rows have another meaning of p: these sums are a type of their own. */
typedef struct {
    invcal_sums sums;
} invcal_linear_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_linear_init(invcal_linear_sums *linear);

/* Adds a position of known direction by J1, or by J2.
 *
 * eta  the up direction in the frame of the unit, unit length within 1e-4.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE, INVCAL_BAD_DIRECTION. */
invcal_status invcal_linear_add_vertical(invcal_linear_sums *linear,
                                         const invcal_calibration *nominal,
                                         const invcal_real raw[3], const invcal_real eta[3]);
invcal_status invcal_linear_add_scalar(invcal_linear_sums *linear,
                                       const invcal_calibration *nominal, const invcal_real raw[3],
                                       const invcal_real eta[3]);

/* Solves them: A = (I + S)^-1.
 *
 * linear  sums: are lost.
 * out     the calibration. x: the nine parameters.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW, INVCAL_UNDETERMINED, INVCAL_NOT_ELLIPSOID if a semi-axis of
 * I + S is outside 0.1 ... 10; INVCAL_BAD_NOMINAL. */
invcal_status invcal_linear_solve(invcal_linear_sums *linear, const invcal_calibration *nominal,
                                  invcal_calibration *out, invcal_real x[INVCAL_PARAMETERS]);

/* ---- where to turn next ---------------------------------------------------------------------------------
 *
 * Of 26 directions - the 6 faces, 12 edges and 8 corners of a cube - the one with the largest
 * h K h' is asked for, K = (H'H)^-1 of the positions so far: it multiplies det H'H by the most,
 * 1 + h K h' (greedy D-optimal design). A small ridge on H'H makes that work from the first
 * position on. Nine positions that follow determine everything, sqrt(K(r,r)) at most 3.01; eighteen
 * come within 0.3 of the largest log det H'H there can be. Hand errors of 10 degrees cost little. */

/* The direction to take next.
 *
 * positions  those so far; none at the beginning. Those that are no readings are passed over.
 * Of directions whose h K h' is within 1 % of the largest, the nearest to the last position, but
 * none within 26 degrees of it if there is another. */
void invcal_next(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                 invcal_real up[3]);

/* sqrt(K(r,r)) of the positions so far: sigma of parameter r over that of a position mean.
 *
 * up  null, or a direction as if it had been taken too: what it will improve. The ridge ends what is
 *     open at about 100. */
void invcal_prospect(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                     const invcal_real *up, invcal_real root[INVCAL_PARAMETERS]);

/* ---- rests ------------------------------------------------------------------------------------------------ */

/* A rest that was taken. */
typedef struct {
    int64_t sum[3];       /* of the raw samples, exact */
    uint32_t count;       /* how many, > 0 */
    uint32_t begin, end;  /* index of the first, and of the one after the last */
    invcal_real variance; /* of one sample about its block, counts^2, the mean of the three axes */
} invcal_rest;
invcal_status invcal_rests_init(invcal_rests *rests, unsigned rate);
invcal_status invcal_rests_rails(invcal_rests *rests, int32_t low, int32_t high);
void invcal_rests_hold(invcal_rests *rests, unsigned milliseconds);
invcal_event invcal_rests_feed(invcal_rests *rests, const int32_t raw[3]);
void invcal_rests_gap(invcal_rests *rests);
invcal_event invcal_rests_finish(invcal_rests *rests);
unsigned invcal_rests_progress(const invcal_rests *rests);
invcal_status invcal_rests_reason(const invcal_rests *rests);
int invcal_rests_get(const invcal_rests *rests, invcal_rest *out);
void invcal_rest_mean(const invcal_rest *rest, invcal_real mean[3]);

/* ---- in the background --------------------------------------------------------------------------------------
 *
 * The same for a device that nobody calibrates on purpose: fed with whatever comes in days. A rest
 * in a direction that is well covered is passed over (INVCAL_REFUSED, INVCAL_REST_SAME); the table
 * keeps what tells most, up to INVCAL_MAX_POSITIONS - 1; an old position gives way before a new
 * one, and goes after 88 days. */
typedef struct {
    invcal_session session;
    uint8_t age[INVCAL_MAX_POSITIONS]; /* days */
} invcal_background;

/* Begins: as invcal_session_begin. The session inside may be set up by the functions of invcal.h,
 * read, and solved. */
invcal_status invcal_background_init(invcal_background *background,
                                     const invcal_calibration *nominal, unsigned rate);

/* Feeds one sample: as invcal_session_feed, but what tells hardly anything new is refused. At the
 * end of a rest it compares the positions kept: up to 40,000 instructions. */
invcal_event invcal_background_feed(invcal_background *background, const int32_t raw[3]);

/* A day has gone by. */
void invcal_background_age(invcal_background *background);

#ifdef __cplusplus
}
#endif

#endif
