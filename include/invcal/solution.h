/* SPDX-License-Identifier: MIT
 *
 * invcal/solution.h: from the normal equations to the calibration.
 */
#ifndef INVCAL_SOLUTION_H
#define INVCAL_SOLUTION_H

#include <stdint.h>

#include "invcal/cholesky.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Lengths cannot tell how the calibrated frame is turned against the case: one has to choose.
 * Delta, dk and gamma are always those of the symmetric model. */
typedef enum {
    INVCAL_FRAME_SYMMETRIC, /* closest to the axes of the nominal calibration (default) */
    INVCAL_FRAME_TRIANGULAR /* matrix upper triangular for a diagonal nominal matrix, as imu_tk:
                               only the x sensor feels a field along the calibrated x axis */
} invcal_frame;

/* What the user knows and wants. */
typedef struct {
    invcal_calibration nominal; /* the one the readings were made with */
    invcal_real field;          /* length of the field, field units, > 0 */
    invcal_real noise;          /* standard deviation of one position mean on each axis, field
                                   units, at most field; 0: not known, only the residuals tell */
    invcal_real prior[INVCAL_PARAMETERS]; /* what is known beforehand of the deviation from
                                   nominal: standard deviations up to about 0.2 (beyond, the
                                   first order fails that makes them one of p), 0: nothing.
                                   Needs noise > 0 */
    invcal_frame frame;                   /* of the calibrated readings */
} invcal_settings;

/* The result. */
typedef struct {
    invcal_calibration calibration; /* offset (raw units), matrix (field units per raw unit) */
    invcal_real delta[3];           /* zero offsets against nominal, over field */
    invcal_real dk[3];              /* scale errors against nominal: 0.01 reads 1 % too much */
    invcal_real gamma[3];           /* non-orthogonality xy, xz, zy against nominal, rad */
} invcal_solution;

/* Solves the normal equations (mathematics.md, "From p to the calibration"):
 *
 *     p = -(H'H)^-1 H'J
 *     v = (p0 p1 p2),  Q = I + [2 p3 p6 p7; p6 2 p4 p8; p7 p8 2 p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta,  I + S = (Q / k)^-1/2
 *     calibrated = A (u - delta),  A'A = Q / k
 *
 * and for the linear model X = -p, A = (I + S)^-1. One 9x9 Cholesky, no iteration that could
 * fail to converge. Then A and delta are joined with the nominal calibration.
 *
 * normal    sums of rows made with settings->nominal and settings->field. Not changed: more
 *           positions may be added afterwards.
 *
 * Returns INVCAL_OK;
 *   INVCAL_BAD_SETTING    invcal_settings_check refuses the settings;
 *   INVCAL_TOO_FEW        fewer positions than parameters without a prior, or none;
 *   INVCAL_UNDETERMINED   the positions leave parameters open, to the precision of the number
 *                         type; invcal_undetermined names them;
 *   INVCAL_NOT_ELLIPSOID  the readings lie on no ellipsoid (but, say, on a hyperboloid), or on
 *                         one with a semi-axis outside 0.1 ... 10 of nominal.
 *
 * What it does not do is judge: INVCAL_OK says solvable, invcal_assess says how good.
 * Stack: about 500 bytes (float, Cortex-M4F, -Os; likewise below). */
invcal_status invcal_solve(const invcal_normal *normal, const invcal_settings *settings,
                           invcal_solution *solution);

/* Which parameters the positions leave open, as bits (bit r: parameter r), so that a refusal can
 * name them. Uses a small ridge on H'H: a parameter that the ridge holds is one that the data
 * do not. Rough by nature; empty sums leave all nine open.
 * Stack: about 330 bytes. */
uint16_t invcal_undetermined(const invcal_normal *normal);

/* Are the settings usable? Asked by all functions that take some.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if a number is NaN or infinite, field is not positive,
 * noise negative or above field, a prior negative or stated without the noise, the nominal matrix
 * singular, frame none of the two; or if an offset, the matrix, or the field in raw units exceeds
 * 1e-6 of the number type's largest: what is computed of them might not fit it. */
invcal_status invcal_settings_check(const invcal_settings *settings);

/* 1 if the settings hold a prior for any parameter, else 0. */
int invcal_has_prior(const invcal_settings *settings);

/* H'WH with the prior of the settings, packed.
 *
 * The prior, parameter r is 0 with standard deviation prior[r], adds (noise / prior[r])^2 to the
 * diagonal, which makes the solution a Bayesian update (mathematics.md, "Prior").
 *
 * settings  that invcal_settings_check accepts.
 * noise     standard deviation of one equation, over field; > 0 beside a prior. Where the
 *           positions alone leave parameters open it is raised to what the number type can
 *           resolve beside the prior: in float to sqrt(count) / 2000 of the widest prior. With
 *           less, rounding errors of H'H would count as data. Without a prior it is not used. */
void invcal_information(const invcal_normal *normal, const invcal_settings *settings,
                        invcal_real *noise, invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

/* The same, factored to L.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED: l and noise are lost then. */
invcal_status invcal_information_factor(const invcal_normal *normal,
                                        const invcal_settings *settings, invcal_real *noise,
                                        invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

/* S of the sensor model u = (I + S) eta + delta from dk and gamma, packed (INVCAL_PACKED). */
void invcal_solution_deviation(const invcal_solution *solution, invcal_real s[6]);

#ifdef __cplusplus
}
#endif

#endif
