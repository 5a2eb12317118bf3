/* SPDX-License-Identifier: MIT
 *
 * invcal/calibration.h: the correction of a triad, and its use.
 *
 * This is all that a running device needs: calibrated = matrix (raw - offset).
 * The same structure states what is known beforehand: a data sheet's zero and scale (the
 * *nominal* calibration), or an earlier calibration that is to be renewed.
 */
#ifndef INVCAL_CALIBRATION_H
#define INVCAL_CALIBRATION_H

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a correction takes. */
typedef struct {
    invcal_real offset[3];    /* raw reading in no field, raw units, finite */
    invcal_real matrix[3][3]; /* field units per raw unit, by rows, regular */
} invcal_calibration;

/* The nominal calibration of a data sheet.
 *
 * zero   raw reading in no field, raw units.
 * scale  field units per raw unit of each axis (m/s^2 per count, uT per count); a negative value
 *        turns an axis round.
 * out    zero as its offset, scale on the diagonal of its matrix.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if a number is not finite or a scale is zero. */
invcal_status invcal_calibration_nominal(const invcal_real zero[3], const invcal_real scale[3],
                                         invcal_calibration *out);

/* Applies a calibration: calibrated = matrix (raw - offset).
 *
 * raw         one sample or mean, raw units.
 * calibrated  the field in field units; may be the same array as raw.
 *
 * Nothing is checked: a NaN in gives a NaN out. Cost: 9 multiplications, 9 additions. */
void invcal_apply(const invcal_calibration *calibration, const invcal_real raw[3],
                  invcal_real calibrated[3]);

/* The inverse of the matrix: raw units per field unit, by rows.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if the matrix is singular to rounding, or it or its
 * inverse holds a number that is not finite. */
invcal_status invcal_calibration_inverse(const invcal_calibration *calibration,
                                         invcal_real inverse[3][3]);

#ifdef __cplusplus
}
#endif

#endif
