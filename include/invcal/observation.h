/* SPDX-License-Identifier: MIT
 *
 * invcal/observation.h: one rest position becomes one equation.
 *
 * The sensor model (mathematics.md, "The sensor"; the paper's W): a triad in the field of unit
 * direction eta reads, after nominal scaling and in units of the field,
 *
 *     u = (I + S) eta + delta + noise,
 *
 * with S = diag(dk) + the symmetric part of the cross terms, gamma_xy = S_xy + S_yx and so on.
 * Only lengths are observed, so an antisymmetric part of S (a rotation of the case) is not seen.
 * Nothing here knows that the field is gravity: a magnetometer in uT is treated alike.
 *
 * All three kinds of equation read j + h p = 0 with the row of the paper
 *
 *     h(a) = (x y z x^2 y^2 z^2 xy xz yz).
 */
#ifndef INVCAL_OBSERVATION_H
#define INVCAL_OBSERVATION_H

#include "invcal/calibration.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What p means. Equations of different meaning cannot be solved together. */
typedef enum {
    INVCAL_MODEL_ELLIPSOID, /* p: coefficients of the ellipsoid through the readings, exact */
    INVCAL_MODEL_LINEAR     /* p = -X, X = (delta, dk, gamma) */
} invcal_model;

/* One equation. */
typedef struct {
    invcal_real h[INVCAL_PARAMETERS]; /* the row */
    invcal_real j;                    /* the composition */
    invcal_model model;               /* of p */
} invcal_observation;

/* A reading in units of the field, which is what the three rows below take.
 *
 * nominal  raw to field units, as far as known: 20 % or half a field of error is no harm. Only an
 *          offset error of about one field is bad, readings then pass near zero: find the middle
 *          of the readings first if hard iron may be that strong.
 * field    length of the field, in field units, > 0 (9.80665 for m/s^2, 48.5 for uT, ...).
 * raw      the mean of the samples of one rest position, raw units.
 * u        the reading over field, about a unit vector.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if field is not finite and positive;
 * INVCAL_NOT_FINITE if the result is not finite (a raw value or the nominal was not). */
invcal_status invcal_observation_reading(const invcal_calibration *nominal, invcal_real field,
                                         const invcal_real raw[3], invcal_real u[3]);

/* The exact scalar equation, the default: needs no direction.
 *
 *     j = (|u|^2 - 1)/2, row h(u), u not normalised           (mathematics.md, "The exact row")
 *
 * |A (u - delta)|^2 = 1 is the equation of an ellipsoid, and this is its general form, linear in
 * its coefficients p: exact for errors of any size.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE if |u| is outside 0.1 ... 10. */
invcal_status invcal_observation_exact(const invcal_real u[3], invcal_observation *out);

/* Both in one, what a device does with each position mean: the exact equation of a raw reading.
 * The reading over field is out->h[0 ... 2]. Returns as the two do. */
invcal_status invcal_observe(const invcal_calibration *nominal, invcal_real field,
                             const invcal_real raw[3], invcal_observation *out);

/* The paper's scalar composition J2, for comparison: the direction is known, the equation holds
 * to first order only.
 *
 *     j = (|u|^2 - 1)/2 = h(eta) X + O(X^2)
 *
 * It is wrong by 1e-4 at errors of 1 % and by 1e-2 at errors of 10 %.
 *
 * vertical  eta, the direction of the field in the frame of the case, unit length within 1e-4.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE; INVCAL_NOT_UNIT. */
invcal_status invcal_observation_first_order(const invcal_real u[3], const invcal_real vertical[3],
                                             invcal_observation *out);

/* The paper's vertical composition J1: the direction is known, from a stand.
 *
 *     j = u eta - 1 = h(eta) X
 *
 * Linear without approximation; as good as the stand's directions.
 *
 * vertical, returns: as invcal_observation_first_order. */
invcal_status invcal_observation_vertical(const invcal_real u[3], const invcal_real vertical[3],
                                          invcal_observation *out);

#ifdef __cplusplus
}
#endif

#endif
