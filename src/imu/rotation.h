/* SPDX-License-Identifier: MIT
 *
 * Internal: rotations of the gyroscope's segments.
 */
#ifndef INVCAL_ROTATION_H
#define INVCAL_ROTATION_H

#include "invcal/gyro.h"
#include "../core/vector.h"

/* int16 holds a v of 1 rad, nearly three times that of a full segment, and a coning of 1/8 rad. */
#define INVCAL_V_UNIT (1 / INVCAL_REAL(32768.0))      /* of segment.v */
#define INVCAL_KAPPA_UNIT (1 / INVCAL_REAL(262144.0)) /* of segment.kappa, and of a rest's bias */

#define INVCAL_LEAST_RATE INVCAL_REAL(8.0) /* samples per second */
#define INVCAL_MOST_RATE INVCAL_REAL(8000.0)

/* Distinguishes kept bytes of another layout, number type or byte order: version, moves, type,
 * segments. */
#define INVCAL_MOVES_LAYOUT                                                                        \
    (UINT32_C(0x62000000) + INVCAL_MAX_MOVES * UINT32_C(0x40000) +                                 \
     (uint32_t)sizeof(invcal_real) * 0x1000u + INVCAL_MAX_SEGMENTS)

/* No rest and no move, with these settings. */
void invcali_moves_empty(invcal_imu *imu, const invcal_calibration *nominal, invcal_real rate);

/* Begins a stream; rests and moves so far are kept. */
void invcali_moves_restart(invcal_imu *imu);

/* out += unit packed */
void invcali_unpack(const int16_t packed[3], invcal_real unit, invcal_real out[3]);

#endif
